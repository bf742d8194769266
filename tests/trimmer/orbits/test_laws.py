"""Laws of exact orbits: scaling in amplitude and time, other states and gains, disturbed motions."""

import functools

import control
import numpy as np
import pytest
import scipy.signal

from tests.quick import quick
from tests.trimmer.orbits.random_loops import mixed_states
from trimmer import Saturation, ViscousBacklash, periodic_orbits, simulate
from trimmer.elements import CoulombFriction, DeadZone, FrictionBacklash, InertiaBacklash, Preload, Relay
from trimmer.loops import LoopSignal
from trimmer.orbits import OrbitSearch, PeriodicOrbit, PeriodicOrbits, Simulations
from trimmer.thesis import InputChannels, TrimmerParameters, pin_model

SERVO = control.ss(control.tf([3.0], [1.0, 1.0, 0.0]))
WITH_INTEGRATOR = control.ss(control.tf([1.0], [1.0, 2.0, 1.0, 0.0]))
LAGS = control.ss(control.tf([60.0], [1.0, 3.0, 3.0, 1.0]))
OSCILLATOR = control.ss(control.tf([1.0], [1.0, 0.3, 1.0]))
FRACTION = control.ss(*scipy.signal.tf2ss([20, 8.5], [1, 4.7, 0]))
TRIMMER = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
SIZE, SPEED = 3e-5, 40.0


LOOPS = {
    "relay": (LAGS, lambda size, speed: Relay(size)),
    "relay with thresholds": (LAGS, lambda size, speed: Relay(size, 0.1 * size, 0.2 * size)),
    "hysteresis": (LAGS, lambda size, speed: Relay(size, 0.3 * size)),
    "saturation": (LAGS, lambda size, speed: Saturation(size, 0.8)),
    "dead zone": (LAGS, lambda size, speed: DeadZone(size, 0.8)),
    "preload": (LAGS, lambda size, speed: Preload(0.5 * size, 0.01)),
    "friction": (LAGS, lambda size, speed: FrictionBacklash(size)),
    "load that slows down": (SERVO, lambda size, speed: ViscousBacklash(size, 0.3 / speed)),
    "load that bounces": (FRACTION, lambda size, speed: InertiaBacklash(size)),
    "negative friction": (OSCILLATOR, lambda size, speed: -CoulombFriction(size)),
    "friction-controlled trimmer": (TRIMMER, lambda size, speed: FrictionBacklash(size)),
    "viscous-controlled trimmer": (TRIMMER, lambda size, speed: ViscousBacklash(size, 3e-4 / speed)),
    "inertia-controlled trimmer": (TRIMMER, lambda size, speed: InertiaBacklash(size)),
    "sum": (WITH_INTEGRATOR, lambda size, speed: FrictionBacklash(size) + 0.5 * Relay(2.0 * size)),
}
"""A system, and an element for a size of its input (and output) and a speed of the loop."""


def slowed(system: control.StateSpace, speed: float) -> control.StateSpace:
    """The same system in a time that passes so many times as fast."""
    return control.ss(speed * system.A, speed * system.B, system.C, system.D)


@functools.cache
def orbits_of(name: str) -> PeriodicOrbits:
    system, element = LOOPS[name]
    return periodic_orbits(system, element(1.0, 1.0))


def assert_alike(found: PeriodicOrbits, expected: PeriodicOrbits, size: float, speed: float) -> None:
    assert len(found) == len(expected) > 0
    for one, other in zip(found, expected, strict=True):
        assert one.amplitude == pytest.approx(size * other.amplitude, rel=1e-8)
        assert one.period == pytest.approx(other.period / speed, rel=1e-8)
        assert np.sort(abs(one.multipliers)) == pytest.approx(np.sort(abs(other.multipliers)), abs=1e-5)
        assert one.steadiness == other.steadiness
        np.testing.assert_allclose(abs(one.harmonics), size * abs(other.harmonics), atol=1e-8 * one.amplitude)
        assert len(one.switching_times) == len(other.switching_times)


@pytest.mark.parametrize("name", quick(LOOPS, 1, 6, 13))
@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning", "ignore::trimmer.errors.OrbitNotFoundWarning")
def test_orbits_scale_in_amplitude_and_time(name: str) -> None:
    system, element = LOOPS[name]
    found = periodic_orbits(slowed(system, SPEED), element(SIZE, SPEED))
    assert_alike(found, orbits_of(name), SIZE, SPEED)


@pytest.mark.parametrize("name", quick(LOOPS, 1, 4, 12, 13))
@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning", "ignore::trimmer.errors.OrbitNotFoundWarning")
def test_factors_of_the_element_may_be_those_of_the_system_in_other_states(name: str) -> None:
    system, element = LOOPS[name]
    turn = np.diag(10.0 ** np.resize([-1, 1, 0, 2, -2], system.nstates))
    if system.nstates < 8:  # Those of the trimmer, which have nothing in common, are mixed below.
        turn = turn @ np.triu(np.ones_like(turn))
    other = control.ss(
        np.linalg.solve(turn, system.A @ turn), np.linalg.solve(turn, system.B) / -2.5, system.C @ turn, 0
    )
    assert_alike(periodic_orbits(other, -2.5 * element(1.0, 1.0)), orbits_of(name), 1.0, 1.0)


@pytest.mark.parametrize("seed", quick([0, 1, 2], 0))
@pytest.mark.parametrize("name", [name for name in LOOPS if name.endswith("trimmer")])
@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_orbits_are_the_same_where_states_mix_displacements_and_velocities(name: str, seed: int) -> None:
    """But for the rounding of the mixed entries, by which they are those of another system."""
    system, element = LOOPS[name]
    mixed, expected = mixed_states(system, seed), orbits_of(name)
    mixed = control.ss(mixed.A, mixed.B / -2.5, mixed.C, 0)
    found = periodic_orbits(mixed, -2.5 * element(1.0, 1.0))
    assert len(found) == len(expected) == 2
    for one, other in zip(found, expected, strict=True):
        assert one.period == pytest.approx(other.period, rel=1e-6)
        assert one.amplitude == pytest.approx(other.amplitude, rel=1e-6)
        assert one.steadiness == other.steadiness
        assert np.sort(abs(one.multipliers)) == pytest.approx(np.sort(abs(other.multipliers)), abs=1e-5)
        np.testing.assert_allclose(abs(one.harmonics), abs(other.harmonics), atol=1e-4 * other.amplitude)
        assert len(one.switching_times) == len(other.switching_times)
        input_, times = LoopSignal.ELEMENT_INPUT, np.linspace(0.0, one.period, 99)
        assert one.stroke_of(input_) == pytest.approx(2.0 * other.amplitude, rel=1e-4)
        outputs = mixed.C[0] @ one.motion.state(times)[:8]
        assert np.ptp(outputs) == pytest.approx(2.0 * other.amplitude, rel=1e-2)


@pytest.mark.parametrize("mixing", [1e-3, 1e-2, 1e-1, 1.0, 1e2])
@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_orbits_are_the_same_however_far_states_are_mixed(mixing: float) -> None:
    """From states in which displacements and velocities are alike to those in which the latter hide them."""
    expected = orbits_of("friction-controlled trimmer")
    speeds = np.repeat([1.0, 1.0 / (4000.0 * mixing)], 4)
    alike = control.ss(
        speeds[:, None] * TRIMMER.A / speeds, speeds[:, None] * TRIMMER.B, TRIMMER.C / speeds, 0
    )
    found = periodic_orbits(mixed_states(alike, 5), FrictionBacklash(1.0))
    assert len(found) == len(expected)
    assert [one.period for one in found] == pytest.approx([one.period for one in expected], rel=1e-6)
    assert [one.steadiness for one in found] == [one.steadiness for one in expected]


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning", "ignore::trimmer.errors.OrbitNotFoundWarning")
def test_equal_poles_among_mixed_states_hide_no_digit_in_any_unit_of_time() -> None:
    """Their modes act on each other. Where mixing has hidden the digits of four, that is no error."""
    plain, relay = control.ss(control.tf([8.0], [1.0, 3.0, 3.0, 1.0])), Relay(1.0, 0.1)
    search = OrbitSearch(Simulations.NEVER)
    units = np.array([1.0, 1e2, 1e4])
    other = control.ss(
        4e3 * units[:, None] * plain.A / units, 4e3 * units[:, None] * plain.B, plain.C / units, 0
    )
    (expected,), (found,) = (
        periodic_orbits(each, relay, search=search) for each in (plain, mixed_states(other, 3))
    )
    assert 4e3 * found.period == pytest.approx(expected.period, rel=1e-10)
    lost = control.tf([16e20], np.poly([-1e5, -1.0001e5, -1e5, -2e5]))
    periodic_orbits(mixed_states(control.ss(lost), 3), Saturation(0.1), search=search)


def begun(orbit: PeriodicOrbit, load: bool) -> tuple[np.ndarray, float]:
    """State of the linear system far from events, and the output that sets the element's own states.

    A load has none while it is in contact: asked to lie far away, it begins there.
    """
    order = orbit.motion.loop.model.nstates
    ends = np.append(orbit.switching_times, orbit.switching_times[0] + orbit.period)
    for begin in 0.5 * (ends[:-1] + ends[1:])[np.argsort(-np.diff(ends))]:
        time = begin % orbit.period
        output = float(orbit.motion.element_output(time))
        if not load:
            return orbit.motion.state(time)[:order], output
        side = orbit.motion.element_input(time) - output
        if abs(abs(side) - 0.5) < 1e-9:
            return orbit.motion.state(time)[:order], -1e9 * np.sign(side)
    raise AssertionError


def slopes(orbit: PeriodicOrbit, load: bool) -> np.ndarray:
    """Derivative of the state after a period by that before it, relative to sizes, by differences."""
    start, output = begun(orbit, load)
    order, period = len(start), orbit.period
    sizes = abs(orbit.motion.state(np.linspace(0.0, period, 99))[:order]).max(axis=1)

    def returned(change: np.ndarray) -> np.ndarray:
        state = start + change
        motion = simulate(orbit.motion.loop, period, initial_state=state, element_output=output)
        return motion.state(period)[:order] / sizes

    assert returned(0.0 * start) == pytest.approx(start / sizes, abs=1e-9)
    shifts = 1e-6 * np.diag(sizes)
    return np.array([(returned(shift) - returned(-shift)) / 2e-6 for shift in shifts]).T


ONLY_SCALED = ("load that bounces", "friction", "sum")
"""Of a contact of no length, one so brief that a millionth more is much, and a load beside a relay."""


@pytest.mark.parametrize("name", [name for name in LOOPS if name not in ONLY_SCALED])
@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning", "ignore::trimmer.errors.OrbitNotFoundWarning")
def test_multipliers_are_those_of_disturbed_motions(name: str) -> None:
    """Where a load is in contact, the states of the linear system tell all multipliers that are not zero."""
    load = name.startswith(("load", "friction", "viscous", "inertia"))
    for orbit in orbits_of(name):
        differences = np.sort(abs(np.linalg.eigvals(slopes(orbit, load))))
        found = np.sort(abs(orbit.multipliers))
        assert found[-len(differences) :] == pytest.approx(differences, rel=1e-5, abs=1e-6)
        assert not load or found[: -len(differences)].max() < 1e-6


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_an_orbit_is_told_once_whichever_motion_led_to_it() -> None:
    """Simulated from many states, on both sides, at any phase; a relay's own equation leads there too."""
    for name in ("load that bounces", "relay", "load that slows down"):
        system, element = LOOPS[name]
        asked = periodic_orbits(system, element(1.0, 1.0), search=OrbitSearch(Simulations.ALWAYS, starts=8))
        assert asked.search.simulations.settled > 4
        assert_alike(asked, orbits_of(name), 1.0, 1.0)


@pytest.mark.parametrize(
    "part",
    [
        lambda size: Relay(size),
        lambda size: Relay(size, 0.1, 0.05),
        lambda size: 4.0 * size * Saturation(0.1),
        lambda size: 4.0 * size * DeadZone(0.1),
    ],
)
def test_two_elements_that_always_switch_together_are_one(part) -> None:
    """Whatever comes first of two events at one instant, the orbit and its multipliers are those of one."""
    plant = control.tf([1.0], [1.0, 2.0, 2.0, 1.0])
    alone, both = (periodic_orbits(plant, each).orbits for each in (part(3.0), part(1.0) + part(2.0)))
    assert len(alone) == len(both) > 0
    for one, other in zip(alone, both, strict=True):
        assert other.period == pytest.approx(one.period, rel=1e-10)
        assert other.multipliers == pytest.approx(one.multipliers, abs=1e-9)
        assert (other.stable, other.amplitude) == (one.stable, pytest.approx(one.amplitude, rel=1e-10))
