"""Any linear system with an element, closed or driven, against `solve_ivp`; with direct feedthrough too."""

import math

import control
import numpy as np
import pytest

from tests.quick import quick
from tests.trimmer.loops.reference.peers import Course, Plant, pieces, play, switch
from trimmer import InertiaBacklash, Relay, Saturation, ViscousBacklash, ViscousFriction, simulate
from trimmer.elements import CoulombFriction, DeadZone, Element, FrictionBacklash
from trimmer.loops import ClosedLoop, Drive, OpenLoop, Outcome

DRIVE = (1.3, 1.1, 0.4)
GAP, LEVEL = 1.0, 0.7
BACKLASHES = [
    (FrictionBacklash(GAP), 0.0),
    (ViscousBacklash(GAP, 0.05), 0.05),
    (ViscousBacklash(GAP, 2.0), 2.0),
    (InertiaBacklash(GAP), math.inf),
]
THIRD_ORDER = control.ss(control.tf([4.0], [1.0, 1.3, 3.0, 1.0]))
SECOND_ORDER = control.ss(control.tf([2.0], [1.0, 0.4, 3.0]))
WITH_ZERO = control.ss(control.tf([2.0, 1.0], [1.0, 0.4, 3.0]))


def plant(system: control.StateSpace, drive: tuple[float, float, float] | None) -> Plant:
    return Plant(system.A, system.B[:, 0], system.C[0], drive)


def with_pin_in_the_middle(system: control.StateSpace) -> np.ndarray:
    """Return a moving state in which y is zero."""
    state, row = np.array([1.5, -1.0, 0.3])[: system.nstates], system.C[0]
    return np.asarray(state - row * (row @ state) / (row @ row))


def compare(
    system: control.StateSpace,
    element: Element,
    drive: tuple[float, float, float] | None,
    start: np.ndarray,
    course: Course,
    end: float,
) -> None:
    """Compare instants and states; the peer is right to about 1e-10."""
    loop = OpenLoop(system, element, Drive(*drive)) if drive else ClosedLoop(system, element)
    motion = simulate(loop, end, initial_state=start)
    assert motion.outcome is Outcome.COMPLETED
    assert len(course.events) >= 3
    instants = np.unique(motion.event_times)
    assert instants == pytest.approx(course.events, abs=1e-8)
    times = np.linspace(0.0, end, 60)
    expected = np.array([course.state(time, len(start)) for time in times]).T
    assert motion.state(times) == pytest.approx(expected, abs=1e-8)


@pytest.mark.parametrize(("element", "tau"), BACKLASHES)
@pytest.mark.parametrize("system", quick([THIRD_ORDER, WITH_ZERO], 1))
@pytest.mark.parametrize("drive", [None, (*DRIVE[:2], 0.0)])
def test_backlash(element, tau, system, drive) -> None:
    start = with_pin_in_the_middle(system)
    course = play(plant(system, drive), GAP, tau, start, 6.0)
    compare(system, element, drive, start, course, 6.0)


@pytest.mark.parametrize("system", quick([THIRD_ORDER, SECOND_ORDER, WITH_ZERO], 0, 2))
@pytest.mark.parametrize("drive", [None, DRIVE])
def test_relay(system: control.StateSpace, drive: tuple[float, float, float] | None) -> None:
    start = np.array([0.4, 1.9, -0.3])[: system.nstates]
    course = switch(plant(system, drive), LEVEL, False, start, 12.0)
    compare(system, Relay(LEVEL), drive, start, course, 12.0)


@pytest.mark.parametrize("system", [THIRD_ORDER, SECOND_ORDER])
@pytest.mark.parametrize("drive", [None, DRIVE])
def test_coulomb_friction(system: control.StateSpace, drive: tuple[float, float, float] | None) -> None:
    start = np.array([3.5, 0.3, -0.6])[: system.nstates]
    course = switch(plant(system, drive), LEVEL, True, start, 8.0)
    compare(system, CoulombFriction(LEVEL), drive, start, course, 8.0)


PIECES = [
    (Relay(LEVEL, hysteresis=0.2), (0.0,), (lambda u: -LEVEL, lambda u: LEVEL), 0.2),
    (Saturation(0.3), (-0.3, 0.3), (lambda u: -0.3, lambda u: u, lambda u: 0.3), 0.0),
    (
        DeadZone(0.3) + Relay(LEVEL),
        (-0.3, 0.0, 0.3),
        (lambda u: u + 0.3 - LEVEL, lambda u: -LEVEL, lambda u: LEVEL, lambda u: u - 0.3 + LEVEL),
        0.0,
    ),
]


@pytest.mark.parametrize(("element", "limits", "laws", "hysteresis"), PIECES)
@pytest.mark.parametrize("drive", [None, (*DRIVE[:2], 0.1)])
def test_elements_by_pieces(element: Element, limits, laws, hysteresis: float, drive) -> None:
    start = with_pin_in_the_middle(THIRD_ORDER) - 0.005 * THIRD_ORDER.C[0]
    course = pieces(plant(THIRD_ORDER, drive), limits, laws, hysteresis, start, 12.0)
    compare(THIRD_ORDER, element, drive, start, course, 12.0)


def test_viscous_friction_is_damping() -> None:
    motion = simulate(ClosedLoop(SECOND_ORDER, ViscousFriction(0.9)), 8.0, initial_state=[1.0, 0.0])
    damped = control.ss(control.tf([2.0], [1.0, 0.4 + 2.0 * 0.9, 3.0]))
    times = np.linspace(0.0, 8.0, 60)
    rate = SECOND_ORDER.C[0] @ SECOND_ORDER.A @ [1.0, 0.0]
    start = np.linalg.solve(np.vstack([damped.C, damped.C @ damped.A]), [SECOND_ORDER.C[0, 0], rate])
    response = control.initial_response(damped, times, start)
    assert motion.output(times) == pytest.approx(response.outputs, abs=1e-12)


PUSH = Drive(0.3, 2.0 * math.pi)
TIMES = np.linspace(0.0, 3.0, 301)


def system(direct: float) -> control.StateSpace:
    """Two damped modes beside what passes at once."""
    A = np.array([[0.0, 1.0, 0.0], [-30.0, -0.8, 0.0], [0.0, 0.0, -2.0]])
    return control.ss(A, [[0.0], [5.0], [1.0]], [[1.0, 0.1, -0.4]], [[direct]])


@pytest.mark.parametrize("element", [2.0 * FrictionBacklash(0.1), ViscousBacklash(0.1, 0.05)])
def test_a_driven_system_adds_the_element_output_times_d(element: Element) -> None:
    """The element follows the drive alone, so the outputs differ by D times its output."""
    motions = [simulate(OpenLoop(system(d), element, PUSH), 3.0) for d in (0.0, 0.7)]
    added = motions[1].output(TIMES) - motions[0].output(TIMES)
    passed = motions[1].element_output(TIMES)
    assert np.ptp(passed) > 0.1
    assert added == pytest.approx(0.7 * passed, abs=1e-12)
    assert motions[1].state(TIMES) == pytest.approx(motions[0].state(TIMES), abs=1e-12)
