"""A wrong type for any argument ends in a sentence that names argument and value, not in a traceback."""

import itertools
import math
import traceback
from fractions import Fraction
from functools import cache
from pathlib import Path

import control
import numpy as np
import pytest

import trimmer

PACKAGE = Path(trimmer.__file__).parent
THESIS = trimmer.TrimmerParameters.thesis()
SYSTEM = trimmer.pin_model(THESIS)
PLAY = trimmer.FrictionBacklash(4e-5)
DRIVE = trimmer.Drive(1.5e-3, 700.0)
LOOP, TRIMMER = trimmer.ClosedLoop(SYSTEM, PLAY), trimmer.TrimmerLoop(THESIS, PLAY, DRIVE)
CYCLE = trimmer.limit_cycles(SYSTEM, PLAY)[-1]
SAMPLES = np.sin(np.arange(200.0))
SIGNAL = trimmer.Signal(SAMPLES, 1000.0)
MOVING = trimmer.Signal(SAMPLES, 1000.0, "x", "m")
SIMULATED = trimmer.spectra.SimulatedLines(np.array([1.0 + 0j]), 160.0)
SPECTRUM = trimmer.spectra.amplitude_spectrum(SAMPLES, 1000.0)
FRICTION = trimmer.CoulombFriction(1.0)
STATIC = trimmer.StaticElement(np.sin)
SEARCH = trimmer.OrbitSearch(trimmer.orbits.Simulations.NEVER)


@cache
def motion() -> trimmer.Motion:
    """Moved when a test asks: while tests are collected, each process would compile what moves it."""
    return trimmer.simulate(TRIMMER, 0.001)


def output(**given: object) -> object:
    return motion().output(**given)


def state(**given: object) -> object:
    return motion().state(**given)


BOTH, OF_SYSTEM = {"system": SYSTEM, "element": PLAY}, {"system": SYSTEM, "omega": 1.0}
RANGES = {**BOTH, "omega_range": (100.0, 1e4), "frozen_omega": 4e3}
ANYTHING = {"text": "1.0", "an object": object(), "a class": trimmer.FrictionBacklash, "complex": 1j}
ANYTHING |= {"a dictionary": {"a": 1.0}, "uneven lists": [[1.0], [1.0, 2.0]], "none": None, "a loop": TRIMMER}

CALLS = {
    trimmer.identify_time_constant: {"system": SYSTEM, "gap": 4e-5, "frequency": 740.0}
    | {"frequency_uncertainty": 0.0},
    trimmer.harmonic_leakage: {"system": SYSTEM, "element": PLAY, "cycle": CYCLE, "harmonics": (3, 5)},
    trimmer.harmonic_balance: RANGES,
    trimmer.limit_cycles: RANGES,
    trimmer.CoulombFriction: {"force": 1.0},
    trimmer.Relay: {"level": 1.0, "hysteresis": 0.1, "dead_zone": 0.1},
    trimmer.Saturation: {"threshold": 1.0, "slope": 1.0},
    trimmer.DeadZone: {"threshold": 1.0, "slope": 1.0},
    trimmer.Preload: {"level": 1.0, "slope": 1.0},
    trimmer.StaticElement: {"function": np.sin, "scale": 1.0, "kinks": (0.5,)},
    trimmer.elements.ControlElement: {"nonlinearity": control.saturation_nonlinearity(1.0)},
    STATIC.describing_function_estimate: {"amplitude": 1.0, "omega": 1.0, "harmonic": 1},
    trimmer.ViscousFriction: {"damping": 1.0},
    trimmer.FrictionBacklash: {"gap": 1.0},
    trimmer.InertiaBacklash: {"gap": 1.0},
    trimmer.ViscousBacklash: {"gap": 1.0, "time_constant": 1.0},
    trimmer.elements.ElementAtFrequency: {"element": PLAY, "omega": 1.0},
    trimmer.elements.ScaledElement: {"element": PLAY, "factor": 2.0},
    trimmer.elements.SumOfElements: {"terms": (PLAY,)},
    PLAY.describing_function: {"amplitude": 1.0, "omega": 1.0, "harmonic": 1},
    PLAY.waveform: {"phase": 1.0, "amplitude": 1.0, "omega": 1.0},
    PLAY.derivatives: {"amplitude": 1.0, "omega": 1.0},
    PLAY.mean_gain: {"amplitude": 1.0},
    PLAY.at: {"omega": 1.0},
    trimmer.linear.gain_crossings: {"system": SYSTEM, "level": 1.0},
    trimmer.linear.real_axis_crossings: {"system": SYSTEM},
    trimmer.linear.antiresonances: {"system": SYSTEM},
    trimmer.resonance_peaks: {"system": SYSTEM},
    trimmer.response_at: {"system": SYSTEM, "omega": 1.0},
    trimmer.linear.asymptotic_roll_off: {"system": SYSTEM},
    trimmer.linear.bandwidth: {"system": SYSTEM, "dbdrop": -3.0},
    trimmer.linear.bandwidth_crossings: {"system": SYSTEM, "dbdrop": -3.0},
    trimmer.linear.filtering_ratio: {"system": SYSTEM, "omega": 1.0, "harmonic": 3},
    trimmer.linear.local_slope: {"system": SYSTEM, "omega": 1.0},
    trimmer.linear_model: {"parameters": THESIS, "output": "q2"},
    trimmer.pin_model: {"parameters": THESIS},
    trimmer.transfer_function: {"parameters": THESIS},
    trimmer.modes: {"parameters": THESIS},
    trimmer.linear.undamped_modes: {"parameters": THESIS},
    trimmer.summarise: {"parameters": THESIS},
    trimmer.linear.encirclements: {"system": SYSTEM, "point": -1.0},
    trimmer.linear.steady_state: {"system": SYSTEM, "omega": 1.0, "amplitude": 1.0},
    trimmer.linear.steady_state(SYSTEM, 1.0).at: {"times": 1.0},
    trimmer.linear.time_response: {"system": SYSTEM, "times": [0.0, 1.0], "inputs": [0.0, 1.0]}
    | {"initial_state": 0.0},
    trimmer.energy_balance: {"motion": motion},
    trimmer.ClosedLoop: {"system": SYSTEM, "element": PLAY},
    trimmer.OpenLoop: {"system": SYSTEM, "element": PLAY, "drive": DRIVE},
    trimmer.TrimmerLoop: {"parameters": THESIS, "element": PLAY, "drive": DRIVE, "frictions": ()},
    trimmer.loops.BodyFriction: {"between": trimmer.thesis.CUTTER_RELATIVE_TO_GUARD, "law": FRICTION},
    trimmer.simulate: {"loop": LOOP, "duration": 0.001, "initial_state": np.zeros(8), "impulse": 1e-6}
    | {"element_output": 0.0, "event_limit": 10, "step_limit": 1000},
    output: {"times": 0.0},
    state: {"times": 0.0},
    trimmer.forced_orbit: {"loop": TRIMMER, "settling": 8},
    trimmer.multi_harmonic_balance: {"system": SYSTEM, "element": PLAY, "cycle": CYCLE, "orders": (1, 3)},
    trimmer.periodic_orbits: {"system": SYSTEM, "element": PLAY, "guesses": (CYCLE,), "search": SEARCH},
    trimmer.OrbitSearch: {"simulations": "never", "half_periods": (1.0, 2.0)}
    | dict.fromkeys(("starts", "seed", "steps"), 1),
    trimmer.files.write_atomically: {"path": "a.bin", "content": b"", "overwrite": True},
    trimmer.TrimmerParameters.from_toml: {"path": "nothing.toml"},
    trimmer.Signal: {"values": SAMPLES, "sample_rate": 1.0, "name": "a", "unit": "m", "start": 0.0}
    | {"interpolated": 0, "converted": 0},
    trimmer.write_signal: {"path": "a.csv", "signal": SIGNAL, "overwrite": True},
    trimmer.signals.write_wav: {"path": "a.wav", "signal": SAMPLES, "sample_rate": 8000.0, "peak": 0.9}
    | {"overwrite": True},
    SIGNAL.scaled: {"factor": 2.0},
    SIGNAL.between: {"begin": 0.0, "end": 1.0},
    trimmer.read_signal: {"path": "a.csv", "sample_rate": 1.0, "layout": trimmer.signals.CsvLayout()}
    | {"sampling": trimmer.signals.Sampling()},
    trimmer.signals.read_wav: {"path": "a.wav", "channel": 1, "begin": 0.0, "end": 1.0},
    trimmer.convert: {"signal": MOVING, "quantity": "velocity", "highest": 200.0, "sensor_corner": 1.0},
    trimmer.faults: {"signal": SIGNAL},
    trimmer.spectra.averaged_spectrum: {"signals": SIGNAL, "averages": 2},
    trimmer.spectra.compare_motions: {"signal": MOVING, "simulated": SIMULATED, "drive_frequency": 160.0},
    trimmer.spectra.SimulatedLines: {"displacement": np.array([1j]), "frequency": 1.0, "period_count": 1},
    trimmer.analyse_signal: {"signal": SIGNAL, "drive_frequency": 100.0, "natural_frequencies": (10.0,)}
    | {"limit": 3, "limit_cycle_frequencies": (10.0,), "closed_loop": True},
    trimmer.spectra.classify: {"peaks": (), "bin_width": 1.0, "natural_frequencies": (1.0,)}
    | {"limit_cycle_frequencies": (1.0,), "tolerance": trimmer.spectra.Tolerance(), "closed_loop": True},
    trimmer.spectra.fit_harmonics: {"signal": SAMPLES, "sample_rate": 1000.0, "drive_frequency": 100.0}
    | {"count": 2},
    trimmer.peaks: {"spectrum": SPECTRUM, "limit": 3},
    trimmer.spectra.amplitude_spectrum: {"signal": SAMPLES, "sample_rate": 1000.0},
    trimmer.spectra.Tolerance: {"bins": 1.0, "model": 0.1},
}
NONE_WILL_DO = {
    "omega_range",
    "frozen_omega",
    "initial_state",
    "limit",
    "count",
    "drive_frequency",
    "settling",
}
NONE_WILL_DO |= {"drive", "element", "sample_rate", "omega", "guesses", "search", "half_periods", "channel"}
NONE_WILL_DO |= {"highest", "sensor_corner", "settling"}
"""Arguments that may be left out, somewhere."""
ALSO_NAMED = {"values": "samples", "signal": "samples", "bins": "tolerance in bins"}
ALSO_NAMED |= {"model": "model tolerance", "bin_width": "bin width", "drive_frequency": "of the drive"}
ANY_TEXT = {"path", "name", "unit", "content"}
NONSENSE = [
    None,
    "nonsense",
    math.nan,
    math.inf,
    [],
    (),
    0,
    -1,
    1.5,
    True,
    [1, "a"],
    [None],
    {},
    object(),
    1j,
]
NONSENSE += [np.full(3, np.nan), np.array([]), b"x", 10**400, [[1.0], [1.0, 2.0]], float, [math.nan]]


def right(call) -> dict[str, object]:
    return {name: motion() if value is motion else value for name, value in CALLS[call].items()}


def wrong(argument: str) -> list[object]:
    """What is of a wrong type for an argument."""
    return [
        value
        for kind, value in ANYTHING.items()
        if not (kind == "none" and argument in NONE_WILL_DO)
        and not (kind == "text" and argument in ANY_TEXT)
        and not (kind == "a loop" and argument == "loop")
        and argument not in ("between", "output")  # what is wrong there is called a displacement
    ]


@pytest.mark.parametrize("call", CALLS, ids=lambda call: call.__qualname__)
def test_a_wrong_type_is_named(call, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    for argument, value in ((name, value) for name in CALLS[call] for value in wrong(name)):
        with pytest.raises((ValueError, TypeError)) as caught:
            call(**{**right(call), argument: value})
        last = traceback.extract_tb(caught.value.__traceback__)[-1]
        assert Path(last.filename).is_relative_to(PACKAGE), ("raised by another package", argument, value)
        assert last.line.startswith("raise "), ("not raised on purpose", argument, value)
        message = str(caught.value)
        assert argument in message or ALSO_NAMED.get(argument, argument) in message, value
        assert isinstance(caught.value, trimmer.TrimmerError | ValueError)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("call", CALLS, ids=lambda call: call.__qualname__)
def test_nonsense_works_or_is_refused_on_purpose(call, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    for argument, value in itertools.product(CALLS[call], NONSENSE):
        try:
            call(**{**right(call), argument: value})
        except (trimmer.TrimmerError, ValueError) as error:
            last = traceback.extract_tb(error.__traceback__)[-1]
            assert Path(last.filename).is_relative_to(PACKAGE), (argument, value)
            assert str(last.line).startswith("raise "), (argument, value)


def test_frictions_may_be_a_list() -> None:
    friction = trimmer.loops.BodyFriction(trimmer.thesis.CUTTER_RELATIVE_TO_GUARD, FRICTION)
    assert trimmer.TrimmerLoop(THESIS, PLAY, DRIVE, frictions=[friction]).frictions == (friction,)


def test_numbers_of_other_kinds_are_numbers() -> None:
    for gap in (np.float32(0.5), np.array(0.5), Fraction(1, 2)):
        element = trimmer.FrictionBacklash(float(gap))
        assert trimmer.FrictionBacklash(gap).describing_function(1.0) == element.describing_function(1.0)
    assert trimmer.Drive(1, np.int64(2)) == trimmer.Drive(1.0, 2.0)
