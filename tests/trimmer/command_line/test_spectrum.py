from __future__ import annotations

import json
import wave
from pathlib import Path

import numpy as np
import pytest

from trimmer.balance.solve import limit_cycles
from trimmer.command_line.main import main
from trimmer.command_line.signals.signal_options import DECIMAL_SIGNS, DELIMITERS, MISSING_VALUES
from trimmer.command_line.signals.spectrum import BIT_DEPTHS, WINDOWS
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.linear.model import pin_model
from trimmer.linear.modes import modes
from trimmer.parameters import TrimmerParameters
from trimmer.signals.csv_layout import DecimalSign, Delimiter
from trimmer.signals.missing import MissingValues
from trimmer.signals.signal import Signal
from trimmer.signals.wav import BitDepth
from trimmer.signals.write import write_signal
from trimmer.spectra.window import Window

RATE, DRIVE, GAP = 20_000.0, 109.845, 4e-5


@pytest.fixture(scope="module")
def thesis_cycle() -> float:
    """Frequency of the stable limit cycle that harmonic balance predicts for the gap, Hz."""
    cycles = limit_cycles(pin_model(TrimmerParameters.thesis()), FrictionBacklash(GAP))
    (stable,) = [cycle for cycle in cycles if cycle.stable]
    return stable.frequency


@pytest.fixture
def file(tmp_path: Path, thesis_cycle: float) -> Path:
    """A second of a drive with a third harmonic, a limit cycle and something that nothing explains."""
    times = np.arange(20_000) / RATE
    parts = {DRIVE: 1e-3, 3 * DRIVE: 5e-5, thesis_cycle: 3e-5, 900.0: 1e-5}
    values = 2e-6 + sum(size * np.cos(2 * np.pi * f * times) for f, size in parts.items())
    write_signal(tmp_path / "measured.csv", Signal(values, RATE, "q2-q4", "m"))
    return tmp_path / "measured.csv"


def as_json(capsys: pytest.CaptureFixture[str], *words: object) -> dict:
    assert main(["spectrum", "--json", *map(str, words)]) == 0
    return json.loads(capsys.readouterr().out)


def test_json_holds_the_spectrum_in_full_precision(capsys, file: Path, thesis_cycle: float) -> None:
    printed = as_json(capsys, file, "--drive", DRIVE, "--gap", GAP, "--closed-loop")
    assert printed["signal"] == {
        **{"name": "q2-q4", "unit": "m", "samples": 20_000},
        **{"sample_rate": RATE, "start": 0.0, "interpolated": 0, "quantity": "displacement"},
        "trusted": {"lowest": 0.0, "highest": None, "lowest_reason": "", "highest_reason": ""},
    }
    assert printed["spectrum"]["window"] == "hann"
    assert printed["spectrum"]["bin_width"] == 1.0
    assert printed["harmonics"]["amplitudes"][:4] == pytest.approx([1e-3, 0.0, 5e-5, 0.0], abs=1e-9)
    assert printed["harmonics"]["phases"][0] == pytest.approx(0.0, abs=1e-6)
    assert printed["natural_frequencies"] == [mode.frequency for mode in modes(TrimmerParameters.thesis())]
    assert printed["limit_cycles"] == [thesis_cycle]
    assert [peak["frequency"] for peak in printed["peaks"]] == pytest.approx(
        [DRIVE, 3 * DRIVE, thesis_cycle, 900.0], abs=1e-6
    )
    drive, third, cycle, other = (peak["explanation"] for peak in printed["peaks"])
    assert drive == {"kind": "harmonic", "order": 1, "frequency": DRIVE, "odd": True}
    assert (third["kind"], third["order"]) == ("harmonic", 3)
    assert cycle == {"kind": "limit cycle", "number": 1, "order": 1, "frequency": thesis_cycle}
    assert other is None
    kinds = {candidate["kind"]: candidate for candidate in printed["peaks"][3]["candidates"]}
    assert set(kinds) == {"harmonic", "natural mode", "limit cycle"}
    assert kinds["harmonic"]["distance_bins"] == pytest.approx(900 - 8 * DRIVE, abs=1e-4)
    assert printed["wav"] is None


def test_text_is_short_tables_and_says_what_was_done(capsys, file: Path) -> None:
    words = ["spectrum", str(file), "--drive", str(DRIVE), "--gap", str(GAP), "--limit", "4", "--closed-loop"]
    assert main(words) == 0
    printed = capsys.readouterr().out
    for shown in (
        f"q2-q4 [m] of {file}: 20000 samples at 20000 Hz, 1 s\n",
        "bins 1 Hz apart, hann window, mean ",
        "harmonic 3 (odd)",
        "limit cycle 1",
        "unexplained",
        "nearest: harmonic 8 (even)  +21.24",
        "natural modes of the thesis's trimmer: 222.348 Hz, 354.837 Hz, 549.589 Hz, 1139.5 Hz",
    ):
        assert shown in printed
    assert "-0.00" not in printed
    assert max(len(line) for line in printed.splitlines() if str(file) not in line) <= 110


def test_a_driven_trimmer_is_not_said_to_have_a_limit_cycle(capsys, file: Path, thesis_cycle: float) -> None:
    printed = as_json(capsys, file, "--drive", DRIVE, "--gap", GAP)
    assert printed["limit_cycles"] == [thesis_cycle]
    assert {c["kind"] for peak in printed["peaks"] for c in peak["candidates"]} == {
        "harmonic",
        "natural mode",
    }
    assert printed["peaks"][2]["explanation"] is None
    assert "nothing feeds the output back" in printed["notes"][0]
    assert printed["harmonics"]["frequency"] == printed["harmonics"]["drive"] == DRIVE
    assert main(["spectrum", str(file), "--drive", str(DRIVE), "--gap", str(GAP)]) == 0
    text = capsys.readouterr().out
    assert "limit cycle 1" not in text
    assert "--closed-loop" in text
    assert max(len(line) for line in text.splitlines() if str(file) not in line) <= 110


def test_without_drive_and_gap_only_modes_are_candidates(capsys, file: Path) -> None:
    printed = as_json(capsys, file)
    assert (printed["harmonics"], printed["limit_cycles"]) == (None, None)
    assert {c["kind"] for peak in printed["peaks"] for c in peak["candidates"]} == {"natural mode"}
    assert main(["spectrum", str(file)]) == 0
    assert "Harmonics" not in capsys.readouterr().out


def test_parameters_change_modes_and_limit_cycles(capsys, file: Path, tmp_path: Path) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text(TrimmerParameters.thesis().to_toml().replace("m1 = 0.035", "m1 = 0.07"))
    printed = as_json(capsys, file, "--parameters", mine)
    expected = [mode.frequency for mode in modes(TrimmerParameters.from_toml(mine))]
    assert printed["natural_frequencies"] == expected
    only_displacement = as_json(capsys, file, "--gap", GAP, "--channels", "displacement")
    assert only_displacement["limit_cycles"] == pytest.approx([733.631], abs=1e-3)


def test_a_file_as_a_spreadsheet_writes_it(capsys, tmp_path: Path) -> None:
    """Semicolons, decimal commas, a line of units, Latin-1, a missing value, time in ms."""
    values = np.cos(2 * np.pi * 110 * np.arange(2000) / 2000)
    rows = [f"{k / 2:.1f};{value:.9f};0".replace(".", ",") for k, value in enumerate(values)]
    rows[500] = rows[500].split(";")[0] + ";;0"
    path = tmp_path / "Excel.csv"
    path.write_bytes("\r\n".join(["Time;Weg;Kanal µ", "ms;µm;V", *rows, ""]).encode("latin-1"))
    printed = as_json(capsys, path, "--column", "Weg", "--missing", "interpolate", "--drive", 110)
    assert printed["signal"]["sample_rate"] == 2000.0
    assert (printed["signal"]["unit"], printed["signal"]["interpolated"]) == ("µm", 1)
    assert printed["peaks"][0]["amplitude"] == pytest.approx(1.0, abs=1e-3)


def test_columns_can_be_described_instead_of_found_out(capsys, tmp_path: Path) -> None:
    values = np.cos(2 * np.pi * 110 * np.arange(2000) / 2000)
    path = tmp_path / "one.csv"
    path.write_text("\n".join(f"{value:.9f}".replace(".", ",") for value in values))
    printed = as_json(capsys, path, "--decimal", "comma", "--rate", 2000)
    assert printed["peaks"][0]["frequency"] == pytest.approx(110.0, abs=1e-6)
    path.write_text("\n".join(f"{value:.9f}\t{k}" for k, value in enumerate(values)))
    printed = as_json(capsys, path, "--delimiter", "tab", "--column", "1", "--rate", 2000)
    assert printed["signal"]["name"] == "column 1"


@pytest.mark.parametrize(("bits", "width"), [("16", 2), ("24", 3)])
def test_the_vibration_is_written_as_sound(capsys, file: Path, tmp_path: Path, bits: str, width: int) -> None:
    printed = as_json(capsys, file, "--wav", tmp_path / "a.wav", "--bits", bits)
    with wave.open(str(tmp_path / "a.wav")) as sound:
        assert (sound.getframerate(), sound.getsampwidth()) == (22_050, width)
        assert printed["wav"]["samples"] == sound.getnframes()
    assert printed["wav"]["bit_depth"] == int(bits)
    assert main(["spectrum", str(file), "--wav", str(tmp_path / "a.wav")]) == 0
    shown = capsys.readouterr().out.splitlines()[-1]
    assert shown.startswith(
        "Sound: 22050 samples at 22050 Hz, resampled from 20000 Hz, 16 bits; full scale is"
    )
    assert shown.endswith(" m")


@pytest.mark.parametrize(("name", "start"), [("a.svg", b"<?xml"), ("a.png", b"\x89PNG"), ("a.pdf", b"%PDF")])
def test_the_picture_is_the_same_bytes_each_time(file: Path, tmp_path: Path, name: str, start: bytes) -> None:
    contents = []
    for folder in ("one", "two"):
        target = tmp_path / folder / name
        assert main(["spectrum", str(file), "--drive", str(DRIVE), "--plot", str(target)]) == 0
        contents.append(target.read_bytes())
    assert contents[0].startswith(start)
    assert contents[0] == contents[1]
    assert len(contents[0]) < 200_000


def test_a_picture_of_noise_and_odd_units_is_drawn(tmp_path: Path) -> None:
    values = np.random.default_rng(0).normal(size=100_000)
    write_signal(tmp_path / "noise.csv", Signal(values, 1e6, "$x", "_$\\"))
    assert main(["spectrum", str(tmp_path / "noise.csv"), "--plot", str(tmp_path / "a.svg")]) == 0
    assert (tmp_path / "a.svg").stat().st_size < 400_000


def test_a_silent_record_is_no_error(capsys, tmp_path: Path) -> None:
    write_signal(tmp_path / "zero.csv", Signal(np.zeros(400), 2000.0))
    words = ["--drive", "110", "--plot", str(tmp_path / "a.svg"), "--wav", str(tmp_path / "a.wav")]
    assert main(["spectrum", str(tmp_path / "zero.csv"), *words]) == 0
    assert "by amplitude\n  none" in capsys.readouterr().out


def test_words_are_those_of_the_library() -> None:
    """They are written out, so that help needs no library."""
    assert tuple(window.word for window in Window) == WINDOWS
    assert tuple(delimiter.word for delimiter in Delimiter) == DELIMITERS
    assert tuple(sign.word for sign in DecimalSign) == DECIMAL_SIGNS
    assert tuple(missing.value for missing in MissingValues) == MISSING_VALUES
    assert tuple(depth.value for depth in BitDepth) == BIT_DEPTHS


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["{file}", "--column", "q1"], "{file}: no column is named 'q1'"),
        (["{file}", "--rate", "10000"], "{file}: the time stamps are those of 20000 Hz, not of 10000 Hz"),
        (
            ["{file}", "--drive", "0.5"],
            "{file}: the record lasts 1 s; 4 s or more are needed for a drive of 0.5",
        ),
        (["{file}", "--drive", "12000"], "{file}: a drive of 12000 Hz is not seen in samples at 20000 Hz"),
        (["{file}", "--parameters", "none.toml"], "none.toml: no such file"),
        (["{file}", "--gap", "1e-5", "--output", "q9"], "'q9' is not a displacement"),
        (["{file}", "--plot", "a.jpg"], "--plot a.jpg: the name must end in .svg"),
        (["{file}", "--wav", "a.mp3"], "--wav a.mp3: the name must end in .wav"),
        (["a.wav", "--wav", "./a.wav"], "--wav a.wav: is the file of the signal; name another one to write"),
        (["a.svg", "--plot", "a.svg"], "--plot a.svg: is the file of the signal"),
        (["none.csv", "--rate", "1"], "none.csv: no such file"),
        (["{short}"], "{short}: 3 samples are too few for a spectrum; 16 or more are needed"),
        (["{slow}", "--wav", "a.wav"], "{slow}: 2 samples per second hold no frequency above 1 Hz"),
    ],
)
def test_what_the_user_got_wrong_is_one_line_and_exit_code_2(
    capsys, monkeypatch, file: Path, tmp_path: Path, words: list[str], message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    write_signal(tmp_path / "short.csv", Signal(np.zeros(3), 1.0))
    write_signal(tmp_path / "slow.csv", Signal(np.zeros(30), 2.0))
    names = {"file": file, "short": tmp_path / "short.csv", "slow": tmp_path / "slow.csv"}
    before = sorted(tmp_path.iterdir())
    assert main(["spectrum", *(word.format(**names) for word in words)]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith(f"trimmer: {message.format(**names)}")
    assert printed.err.count("\n") == 1
    assert sorted(tmp_path.iterdir()) == before


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["a.csv", "--rate", "0"],
        ["a.csv", "--rate", "nan"],
        ["a.csv", "--rate", "fast"],
        ["a.csv", "--drive", "-110"],
        ["a.csv", "--gap", "inf"],
        ["a.csv", "--limit", "0"],
        ["a.csv", "--limit", "1.5"],
        ["a.csv", "--window", "hamming"],
        ["a.csv", "--bits", "8"],
        ["a.csv", "--missing", "ignore"],
    ],
)
def test_values_that_no_file_could_make_right_are_refused_in_a_sentence(capsys, words: list[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["spectrum", *words])
    assert stopped.value.code == 2
    told = capsys.readouterr().err
    assert told.startswith("trimmer: ")
    assert told.endswith("; see trimmer spectrum --help\n")
    assert told.count("\n") == 1
