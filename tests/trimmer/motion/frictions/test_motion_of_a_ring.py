"""What a motion tells of frictions that share a force, and of those that were decided together."""

from __future__ import annotations

import pickle
from types import SimpleNamespace
from typing import Any

import control
import numpy as np
import pytest

from tests.trimmer.motion.hand_made_loop import ring_of_bodies
from trimmer import ClosedLoop, FrictionBacklash, simulate
from trimmer.motion.backlash_component import FREE, UPPER
from trimmer.motion.integration import new_log
from trimmer.motion.mode_tables import ModeTables
from trimmer.motion.motion import Motion, Outcome
from trimmer.motion.relay_component import HELD, PLUS
from trimmer.motion.switched_component import EventKind
from trimmer.motion.tables import TOGETHER

SLIDING, ALL = (FREE, PLUS, PLUS, PLUS, PLUS), (FREE, HELD, HELD, HELD, PLUS)


def half_sliding(*modes: tuple[int, ...]) -> Motion:
    """Return a second of motion of a ring that changes its mode after half of it; 1 N pushes."""
    tables = ModeTables(ring_of_bodies())
    numbers = [tables.number(each) for each in modes]
    state = np.array([0.0, 0, 0, 0.4, 0.4, 0.4, 2.0, 0.0, 0.0, 1.0])
    log = new_log(2, numbers[0], state)
    log.start[1], log.mode[1], log.state[1], log.event_function[1] = 0.5, numbers[1], state, TOGETHER
    for number in numbers:
        tables.tabulate(number)
    loop: Any = SimpleNamespace(modes=tables)
    return Motion(loop, 1.0, Outcome.COMPLETED, log)


def test_forces_of_a_ring_are_within_their_limits() -> None:
    motion = half_sliding(SLIDING, ALL)
    # All have the acceleration of 0.1 N on 6.5 kg. The third friction takes all it can, 0.7 N; so the first
    # one has the rest of what the first body passes on, and the second one what the second body needs less.
    acceleration = 0.1 / 6.5
    first = 1.0 - 0.5 * acceleration - 0.7
    held = [2.0, first, first - 2.0 * acceleration, 0.7, 0.9]
    assert abs(first) < 0.3
    sliding = [2.0, 0.3, 0.5, 0.7, 0.9]
    found = motion.component_outputs(np.array([[0.75], [0.25], [0.5]]))
    assert found.shape == (5, 3, 1)
    np.testing.assert_allclose(found[:, :, 0].T, [held, sliding, held], rtol=1e-9)
    assert motion.component_outputs(0.9) == pytest.approx(np.array(held), rel=1e-9)
    assert motion.component_outputs([0.1]).shape == (5, 1)


def test_what_was_decided_together_is_listed_by_the_modes() -> None:
    motion = half_sliding(SLIDING, (UPPER, HELD, PLUS, HELD, PLUS))
    found = [(each.time, each.component, each.before, each.after, each.kind) for each in motion._changes(1)]
    stick = EventKind.STICK
    assert found[1:] == [(0.5, 1, PLUS, HELD, stick), (0.5, 3, PLUS, HELD, stick)]
    assert [each.relay for each in motion._changes(1)][1:] == [True, True]
    tables = motion.loop.modes
    functions = tables.mode(tables.number(SLIDING)).event_functions
    for number, (owner, relay) in ((0, (0, False)), (2, (1, True))):
        motion.log.event_function[1] = number
        (change,) = motion._changes(1)
        assert (change.component, change.relay) == (owner, relay) == (functions[number].owner, relay)
        assert change.kind is functions[number].reached[0].transition.kind
        assert change.after == functions[number].reached[0].transition.target


def test_a_motion_that_was_pickled_is_the_same() -> None:
    system = control.ss([[0.0, 1.0], [-4.0, -0.1]], [[0.0], [1.0]], [[1.0, 0.0]], 0)
    motion = simulate(ClosedLoop(system, FrictionBacklash(0.5)), 3.0, initial_state=[0.0, 2.0])
    again = pickle.loads(pickle.dumps(motion))
    times = np.linspace(0.0, 3.0, 20)
    assert again.state(times).tolist() == motion.state(times).tolist()
    assert len(motion.events) > 1
    assert again.events == motion.events
    assert (again.duration, again.outcome) == (3.0, motion.outcome)
