"""Statistics of short series, held against their definitions written out."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

from trimmer.response.estimate import correlation_time, mean_of
from trimmer.response.recurrence import candidates, has_returned
from trimmer.response.settling import _counts
from trimmer.response.zero_one import growth_of_walk


def spread(count: int) -> float:
    """Standard deviation of 0, 1 ... count - 1, with count - 1 in the denominator."""
    return math.sqrt(count * (count + 1) / 12)


def test_a_rising_series_has_the_error_of_its_longest_batches() -> None:
    # Batches of 4, 2 and 1 of 64 values; those of 4 differ most.
    found = mean_of(np.arange(64.0))
    assert found.value == 31.5
    assert found.uncertainty == pytest.approx(4 * spread(16) / 4, rel=1e-14)
    # What does not fill a batch is left out at the beginning.
    longer = mean_of(np.concatenate([[-1e3, 1e3, 5.0], np.arange(64.0)]))
    assert longer.value == pytest.approx((64 * 31.5 + 5) / 67)
    assert longer.uncertainty >= 4 * spread(16) / 4 * (1 - 1e-14)


def test_thirty_two_values_are_enough_for_batches() -> None:
    rising = np.arange(32.0)
    assert mean_of(rising).uncertainty == pytest.approx(2 * spread(16) / 4, rel=1e-14)
    assert mean_of(rising[:31]).uncertainty == pytest.approx(spread(31) / math.sqrt(31), rel=1e-14)


def test_a_series_without_correlation_has_batches_of_four() -> None:
    series = np.tile([1.0, -1.0, -1.0, 1.0, 3.0, -3.0], 20)
    assert correlation_time(series) == 1.0
    means = series.reshape(30, 4).mean(axis=1)
    assert mean_of(series).uncertainty == pytest.approx(means.std(ddof=1) / math.sqrt(30), rel=1e-14)


def test_the_time_of_correlation_is_the_sum_of_positive_pairs() -> None:
    series = np.convolve(np.random.default_rng(8).normal(size=90), [1.0, 0.8, 0.7, 0.5, 0.2], "valid")
    count = len(series)
    mean = sum(series) / count
    covariances = [
        sum((series[k] - mean) * (series[k + lag] - mean) for k in range(count - lag)) for lag in range(count)
    ]
    total = -1.0
    for lag in range(0, count // 4, 2):
        pair = (covariances[lag] + covariances[lag + 1]) / covariances[0]
        if pair <= 0:
            break
        total += 2 * pair
    assert total > 2
    assert correlation_time(series) == pytest.approx(total, rel=1e-12)
    assert correlation_time(np.full(8, 3.0)) == 1.0


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
    assert growth_of_walk(np.full(43, 2.0)) == 0.0


def test_periods_are_tried_from_the_longest_to_its_parts() -> None:
    assert list(_counts(12)) == [12, 6, 4, 3, 2, 1]
    assert list(_counts(7)) == [7, 1]
    assert list(_counts(1)) == [1]


SIZES = np.array([2.0, 5.0])


def test_candidates_weigh_each_state_by_its_size() -> None:
    states = np.array([[9.0, 9.0], [0.0, 0.0], [0.0, 0.49], [0.19, 0.0], [7.0, 0.0], [0.0, 0.0]])
    assert candidates(states, SIZES, 24) == [2]
    states[3] = 0.0, 0.51
    assert candidates(states, SIZES, 24) == []
    longer = np.concatenate([np.full((8, 2), 50.0), states])
    assert candidates(longer, SIZES, 24) == [4, 3]
    longer[-4] = longer[-1]
    assert candidates(longer, SIZES, 24) == [3]
    assert candidates(longer, SIZES, 2) == []


def test_a_return_of_any_state_counts() -> None:
    states = np.tile(SIZES, (4, 1))
    assert has_returned(states, SIZES, 1)
    for column in (0, 1):
        moved = states.copy()
        moved[1, column] += 3e-10 * SIZES[column]
        assert not has_returned(moved, SIZES, 1)
    assert not has_returned(states[:3], SIZES, 1)
