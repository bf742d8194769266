"""Where what follows an event cannot be decided, and what an event that is decided counts as."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from trimmer.contact.advance import Ending, _kind, _Progress
from trimmer.contact.flow import ExactFlow
from trimmer.contact.integration import LONGEST_CASCADE
from trimmer.contact.statuses import (
    BACKWARD,
    FORWARD,
    NOTHING,
    PLUS,
    REVERSED,
    STICK,
    STICK_BEGUN,
    STICK_ENDED,
)
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Friction


def test_events_at_one_instant_count_from_the_second_on() -> None:
    progress: Any = SimpleNamespace(cascade=0, cascade_at=(-1, -1.0))
    for done, time in ((0, 0.5), (0, 0.25), (1, 0.25)):
        place: Any = SimpleNamespace(done=done, time=time)
        asked = [_Progress._is_finite(progress, place) for _ in range(LONGEST_CASCADE + 3)]
        assert asked == [True] * (LONGEST_CASCADE + 1) + [False] * 2


def sliding() -> ExactFlow:
    """A body of 2 kg that floor friction of 0.3 N brings to rest after 4 s."""
    friction = {"floor": Friction(("ground", "body"), 0.3)}
    return ExactFlow(Mechanism({"body": Body(2.0)}, frictions=friction, start={"body": (0.1, 0.6)}))


def no_decision(*_: object) -> None:
    raise ArithmeticError


@pytest.mark.parametrize(
    ("name", "replaced", "ending"),
    [
        ("_is_finite", lambda *_: False, Ending.CHATTERING),
        ("_decided", no_decision, Ending.UNDECIDED),
    ],
)
def test_a_motion_ends_where_it_cannot_be_decided(
    name: str, replaced: Any, ending: Ending, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_Progress, name, replaced)
    flow = sliding()
    course = flow.timed(flow.rest(), 9.0)
    assert course.ending is ending
    assert course.duration == pytest.approx(4.0, rel=1e-13)
    assert course.end.state == pytest.approx([1.3, 0.0], rel=1e-13, abs=1e-14)


def test_what_the_change_of_a_friction_counts_as() -> None:
    def kind(before: int, after: int) -> int:
        return _kind((PLUS, FORWARD, before), (PLUS, FORWARD, after), 2)

    assert kind(FORWARD, STICK) == kind(BACKWARD, STICK) == STICK_BEGUN
    assert kind(STICK, FORWARD) == kind(STICK, BACKWARD) == STICK_ENDED
    assert kind(FORWARD, BACKWARD) == kind(BACKWARD, FORWARD) == REVERSED
    assert _kind((STICK,), (STICK,), -1) == NOTHING
