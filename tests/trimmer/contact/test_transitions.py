"""What is known to be zero after an event: as many derivatives as the transition says, and no more."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.cases import trimmer
from trimmer.contact.flow import Course, ExactFlow
from trimmer.contact.statuses import CONTACT_BROKEN, CONTACT_MADE, STICK, STICK_BEGUN, STICK_ENDED
from trimmer.contact.transitions import transition
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Friction, Link, Pin

ZERO, CLEAR = 1e-10, 1e-6
"""Shares of the moduli of its terms below which a derivative vanishes, and above which it does not."""


def rubbing(static: float | None) -> Mechanism:
    """A body that sticks and slips twice a period."""
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=0.4 / (2 * np.pi),
        pins={"base": Pin("ground", 1.0)},
        links={"spring": Link(("base", "body"), 1.0)},
        frictions={"floor": Friction(("ground", "body"), 0.7, static)},
    )


def vanishing(course: Course, row: int, action: int, owner: int) -> int:
    """Count how many derivatives of an event function vanish at the start of a segment."""
    mode, state = course.modes[int(course.log.mode[row])], course.log.state[row]
    (function,) = (each for each in mode.functions if (each.owner, each.action) == (owner, action))
    rates, sizes = state, abs(state)
    for count in range(4):
        value, size = abs(function.row @ rates), abs(function.row) @ sizes
        if value > CLEAR * size:
            return count
        assert value <= ZERO * size
        rates, sizes = mode.flow @ rates, abs(mode.flow) @ abs(rates)
    raise AssertionError("all of them vanish")


def checked(course: Course) -> Counter[int]:
    """Hold each event that falls to zero smoothly against its transition; return how many of each kind."""
    log, seen = course.log, Counter[int]()
    for row in range(1, len(log.start)):
        if log.function[row] < 0 or log.start[row] == log.start[row - 1]:
            continue
        before = course.modes[int(log.mode[row - 1])]
        function = before.functions[int(log.function[row])]
        change = transition(course.modes.machine, before.statuses, function, False)
        assert change is not None
        if change.action >= 0:
            assert vanishing(course, row, change.action, function.owner) == change.zeros
            seen[change.kind] += 1
    return seen


@pytest.mark.parametrize("law", list(ContactLaw))
def test_contacts(law: ContactLaw) -> None:
    flow = ExactFlow(trimmer(law, friction=0.0))
    seen = checked(flow.course(flow.strobe(flow.rest(), 20).end, 2))
    assert min(seen[CONTACT_MADE], seen[CONTACT_BROKEN]) > 3


@pytest.mark.parametrize("static", [None, 0.8])
def test_the_end_of_stick(static: float | None) -> None:
    flow = ExactFlow(rubbing(static))
    seen = checked(flow.course(flow.strobe(flow.rest(), 20).end, 2))
    assert seen[STICK_ENDED] == 4
    assert seen[STICK_BEGUN] == 0


def test_a_drop_of_friction_is_decided_together_with_what_else_sticks() -> None:
    mechanism = rubbing(0.8)
    two = replace(
        mechanism,
        bodies={**mechanism.bodies, "other": Body(1.0)},
        frictions={**mechanism.frictions, "table": Friction(("ground", "other"), 0.1)},
    )
    modes = ExactFlow(two).modes
    mode = modes[modes.number((STICK, STICK))]
    assert [each.owner for each in mode.functions] == [0, 0, 1, 1]
    for each in mode.functions:
        change = transition(modes.machine, mode.statuses, each, False)
        assert (change is None) == (each.owner == 0)
        assert transition(modes.machine, mode.statuses, each, True) is None
