"""The verdict on motions made by hand: every reason for which it is less than sure."""

from __future__ import annotations

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


def test_targets_that_are_met_alone_are_sure() -> None:
    verdict = verdict_on(BOTH, found(GOOD), None)
    assert (verdict.outcome, verdict.sureness) == (DesignOutcome.MET, Sureness.SURE)
    assert [(each.target, each.met) for each in verdict.judged] == [(STROKE, True), (SPEED, True)]
    assert [each.value for each in verdict.judged] == pytest.approx([3e-3, 0.2])
    assert (verdict.otherwise, verdict.others_agree, verdict.missed) == (0.0, True, ())


def test_another_motion_that_is_judged_otherwise_leaves_it_open() -> None:
    other, alike = replace(SMALL, starts=1), replace(GOOD, starts=2)
    verdict = verdict_on(BOTH, found(GOOD, SMALL, alike, other), None)
    assert (verdict.outcome, verdict.sureness) == (DesignOutcome.DEPENDS, Sureness.UNSURE)
    assert verdict.otherwise == pytest.approx(0.4)
    assert not verdict.others_agree
    assert verdict_on(BOTH, found(SMALL, GOOD), None).otherwise == pytest.approx(0.4)


def test_other_motions_that_are_judged_alike_make_it_likely() -> None:
    verdict = verdict_on(BOTH, found(GOOD, replace(GOOD, starts=2)), None)
    assert (verdict.outcome, verdict.sureness, verdict.others_agree) == (
        DesignOutcome.MET,
        Sureness.LIKELY,
        True,
    )
    assert verdict.otherwise == 0.0


@pytest.mark.parametrize(
    ("changes", "lost", "sureness"),
    [
        ({"neighbour_agrees": True}, 0, Sureness.SURE),
        ({"neighbour_agrees": False}, 0, Sureness.LIKELY),
        ({}, 1, Sureness.LIKELY),
        ({"kind": MotionKind.CHAOTIC}, 0, Sureness.UNSURE),
        ({"neutral": True}, 0, Sureness.UNSURE),
    ],
)
def test_what_makes_it_less_sure(changes: dict[str, Any], lost: int, sureness: Sureness) -> None:
    verdict = verdict_on(BOTH, found(replace(GOOD, **changes), lost=lost), None)
    assert (verdict.outcome, verdict.sureness) == (DesignOutcome.MET, sureness)


def test_ranges_decide_where_they_leave_no_doubt() -> None:
    assert verdict_on(BOTH, found(GOOD), study(1.0, 0.0)).outcome is DesignOutcome.MET
    assert verdict_on(BOTH, found(GOOD), study(0.0, 0.0)).outcome is DesignOutcome.MISSED
    assert verdict_on(BOTH, found(SMALL), study(1.0, 0.0)).outcome is DesignOutcome.MET
    verdict = verdict_on(BOTH, found(GOOD), study(0.9, 0.18))
    assert (verdict.outcome, verdict.sureness, verdict.others_agree) == (
        DesignOutcome.DEPENDS,
        Sureness.UNSURE,
        True,
    )


def test_without_targets_or_motion_nothing_is_judged() -> None:
    for verdict in (
        verdict_on((), found(GOOD), None),
        verdict_on(BOTH, found(GOOD, first_failed=True), None),
        verdict_on(BOTH, found(), None),
    ):
        assert (verdict.sureness, verdict.judged) == (Sureness.UNSURE, ())
        assert (verdict.otherwise, verdict.others_agree) == (0.0, True)
    assert verdict_on((), found(GOOD), None).outcome is DesignOutcome.NO_TARGETS
    assert verdict_on(BOTH, found(GOOD, first_failed=True), None).outcome is DesignOutcome.OPEN
    assert verdict_on((), found(), None).outcome is DesignOutcome.NO_TARGETS


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
