"""Doubt and spread over ranges, with a runner that answers with numbers by hand."""

import math
from collections.abc import Callable, Iterable, Iterator
from typing import Any

import numpy as np
import pytest
from scipy.stats import qmc

from tests.trimmer.design.made import oscillator
from trimmer import MotionKind
from trimmer.design import DesignSettings, Measure, MeasureOfPart, OpenRange, RangeStudy, Target, Trial
from trimmer.design.trials.ranges import study_ranges
from trimmer.design.trials.trial import TrialWork

STROKE = MeasureOfPart(Measure.STROKE, "block")
TARGET = Target("stroke_at_least", Measure.STROKE, "block", 3.0)
GAP = OpenRange("stops.stop.gap", "m", 2e-5, 6e-5, False)
FORCE = OpenRange("frictions.blade.force", "N", 1.0, 2.0, True)


class Answers:
    """Gives every measure one number of the values, and in another order than it was asked."""

    def __init__(self, answer: Callable[..., float]) -> None:
        self.answer = answer

    def results(self, work: TrialWork, values: Iterable[tuple[float, ...]]) -> Iterator[Trial]:
        assert work.most_periods == 77
        for each in reversed(list(values)):
            measures = tuple((asked, self.answer(*each)) for asked in work.asked)
            yield Trial(each, MotionKind.PERIODIC, 1, measures)


def studied(
    answer: Callable[..., float], *ranges: OpenRange, points: int = 5, target: bool = False
) -> RangeStudy:
    settings = DesignSettings(range_points=points, cell_periods=77)
    runner: Any = Answers(answer)
    return study_ranges(oscillator(), ranges, (TARGET,) if target else (), settings, runner)


def by_place(*answers: float) -> Callable[[float], float]:
    """Answer at the evenly spaced points of the gap."""
    return lambda gap: answers[round((gap - 2e-5) / 1e-5)]


def test_one_range_is_looked_at_from_end_to_end_and_several_by_sobol() -> None:
    one = studied(lambda gap: 1e5 * gap, GAP)
    assert [each.values[0] for each in one.trials] == pytest.approx([2e-5, 3e-5, 4e-5, 5e-5, 6e-5])
    assert one.extremes(STROKE) == pytest.approx((2.0, 6.0))
    # 2^3 is the first power of two with five points, and one more power for each further range up to three.
    two = studied(lambda gap, force: force, GAP, FORCE)
    shares = qmc.Sobol(2, scramble=False).random_base2(4) + 1 / 32
    expected = np.array([2e-5, 1.0]) + shares * [4e-5, 1.0]
    np.testing.assert_allclose([each.values for each in two.trials], expected)
    counts = [len(studied(lambda *each: each[0], *(count * [GAP]), points=4).trials) for count in (2, 3, 4)]
    assert counts == [8, 16, 16]


@pytest.mark.parametrize(
    ("answers", "meeting", "doubt", "left", "spread"),
    [
        # Points lie in the quarters 1, 2, 3, 4 and 4.
        ((1, 2, 3, 4, 9), 0.6, 0.48, 0.0, 2 * 6.25 / (5 * np.var([1, 2, 3, 4, 9]))),
        ((1, 5, 5, 5, 1), 0.6, 0.48, 0.2, 2 * 4.0 / (5 * np.var([1, 5, 5, 5, 1]))),
        ((4, 4, 4, 4, 4), 1.0, 0.0, 0.0, 1.0),
        ((0, 0, 0, 0, 0), 0.0, 0.0, 0.0, 1.0),
        ((1, 2, 3, 4, math.inf), 0.6, 0.48, 0.0, 1.0),
    ],
)
def test_what_a_measurement_would_tell_is_counted_in_quarters(answers, meeting, doubt, left, spread) -> None:
    study = studied(by_place(*answers), GAP, target=True)
    assert (study.ranges, study.meeting, study.doubt) == (
        (GAP,),
        pytest.approx(meeting),
        pytest.approx(doubt),
    )
    (narrowing,) = study.narrowings
    assert (narrowing.range, narrowing.doubt) == (GAP, pytest.approx(left))
    assert narrowing.spread == pytest.approx(spread)


def test_the_most_telling_range_stands_first() -> None:
    for ranges in ((FORCE, GAP), (GAP, FORCE)):
        study = studied(lambda *each: max(each), *ranges)
        assert (study.meeting, study.doubt) == (None, 0.0)
        assert [each.range for each in study.narrowings] == [FORCE, GAP]
        assert study.narrowings[0].spread < 0.1 < 0.9 < study.narrowings[1].spread
        assert [each.doubt for each in study.narrowings] == [0.0, 0.0]


def test_extremes_pass_over_what_failed() -> None:
    study = studied(by_place(2.0, math.nan, 1.0, 1.5, math.nan), GAP)
    assert study.extremes(STROKE) == (1.0, 2.0)
    assert all(math.isnan(each) for each in studied(lambda gap: math.nan, GAP).extremes(STROKE))
