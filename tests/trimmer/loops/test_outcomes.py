"""How a motion can end, and what can be odd about it: each case has its documented outcome."""

import math
import time

import control
import numpy as np
import pytest

from trimmer import CoulombFriction, FrictionBacklash, InertiaBacklash, Motion, Relay, simulate
from trimmer.elements import Element, ViscousBacklash
from trimmer.loops import BodyFriction, ClosedLoop, Drive, EventKind, OpenLoop, Outcome, TrimmerLoop
from trimmer.thesis import Displacement, TrimmerBody, TrimmerParameters

THESIS = TrimmerParameters.thesis()
AMPLITUDE, OMEGA = 1.5e-3, 2 * math.pi * 110
DRIVE = Drive(AMPLITUDE, OMEGA)
MASS = control.tf([1.0], [1.0, 0.0, 0.0])
OSCILLATOR = control.ss(control.tf([1.0], [1.0, 0.2, 1.0]))
BLADES = Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD)


def with_friction(force: float, *between: Displacement, element: Element | None = None) -> Motion:
    frictions = tuple(BodyFriction(each, CoulombFriction(force)) for each in between or (BLADES,))
    return simulate(TrimmerLoop(THESIS, element, DRIVE, frictions=frictions), 0.05)


def test_friction_ends_in_sticking_for_ever() -> None:
    loop = TrimmerLoop(THESIS, None, Drive(0.0, 1.0), frictions=(BodyFriction(BLADES, CoulombFriction(5.0)),))
    motion = simulate(loop, 1.0, impulse=1e-3)
    last = motion.events[-1]
    assert motion.outcome is Outcome.COMPLETED
    assert (last.kind, last.mode) == (EventKind.STICK, "held")
    times = np.linspace(last.time, 1.0, 200)
    states = motion.state(times)
    between = states[1] - states[3]
    assert abs(between - between[0]).max() < 1e-10 * abs(states[1]).max()
    assert abs(motion.component_outputs(times)[1]).max() <= 5.0


@pytest.mark.parametrize("force", [1e4, 1e12, 1e300])
def test_nothing_moves_under_a_friction_that_is_too_large(force: float) -> None:
    everything = tuple(Displacement(body) for body in TrimmerBody)
    motion = with_friction(force, *everything, element=FrictionBacklash(2e-4))
    times = np.linspace(0.0, 0.05, 100)
    assert motion.outcome is Outcome.COMPLETED
    assert abs(motion.state(times)[:4]).max() < 1e-15
    assert {event.component for event in motion.events} == {"backlash"}


@pytest.mark.parametrize("force", [1e-12, 1e-300])
def test_a_vanishing_friction_tends_to_none(force: float) -> None:
    times = np.linspace(0.0, 0.05, 100)
    free = simulate(TrimmerLoop(THESIS, None, DRIVE), 0.05).state(times)[:4]
    assert with_friction(force).state(times)[:4] == pytest.approx(free, abs=1e-10 * abs(free).max())


@pytest.mark.parametrize("tau", [0.0, 1e-3, math.inf])
def test_a_drive_below_half_the_gap_moves_nothing(tau: float) -> None:
    loop = TrimmerLoop(THESIS, ViscousBacklash(2.0001 * AMPLITUDE, tau), DRIVE)
    motion = simulate(loop, 0.1)
    assert motion.outcome is Outcome.COMPLETED
    assert motion.events == ()
    assert not motion.state([0.0, 0.05, 0.1]).any()


@pytest.mark.parametrize("element", [FrictionBacklash(1.0), ViscousBacklash(1.0, 0.3), InertiaBacklash(1.0)])
@pytest.mark.parametrize("excess", [-1e-15, 0.0, 1e-15, 1e-9])
def test_grazing_contact_gives_no_more_than_its_push(element: Element, excess: float) -> None:
    motion = simulate(OpenLoop(OSCILLATOR, element, Drive(0.5 * (1 + excess), 1.0)), 4.5)
    assert motion.outcome is Outcome.COMPLETED
    assert len(motion.events) == (2 if excess > 0 else 0)
    assert motion.touches == (excess <= 0)
    pushed = abs(motion.element_output(np.linspace(0.0, 4.5, 500))).max()
    rounding = 1e-14
    if isinstance(element, FrictionBacklash):
        assert pushed == pytest.approx(0.5 * max(excess, 0.0), rel=1e-2, abs=rounding)
    else:  # The pin's velocity at the impact, sqrt(2 excess) / 2, for at most 3 s.
        assert pushed <= 3.0 * math.sqrt(max(excess, 0.0)) + rounding


def test_grazing_in_a_closed_loop_pushes_nothing() -> None:
    # The pin moves as -sin t and so comes to the lower side, at -gap / 2, with velocity zero.
    system = control.ss([[0.0, 1.0], [-1.0, 0.0]], [[0.0], [1e-9]], [[1.0, 0.0]], 0)
    motion = simulate(ClosedLoop(system, FrictionBacklash(2.0)), 3.0, initial_state=[0.0, 1.0])
    assert motion.outcome is Outcome.COMPLETED
    assert [event.kind for event in motion.events] in ([], [EventKind.IMPACT, EventKind.SEPARATION])
    assert abs(motion.element_output(np.linspace(0.0, 3.0, 100))).max() < 1e-12


@pytest.mark.parametrize(
    ("tau", "limit", "apart"),
    [
        *((tau, FrictionBacklash(4e-5), 1e-3 * min(1, tau / 1e-9) + 1e-11) for tau in (1e-300, 1e-15, 1e-9)),
        *((tau, InertiaBacklash(4e-5), 1e-7) for tau in (1e9, 1e308)),
    ],
)
def test_a_tiny_or_huge_time_constant_tends_to_friction_or_inertia(tau, limit: Element, apart: float) -> None:
    viscous, known = (
        simulate(TrimmerLoop(THESIS, element), 0.02, impulse=1e-6)
        for element in (ViscousBacklash(4e-5, tau), limit)
    )
    assert len(viscous.events) == len(known.events) > 20
    assert viscous.event_times == pytest.approx(known.event_times, rel=apart, abs=1e-15)


def test_an_unstable_loop_diverges_and_says_so() -> None:
    motion = simulate(ClosedLoop(control.tf([1.0], [1, -3, 1]), FrictionBacklash(1.0)), 1e4, impulse=10.0)
    assert motion.outcome is Outcome.DIVERGED
    assert motion.duration < 1e4
    state = motion.state(motion.duration)
    assert 1e140 < abs(state).max() <= 1e151
    assert np.isfinite(motion.state(np.linspace(0.0, motion.duration, 100))).all()


def test_the_event_limit_is_the_number_of_events() -> None:
    loop = TrimmerLoop(THESIS, FrictionBacklash(4e-5))
    whole, limited = simulate(loop, 0.1, impulse=1e-6), simulate(loop, 0.1, impulse=1e-6, event_limit=7)
    assert limited.outcome is Outcome.EVENT_LIMIT
    assert limited.events == whole.events[:7]
    assert limited.duration == pytest.approx(whole.events[7].time, rel=1e-15)


def test_the_step_limit_ends_a_motion_that_is_too_long() -> None:
    loop = TrimmerLoop(THESIS, FrictionBacklash(4.0), DRIVE)
    begin = time.process_time()
    motion = simulate(loop, 1e30, step_limit=1000)
    assert motion.outcome is Outcome.STEP_LIMIT
    assert 0 < motion.duration < 1e3
    assert time.process_time() - begin < 60


def test_zeno_is_reported_where_it_happens() -> None:
    """The twisting controller y'' = -2 sign(y) - sign(y') stops after 1 + 2/sqrt(3) s (Levant 1993)."""
    motion = simulate(ClosedLoop(MASS, Relay(2.0) + CoulombFriction(1.0)), 20.0, impulse=1.0)
    assert motion.outcome is Outcome.CHATTERING
    assert motion.duration == pytest.approx(1 + 2 / math.sqrt(3), rel=1e-14)
    speed, expected, now = 1.0, [], 0.0
    for _ in range(20):  # It slows down at 3, and comes back at 1, which leaves 1/sqrt(3) of the speed.
        now += speed / 3
        expected.append(now)
        speed /= math.sqrt(3)
        now += speed
        expected.append(now)
    assert motion.event_times[:40] == pytest.approx(expected, rel=1e-13)
    assert abs(motion.state(motion.duration)).max() < 1e-14


def test_swings_that_only_grow_shorter_are_not_called_zeno() -> None:
    """A damped mass under a relay switches for ever, after about 1.5 ln n s, and never at one instant."""
    system = control.tf([1.0], [1.0, 2.0, 1.0])
    motion = simulate(ClosedLoop(system, Relay(1.0)), 100.0, impulse=1.0, event_limit=4000)
    assert motion.outcome is Outcome.EVENT_LIMIT
    times = motion.event_times
    assert times[3999] - times[1999] == pytest.approx(1.5 * math.log(2), rel=2e-3)


@pytest.mark.parametrize("tau", [0.0, 1e-3])
@pytest.mark.parametrize("share", [1e-17, 1e-16, 1e-15, 1e-14, 0.8e-13])
def test_a_gap_below_rounding_is_reported(share: float, tau: float) -> None:
    """Where the pin has gone so far, at its first separation, and not where rounding first repeats events."""
    motion = simulate(TrimmerLoop(THESIS, ViscousBacklash(share * AMPLITUDE, tau), DRIVE), 0.1)
    assert motion.outcome is Outcome.UNRESOLVED
    assert not motion.success
    assert abs(motion.element_input(motion.duration)) > 1e13 * share * AMPLITUDE
    assert [event.kind for event in motion.events[:-1]] == [EventKind.IMPACT]
    assert motion.events[-1].kind is EventKind.SEPARATION


@pytest.mark.parametrize(
    ("share", "tau"), [(1.01e-13, 0.0), (1.01e-13, 1e-3), (1e-13, math.inf), (1e-17, math.inf)]
)
def test_a_gap_above_rounding_moves_as_a_rigid_pin(share: float, tau: float) -> None:
    """A load without drag leaves the pin in the middle of its way, where no gap is too small."""
    times = np.linspace(0.0, 0.1, 300)
    rigid = simulate(TrimmerLoop(THESIS, None, DRIVE), 0.1).state(times)[:4]
    motion = simulate(TrimmerLoop(THESIS, ViscousBacklash(share * AMPLITUDE, tau), DRIVE), 0.1)
    assert motion.outcome is Outcome.COMPLETED
    assert motion.state(times)[:4] == pytest.approx(rigid, abs=1e-10 * abs(rigid).max())


def test_simultaneous_events_are_one_instant() -> None:
    third_order = control.tf([1.0], [1.0, 3.0, 3.0, 1.0])
    one, two = (
        simulate(ClosedLoop(third_order, element), 10.0, impulse=1.0)
        for element in (Relay(3.0), Relay(1.0) + Relay(2.0))
    )
    assert len(one.events) > 4
    assert len(two.events) == 2 * len(one.events)
    for each in (0, 1):
        assert two.event_times[each::2] == pytest.approx(one.event_times, rel=1e-13)
    assert [event.mode for event in two.events] == [event.mode for event in one.events for _ in (0, 1)]
