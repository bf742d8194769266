"""Statistics of series, held against series whose numbers are known and definitions written out."""

import cmath
import math

import numpy as np
import pytest
from scipy.signal import lfilter
from scipy.stats import norm

from trimmer.response.statistics.estimate import Estimate, correlation_time, mean_of
from trimmer.response.statistics.zero_one import growth_of_walk


@pytest.mark.parametrize("share", [0.0, 0.5, 0.9])
def test_correlation_makes_a_mean_less_sure(share: float) -> None:
    noise = np.random.default_rng(4).normal(size=20_000)
    # Each value keeps a share of the one before; its variance is 1.
    series = np.asarray(lfilter([np.sqrt(1 - share**2)], [1.0, -share], noise))
    time = (1 + share) / (1 - share)  # 1 + 2 Σ share^n
    assert correlation_time(series) == pytest.approx(time, rel=0.2)
    found = mean_of(series)
    assert found.value == series.mean()
    # Batches of four times of correlation still hang together a little.
    assert found.uncertainty == pytest.approx(np.sqrt(time / len(series)), rel=0.2)


def test_few_values_are_taken_as_they_are() -> None:
    assert mean_of(np.array([1.0, 2.0, 3.0])) == Estimate(2.0, pytest.approx(1 / np.sqrt(3)))
    assert mean_of(np.array([7.0])) == Estimate(7.0, 0.0)
    low, high = Estimate(2.0, 0.5).interval
    assert (low, high) == pytest.approx((2 - 0.5 * norm.ppf(0.975), 2 + 0.5 * norm.ppf(0.975)))


def spread(count: int) -> float:
    """Standard deviation of 0, 1 ... count - 1, with count - 1 in the denominator."""
    return math.sqrt(count * (count + 1) / 12)


@pytest.mark.parametrize(
    ("count", "error"), [(64, 4 * spread(16) / 4), (32, 2 * spread(16) / 4), (31, spread(31) / math.sqrt(31))]
)
def test_a_rising_series_has_the_error_of_its_longest_batches(count: int, error: float) -> None:
    found = mean_of(np.arange(float(count)))
    assert found == Estimate((count - 1) / 2, pytest.approx(error, rel=1e-14))


def test_a_series_without_correlation_has_batches_of_four() -> None:
    series = np.tile([1.0, -1.0, -1.0, 1.0, 3.0, -3.0], 20)
    assert correlation_time(series) == 1.0
    means = series.reshape(30, 4).mean(axis=1)
    assert mean_of(series).uncertainty == pytest.approx(means.std(ddof=1) / math.sqrt(30), rel=1e-14)


def test_two_frequencies_and_rest_are_order_and_the_logistic_map_at_4_is_chaos() -> None:
    steps = np.arange(2000)
    assert growth_of_walk(np.sin(steps * np.sqrt(2)) + 0.5 * np.cos(steps * np.sqrt(3))) < 0.1
    assert growth_of_walk(np.full(500, 0.1)) < 0.1
    values = [0.3]
    for _ in range(1999):
        values.append(4 * values[-1] * (1 - values[-1]))
    assert growth_of_walk(np.array(values)) == pytest.approx(1.0, abs=0.05)


def test_the_walk_of_the_0_1_test_is_that_of_its_definition() -> None:
    """Gottwald and Melbourne 2009: displacements up to a tenth of the series, correlated with time."""
    series = np.random.default_rng(5).normal(size=43) + 2.0
    count, longest = 43, 4
    mean = sum(series) / count
    ratios = []
    for angle in np.random.default_rng(0).uniform(math.pi / 5, 4 * math.pi / 5, 101):
        place, walk = 0j, []
        for step, value in enumerate(series, 1):
            place += (value - mean) * cmath.exp(1j * angle * step)
            walk.append(place)
        squares = [
            sum(abs(walk[k + lag] - walk[k]) ** 2 for k in range(count - longest)) / (count - longest)
            for lag in range(1, longest + 1)
        ]
        ratios.append(np.corrcoef(range(1, longest + 1), squares)[0, 1])
    assert growth_of_walk(series) == pytest.approx(sorted(ratios)[50], rel=1e-10)
