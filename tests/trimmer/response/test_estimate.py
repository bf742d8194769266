"""Means of series whose correlation is known."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lfilter
from scipy.stats import norm

from trimmer.response import estimate
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


@pytest.mark.parametrize(
    ("count", "time", "lengths"),
    [
        (160, 2.5, [10]),
        (160, 2.6, [10, 5, 2]),
        (160, 0.1, [1]),
        (175, 9.0, [10, 5, 2]),
        (64, 9.0, [4, 2, 1]),
        (48, 9.0, [3, 1, 1]),
        (32, 9.0, [2, 1, 1]),
        (32, 0.5, [2]),
    ],
)
def test_batches_are_four_times_of_correlation_long_or_of_some_lengths(
    monkeypatch: pytest.MonkeyPatch, count: int, time: float, lengths: list
) -> None:
    asked: list = []
    errors = {10: 3.0, 5: 7.0, 2: 5.0, 4: 1.0, 1: 0.5, 3: 0.1}
    monkeypatch.setattr(estimate, "correlation_time", lambda series: time)
    monkeypatch.setattr(estimate, "_error", lambda series, length: asked.append(length) or errors[length])
    found = mean_of(np.arange(float(count)))
    assert asked == lengths
    assert found == Estimate(0.5 * (count - 1), max(errors[length] for length in lengths))
