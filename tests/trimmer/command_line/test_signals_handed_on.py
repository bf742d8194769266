"""What the commands on measured signals, and those that close a loop, make of their options."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path
from types import SimpleNamespace as Made

import numpy as np
import pytest

import trimmer
from tests.trimmer.command_line.handed_on import Called, as_words
from trimmer.command_line.main import main
from trimmer.command_line.parser import OptionError
from trimmer.command_line.signals import fit, overlay, signal_options

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = str(EXAMPLES / "thesis-play.toml")


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    """Two seconds of two sines, in m."""
    times = np.arange(1000) / 500
    columns = [times, 1e-3 * np.sin(2 * np.pi * 40 * times), 2e-3 * np.cos(2 * np.pi * 90 * times)]
    file = tmp_path / "vibration.csv"
    np.savetxt(
        file, np.transpose(columns), delimiter=",", header="time [s],first [m],second [m]", comments=""
    )
    return file


def test_spectrum_hands_on_what_is_asked(
    replaced, written, monkeypatch, recorded: Path, tmp_path: Path, capsys
) -> None:
    analyse = replaced("trimmer.spectra.analysis.analyse_signal", Made(plot=Called()))
    average = replaced("trimmer.spectra.averaged.averaged_spectrum", "averaged")
    balance = replaced(
        "trimmer.balance.solve.harmonic_balance",
        Made(limit_cycles=[Made(frequency=740.0, stable=True), Made(frequency=3.0, stable=False)]),
    )
    wav = replaced("trimmer.signals.wav.write_wav", "wav")
    shown = []
    module = "trimmer.command_line.signals.spectrum_text"
    monkeypatch.setattr(f"{module}.as_text", lambda each: shown.append(each) or "told")
    monkeypatch.setattr(f"{module}.as_json", lambda each: shown.append(each) or "data")
    words = ["spectrum", str(recorded), "--column", "first"]
    assert main(words) == 0
    signal, drive, natural, cycles, window, limit = analyse.arguments
    assert (signal.name, signal.unit, signal.sample_rate, signal.values.size) == ("first", "m", 500.0, 1000)
    assert (drive, cycles, window, limit, analyse.keywords) == (None, (), "hann", 20, {"closed_loop": False})
    assert max(natural) > 100
    (first,) = shown
    assert (first.file, first.analysis, first.chosen.signal) == (recorded, analyse.result, signal)
    assert (first.averaged, first.wav, first.predictions.gap) == (None, None, None)
    assert first.predictions.source == "the thesis's trimmer"
    sound, table, picture = tmp_path / "a.wav", tmp_path / "a.csv", tmp_path / "a.svg"
    words += ["--drive", "40", "--gap", "4e-5", "--closed-loop", "--window", "flat-top", "--limit", "3"]
    words += ["--average", "5", "--wav", str(sound), "--csv", str(table), "--bits", "24", "--json"]
    assert main([*words, "--plot", str(picture)]) == 0
    signal, drive, _, cycles, window, limit = analyse.arguments
    assert (drive, cycles, window, limit) == (40.0, (740.0,), "flat-top", 3)
    assert analyse.keywords == {"closed_loop": True}
    assert average.arguments == ((signal,), 5, "flat-top")
    assert balance.arguments[1].gap == 4e-5
    assert (wav.arguments[0], wav.arguments[2:], wav.keywords) == (sound, (500.0, 24), {"overwrite": False})
    np.testing.assert_array_equal(wav.arguments[1], signal.values)
    assert (shown[1].averaged, shown[1].wav, shown[1].predictions.gap) == ("averaged", "wav", 4e-5)
    np.testing.assert_allclose(np.loadtxt(table, delimiter=",", skiprows=1)[:, 1], signal.values)
    assert len(written) == 1
    assert capsys.readouterr().out == "told\ndata\n"
    for wrong in (["--output", "q3"], ["--channels", "both"], ["--bits", "16"]):
        assert main(["spectrum", str(recorded), "--column", "first", *wrong]) == 2
    analyse.result = trimmer.SignalError("too short")
    assert main(words[:4]) == 2
    assert f"{recorded}: too short" in capsys.readouterr().err


def test_overlay_hands_on_what_settles(
    replaced, written, monkeypatch, recorded: Path, tmp_path: Path, capsys
) -> None:
    output = Made(amplitudes=np.array([3.0, 1.0]))
    orbit = Made(measures=Made(outputs={"stroke": output}), period_count=2, period=0.05)
    respond = replaced(
        "trimmer.response.respond.respond", Made(motion=Made(orbit=orbit, message="It settles."))
    )
    compare = replaced("trimmer.spectra.comparison.compare_motions", "comparison")
    figure = replaced("trimmer.drawing.signals.comparison.comparison_figure", "figure")
    shown = []
    module = "trimmer.command_line.signals.overlay_text"
    monkeypatch.setattr(f"{module}.as_text", lambda each: shown.append(each) or "told")
    monkeypatch.setattr(f"{module}.as_json", lambda each: "data")
    words = ["overlay", str(recorded), "--column", "second", "--against", TWIN, "--set", "frequency=60"]
    assert main(words) == 0
    signal, lines, drive = compare.arguments
    assert (signal.name, drive, respond.arguments[0].frequency) == ("second", None, 60)
    assert (lines.displacement.tolist(), lines.frequency, lines.period_count) == ([3.0, 1.0], 60.0, 2)
    (first,) = shown
    assert (first.file, first.against, first.output, first.settled) == (
        recorded,
        Path(TWIN),
        "stroke",
        "It settles.",
    )
    assert (first.chosen.signal.name, first.comparison) == ("second", "comparison")
    picture = tmp_path / "a.svg"
    assert main([*words, "--drive", "61", "--output", "stroke", "--json", "--plot", str(picture)]) == 0
    assert compare.arguments[2] == 61.0
    assert (figure.arguments, written) == (("comparison",), ["figure"])
    assert capsys.readouterr().out == "told\ndata\n"
    compare.result = trimmer.SignalError("too short")
    assert main(words) == 2
    assert f"{recorded}: too short" in capsys.readouterr().err
    respond.result.motion.orbit = None
    assert main(words) == 2
    assert "does not repeat" in capsys.readouterr().err
    assert main(["overlay", "-", "--against", "-"]) == 2


def test_the_output_that_was_measured_is_chosen() -> None:
    one, two, none = (Made(outputs=dict.fromkeys(names)) for names in ("a", "ab", ""))
    asked = Namespace(output=None, against="m.toml")
    assert overlay._output(asked, one) == "a"
    for mechanism, listed in ((two, "a, b"), (none, "none")):
        with pytest.raises(
            OptionError, match=rf"choose the output that was measured \(--output\): {listed}$"
        ):
            overlay._output(asked, mechanism)
    asked.output = "b"
    assert overlay._output(asked, two) == "b"
    with pytest.raises(OptionError, match=r"^m\.toml: there is no output 'b'; there are a$"):
        overlay._output(asked, one)
    asked.output = "strok"
    with pytest.raises(OptionError, match=r"there is no output 'strok'; did you mean stroke\?$"):
        overlay._output(asked, Made(outputs={"stroke": 1}))


def test_lines_of_what_moves_by_itself_are_at_its_own_frequency(replaced) -> None:
    orbit = Made(measures=Made(outputs={"x": Made(amplitudes=np.ones(1))}), period_count=1, period=0.04)
    replaced("trimmer.response.respond.respond", Made(motion=Made(orbit=orbit, message="")))
    lines, _ = overlay._simulated(Made(frequency=None), "x")
    assert lines.frequency == pytest.approx(25.0)


def test_fit_hands_on_what_is_asked(replaced, written, monkeypatch, tmp_path: Path, capsys) -> None:
    file = tmp_path / "measured.csv"
    times = np.arange(400) / 4000
    np.savetxt(
        file,
        np.transpose([times, 1e-3 * np.sin(700 * times)]),
        delimiter=",",
        header="time [s],stroke [m]",
        comments="",
    )
    result = Made(mechanism=Made(to_toml=lambda: "# Mechanism that moves along one line\n"))
    fitted = replaced("trimmer.fitting.fit.fit_mechanism", result)
    figure = replaced("trimmer.drawing.signals.fit.fit_figure", "figure")
    as_words(monkeypatch, "signals.fit_text")
    shown = []
    monkeypatch.setattr(
        "trimmer.command_line.signals.fit_text.as_text", lambda each: shown.append(each) or "told"
    )
    words = ["fit", TWIN, str(file)]
    assert main(words) == 0
    assert (shown[0].file, shown[0].measured, shown[0].output) == (Path(TWIN), file, None)
    assert (list(shown[0].recordings), shown[0].fit) == (["stroke"], result)
    mechanism, signals, free = fitted.arguments
    assert (mechanism.title != "", list(signals), free) == (True, ["stroke"], [])
    settings = fitted.keywords["settings"]
    assert (settings.starts, settings.seed, fitted.keywords["drive_frequency"]) == (5, 0, None)
    output, picture = tmp_path / "fitted.toml", tmp_path / "a.svg"
    words += ["--free", "plays.bridge.gap", "--free", "frictions.blade.force", "--starts", "2", "--seed", "3"]
    words += ["--drive", "111", "--output", str(output), "--plot", str(picture), "--column", "stroke=2"]
    assert main([*words, "--json", "--from", "0.05"]) == 0
    _, signals, free = fitted.arguments
    assert free == ["plays.bridge.gap", "frictions.blade.force"]
    assert signals["stroke"].values.size == 200
    settings = fitted.keywords["settings"]
    assert (settings.starts, settings.seed, fitted.keywords["drive_frequency"]) == (2, 3, 111.0)
    assert (figure.arguments, written) == ((result,), ["figure"])
    assert output.read_text("utf-8") == result.mechanism.to_toml()
    assert capsys.readouterr().out == "told\ndata\n"
    for wrong in (["--starts", "1", "--seed", "2"], ["--seed", "-1"], ["--column", "strok=2"]):
        assert main([*words[:3], *wrong]) == 2
    assert main(["fit", "-", "-"]) == 2
    fitted.result = trimmer.SignalError("too short")
    assert main(words[:3]) == 2
    assert f"{file}: too short" in capsys.readouterr().err


def test_columns_belong_to_outputs(recorded: Path) -> None:
    def columns(outputs: str, given: list[str], measured: Path = recorded) -> dict[str, str | None]:
        names = dict.fromkeys(outputs.split())
        return fit._columns(Namespace(columns=given, measured=measured, file="m.toml"), Made(outputs=names))

    assert columns("second other", []) == {"second": "second"}
    assert columns("first second", []) == {"first": "first", "second": "second"}
    assert columns("x", []) == {"x": None}
    assert columns("x", [], Path("-")) == {"x": None}
    assert columns("x", ["first"]) == {"x": "first"}
    assert columns("x y", ["y=first", "x=a=b"]) == {"y": "first", "x": "a=b"}
    for outputs, given, told in (
        ("", [], "no output that could be measured"),
        ("x y", [], "no column has the name"),
        ("x y", ["first"], "x=first or y=first"),
        ("x y", ["x="], "no output 'x'"),
        ("x y", ["z=first"], "there are x, y"),
        ("x y", ["x=first", "x=second"], "by another column already"),
    ):
        with pytest.raises(OptionError, match=told):
            columns(outputs, given)


def test_several_columns_have_one_time(monkeypatch: pytest.MonkeyPatch) -> None:
    signals = {
        "1": trimmer.Signal(np.arange(5.0), 10.0),
        "2": trimmer.Signal(np.arange(5.0), 10.0, start=1.0),
    }
    monkeypatch.setattr(fit, "_columns", lambda *_: {"a": "1", "b": "2"})
    monkeypatch.setattr(fit, "chosen_recording", lambda given: Made(signal=signals[given.column]))
    arguments = Namespace(measured=Path("m.csv"), file=Path("f.toml"), scale=None, unit=None, quantity="x")
    with pytest.raises(OptionError, match="unlike times"):
        fit._recordings(arguments, Made())
    signals["2"] = signals["1"]
    assert list(fit._recordings(arguments, Made())) == ["a", "b"]
    arguments.measured = Path("-")
    with pytest.raises(OptionError, match="standard input"):
        fit._recordings(arguments, Made())
    arguments.given = frozenset(["scale"])
    with pytest.raises(OptionError, match="--scale has no effect without a single column"):
        fit._recordings(arguments, Made())
    monkeypatch.setattr(fit, "_columns", lambda *_: {"a": "1"})
    assert list(fit._recordings(arguments, Made())) == ["a"]
    reading = fit._reading(arguments, "3")
    assert (reading.file, reading.column, reading.quantity) == (Path("-"), "3", None)


def test_samples_of_a_part_of_the_record_are_used(recorded: Path, replaced, monkeypatch) -> None:
    analyse = replaced("trimmer.spectra.analysis.analyse_signal")
    as_words(monkeypatch, "signals.spectrum_text")
    words = ["spectrum", str(recorded), "--column", "2"]

    def analysed(*more: str) -> trimmer.Signal:
        assert main([*words, *more]) == 0
        return analyse.arguments[0]

    assert (analysed("--from", "0.5").start, analysed("--from", "0.5").values.size) == (0.5, 750)
    assert analysed("--until", "0.498").values.size == 250
    assert analysed("--from", "0.5", "--until", "0.998").values.size == 250
    plain = analysed()
    np.testing.assert_allclose(analysed("--scale", "-2").values, -2 * plain.values)
    assert analysed("--scale", "3", "--unit", "m/s").unit == "m/s"
    assert main([*words, "--unit", "m/s"]) == 2  # the heading says m
    assert analysed("--unit", "m").unit == "m"
    assert analysed("--ignore-time", "--rate", "100").sample_rate == 100.0
    assert main([*words, "--ignore-time"]) == 2
    assert analysed("--resample").sample_rate == pytest.approx(500.0)
    velocity = analysed("--as", "velocity", "--lowest", "20")
    assert velocity.unit == "m/s"
    assert velocity.trusted.lowest == 20.0
    for wrong in (["--lowest", "20"], ["--highest", "20"], ["--sensor-corner", "2"], ["--channel", "1"]):
        assert main([*words, *wrong]) == 2


def test_stretches_that_are_too_short_are_left_out() -> None:
    rng = np.random.default_rng(2)
    long, middle, short = (
        trimmer.Signal(1e-3 * rng.normal(size=size), 1000.0, "x", "m", start=start)
        for size, start in ((4000, 10.0), (2000, 20.0), (3, 30.0))
    )
    recording = trimmer.Recording((middle, long, short))
    asked = Namespace(quantity="velocity", lowest=30.0, highest=200.0, sensor_corner=None)
    first, second = signal_options._converted(asked, recording)
    # In the order of the record, each cut where the filter settles.
    assert (first.start - middle.start, second.start - long.start) == pytest.approx((0.2, 0.2))
    assert {first.trusted.lowest, second.trusted.lowest} == {30.0}
    assert {first.trusted.highest, second.trusted.highest} == {200.0}
    for each in (first, second):
        assert each.notes[-1].endswith("left out: 1")
    (alone,) = signal_options._converted(asked, trimmer.Recording((long,)))
    assert not any("left out" in note for note in alone.notes)
