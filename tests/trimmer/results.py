"""One of each result, made when it is first asked for."""

from functools import cache
from pathlib import Path

import control
import numpy as np

import trimmer
from tests.trimmer.fitting.made import record
from tests.trimmer.fitting.made import trimmer as driven_trimmer
from tests.trimmer.maps.machines import impact_oscillator
from trimmer import SerialRunner
from trimmer.response import MechanismOrbit

EXAMPLES = Path(__file__).parents[2] / "examples"
GAP = 4e-5
PLAY = trimmer.FrictionBacklash(GAP)


@cache
def system() -> control.StateSpace:
    return trimmer.pin_model(trimmer.TrimmerParameters.thesis())


@cache
def loop() -> trimmer.ClosedLoop:
    return trimmer.ClosedLoop(system(), PLAY)


@cache
def balance() -> trimmer.HarmonicBalance:
    return trimmer.harmonic_balance(loop())


@cache
def orbits() -> trimmer.orbits.PeriodicOrbits:
    return trimmer.periodic_orbits(loop())


@cache
def identification() -> trimmer.balance.Identification:
    return trimmer.identify_time_constant(system(), GAP, 740.0, frequency_uncertainty=2.0)


@cache
def driven() -> trimmer.Motion:
    parameters, drive = trimmer.TrimmerParameters.thesis(), trimmer.Drive(1.5e-3, frequency=110.0)
    between = trimmer.thesis.Displacement(trimmer.thesis.TrimmerBody.CUTTER, trimmer.thesis.TrimmerBody.GUARD)
    friction = trimmer.loops.BodyFriction(between, trimmer.CoulombFriction(2.0))
    element = trimmer.FrictionBacklash(2e-4)
    return trimmer.simulate(trimmer.TrimmerLoop(parameters, element, drive, frictions=(friction,)), 0.03)


@cache
def relay() -> trimmer.Motion:
    """Of a loop without units."""
    loop = trimmer.ClosedLoop(control.ss(control.tf([1.0], [1.0, 3.0, 2.0, 0.0])), trimmer.Relay(1.0))
    return trimmer.simulate(loop, 20.0, initial_state=[0.0, 0.0, 1.0])


@cache
def summary() -> trimmer.linear.LinearSummary:
    return trimmer.summarise(trimmer.TrimmerParameters.thesis())


@cache
def time_response() -> trimmer.linear.TimeResponse:
    times = np.linspace(0.0, 0.06, 601)
    return trimmer.linear.time_response(control.ss([[-100.0]], [[100.0]], [[1.0]], 0.0), times, np.ones(601))


@cache
def signal() -> trimmer.Signal:
    times = np.arange(4000) / 4000.0
    values = 1e-3 * np.sin(2 * np.pi * 110.0 * times) + 1e-5 * np.sin(2 * np.pi * 554.3 * times)
    return trimmer.Signal(values, 4000.0, "q2-q4", "m")


@cache
def analysis() -> trimmer.spectra.SpectrumAnalysis:
    return trimmer.analyse_signal(signal(), 110.0, [222.35], [554.3], closed_loop=True)


@cache
def averaged() -> trimmer.spectra.AveragedSpectrum:
    return trimmer.spectra.averaged_spectrum(signal())


@cache
def comparison() -> trimmer.spectra.MotionComparison:
    return trimmer.spectra.compare_motions(
        signal(), trimmer.spectra.SimulatedLines(np.array([1e-3, 2e-6]), 110.0)
    )


@cache
def fit() -> trimmer.fitting.Fit:
    settings = trimmer.fitting.FitSettings(starts=1)
    measured = {"stroke": record(driven_trimmer(), 2e-6)}
    return trimmer.fit(driven_trimmer(), measured, ["plays.bridge.gap"], settings=settings)


@cache
def stopped() -> trimmer.MechanismMotion:
    return trimmer.simulate(impact_oscillator(), 6.0, state={"mass": (12.0, 100.0)})


@cache
def forced() -> MechanismOrbit:
    """The orbit of the impact oscillator with contact."""
    response = trimmer.respond(impact_oscillator(), state={"mass": (-25.0, 0.0)})
    assert response.motion.orbit is not None
    return response.motion.orbit


@cache
def response() -> trimmer.Response:
    return trimmer.respond(impact_oscillator(), starts=2)


@cache
def branch() -> trimmer.FollowedBranch:
    """From contact at 8 rad/s over the fold at 8.566394 rad/s, and back."""
    start, stop = 8.0 / (2 * np.pi), 8.7 / (2 * np.pi)
    settings = trimmer.FollowSettings(quiet=True, largest_step=0.05)
    return trimmer.follow(
        impact_oscillator(), "frequency", start, stop, state=forced().instant.state, settings=settings
    )


@cache
def motion_map() -> trimmer.MotionMap:
    values = {"frequency": [1.1, 1.2, 1.3], "stops.wall.gap": [8.0, 10.0]}
    return trimmer.motion_map(impact_oscillator(), values, runner=SerialRunner(), quiet=True)


@cache
def swept() -> trimmer.maps.Sweep:
    return trimmer.maps.sweep(impact_oscillator(), "frequency", 1.1, 1.3, steps=2, periods=20, quiet=True)


@cache
def stepped() -> trimmer.response.StepResponse:
    motor = trimmer.Mechanism.from_toml(EXAMPLES / "stiction-pid.toml")
    return trimmer.response.step_response(motor, "path", duration=0.1)


@cache
def basin() -> trimmer.maps.Basin:
    values = {"mass.displacement": [-25.0, 0.0, 12.0], "mass.velocity": [-100.0, 0.0, 100.0]}
    return trimmer.basin(impact_oscillator(), values, runner=SerialRunner(), quiet=True)


def locus() -> trimmer.branches.Locus:
    """A locus put together by hand."""
    values = np.array([[1.0, 8e-6], [1.2, 9e-6], [1.4, 12e-6]])
    return trimmer.branches.Locus(
        trimmer.SpecialKind.FOLD,
        (),
        ("frequency", "stops.wall.gap"),
        1,
        values,
        np.zeros((3, 2)),
        np.zeros(3),
        np.zeros(3),
        trimmer.branches.LocusEnd.LEFT,
        "it leaves the ranges",
        ("Hz", "m"),
    )


def curves() -> trimmer.maps.SpecialCurves:
    return trimmer.maps.SpecialCurves((trimmer.maps.SpecialCurve((locus(),)),), "by hand")


@cache
def samples() -> trimmer.uncertainty.Samples:
    scattering = trimmer.uncertainty.uncertainty_from(forced().mechanism, {"frequency": {"normal": "1 %"}})
    settings = trimmer.uncertainty.SampleSettings(3)
    return trimmer.sample(forced().mechanism, scattering, settings, runner=SerialRunner())


@cache
def several() -> trimmer.balance.FeedbackBalance:
    names = ["amplifier", "rub"]
    plant = control.ss(
        [[0, 1, 0], [0, -1, 0], [5, 0, -5]],
        [[0, 0], [4, -1], [0, 0]],
        [[0, 0, -1], [0, 1, 0]],
        0,
        inputs=names,
        outputs=names,
    )
    elements = {"amplifier": trimmer.Relay(1.0), "rub": trimmer.CoulombFriction(0.05)}
    return trimmer.harmonic_balance(trimmer.Feedback(plant, elements), order=1)
