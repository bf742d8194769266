"""What commands print as JSON is what the library returns, and what a record was made with is found."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import trimmer
from tests.trimmer.command_line.inputs import AMPLITUDES, DRIVE, write_inputs
from trimmer.command_line.main import main
from trimmer.command_line.signals import signal_options, spectrum
from trimmer.linear.model import InputChannels
from trimmer.progress import progress_bar, silenced
from trimmer.signals.csv_layout import DecimalSign, Delimiter
from trimmer.signals.missing import MissingValues
from trimmer.signals.quantity import MotionQuantity
from trimmer.signals.sampling import Gaps
from trimmer.signals.wav import BitDepth
from trimmer.spectra.window import Window

THESIS = trimmer.TrimmerParameters.thesis()
PLAY = trimmer.FrictionBacklash(4e-5)
LOOP = ["--element", "friction", "--gap", "4e-5", "--channels", "displacement", "--json"]
OPEN = trimmer.pin_model(THESIS, channels=InputChannels.DISPLACEMENT_ONLY)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("inputs")
    write_inputs(folder)
    return folder


@pytest.fixture
def printed(folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    monkeypatch.chdir(folder)

    def call(*words: str) -> dict:
        assert main(words) == 0
        text = capsys.readouterr().out
        content: dict = json.loads(text)
        assert text in {f"{json.dumps(content, indent=2, ensure_ascii=way)}\n" for way in (True, False)}
        return content

    return call


def test_shapes_of_a_structure_are_of_its_points(printed) -> None:
    content = printed("linear", str(Path(__file__).parents[3] / "examples" / "housing-modes.toml"), "--json")
    names = content["coordinates"]
    assert names == ["bit", "hand", "housing.motor", "housing.tool", "housing.handle"]
    shapes = [mode["shape"] for state in content["states"] for mode in state["modes"]]
    assert {len(shape) for shape in shapes} == {len(names)}


def test_the_linear_trimmer(printed) -> None:
    content = printed("linear", "--output", "q1", "--channels", "displacement", "--json")
    summary = trimmer.summarise(
        THESIS, trimmer.thesis.Displacement.parse("q1"), InputChannels.DISPLACEMENT_ONLY
    )
    assert content["parameters"] == vars(THESIS)
    assert [complex(*mode["eigenvalue"]) for mode in content["modes"]] == [
        mode.eigenvalue for mode in summary.modes
    ]
    assert tuple(complex(*pole) for pole in content["poles"]) == summary.factored.poles
    assert tuple(complex(*zero) for zero in content["zeros"]) == summary.factored.zeros
    assert tuple(content["gain_crossings"]) == summary.gain_crossings
    assert [peak["omega"] for peak in content["peaks"]] == [peak.omega for peak in summary.peaks]
    for name in ("static_gain",):
        assert content[name] == getattr(summary.factored, name)
    assert (content["bandwidth"], content["roll_off"]) == (summary.low_pass.bandwidth, summary.roll_off)


def test_limit_cycles_and_orbits(printed) -> None:
    balance = trimmer.harmonic_balance(OPEN, PLAY)
    expected = [(each.amplitude, each.frequency, each.stable) for each in balance.limit_cycles]
    content = printed("limit-cycles", *LOOP)
    told = [(each["amplitude"], each["frequency"], each["stable"]) for each in content["limit_cycles"]]
    assert told == expected
    assert content["certificate"]["complete"] is balance.certificate.complete is True
    orbits = trimmer.periodic_orbits(trimmer.ClosedLoop(OPEN, PLAY))
    told = [
        (each["amplitude"], each["period"], each["residual"]) for each in printed("orbits", *LOOP)["orbits"]
    ]
    assert told == [(each.amplitude, each.period, each.residual) for each in orbits]


def test_what_a_mechanism_does(printed) -> None:
    twin = trimmer.Mechanism.from_toml("examples/thesis-play.toml").with_value("frictions.blade.force", 1.0)
    words = ["examples/thesis-play.toml", "--set", "frictions.blade.force=1", "--json"]
    content, orbit = printed("respond", *words), trimmer.respond(twin).motion.orbit
    assert [complex(*each) for each in content["multipliers"]] == list(orbit.multipliers)
    stroke = content["outputs"]["stroke"]
    assert stroke["peak_to_peak"] == orbit.measures.outputs["stroke"].peak_to_peak
    content = printed("simulate", *words, "--duration", "0.02", "--state", "motor=1um,-3")
    motion = trimmer.simulate(twin, 0.02, state={"motor": (1e-6, -3.0)})
    assert [each["time"] for each in content["events"]] == [each.time for each in motion.events]
    assert content["energy"]["pins"] == motion.energy.pins


@pytest.mark.parametrize(
    ("words", "amplitudes"),
    [
        (["logger.csv", "--gaps", "split", "--as", "displacement"], AMPLITUDES),
        (
            ["volts.csv", "--rate", "5000", "--scale", "10", "--unit", "g", "--as", "displacement"],
            AMPLITUDES,
        ),
        (["jitter.csv", "--resample"], {1: 1.0}),
    ],
    ids=lambda each: each[0] if isinstance(each, list) else "",
)
def test_the_amplitudes_that_a_record_was_made_with_are_found(printed, words, amplitudes) -> None:
    content = printed("spectrum", *words, "--drive", str(DRIVE), "--average", "10", "--json")
    for order, amplitude in amplitudes.items():
        assert content["harmonics"]["amplitudes"][order - 1] == pytest.approx(amplitude, rel=3e-3)
    for line, amplitude in zip(content["averaged"]["lines"], sorted(amplitudes.values())[::-1], strict=False):
        low, high = line["interval"]
        assert low - 2e-3 * amplitude < amplitude < high + 2e-3 * amplitude
    frequencies, densities = (np.array(content["averaged"][name]) for name in ("frequencies", "densities"))
    drive = abs(frequencies - DRIVE) < 5 * frequencies[1]
    power = densities[drive].sum() * frequencies[1]
    assert power == pytest.approx(amplitudes[1] ** 2 / 2, rel=0.02)


def test_what_was_simulated_is_found_again(printed, tmp_path: Path) -> None:
    content = printed("overlay", "speed.csv", "--column", "v", "--against", "stop.toml", "--json")
    assert content["frequency"] == pytest.approx(20.0, rel=1e-5)
    assert content["rest"] == pytest.approx(1e-3, rel=0.1)  # the noise
    fitted = tmp_path / "fitted.toml"
    words = ["--set", "plays.bridge.gap=50um", "--free", "plays.bridge.gap", "--starts", "1"]
    words += ["--set", "frictions.blade.force=1", "--output", str(fitted), "--json"]
    (number,) = printed("fit", "examples/thesis-play.toml", "stroke.csv", *words)["numbers"]
    assert number["lower"] < 40e-6 < number["upper"]
    assert trimmer.Mechanism.from_toml(fitted).value("plays.bridge.gap") == number["value"]


def test_the_mirrored_motion_of_a_loop(printed) -> None:
    words = ["simulate", *LOOP, "--duration", "0.02", "--impulse"]
    first, second = (printed(*words, impulse) for impulse in ("1e-6", "-1e-6"))
    assert [each["time"] for each in first["events"]] == [each["time"] for each in second["events"]]
    turned = {"upper contact": "lower contact", "lower contact": "upper contact"}
    assert [turned.get(each["mode"], each["mode"]) for each in first["events"]] == [
        each["mode"] for each in second["events"]
    ]


def test_words_are_those_of_the_library() -> None:
    """They are written out, so that help needs no library."""
    assert tuple(each.word for each in Window) == spectrum.WINDOWS
    assert tuple(each.value for each in BitDepth) == spectrum.BIT_DEPTHS
    assert tuple(each.word for each in Delimiter) == signal_options.DELIMITERS
    assert tuple(each.word for each in DecimalSign) == signal_options.DECIMAL_SIGNS
    assert tuple(each.word for each in MissingValues) == signal_options.MISSING_VALUES
    assert tuple(each.word for each in Gaps) == signal_options.GAPS
    quantities = tuple(each.word for each in MotionQuantity if each is not MotionQuantity.OTHER)
    assert quantities == signal_options.QUANTITIES


@pytest.mark.parametrize(("terminal", "quiet"), [(True, False), (True, True), (False, False)])
def test_a_bar_shows_on_a_terminal_alone(monkeypatch, capsys, terminal: bool, quiet: bool) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: terminal)
    if quiet:
        with silenced():
            bar = progress_bar(range(3), "cells")
    else:
        bar = progress_bar(range(3), "cells")
    bar.refresh()
    assert ("cells" in capsys.readouterr().err) is (terminal and not quiet)
