"""Files as a laboratory has them, through the commands: what is asked, what is told, what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.io import wavfile

from tests.json_document import documented, keys
from trimmer.command_line.main import main
from trimmer.command_line.signals.signal_options import CLIPPED, GAPS, MISSING_VALUES, QUANTITIES
from trimmer.signals.missing import MissingValues
from trimmer.signals.quantity import STANDARD_GRAVITY, Quantity
from trimmer.signals.read import read_signal
from trimmer.signals.sampling import Gaps

OF_FAULTS = {"faults[].kind", "faults[].certainty", "faults[].message"}
OF_GAPS = {"gaps[].begin", "gaps[].end", "gaps[].line", "gaps[].missing"}
RATE, DRIVE = 5000.0, 110.3
TIMES = np.arange(20_000) / RATE
AMPLITUDES = {1: 1.2e-3, 2: 2e-5, 3: 1.5e-4}
RNG = np.random.default_rng(3)
ACCELERATION = (
    sum(
        -((2 * np.pi * n * DRIVE) ** 2) * a * np.cos(2 * np.pi * n * DRIVE * TIMES + n)
        for n, a in AMPLITUDES.items()
    )
    / STANDARD_GRAVITY
    + 0.3 * RNG.normal(size=TIMES.size)
    + 0.8
    + 0.05 * TIMES
)
"""What an accelerometer on the blade gives, g: noise, offset and drift with it."""

MECHANISM = """
title = "Oscillator at a stop"
frequency = 20.0
[bodies]
mass = { mass = 1.0 }
[pins]
[links]
spring = { between = ["ground", "mass"], stiffness = 1e4, damping = 10.0 }
[stops]
wall = { between = ["mass", "ground"], stiffness = 1e5, damping = 20.0, gap = 1e-3 }
[forces]
shaker = { on = "mass", amplitude = 40.0 }
[outputs]
mass = { mass = 1 }
"""


def run(capsys, *words: object) -> dict:
    assert main([*map(str, words), "--json"]) == 0
    printed: dict = json.loads(capsys.readouterr().out)
    return printed


def refused(capsys, *words: object) -> str:
    assert main([*map(str, words)]) == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1
    return str(printed.err)


@pytest.fixture
def logger(tmp_path: Path) -> Path:
    """A spreadsheet of a logger: preamble, units in a line, decimal commas, stamps in ms, a gap."""
    kept = np.r_[0:9000, 9400:20_000]
    rows = (f"{TIMES[k]:.3f};{ACCELERATION[k]:.4f}".replace(".", ",") for k in kept)
    path = tmp_path / "logger.csv"
    path.write_text("\n".join(["Logger 3000", "serial;1234", "Time;Accel X", "s;g", *rows]))
    return path


def test_a_logger_with_a_gap_becomes_displacement(capsys, logger: Path, tmp_path: Path) -> None:
    told = refused(capsys, "spectrum", logger)
    assert "1 gap in the time stamps: gap of 0.08 s after 1.8 s" in told and "--gaps split" in told
    written = tmp_path / "displacement.csv"
    words = ["--drive", DRIVE, "--gaps", "split", "--as", "displacement", "--average", 10]
    printed = run(capsys, "spectrum", logger, *words, "--csv", written)
    assert (printed["signal"]["unit"], printed["signal"]["quantity"]) == ("m", "displacement")
    assert 10 < printed["signal"]["trusted"]["lowest"] < 13
    assert printed["gaps"][0]["missing"] == pytest.approx(400, abs=6)
    assert len(printed["stretches"]) == 2
    for order, amplitude in AMPLITUDES.items():
        assert printed["harmonics"]["amplitudes"][order - 1] == pytest.approx(amplitude, rel=3e-3)
    assert [peak["frequency"] for peak in printed["peaks"]] == pytest.approx([110.3, 330.9, 220.6], abs=0.01)
    lines = printed["averaged"]["lines"]
    assert [line["frequency"] for line in lines] == pytest.approx([110.3, 330.9, 220.6], abs=0.05)
    for line, amplitude in zip(lines, (1.2e-3, 1.5e-4, 2e-5), strict=True):
        low, high = line["interval"]
        assert low - 2e-3 * amplitude < amplitude < high + 2e-3 * amplitude
    notes = " ".join(printed["notes"])
    for part in (
        "rounded to 0.001 s",
        "1 gap",
        "converted to displacement",
        "cut off at either end",
        "longest",
    ):
        assert part in notes
    assert set(keys(printed)) - {"faults"} <= documented("trimmer spectrum")
    assert set(keys(printed)) >= OF_GAPS
    assert read_signal(written).heading == "Accel X as displacement [m]"


def test_the_text_tells_the_same_within_110_signs(capsys, logger: Path) -> None:
    words = ["spectrum", str(logger), "--gaps", "split", "--as", "velocity", "--average", "10"]
    assert main(words) == 0
    text = capsys.readouterr().out
    assert "Average of 10 spectra (Welch)" in text and "lines closer than" in text
    assert "note: acceleration converted to velocity" in text
    assert max(len(line) for line in text.splitlines()[1:]) <= 110


@pytest.fixture
def sound(tmp_path: Path) -> Path:
    """A stereo WAV file of 16 bits, whose full scale is 60 g, so that it is clipped."""
    path = tmp_path / "recorder.wav"
    clipped = np.clip(np.rint(32768 * ACCELERATION / 60), -32768, 32767)
    samples = np.stack([np.zeros(TIMES.size), clipped], axis=1)
    wavfile.write(path, int(RATE), samples.astype(np.int16))
    return path


def test_a_clipped_wav_file_is_marked_or_refused(capsys, sound: Path) -> None:
    assert "has 2 channels; choose one" in refused(capsys, "spectrum", sound)
    printed = run(capsys, "spectrum", sound, "--channel", 2)
    assert printed["signal"]["quantity"] == "other"
    assert any("no scale was given" in note for note in printed["notes"])
    (fault,) = printed["faults"]
    assert set(keys(printed)) >= OF_FAULTS
    assert (fault["kind"], fault["certainty"]) == ("clipping", "certain")
    assert "does not tell whether" in refused(
        capsys, "spectrum", sound, "--channel", 2, "--as", "displacement"
    )
    scaled = ["--channel", 2, "--scale", 60, "--unit", "g"]
    printed = run(capsys, "spectrum", sound, *scaled, "--from", 1, "--until", 3, "--as", "velocity")
    assert printed["signal"]["unit"] == "m/s"
    assert printed["signal"]["start"] > 1.0
    assert any("clipped at full scale" in note for note in printed["notes"])
    assert "clipped at full scale" in refused(capsys, "spectrum", sound, *scaled, "--clipped", "refuse")


def test_jittering_stamps_are_resampled_or_ignored(capsys, tmp_path: Path) -> None:
    times = TIMES[:8000] + RNG.uniform(-3e-5, 3e-5, 8000)
    values = np.cos(2 * np.pi * DRIVE * times) + 0.05 * np.cos(2 * np.pi * 1500.0 * times)
    path = tmp_path / "jitter.csv"
    path.write_text(
        "t [ms],v [mm/s]\n"
        + "\n".join(f"{1e3 * t:.4f},{v!r}" for t, v in zip(times, values.tolist(), strict=True))
    )
    assert "--resample" in refused(capsys, "spectrum", path)
    printed = run(capsys, "spectrum", path, "--resample", "--drive", DRIVE)
    assert printed["harmonics"]["amplitudes"][0] == pytest.approx(1.0, rel=1e-3)
    assert 500 < printed["signal"]["trusted"]["highest"] < 700
    assert any(note.startswith("not to be trusted: peaks at 1500") for note in printed["notes"])
    assert "--ignore-time needs the sample rate" in refused(capsys, "spectrum", path, "--ignore-time")
    printed = run(capsys, "spectrum", path, "--ignore-time", "--rate", 5000)
    assert any("time stamps are left aside" in note for note in printed["notes"])


def test_volts_become_displacement_with_the_sensitivity(capsys, tmp_path: Path) -> None:
    path = tmp_path / "volts.csv"
    np.savetxt(path, 0.1 * ACCELERATION, header="U [V]", comments="")
    words = ["spectrum", path, "--rate", RATE, "--drive", DRIVE, "--as", "displacement"]
    assert "the unit 'V' does not tell" in refused(capsys, *words)
    assert "the heading says that U is in V, not in g" in refused(capsys, *words, "--unit", "g")
    printed = run(capsys, *words, "--scale", 10, "--unit", "g", "--sensor-corner", 5)
    assert printed["harmonics"]["amplitudes"][0] == pytest.approx(1.2e-3, rel=3e-3)
    assert printed["signal"]["trusted"]["lowest"] == 15.0


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["{wav}", "--column", "1"], "--column has no effect without a CSV file; this one is a WAV file"),
        (["{wav}", "--channel", "1", "--resample"], "--resample has no effect on a WAV file"),
        (["none.wav", "--channel", "1"], "none.wav: no such file"),
        (["{csv}", "--channel", "1"], "--channel has no effect without a WAV file"),
        (["{csv}", "--lowest", "5"], "--lowest has no effect without --as"),
        (["{csv}", "--gaps", "split", "--from", "9"], "no sample lies from 9 s"),
        (["{csv}", "--gaps", "split", "--as", "velocity", "--lowest", "1"], "too short to convert from 1"),
        (["{csv}", "--gaps", "split", "--average", "5000"], "too few for 5000 averages"),
        (["{csv}", "--gaps", "split", "--scale", "0"], "the factor must be finite and not 0"),
        (["{csv}", "--csv", "{csv}"], "is the file of the signal"),
    ],
)
def test_what_does_not_fit_is_refused_in_a_sentence(capsys, logger, sound, words, message: str) -> None:
    assert message in refused(capsys, "spectrum", *(word.format(csv=logger, wav=sound) for word in words))


def test_words_are_those_of_the_library() -> None:
    assert tuple(each.word for each in Gaps) == GAPS
    assert tuple(each.word for each in MissingValues) == MISSING_VALUES
    assert tuple(each.word for each in Quantity if each is not Quantity.OTHER) == QUANTITIES
    assert CLIPPED == ("mark", "refuse")


@pytest.fixture(scope="module")
def oscillator(tmp_path_factory) -> Path:
    """A mechanism, and beside it its own motion as measured: velocity with noise, from some time on."""
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.response.simulate import simulate

    folder = tmp_path_factory.mktemp("oscillator")
    (folder / "stop.toml").write_text(MECHANISM)
    motion = simulate(Mechanism.from_toml(folder / "stop.toml"), 4.0)
    times = np.arange(2.013, 4.0, 5e-4)
    velocity = motion.velocity("mass", times)
    noise = 1e-3 * np.random.default_rng(0).normal(size=times.size)
    table = np.column_stack([times, velocity + noise, -velocity])
    np.savetxt(folder / "speed.csv", table, "%.9g", ",", header="t,v [m/s],turned [m/s]", comments="")
    return folder


def test_a_measured_motion_is_compared_with_the_simulated_one(
    capsys, oscillator: Path, tmp_path: Path
) -> None:
    words = ["overlay", oscillator / "speed.csv", "--against", oscillator / "stop.toml"]
    printed = run(capsys, *words, "--column", "v", "--plot", tmp_path / "a.svg")
    assert (tmp_path / "a.svg").read_bytes().startswith(b"<?xml")
    assert printed["frequency"] == pytest.approx(20.0, rel=1e-5)
    assert printed["residual"] < 0.01
    assert printed["rest"] == pytest.approx(1e-3, rel=0.1)
    assert [line["decibels"] for line in printed["lines"][:3]] == pytest.approx([0.0, 0.0, 0.0], abs=0.1)
    known = documented("trimmer overlay") - OF_FAULTS - OF_GAPS
    assert set(keys(printed)) - {"faults", "gaps"} == known
    turned = run(capsys, *words, "--column", "turned")
    assert any("--scale -1" in note for note in turned["notes"])
    assert main([*map(str, words), "--column", "turned", "--scale", "-1"]) == 0
    text = capsys.readouterr().out
    assert "the simulation is shifted by" in text and "--scale -1" not in text
    assert max(len(line) for line in text.splitlines()[1:]) <= 110


def test_another_frequency_is_told(capsys, oscillator: Path) -> None:
    words = ["overlay", oscillator / "speed.csv", "--column", "v", "--against", oscillator / "stop.toml"]
    printed = run(capsys, *words, "--set", "frequency=20.2Hz")
    assert any("--set frequency=20Hz" in note for note in printed["notes"])
    told = refused(capsys, *words, "--set", "frequency=25Hz")
    assert "explain only" in told and "--drive" in told
    assert "there is no output 'x'; there are mass" in refused(capsys, *words, "--output", "x")
