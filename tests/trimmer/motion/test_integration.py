"""The integration of loops between calls of the compiled code: logs, limits, and relays decided together."""

from __future__ import annotations

from typing import Any

import control
import numpy as np
import pytest

from tests.trimmer.motion.hand_made_loop import ring_of_bodies
from trimmer import ClosedLoop, FrictionBacklash, Outcome, SimulationInterrupted, simulate
from trimmer.motion import integration
from trimmer.motion.backlash_component import FREE, UPPER
from trimmer.motion.integration import (
    IntegrationInterrupted,
    _all_at_rest,
    _decide_together,
    changes,
    integrate_on,
    new_log,
)
from trimmer.motion.kernel import EVENT_LIMIT, REACHED_END, STEP_LIMIT
from trimmer.motion.mode_tables import ModeTables
from trimmer.motion.relay_component import HELD, MINUS, PLUS
from trimmer.motion.switched_component import EventKind
from trimmer.motion.tables import TOGETHER, Log

SLIDING, ONE = (FREE, PLUS, PLUS, PLUS, PLUS), (FREE, HELD, PLUS, PLUS, PLUS)
ALL = (FREE, HELD, HELD, HELD, PLUS)


def function_of(modes: ModeTables, number: int, component: int) -> int:
    """Return the first event function of a component in a mode."""
    functions = modes.mode(number).event_functions
    return next(k for k, each in enumerate(functions) if each.reached[0].component == component)


def stopping(rows: int) -> tuple[ModeTables, Log]:
    """Return the log of a ring whose first friction begins to stick after half a second, and then the others.

    At that instant the bodies move with 0.4 m/s, and the last one is braked by a friction of 0.9 N.
    """
    modes = ModeTables(ring_of_bodies())
    numbers = [modes.number(each) for each in (SLIDING, ONE, ALL)]
    state = np.array([0.1, 0.2, 0.3, 0.4, 0.4, 0.4, 0.0, 0.0, 0.0, 1.0])
    log = new_log(rows, numbers[0], state)
    log.start[1:], log.mode[1:3], log.state[1:] = 0.5, numbers[1:], state
    log.event_function[1] = function_of(modes, numbers[0], 1)
    log.event_function[2] = function_of(modes, numbers[1], 2)
    log.jumped[3:], log.touches[3:], log.start[3:] = True, 7, 9.0
    return modes, log


def test_a_new_log() -> None:
    log = new_log(3, 5, np.array([0.25, 0.5]))
    assert log.start.tolist() == [0.0] * 3
    assert log.mode.tolist() == [5, 0, 0]
    assert log.state.tolist() == [[0.25, 0.5], [0.0, 0.0], [0.0, 0.0]]
    assert log.event_function.tolist() == [-1] * 3
    assert log.jumped.tolist() == [False] * 3
    assert log.touches.tolist() == [0] * 3
    longer = integration._longer(log)
    assert [len(each) for each in longer] == [6] * 6
    assert longer.mode.tolist() == [5, *[0] * 5]
    short = integration.shortened(log, 1)
    assert [len(each) for each in short] == [2] * 6
    assert not np.shares_memory(short.state, log.state)


def test_what_changed_at_an_event() -> None:
    modes, log = stopping(4)
    assert [(each.component, each.transition.kind) for each in changes(modes, log, 1)] == [
        (1, EventKind.STICK)
    ]
    # That the second one sticks too means that the third one does.
    assert [each.component for each in changes(modes, log, 2)] == [2, 3]
    log.jumped[2] = True
    assert [(each.component, each.transition.kind) for each in changes(modes, log, 2)] == [
        (2, EventKind.SWITCH)
    ]


def test_relays_are_decided_together_in_two_segments_after_the_first() -> None:
    modes, log = stopping(5)
    log.state[2, 3:6] = 0.4, np.nextafter(0.4, 0.0), np.nextafter(0.4, 1.0)
    assert _decide_together(modes, log, 2) == 3
    held = modes.number(ALL)
    assert log.start.tolist() == [0.0, 0.5, 0.5, 0.5, 9.0]
    assert log.mode[1:4].tolist() == [modes.number(ONE), held, held]
    assert log.event_function[2:4].tolist() == [TOGETHER, TOGETHER]
    assert log.jumped[2:].tolist() == [False, False, True]
    assert log.touches[2:].tolist() == [0, 0, 7]
    assert modes.tables.known[held]
    # They have one velocity, that of their momentum.
    assert log.state[2].tolist() == log.state[3].tolist()
    assert len(set(log.state[3, 3:6].tolist())) == 1
    assert log.state[3, 3:6] == pytest.approx([0.4] * 3, rel=1e-15)
    assert log.state[3, :3].tolist() == [0.1, 0.2, 0.3]


def test_what_other_components_did_is_kept() -> None:
    modes, log = stopping(6)
    contact = modes.number((UPPER, *ALL[1:]))
    log.start[3], log.mode[3], log.jumped[3] = 0.5, contact, False
    log.event_function[3] = function_of(modes, modes.number(ALL), 0)
    assert _decide_together(modes, log, 3) == 5
    assert log.mode[2:].tolist() == [modes.number(ALL), contact, contact, contact]
    assert log.event_function[4:].tolist() == [TOGETHER, TOGETHER]


def test_events_of_earlier_instants_have_no_say() -> None:
    modes, later = stopping(4)
    turned = [modes.number((*each[:4], MINUS)) for each in (SLIDING, ONE, ALL)]
    log = new_log(6, modes.number(SLIDING), later.state[0])
    log.start[1:], log.mode[1:4], log.state[1:] = (0.25, *[0.5] * 4), turned, later.state[0]
    log.event_function[1] = function_of(modes, modes.number(SLIDING), 4)
    log.jumped[1] = True
    log.event_function[2] = function_of(modes, turned[0], 1)
    log.event_function[3] = function_of(modes, turned[1], 2)
    assert [each.component for each in changes(modes, log, 1)] == [4]
    assert _decide_together(modes, log, 3) == 4
    assert modes.component_modes(int(log.mode[4])) == (FREE, HELD, HELD, HELD, MINUS)
    # At the start there is no event before the first one; what was decided before is kept.
    log.start[:] = 0.0
    assert _decide_together(modes, log, 3) == 5


def test_what_was_decided_together_is_kept_but_not_for_ever() -> None:
    modes, log = stopping(24)
    log.start[:], log.mode[3:], log.jumped[3:] = 0.5, modes.number(ALL), False
    log.event_function[3:] = TOGETHER
    assert _decide_together(modes, log, 3 + 14) == 3 + 14 + 2
    log.event_function[3:] = TOGETHER
    assert _decide_together(modes, log, 3 + 15) is None
    # Those of other instants do not count.
    log.start[:10] = 0.25
    assert _decide_together(modes, log, 3 + 15) == 3 + 15 + 2


def test_where_outputs_drive_nothing_is_decided_together() -> None:
    modes = ModeTables(ring_of_bodies(sign=1.0))
    number = modes.number(SLIDING)
    assert _all_at_rest(modes, number, set()) == ()
    log = new_log(5, number, np.array([0.0] * 9 + [1.0]))
    log.mode[1], log.event_function[1] = number, function_of(modes, number, 1)
    assert _decide_together(modes, log, 1) is None


def test_those_at_rest_with_what_follows() -> None:
    modes = ModeTables(ring_of_bodies())
    assert _all_at_rest(modes, modes.number(SLIDING), {1}) == (1,)
    assert _all_at_rest(modes, modes.number(SLIDING), {3, 1}) == (1, 2, 3)
    assert _all_at_rest(modes, modes.number((UPPER, PLUS, HELD, MINUS, HELD)), {1}) == (1, 2, 3, 4)


def swinging() -> tuple[ModeTables, Log, float]:
    """Return an oscillator with a gap that is never taken up, and the length of its steps."""
    system = control.ss([[0.0, 1.0], [-4.0, 0.0]], [[0.0], [1.0]], [[1.0, 0.0]], 0)
    modes = ClosedLoop(system, FrictionBacklash(100.0)).modes
    modes.tabulate(0)
    return modes, new_log(2, 0, np.array([1.0, 0, 0, 0, 0, 1.0])), float(modes.tables.step[0])


@pytest.mark.parametrize("at_once", [2, 4, 5, 6])
def test_steps_add_up_over_calls(at_once: int, monkeypatch: pytest.MonkeyPatch) -> None:
    bars = []

    class Bar:
        def __init__(self, **options: Any) -> None:
            self.n, self.options, self.closed = 0.0, options, False
            bars.append(self)

        def update(self, more: float) -> None:
            self.n += more

        def close(self) -> None:
            self.closed = True

    monkeypatch.setattr(integration, "AT_ONCE", at_once)
    monkeypatch.setattr(integration, "progress_bar", Bar)
    modes, log, step = swinging()
    reason, log, reached = integrate_on(modes, log, 99.0, 10, most_steps=5)
    assert (reason, len(log.start)) == (STEP_LIMIT, 1)
    assert reached == pytest.approx(5 * step, rel=1e-14)
    assert len(bars) == (at_once < 5)
    for bar in bars:
        assert bar.options == {"description": "simulate", "total": 99.0, "unit": "s", "unit_scale": True}
        assert bar.closed
        assert bar.n == pytest.approx(at_once * (4 // at_once) * step, rel=1e-14)


def test_an_integration_ends_at_its_limits_and_its_log_grows() -> None:
    modes, log, step = swinging()
    assert integrate_on(modes, log, 3.5 * step, 10)[::2] == (REACHED_END, 3.5 * step)
    system = control.ss([[0.0, 1.0], [-4.0, 0.0]], [[0.0], [0.1]], [[1.0, 0.0]], 0)
    modes = ClosedLoop(system, FrictionBacklash(0.5)).modes
    start = np.array([0.0, 2.0, 0, 0, 0, 1.0])
    reason, log, _ = integrate_on(modes, new_log(2, 0, start), 99.0, 7)
    # One event more than this would be the eighth segment.
    assert (reason, len(log.start)) == (EVENT_LIMIT, 7)
    assert (np.diff(log.start) > 0).all()


def test_an_interrupt_tells_what_was_reached(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(tables: Any, log: Log, segment: int, end: float, limits: Any, pause: Any) -> None:
        pause.segment[0], pause.reached[0] = 1, 0.25
        raise KeyboardInterrupt

    modes, log, _ = swinging()
    monkeypatch.setattr(integration, "integrate", interrupted)
    with pytest.raises(IntegrationInterrupted, match="the integration was interrupted") as error:
        integrate_on(modes, integration._longer(log), 9.0, 10)
    assert error.value.reached == 0.25
    assert [len(each) for each in error.value.log] == [2] * 6
    system = control.ss([[0.0, 1.0], [-4.0, 0.0]], [[0.0], [1.0]], [[1.0, 0.0]], 0)
    with pytest.raises(SimulationInterrupted) as interrupt:
        simulate(ClosedLoop(system, FrictionBacklash(100.0)), 9.0)
    assert str(interrupt.value) == "interrupted after 0.25 s of the motion"
    motion = interrupt.value.motion
    assert (motion.outcome, motion.duration, len(motion.log.start)) == (Outcome.INTERRUPTED, 0.25, 2)
