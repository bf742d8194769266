"""What makes a spectrum doubtful is told: clipping, aliasing, a record that is too short."""

import json
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.complaints import complaints
from trimmer import analyse_signal
from trimmer.command_line.main import main
from trimmer.errors import SignalWarning
from trimmer.signals import Band, Signal, write_signal
from trimmer.spectra.doubts import aliasing_doubt

RATE = 5000.0
TIMES = np.arange(5000) / RATE
SINE = np.sin(2 * np.pi * 109.8 * TIMES)


def test_a_drive_above_half_of_the_sample_rate_is_told_with_where_it_shows() -> None:
    """Sampled sines say where: 110 Hz at 100 Hz shows at 10 Hz."""
    assert aliasing_doubt(49.0, 100.0) is None
    for drive in (50.0, 70.0, 110.0, 190.0):
        told = aliasing_doubt(drive, 100.0)
        sampled = np.abs(np.fft.rfft(np.sin(2 * np.pi * drive * np.arange(1000) / 100.0 + 1.0)))
        assert told is not None
        assert f"shows at {np.argmax(sampled) / 10:g} Hz" in told


def test_simulate_notes_a_drive_that_its_file_cannot_show(tmp_path: Path, capsys) -> None:
    motion = ["simulate", "--element", "friction", "--gap", "4e-5", "--drive", "110", "--amplitude", "0.0015"]
    motion += ["--duration", "0.5"]
    files = ["--csv", str(tmp_path / "a.csv")]
    assert main([*motion, *files, "--sample-rate", "100"]) == 0
    assert "drive at 110 Hz is not below half of the sample rate" in capsys.readouterr().err
    assert main([*motion, *files]) == 0
    assert complaints(capsys.readouterr().err) == ""
    assert main([*motion, "--sample-rate", "100"]) == 2
    assert "--csv or --wav" in capsys.readouterr().err  # without a file nothing is sampled


def test_the_command_notes_it_in_text_and_in_json(tmp_path: Path, capsys) -> None:
    file = tmp_path / "clipped.csv"
    write_signal(file, Signal(np.clip(SINE[:500], -0.5, 0.5), RATE, "x", "m"))
    with warnings.catch_warnings():
        warnings.simplefilter("error", SignalWarning)
        assert main(["spectrum", str(file)]) == 0
        assert "note: " in capsys.readouterr().out
        assert main(["spectrum", str(file), "--json"]) == 0
    (note,) = json.loads(capsys.readouterr().out)["notes"]
    assert "clipped" in note


def test_a_limit_cycle_that_is_left_out_is_not_to_be_parted_from_a_mode() -> None:
    signal = Signal(np.cos(2 * np.pi * 400.0 * np.arange(2000) / 2000.0), 2000.0, "x", "m")
    with pytest.warns(SignalWarning, match=r"limit cycle 1 at 100\.5 Hz are 0\.5 bins apart"):
        told = analyse_signal(signal, None, (100.0,), (100.5,))
    assert len(told.doubts) == 1
    assert analyse_signal(signal, 400.0, (100.0,), (100.5,)).doubts == ()


def test_only_what_a_record_does_not_part_is_doubted() -> None:
    record = Signal(np.cos(2 * np.pi * 400.0 * np.arange(200) / 2000.0), 2000.0, "x", "m")  # bins of 10 Hz

    def doubts(drive: float | None, *modes: float) -> tuple[str, ...]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SignalWarning)
            return analyse_signal(record, drive, modes).doubts

    assert doubts(30.0) == doubts(None) == doubts(None, 100.0, 130.0) == doubts(None, 100.0, 100.0) == ()
    (short,) = doubts(29.0)
    assert "record of 0.1 s holds 2.9 periods" in short and "0.1034 s or more" in short
    (near,) = doubts(None, 129.0, 100.0, 200.0)
    assert "at 100 Hz and natural mode 1 at 129 Hz are 2.9 bins apart" in near and "0.1034 s or more" in near
    assert len(doubts(29.0, 100.0, 110.0, 120.0)) == 3


def test_peaks_outside_the_trusted_band_are_named_up_to_five() -> None:
    places = (100.0, 150.0, 210.0, 270.0, 330.0, 390.0, 450.0)
    values = sum(np.cos(2 * np.pi * place * np.arange(2000) / 2000.0) / place for place in places)
    record = Signal(values, 2000.0, "x", "m")
    for highest, told in ((460.0, None), (440.0, "at 450 Hz;"), (160.0, "at 210, 270, 330, 390, 450 Hz;"),
                          (140.0, "at 150, 210, 270, 330, 390, ... Hz;")):  # fmt: skip
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SignalWarning)
            doubts = analyse_signal(replace(record, trusted=Band(50.0, highest))).doubts
        assert [told in doubt for doubt in doubts] == ([True] if told else [])
