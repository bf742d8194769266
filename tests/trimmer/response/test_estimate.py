"""Means of series whose correlation is known."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lfilter
from scipy.stats import norm

from trimmer.response.estimate import Estimate, correlation_time, mean_of


def correlated(share: float, count: int = 200_000) -> np.ndarray:
    """A series of which each value keeps a share of the one before; its variance is 1."""
    noise = np.random.default_rng(4).normal(size=count)
    return np.asarray(lfilter([np.sqrt(1 - share**2)], [1.0, -share], noise))


@pytest.mark.parametrize("share", [0.0, 0.5, 0.9])
def test_correlation_makes_a_mean_less_sure(share: float) -> None:
    series = correlated(share)
    time = (1 + share) / (1 - share)  # 1 + 2 Σ share^n
    assert correlation_time(series) == pytest.approx(time, rel=0.12)
    found = mean_of(series)
    assert found.value == series.mean()
    # Batches of four times of correlation still hang together a little.
    assert found.uncertainty == pytest.approx(np.sqrt(time / len(series)), rel=0.15)


def test_few_values_are_taken_as_they_are() -> None:
    assert mean_of(np.array([1.0, 2.0, 3.0])) == Estimate(2.0, pytest.approx(1 / np.sqrt(3)))
    assert mean_of(np.array([7.0])) == Estimate(7.0, 0.0)


def test_the_interval_holds_95_percent() -> None:
    low, high = Estimate(2.0, 0.5).interval
    assert (low, high) == pytest.approx((2 - 0.5 * norm.ppf(0.975), 2 + 0.5 * norm.ppf(0.975)))
