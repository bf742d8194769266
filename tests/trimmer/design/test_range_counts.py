"""Doubt and spread over ranges, from trials made by hand."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
import pytest
from scipy.stats import qmc

from tests.trimmer.design.made import oscillator
from trimmer import MotionKind
from trimmer.design.design_file import OpenRange
from trimmer.design.ranges import RangeStudy, _doubt, _narrowing, _points, _variance_left, study_ranges
from trimmer.design.settings import DesignSettings
from trimmer.design.targets import Measure, Target
from trimmer.design.trial import Asked, Trial, TrialWork

STROKE, SPEED = Asked(Measure.STROKE, "x"), Asked(Measure.IMPACT_SPEED, "stop")
GAP = OpenRange("stops.stop.gap", "m", 2e-5, 6e-5, False)
FORCE = OpenRange("frictions.blade.force", "N", 1.0, 2.0, True)
TARGET = Target("stroke_at_least", Measure.STROKE, "x", 3.0)


def trial(stroke: float, speed: float = 1.0) -> Trial:
    return Trial((stroke,), MotionKind.PERIODIC, 1, ((STROKE, stroke), (SPEED, speed)))


def test_doubt_is_the_chance_of_two_unlike_judgements() -> None:
    assert _doubt(np.array([True, False, False, False])) == pytest.approx(2 * 0.25 * 0.75)
    assert _doubt(np.array([True, True])) == 0.0


def test_one_range_is_looked_at_from_end_to_end_and_several_by_sobol() -> None:
    settings = DesignSettings(range_points=5)
    np.testing.assert_allclose(_points(1, settings), [[0.0], [0.25], [0.5], [0.75], [1.0]])
    two = _points(2, settings)
    # 2^3 is the first power of two with five points, and one more power for a second range.
    expected = qmc.Sobol(2, scramble=False).random_base2(4) + 1 / 32
    np.testing.assert_allclose(two, expected)
    odd = _points(2, DesignSettings(range_points=4))
    np.testing.assert_allclose(odd, qmc.Sobol(2, scramble=False).random_base2(3) + 1 / 16)
    assert [len(_points(count, DesignSettings(range_points=4))) for count in (2, 3, 4)] == [8, 16, 16]


def test_variance_that_is_left_is_that_within_the_groups() -> None:
    trials = tuple(trial(each) for each in (1.0, 2.0, 5.0, 9.0))
    groups = [np.array([0, 1]), np.array([2, 3])]
    # Within: (0.25 * 2 + 4 * 2) / 4, in all: variance of 1, 2, 5, 9.
    assert _variance_left(STROKE, trials, groups) == pytest.approx(2.125 / np.var([1, 2, 5, 9]))
    uneven = [np.array([0, 1, 2]), np.array([3])]
    assert _variance_left(STROKE, trials, uneven) == pytest.approx(
        3 * np.var([1, 2, 5]) / (4 * np.var([1, 2, 5, 9]))
    )
    assert _variance_left(SPEED, trials, groups) is None
    assert _variance_left(STROKE, (trial(0.0), trial(0.0)), groups[:1]) is None
    assert _variance_left(STROKE, (*trials[:3], trial(math.inf)), groups) is None


def test_what_a_measurement_would_tell_is_counted_in_quarters() -> None:
    shares = np.array([0.0, 0.24, 0.3, 0.49, 1.0])
    trials = tuple(trial(each, each) for each in (1.0, 2.0, 3.0, 4.0, 9.0))
    met = np.array([False, True, True, True, True])
    found = _narrowing(GAP, shares, trials, met, (TARGET,), (STROKE, SPEED))
    assert found.range is GAP
    # The first quarter is in doubt by 1/2 and holds two of the five points.
    assert found.doubt == pytest.approx(0.2)
    assert found.spread == pytest.approx(4 * 0.25 / (5 * np.var([1, 2, 3, 4, 9])))
    assert _narrowing(GAP, shares, trials, met, (), (STROKE,)).doubt == 0.0
    same = tuple(trial(1.0) for _ in shares)
    assert _narrowing(GAP, shares, same, met, (), (STROKE,)).spread == 1.0


def test_the_spread_is_the_mean_over_the_measures_that_vary() -> None:
    shares = np.array([0.1, 0.2, 0.8, 0.9])
    trials = tuple(trial(*each) for each in ((1.0, 1.0), (1.0, 2.0), (2.0, 1.0), (2.0, 2.0)))
    found = _narrowing(GAP, shares, trials, np.ones(4, bool), (), (STROKE, SPEED))
    assert found.spread == pytest.approx(0.5)  # of the stroke nothing, of the speed all


def test_extremes_pass_over_what_failed() -> None:
    study = RangeStudy((GAP,), (trial(2.0), trial(math.nan), trial(1.0), trial(1.5)), None, 0.0, ())
    assert study.extremes(STROKE) == (1.0, 2.0)
    nothing = RangeStudy((GAP,), (trial(math.nan),), None, 0.0, ()).extremes(STROKE)
    assert all(math.isnan(each) for each in nothing)


class Backwards:
    """Answers with a number that the values give, and in another order than it was asked."""

    def results(self, work: TrialWork, values: Iterable[tuple[float, ...]]) -> Iterator[Trial]:
        assert work.most_periods == 77
        for each in reversed(list(values)):
            stroke = 1e5 * each[0] + (each[1] if len(each) > 1 else 0.0)
            measures = tuple((asked, stroke) for asked in work.asked)
            yield Trial(each, MotionKind.PERIODIC, 1, measures)


def studied(*ranges: OpenRange, targets: tuple[Target, ...] = ()) -> RangeStudy:
    settings = DesignSettings(range_points=5, cell_periods=77)
    runner: Any = Backwards()
    return study_ranges(oscillator(), ranges, targets, settings, runner)


def test_values_lie_in_the_ranges_and_trials_in_their_order() -> None:
    target = Target("stroke_at_least", Measure.STROKE, "block", 4.5)
    study = studied(GAP, targets=(target,))
    assert [each.values[0] for each in study.trials] == pytest.approx([2e-5, 3e-5, 4e-5, 5e-5, 6e-5])
    assert (study.ranges, study.meeting) == ((GAP,), pytest.approx(0.4))
    assert study.doubt == pytest.approx(2 * 0.4 * 0.6)
    assert study.extremes(Asked(Measure.STROKE, "block")) == pytest.approx((2.0, 6.0))


def test_the_most_telling_range_stands_first() -> None:
    study = studied(FORCE, GAP)
    assert (study.meeting, study.doubt) == (None, 0.0)
    assert [each.range for each in study.narrowings] == [FORCE, GAP]  # 1 N counts 1e5 of the gap's 4e-5
    values = np.array([each.values for each in study.trials])
    assert values.min(axis=0) == pytest.approx([1 + 1 / 32, 2e-5 + 4e-5 / 32])
    assert values.max(axis=0) == pytest.approx([2 - 1 / 32, 6e-5 - 4e-5 / 32])
    assert [each.range for each in studied(GAP, FORCE).narrowings] == [GAP, FORCE]
