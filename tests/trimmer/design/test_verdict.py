"""The verdict on motions made by hand: every reason for which it is less than sure."""

from dataclasses import replace
from typing import Any

import pytest

from tests.trimmer.design.made import motion, output
from trimmer import MotionKind
from trimmer.design import (
    DesignOutcome,
    FoundMotion,
    JudgedTarget,
    Measure,
    Motions,
    RangeStudy,
    Sureness,
    Target,
)
from trimmer.design.verdict import verdict_on

STROKE = Target("stroke_at_least", Measure.STROKE, "stroke", 2.5e-3)
SPEED = Target("impact_speed_at_most", Measure.IMPACT_SPEED, "bridge", 0.25)
BOTH = (STROKE, SPEED)
GOOD, SMALL = motion(), motion(outputs={"stroke": output(0.0, 1e-3)}, starts=3)


def found(*motions: FoundMotion, **changes: Any) -> Motions:
    return replace(Motions(motions, 10, 0, 0, "", False), **changes)


def study(meeting: float | None, doubt: float) -> RangeStudy:
    return RangeStudy((), (), meeting, doubt, ())


MET, MISSED, DEPENDS = DesignOutcome.MET, DesignOutcome.MISSED, DesignOutcome.DEPENDS
ALIKE, OTHER = replace(GOOD, starts=2), replace(SMALL, starts=1)


@pytest.mark.parametrize(
    ("motions", "ranges", "outcome", "sureness", "agree", "otherwise"),
    [
        (found(GOOD), None, MET, Sureness.SURE, True, 0.0),
        (found(GOOD, ALIKE), None, MET, Sureness.LIKELY, True, 0.0),
        # Another motion that is judged otherwise leaves it open.
        (found(GOOD, SMALL, ALIKE, OTHER), None, DEPENDS, Sureness.UNSURE, False, 0.4),
        (found(SMALL, GOOD), None, DEPENDS, Sureness.UNSURE, False, 0.4),
        (found(GOOD, lost=1), None, MET, Sureness.LIKELY, True, 0.0),
        *(
            (found(replace(GOOD, **changes)), None, MET, sureness, True, 0.0)
            for changes, sureness in (
                ({"neighbour_agrees": True}, Sureness.SURE),
                ({"neighbour_agrees": False}, Sureness.LIKELY),
                ({"kind": MotionKind.CHAOTIC}, Sureness.UNSURE),
                ({"neutral": True}, Sureness.UNSURE),
            )
        ),
        # Ranges decide where they leave no doubt.
        (found(GOOD), study(1.0, 0.0), MET, Sureness.SURE, True, 0.0),
        (found(GOOD), study(0.0, 0.0), MISSED, Sureness.SURE, True, 0.0),
        (found(SMALL), study(1.0, 0.0), MET, Sureness.SURE, True, 0.0),
        (found(GOOD), study(0.9, 0.18), DEPENDS, Sureness.UNSURE, True, 0.0),
        (found(GOOD, first_failed=True), None, DesignOutcome.OPEN, Sureness.UNSURE, True, 0.0),
        (found(), None, DesignOutcome.OPEN, Sureness.UNSURE, True, 0.0),
    ],
)
def test_a_verdict_is_as_sure_as_motions_and_ranges_agree(
    motions: Motions,
    ranges: RangeStudy | None,
    outcome: DesignOutcome,
    sureness: Sureness,
    agree: bool,
    otherwise: float,
) -> None:
    verdict = verdict_on(BOTH, motions, ranges)
    assert (verdict.outcome, verdict.sureness, verdict.others_agree) == (outcome, sureness, agree)
    assert verdict.otherwise == pytest.approx(otherwise)
    without = verdict_on((), motions, None)
    assert (without.outcome, without.sureness) == (DesignOutcome.NO_TARGETS, Sureness.UNSURE)
    assert (without.judged, without.otherwise, without.others_agree) == ((), 0.0, True)
    if outcome is DesignOutcome.OPEN:
        assert verdict.judged == ()
    elif motions.first is GOOD:
        assert [(each.target, each.met) for each in verdict.judged] == [(STROKE, True), (SPEED, True)]
        assert [each.value for each in verdict.judged] == pytest.approx([3e-3, 0.2])
        assert verdict.missed == ()


def test_margins_are_shares_of_the_bound() -> None:
    assert JudgedTarget(STROKE, 2e-3, False).margin == pytest.approx(-0.2)
    assert JudgedTarget(SPEED, 0.2, True).margin == pytest.approx(0.2)
    nothing = replace(SPEED, bound=0.0)
    assert JudgedTarget(nothing, 0.0, True).margin == 0.0
    assert JudgedTarget(nothing, 0.1, False).margin == -float("inf")


def test_what_is_within_two_per_cent_of_its_bound_is_near() -> None:
    assert JudgedTarget(SPEED, 0.246, True).near
    assert JudgedTarget(SPEED, 0.254, False).near
    assert not JudgedTarget(SPEED, 0.244, True).near
    period = Target("only_drive_period", Measure.PERIOD, "", 1.0)
    assert not JudgedTarget(period, 1.0, True).near
    verdict = verdict_on(BOTH, found(motion(outputs={"stroke": output(0.0, 2.53e-3)})), None)
    assert (verdict.outcome, verdict.sureness) == (DesignOutcome.MET, Sureness.LIKELY)
