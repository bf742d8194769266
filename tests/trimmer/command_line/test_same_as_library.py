"""What commands print as JSON is what the library returns, and what a record was made with is found."""

import json
from pathlib import Path

import numpy as np
import pytest

import trimmer
from tests.trimmer.command_line.inputs import AMPLITUDES, DRIVE, write_inputs
from trimmer.command_line.main import main
from trimmer.command_line.signals import signal_options, spectrum
from trimmer.progress import progress_bar, silenced
from trimmer.signals import BitDepth, DecimalSign, Delimiter, Gaps, MissingValues, MotionQuantity
from trimmer.spectra import Window

LOOP = ["--element", "friction", "--gap", "4e-5", "--channels", "displacement", "--json"]


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


@pytest.mark.parametrize(
    ("words", "amplitudes"),
    [
        (["logger.csv", "--gaps", "split", "--as", "displacement"], AMPLITUDES),
        (["volts.csv", "--rate", "5000", "--scale", "10", "--unit", "g", "--as", "displacement"], AMPLITUDES),
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
