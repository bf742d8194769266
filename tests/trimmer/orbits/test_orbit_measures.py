"""Stroke, phase, harmonics and impacts of exact orbits, beside sampled motion and closed forms."""

import math

import control
import numpy as np
import pytest

from trimmer import UnsupportedMotionError, forced_orbit, linear_model, periodic_orbits, pin_model, simulate
from trimmer.elements import CoulombFriction, FrictionBacklash, InertiaBacklash, ViscousBacklash
from trimmer.errors import WrongTypeError
from trimmer.loops import BodyFriction, Drive, LoopSignal, OpenLoop, TrimmerLoop
from trimmer.thesis import Displacement, InputChannels, TrimmerBody, TrimmerParameters

THESIS = TrimmerParameters.thesis()
DRIVE = Drive(1.5e-3, frequency=110.0, phase=0.3)
SAMPLES = 2**14
CUTTER_ON_GUARD = Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD)
LOOPS = {
    "friction-controlled": TrimmerLoop(THESIS, FrictionBacklash(2e-4), DRIVE),
    "viscous-controlled": TrimmerLoop(THESIS, ViscousBacklash(2e-4, 1e-3), DRIVE),
    "inertia-controlled": TrimmerLoop(THESIS, InertiaBacklash(2e-4), DRIVE),
    "with dry friction": TrimmerLoop(
        THESIS,
        FrictionBacklash(2e-4),
        DRIVE,
        frictions=(BodyFriction(CUTTER_ON_GUARD, CoulombFriction(0.75)),),
    ),
}


@pytest.fixture(scope="module", params=LOOPS.values(), ids=LOOPS)
def orbit(request: pytest.FixtureRequest):
    return forced_orbit(request.param)


def sampled(orbit, signal, times) -> np.ndarray:
    if isinstance(signal, Displacement):
        return np.array(signal.row) @ orbit.motion.state(times)[:4]
    named = {
        LoopSignal.OUTPUT: orbit.motion.output,
        LoopSignal.ELEMENT_INPUT: orbit.motion.element_input,
        LoopSignal.ELEMENT_OUTPUT: orbit.motion.element_output,
    }
    return named[signal](times)


@pytest.mark.parametrize("signal", [*LoopSignal, Displacement(TrimmerBody.HOUSING), CUTTER_ON_GUARD])
def test_strokes_and_harmonics_are_those_of_samples(orbit, signal) -> None:
    times = np.arange(SAMPLES) / SAMPLES * orbit.period
    values = sampled(orbit, signal, times)
    kinks = sampled(orbit, signal, orbit.switching_times)
    assert orbit.stroke_of(signal) == pytest.approx(np.ptp(np.append(values, kinks)), rel=1e-6)
    lines = 2j * np.fft.fft(values)[1:16] / SAMPLES
    np.testing.assert_allclose(orbit.harmonics_of(signal), lines, atol=2e-7 * np.ptp(values))


def test_the_output_is_the_displacement_that_the_loop_was_given(orbit) -> None:
    assert orbit.stroke_of() == orbit.stroke_of(CUTTER_ON_GUARD)
    np.testing.assert_array_equal(orbit.harmonics_of(), orbit.harmonics_of(CUTTER_ON_GUARD))


def test_the_input_of_the_element_is_the_drive(orbit) -> None:
    assert orbit.drive == DRIVE
    assert orbit.stroke_of(LoopSignal.ELEMENT_INPUT) == pytest.approx(2 * DRIVE.amplitude, rel=1e-12)
    assert orbit.amplitude == pytest.approx(DRIVE.amplitude, rel=1e-12)
    assert abs(orbit.harmonics[0]) == pytest.approx(DRIVE.amplitude, rel=1e-12)
    assert abs(orbit.harmonics[1:]).max() < 1e-15


@pytest.mark.parametrize("element", [FrictionBacklash(2e-4), ViscousBacklash(2e-4, 1e-3)])
@pytest.mark.parametrize("channels", InputChannels)
def test_harmonics_are_those_of_describing_functions_and_frequency_response(element, channels) -> None:
    system = pin_model(THESIS, channels=channels)
    orbit = forced_orbit(OpenLoop(system, element, DRIVE))
    for n in (1, 3, 5):
        gain = complex(element.describing_function(DRIVE.amplitude, DRIVE.omega, harmonic=n))
        turned = np.exp(1j * n * DRIVE.phase)
        bridge = gain * DRIVE.amplitude * turned
        assert orbit.harmonics_of(LoopSignal.ELEMENT_OUTPUT)[n - 1] == pytest.approx(bridge, abs=1e-13)
        expected = bridge * complex(system(1j * n * DRIVE.omega))
        assert orbit.harmonics_of()[n - 1] == pytest.approx(expected, abs=1e-13)


@pytest.mark.parametrize("phase", [0.0, 2.0, -3.0])
def test_phase_is_relative_to_the_drive_however_that_begins(phase: float) -> None:
    loops = [TrimmerLoop(THESIS, FrictionBacklash(2e-4), Drive(1.5e-3, 700.0, at)) for at in (0.3, phase)]
    first, other = (forced_orbit(loop) for loop in loops)
    turned = np.exp(1j * (phase - 0.3)) * first.harmonics_of()[0]
    assert other.harmonics_of()[0] == pytest.approx(turned, rel=1e-9)
    assert np.sort(other.impact_speeds) == pytest.approx(np.sort(first.impact_speeds), rel=1e-9)


def test_the_pin_meets_a_load_at_rest_with_its_own_speed() -> None:
    """Friction-controlled: half a gap beyond the middle of the play the pin moves at A omega cos(theta)."""
    gap = 2e-4
    orbit = forced_orbit(TrimmerLoop(THESIS, FrictionBacklash(gap), DRIVE))
    cosine = math.sqrt(1 - ((DRIVE.amplitude - gap) / DRIVE.amplitude) ** 2)
    assert orbit.impact_speeds == pytest.approx([DRIVE.amplitude * DRIVE.omega * cosine] * 2, rel=1e-9)


def test_impacts_are_those_of_a_long_simulation(orbit) -> None:
    impacts = [each for each in orbit.motion.events if each.kind.value == "impact"]
    assert [(each.time, each.mode) for each in impacts] == [(each.time, each.mode) for each in orbit.impacts]
    short = 1e-9
    times = np.array([each.time for each in orbit.impacts])
    apart = [
        orbit.motion.element_input(t) - orbit.motion.element_output(t)
        for t in (times - 2 * short, times - short)
    ]
    speeds = abs(apart[1] - apart[0]) / short
    assert orbit.impact_speeds == pytest.approx(speeds, rel=1e-4)


@pytest.mark.parametrize("gap", [1e-4, 2e-4, 3e-4, 5e-4])
def test_an_impact_at_the_seam_of_the_period_counts_once(gap: float) -> None:
    """The drive begins where the pin meets the load, so that the motion begins with a contact."""
    start = math.pi - math.asin((DRIVE.amplitude - gap) / DRIVE.amplitude)
    for shift in (-1e-9, -4e-16, 0.0, 4e-16, 1e-9):
        drive = Drive(DRIVE.amplitude, DRIVE.omega, start + math.pi + shift)
        orbit = forced_orbit(TrimmerLoop(THESIS, FrictionBacklash(gap), drive))
        assert len(orbit.impacts) == 2
        assert len(orbit.switching_times) == 4


def test_a_limit_cycle_has_strokes_and_impacts() -> None:
    system, element = pin_model(THESIS), FrictionBacklash(4e-5)
    orbit = periodic_orbits(system, element)[0]
    assert orbit.drive is None
    assert orbit.stroke_of(LoopSignal.ELEMENT_INPUT) == pytest.approx(2 * orbit.amplitude, rel=1e-12)
    assert orbit.stroke_of() == pytest.approx(2 * orbit.amplitude, rel=1e-12)
    found = orbit.harmonics_of(LoopSignal.ELEMENT_INPUT)
    np.testing.assert_allclose(found, orbit.harmonics, atol=1e-9 * orbit.amplitude)
    assert len(orbit.impacts) == 2
    assert orbit.impact_speeds[0] == pytest.approx(orbit.impact_speeds[1], rel=1e-6)


def test_displacements_need_the_states_of_a_trimmer() -> None:
    orbit = forced_orbit(OpenLoop(pin_model(THESIS), FrictionBacklash(2e-4), DRIVE))
    assert orbit.stroke_of(CUTTER_ON_GUARD) == pytest.approx(orbit.stroke_of(), rel=1e-12)
    other = forced_orbit(OpenLoop(control.tf([1], [1, 1, 1]), FrictionBacklash(1.0), Drive(2.0, 1.0)))
    with pytest.raises(UnsupportedMotionError, match="q2 cannot be read from this loop"):
        other.stroke_of(Displacement(TrimmerBody.CUTTER))
    with pytest.raises(WrongTypeError, match="signal must be a LoopSignal or a Displacement, not 'q2'"):
        other.stroke_of("q2")


def test_absolute_displacements_are_those_of_the_model_with_all_outputs() -> None:
    """Without play: the response of each body from python-control."""
    orbit = forced_orbit(TrimmerLoop(THESIS, drive=DRIVE))
    for body in TrimmerBody:
        model = linear_model(THESIS, Displacement(body))
        inputs = np.array([1.0, 1j * DRIVE.omega])
        gain = complex((model(1j * DRIVE.omega) @ inputs).item())
        expected = gain * DRIVE.amplitude * np.exp(1j * DRIVE.phase)
        assert orbit.harmonics_of(Displacement(body))[0] == pytest.approx(expected, rel=1e-9)
        assert orbit.stroke_of(Displacement(body)) == pytest.approx(2 * abs(expected), rel=1e-9)
    assert len(orbit.impacts) == 0


def test_a_motion_tells_whether_it_reached_its_end() -> None:
    motion = simulate(LOOPS["friction-controlled"], 0.05)
    assert motion.success
    assert motion.message == "reached the end"
    stopped = simulate(LOOPS["friction-controlled"], 0.05, event_limit=3)
    assert not stopped.success
    assert stopped.message == "reached the greatest number of events"
