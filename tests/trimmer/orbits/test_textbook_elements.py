"""Motion and orbits with saturation, dead zone, preload and relays with thresholds, beside other ways."""

import control
import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
import scipy.optimize

from trimmer import harmonic_balance, multi_harmonic_balance, periodic_orbits, simulate
from trimmer.elements import DeadZone, Element, Preload, Relay, Saturation, ScaledElement
from trimmer.errors import UnsupportedMotionError
from trimmer.loops import ClosedLoop, Drive, OpenLoop, Outcome

THIRD_ORDER = control.tf([60.0], [1.0, 3.0, 3.0, 1.0])
WITH_INTEGRATOR = control.tf([10.0], [1.0, 2.0, 1.0, 0.0])
ELEMENTS = (
    Saturation(1.0, 0.8),
    DeadZone(1.0, 0.8),
    Relay(1.0, hysteresis=0.1),
    Relay(1.0, dead_zone=0.2),
    Relay(1.0, hysteresis=0.1, dead_zone=0.2),
    Relay(1.0, hysteresis=0.3, dead_zone=0.2),
    Preload(0.5, 0.01),
)


def stepped(element: Element, given: np.ndarray) -> np.ndarray:
    """Return the output for samples of the input, from the definitions; a relay begins silent or positive."""
    match element:
        case Saturation(threshold, slope):
            return slope * np.clip(given, -threshold, threshold)
        case DeadZone(threshold, slope):
            return slope * (given - np.clip(given, -threshold, threshold))
        case Preload(level, slope):
            return slope * given + level * np.sign(given)
        case Relay(level, hysteresis, dead_zone):
            on, off = dead_zone + hysteresis, dead_zone - hysteresis
            state, outputs = 0 if dead_zone else 1, []
            for x in given:
                # Leave first; then enter.
                if (state == 1 and x < off) or (state == -1 and x > -off):
                    state = 0 if dead_zone else -state
                if x > on:
                    state = 1
                elif x < -on:
                    state = -1
                outputs.append(state * level)
            return np.array(outputs, dtype=float)
    raise AssertionError


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
def test_a_driven_element_is_that_of_its_definition(element: Element) -> None:
    """The output of 1/(s + 1) behind the element, beside a sum over a fine grid."""
    drive = Drive(1.7, omega=2.0, phase=0.3)
    motion = simulate(OpenLoop(control.tf([1.0], [1.0, 1.0]), element, drive), 8.0)
    assert motion.outcome is Outcome.COMPLETED
    times = np.linspace(0.0, 8.0, 160_001)
    middles = 0.5 * (times[:-1] + times[1:])
    outputs = stepped(element, 1.7 * np.sin(2.0 * middles + 0.3))
    step = times[1]
    decay = np.exp(-step)
    state, states = 0.0, [0.0]
    for output in outputs:
        state = decay * state + (1.0 - decay) * output
        states.append(state)
    assert motion.output(times[::4000]) == pytest.approx(np.array(states)[::4000], abs=2e-4)


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
@pytest.mark.parametrize("system", [THIRD_ORDER, WITH_INTEGRATOR], ids=["lags", "integrator"])
@pytest.mark.filterwarnings("ignore::trimmer.errors.OrbitNotFoundWarning")
def test_harmonic_balance_is_certain_and_near_the_exact_orbit(system: control.LTI, element: Element) -> None:
    balance = harmonic_balance(system, element)
    assert balance.certificate.complete
    (largest,) = [cycle for cycle in balance.limit_cycles if cycle.amplitude > 0.5][:1]
    orbits = periodic_orbits(system, element, balance)
    nearest = min(orbits, key=lambda orbit: abs(orbit.amplitude - largest.amplitude))
    assert nearest.amplitude == pytest.approx(largest.amplitude, rel=0.04)
    assert 2.0 * np.pi / nearest.period == pytest.approx(largest.omega, rel=0.07)
    assert nearest.stable == largest.stable


@pytest.mark.slow
def test_an_orbit_with_saturation_is_that_of_an_adaptive_integrator() -> None:
    """The loop is followed by scipy.integrate from far away; its last periods are measured by events."""
    A, B, C = (np.asarray(getattr(control.ss(THIRD_ORDER), part)) for part in "ABC")

    def rate(time: float, x: np.ndarray) -> np.ndarray:
        return A @ x + B[:, 0] * np.clip(-(C @ x)[0], -1.0, 1.0)

    def rising(time: float, x: np.ndarray) -> float:
        return float((C @ x)[0])

    rising.direction = 1.0  # type: ignore[attr-defined]
    solved = scipy.integrate.solve_ivp(
        rate,
        (0.0, 80.0),
        [1.0, 0.0, 0.0],
        rtol=1e-9,
        atol=1e-11,
        events=rising,
        dense_output=True,
        max_step=0.2,
    )
    begin, end = solved.t_events[0][-2:]
    largest = np.abs(C @ solved.sol(np.linspace(begin, end, 4001))).max()
    (orbit,) = periodic_orbits(THIRD_ORDER, Saturation(1.0))
    assert orbit.period == pytest.approx(end - begin, rel=1e-6)
    assert orbit.amplitude == pytest.approx(largest, rel=1e-5)


@pytest.mark.parametrize("hysteresis", [0.05, 0.4])
def test_an_orbit_with_hysteresis_is_that_of_tsypkin(hysteresis: float) -> None:
    """The half period solves c tanh(A T/2) A^-1 b L = h (Tsypkin 1984), here by SciPy."""
    model = control.ss(THIRD_ORDER)

    def miss(half: float) -> float:
        start = scipy.linalg.solve(model.A, scipy.linalg.tanhm(0.5 * half * model.A) @ model.B[:, 0])
        return float(model.C[0] @ start) - hysteresis

    half = scipy.optimize.brentq(miss, 0.5, 6.0, xtol=1e-14)
    (orbit,) = periodic_orbits(THIRD_ORDER, Relay(1.0, hysteresis))
    assert orbit.period == pytest.approx(2.0 * half, rel=1e-9)
    assert orbit.stable


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_an_integrator_and_a_relay_with_hysteresis_make_a_triangle() -> None:
    """Behind 1/s the input goes to and fro between the thresholds: the period is 4 h/L."""
    (orbit,) = periodic_orbits(control.tf([1.0], [1.0, 0.0]), Relay(2.0, hysteresis=0.3))
    assert orbit.period == pytest.approx(4.0 * 0.3 / 2.0, rel=1e-12)
    assert orbit.amplitude == pytest.approx(0.3, rel=1e-12)


def test_a_multi_harmonic_balance_gets_nearer_to_the_orbit() -> None:
    for element in ELEMENTS:
        cycle = max(harmonic_balance(THIRD_ORDER, element).limit_cycles, key=lambda each: each.amplitude)
        exact = max(periodic_orbits(THIRD_ORDER, element, (cycle,)), key=lambda orbit: orbit.amplitude)
        balanced = multi_harmonic_balance(THIRD_ORDER, element, cycle, (1, 3, 5, 7))[-1]
        omega = 2.0 * np.pi / exact.period
        assert abs(balanced.omega - omega) < 0.05 * abs(cycle.omega - omega)


def test_a_narrow_corner_or_threshold_moves_like_the_relay() -> None:
    (relay,) = periodic_orbits(THIRD_ORDER, Relay(1.0))
    for near in (Saturation(1e-7, 1e7), Relay(1.0, 1e-7), Relay(1.0, 5e-8, 1e-7), Preload(1.0, 1e-9)):
        cycle = max(harmonic_balance(THIRD_ORDER, near).limit_cycles, key=lambda each: each.amplitude)
        (orbit,) = periodic_orbits(THIRD_ORDER, near, (cycle,))
        assert orbit.period == pytest.approx(relay.period, rel=1e-6)


def test_a_dead_zone_beside_a_saturation_moves_like_a_gain() -> None:
    model = control.ss([[-0.1, -1.0], [1.0, 0.0]], [[1.0], [0.0]], [[0.0, 1.0]], [[0.0]])
    both = ClosedLoop(model, DeadZone(1.0, 2.0) + Saturation(1.0, 2.0))
    motion = simulate(both, 10.0, initial_state=[0.0, 3.0])
    alone = control.ss(model.A - 2.0 * model.B @ model.C, model.B, model.C, model.D)
    times = np.linspace(0.0, 10.0, 50)
    free = control.initial_response(alone, times, [0.0, 3.0])
    assert motion.output(times) == pytest.approx(free.outputs, abs=1e-6)
    assert {event.kind.value for event in motion.events} == {"corner"}


def test_a_relay_with_hysteresis_starts_with_the_output_that_is_asked_for() -> None:
    model = control.ss([[-1.0]], [[1.0]], [[1.0]], [[0.0]])
    for asked, sign in ((1.0, 1.0), (-1.0, -1.0), (0.0, 1.0)):
        motion = simulate(ClosedLoop(model, Relay(1.0, 0.5)), 1e-3, element_output=asked)
        assert np.sign(motion.output(1e-3)) == sign
    # Asked for what the input rules out, it has the other sign.
    motion = simulate(ClosedLoop(model, Relay(1.0, 0.5)), 1e-3, initial_state=[0.7], element_output=1.0)
    assert motion.output(1e-3) < 0.7 * np.exp(-1e-3)
    # With a dead zone it starts silent.
    assert simulate(ClosedLoop(model, Relay(1.0, 0.1, 0.3)), 1.0).output(1.0) == 0.0


def test_sliding_at_the_edge_of_a_dead_zone_is_refused() -> None:
    first_order = control.tf([1.0], [1.0, 1.0])
    with pytest.raises(UnsupportedMotionError, match="slide along the edge of the dead zone"):
        simulate(ClosedLoop(first_order, Relay(1.0, dead_zone=0.1)), 1.0)
    for moves in (Relay(1.0, 1e-3, 0.1), ScaledElement(Relay(1.0, dead_zone=0.1), -1.0)):
        assert simulate(ClosedLoop(first_order, moves), 1.0, impulse=1.0).duration == 1.0
