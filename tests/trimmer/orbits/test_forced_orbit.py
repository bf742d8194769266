"""Exact periodic motion of driven loops."""

import control
import numpy as np
import pytest

from tests.quick import quick
from tests.trimmer.orbits.random_loops import mixed_states
from trimmer import OrbitNotFoundError, TrimmerParameters, ViscousBacklash, forced_orbit, pin_model, simulate
from trimmer.elements import CoulombFriction, Element, FrictionBacklash, InertiaBacklash, Saturation
from trimmer.loops import BodyFriction, ClosedLoop, Drive, OpenLoop, TrimmerLoop
from trimmer.thesis import Displacement, InputChannels, TrimmerBody

DRIVE = Drive(0.0015, 2 * np.pi * 109.845)
CUTTER_ON_GUARD = Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD)


def open_loop(element: Element, drive: Drive = DRIVE) -> OpenLoop:
    system = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
    return OpenLoop(system, element, drive)


def rubbing(force: float) -> TrimmerLoop:
    friction = BodyFriction(CUTTER_ON_GUARD, CoulombFriction(force))
    return TrimmerLoop(TrimmerParameters.thesis(), FrictionBacklash(2e-4), DRIVE, frictions=(friction,))


@pytest.mark.parametrize(
    ("loop", "precision"),
    [
        (open_loop(FrictionBacklash(2e-4)), 1e-12),
        (open_loop(ViscousBacklash(2e-4, 1e-3)), 1e-12),
        (open_loop(InertiaBacklash(2e-4)), 1e-12),
        *((rubbing(force), 1e-11) for force in (0.25, 0.75, 5.0)),
    ],
)
def test_motion_behind_play_repeats_with_the_drive(loop: OpenLoop | TrimmerLoop, precision: float) -> None:
    """With friction beside it that sticks and slips too."""
    orbit = forced_orbit(loop)
    times = np.linspace(0.97, 1.0, 301)
    exact = orbit.motion.output(np.mod(times, orbit.period))
    assert simulate(loop, 1.0).output(times) == pytest.approx(exact, abs=precision)
    assert orbit.stable


def test_without_play_it_is_the_frequency_response() -> None:
    parameters = TrimmerParameters.thesis()
    orbit = forced_orbit(TrimmerLoop(parameters, drive=DRIVE))
    times = np.linspace(0.0, orbit.period, 50, endpoint=False)
    gain = complex(pin_model(parameters)(1j * DRIVE.omega))
    expected = (gain * DRIVE.amplitude * np.exp(1j * DRIVE.omega * times)).imag
    assert orbit.motion.output(times) == pytest.approx(expected, abs=1e-14)
    modes = np.exp(np.linalg.eigvals(pin_model(parameters).A) * DRIVE.period)
    assert np.sort(abs(orbit.multipliers)) == pytest.approx(np.sort(abs(modes)), rel=1e-9)


def test_friction_that_never_slips_leaves_the_place_open() -> None:
    orbit = forced_orbit(rubbing(500.0))
    times = np.linspace(0.0, orbit.period, 50, endpoint=False)
    assert np.ptp(orbit.motion.output(times)) < 1e-12
    # Cutter and guard could be stuck elsewhere as well: a shift neither grows nor decays. The multiplier one
    # is double (position and velocity), so rounding enters by its square root.
    assert abs(orbit.multipliers - 1).min() < 1e-6
    assert not orbit.stable


def test_a_drive_within_the_gap_moves_nothing() -> None:
    orbit = forced_orbit(open_loop(FrictionBacklash(4e-5), Drive(1.9e-5, 600.0)))
    assert orbit.amplitude == pytest.approx(1.9e-5)
    assert len(orbit.switching_times) == 0
    assert not orbit.motion.output(np.linspace(0, orbit.period, 9)).any()


def test_only_a_driven_loop_has_a_forced_motion() -> None:
    system = control.tf([1], [1, 1, 1])
    with pytest.raises(ValueError, match="periodic_orbits"):
        forced_orbit(ClosedLoop(system, FrictionBacklash(1.0)))
    with pytest.raises(ValueError, match="settling"):
        forced_orbit(open_loop(FrictionBacklash(4e-5)), settling=-1)


def test_a_motion_that_does_not_settle_is_told() -> None:
    growing, drive = control.tf([1], [1, -1, 0]), Drive(2.0, 1.0)
    with pytest.raises(OrbitNotFoundError, match=r"6\.28319 s, was found after 512 periods; the motion may"):
        forced_orbit(OpenLoop(growing, FrictionBacklash(1.0), drive))
    resonant = OpenLoop(control.tf([1], [1, 0, 1]), FrictionBacklash(1.0), drive)
    for settling, periods in ((None, 512), (5, 5)):
        with pytest.raises(OrbitNotFoundError, match=rf"6\.28319 s, was found after {periods} periods"):
            forced_orbit(resonant, settling=settling)


@pytest.mark.parametrize(
    "element", quick([FrictionBacklash(1.0), ViscousBacklash(1.0, 0.3), Saturation(1.0, 1.0)], 0)
)
@pytest.mark.parametrize(
    ("system", "omega", "told"),
    [
        (control.tf([1], [1, 0, 1]), 1.0, "once the frequency"),
        (control.tf([1], [1, 0, 9]), 1.0, "3 times the frequency"),
        (control.tf([1], [1, 0, 1e8]), 1e4, "once the frequency"),
        (control.tf([1], [1, 0, 1, 0]), 1.0, "once the frequency"),
        (control.tf([1], [1, 0, 2, 0, 1]), 1.0, "once the frequency"),
    ],
    ids=["resonance", "of a harmonic", "fast", "with an integrator", "double"],
)
def test_at_an_undamped_resonance_there_is_no_orbit(element, system, omega, told) -> None:
    with pytest.raises(OrbitNotFoundError, match=f"undamped pole at {told}"):
        forced_orbit(OpenLoop(system, element, Drive(2.0, omega)))


@pytest.mark.parametrize(("damping", "detuning"), [(1e-3, 0.0), (1e-6, 0.0), (0.0, 1e-6)])
def test_beside_an_undamped_resonance_there_is_one(damping: float, detuning: float) -> None:
    """As large as the first harmonic of the output asks for, beside which the others are small."""
    system = control.tf([1.0], [1.0, damping, 1.0 + detuning])
    drive, element = Drive(2.0, 1.0), FrictionBacklash(1.0)
    orbit = forced_orbit(OpenLoop(system, element, drive))
    gain = abs(system(1j)) * abs(element.describing_function(2.0, 1.0))
    assert 0.5 * orbit.stroke_of() == pytest.approx(2.0 * gain, rel=max(1e-2 * damping, 1e-4))


@pytest.mark.parametrize("denominator", [[1, 0], [1, 0, 4]])
def test_an_undamped_pole_that_the_output_does_not_drive_leaves_a_neutral_orbit(denominator) -> None:
    """An odd element gives no constant and no even harmonics."""
    loop = OpenLoop(control.tf([1], denominator), FrictionBacklash(1.0), Drive(2.0, 1.0))
    orbit = forced_orbit(loop)
    model, half = orbit.motion.loop.model, 0.5 * orbit.period
    assert orbit.neutral
    assert orbit.stroke_of() < 10.0
    begin, end = orbit.motion.state(0.0), orbit.motion.state(2.0 * half)
    assert end[: model.nstates] == pytest.approx(begin[: model.nstates], abs=1e-9)


def test_the_forced_motion_does_not_depend_on_the_states_of_the_system() -> None:
    loop = open_loop(FrictionBacklash(2e-4))
    mixed = mixed_states(loop.system, 3)
    other = forced_orbit(OpenLoop(mixed, loop.element, loop.drive))
    expected = forced_orbit(loop)
    times = np.linspace(0.0, other.period, 50)
    size = expected.stroke_of()
    assert other.motion.output(times) == pytest.approx(expected.motion.output(times), abs=1e-4 * size)
    assert other.stroke_of() == pytest.approx(size, rel=1e-5)
    assert other.residual < 1e-10


@pytest.mark.parametrize("settling", [0, 2, 20])
def test_the_motion_is_the_same_however_long_it_settled(settling: int) -> None:
    drive = Drive(2.0, 3.0, 0.4)
    loop = OpenLoop(control.ss([[-0.7]], [[2.0]], [[1.0]], [[0.0]]), FrictionBacklash(0.5), drive)
    times = np.linspace(0.0, drive.period, 50)
    expected, found = forced_orbit(loop), forced_orbit(loop, settling=settling)
    assert found.motion.output(times) == pytest.approx(expected.motion.output(times), abs=1e-9)
    assert (found.period, found.prediction, found.driven) == (drive.period, None, True)
    assert found.residual < 1e-10
