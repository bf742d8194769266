"""What frictions at rest do when one of them, with a static force, gives way: two bodies, by hand."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.contact.assembly import EventFunction
from trimmer.contact.joint import after_event, decide
from trimmer.contact.machine import machine_of
from trimmer.contact.statuses import AT_LIMIT, BACKWARD, FORWARD, FREE, STICK
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force, Friction, Stop

ALL = np.arange(3)
STICKING = (FREE, STICK, STICK, STICK)


def pushed(force: float):
    """One body of 1 kg is pushed, and rubs on another of 2 kg with 0.6 N, or 0.9 N from rest."""
    mechanism = Mechanism(
        {"one": Body(1.0), "two": Body(2.0)},
        stops={"far": Stop(("ground", "one"), 1.0, 0.0, 9.0)},
        frictions={
            "between": Friction(("two", "one"), 0.6, 0.9),
            "one on ground": Friction(("ground", "one"), 1.0),
            "two on ground": Friction(("ground", "two"), 0.8),
        },
        forces={"push": Force("one", force)},
    )
    machine, _ = machine_of(mechanism)
    return machine, np.array([0.0, 0.0, 0.0, 0.0, 1.0])


@pytest.mark.parametrize(("side", "there"), [(1.0, FORWARD), (-1.0, BACKWARD)])
def test_what_a_static_force_moves_stays_once_that_is_gone(side: float, there: int) -> None:
    # The static 0.9 N would move the second body against its 0.8 N, the kinetic 0.6 N do not.
    machine, state = pushed(3.0 * side)
    assert decide(machine, STICKING, state, ALL) == (FREE, there, there, STICK)
    # 1.7 N hold the first body: 0.9 N of the second and 0.8 N, or 1 N and 0.7 N.
    machine, state = pushed(1.7 * side)
    assert decide(machine, STICKING, state, ALL) == STICKING
    # What does not rest is not asked.
    machine, state = pushed(3.0 * side)
    assert decide(machine, (FREE, there, there, there), state, ALL[:0]) == (FREE, there, there, there)


@pytest.mark.parametrize(("sign", "there"), [(1, FORWARD), (-1, BACKWARD)])
def test_the_others_are_decided_where_one_gives_way(sign: int, there: int) -> None:
    limit = EventFunction(1, AT_LIMIT, np.zeros(5), (sign, 0, 0))
    machine, state = pushed(3.0 * sign)
    assert after_event(machine, STICKING, state, limit, False, ALL) == ((FREE, there, there, STICK), 1)
    machine, state = pushed(1.5 * sign)
    assert after_event(machine, STICKING, state, limit, False, ALL) == ((FREE, there, STICK, STICK), 1)
    # One that slides already is not asked.
    sliding = (FREE, STICK, there, STICK)
    assert after_event(machine, sliding, state, limit, False, ALL[[0, 2]]) == ((FREE, there, there, STICK), 1)
