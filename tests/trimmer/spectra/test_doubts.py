"""What makes a spectrum doubtful is told: clipping, aliasing, a record that is too short."""

from __future__ import annotations

import json
import warnings
from pathlib import Path

import numpy as np
import pytest

from tests.complaints import complaints
from trimmer.command_line.main import main
from trimmer.errors import SignalWarning
from trimmer.signals.signal import Signal
from trimmer.signals.write import write_signal
from trimmer.spectra.analysis import analyse_signal
from trimmer.spectra.doubts import aliasing_doubt
from trimmer.spectra.window import Window

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


def test_a_record_too_short_for_the_harmonics_or_the_candidates_is_told() -> None:
    record = Signal(SINE[:125], RATE)  # 25 ms: bins 40 Hz apart
    with pytest.warns(SignalWarning, match="holds 2.75 periods of the drive.*0.02732 s or more"):
        told = analyse_signal(record, drive_frequency=109.8).doubts
    assert len(told) == 1
    with pytest.warns(
        SignalWarning, match="natural mode 1 at 222 Hz and limit cycle 1 at 252 Hz are 0.75 bins"
    ):
        analyse_signal(record, natural_frequencies=(222.0,), limit_cycle_frequencies=(252.0,))


@pytest.mark.parametrize("window", Window)
def test_the_length_that_is_named_is_enough(window: Window) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", SignalWarning)
        duration = 1.001 * window.parted / 30.0
        values = np.sin(2 * np.pi * 109.8 * np.arange(int(duration * RATE) + 1) / RATE)
        options = {"natural_frequencies": (222.0,), "limit_cycle_frequencies": (252.0, 222.0)}
        assert analyse_signal(Signal(values, RATE), window=window, **options).doubts == ()


def test_the_command_notes_it_in_text_and_in_json(tmp_path: Path, capsys) -> None:
    file = tmp_path / "clipped.csv"
    write_signal(file, Signal(np.clip(SINE, -0.5, 0.5), RATE, "x", "m"))
    with warnings.catch_warnings():
        warnings.simplefilter("error", SignalWarning)
        assert main(["spectrum", str(file)]) == 0
        assert "note: " in capsys.readouterr().out
        assert main(["spectrum", str(file), "--json"]) == 0
    (note,) = json.loads(capsys.readouterr().out)["notes"]
    assert "clipped" in note


def test_a_drive_that_the_record_cannot_show_is_an_error(tmp_path: Path, capsys) -> None:
    file = tmp_path / "a.csv"
    write_signal(file, Signal(SINE, RATE, "x", "m"))
    assert main(["spectrum", str(file), "--drive", "2600"]) == 2
    assert "not seen in samples" in capsys.readouterr().err


def test_a_limit_cycle_that_is_left_out_is_not_to_be_parted_from_a_mode() -> None:
    signal = Signal(np.cos(2 * np.pi * 400.0 * np.arange(2000) / 2000.0), 2000.0, "x", "m")
    with pytest.warns(SignalWarning, match=r"limit cycle 1 at 100\.5 Hz are 0\.5 bins apart"):
        told = analyse_signal(signal, None, (100.0,), (100.5,))
    assert len(told.doubts) == 1
    assert analyse_signal(signal, 400.0, (100.0,), (100.5,)).doubts == ()
