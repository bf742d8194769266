"""What is told of spectra and comparisons that are made by hand: each row and each number."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace as Made

import numpy as np
import pytest

from tests.trimmer.command_line.told import cells
from trimmer.command_line.signals import averaged_text, overlay_text, spectrum_text
from trimmer.signals.signal import Signal
from trimmer.spectra.classification import ClassifiedPeak, Harmonic, LimitCycleLine, Match, NaturalMode
from trimmer.spectra.peaks import Peak

SIGNAL = Signal(np.arange(500.0), 250.0, "stroke", "m")
FIT = Made(
    frequency=110.0,
    orders=(1, 2, 3, 4),
    coefficients=np.array([2j, 2e-4 * (1 + 1e-9), -1.0, 1.9e-4]),
    amplitudes=np.array([2.0, 2e-4 * (1 + 1e-9), 1.0, 1.9e-4]),
    explained=0.875,
    residual=0.0125,
)


def test_harmonics_are_told_unless_they_are_small() -> None:
    lines = list(spectrum_text._harmonics(FIT, "m"))
    assert cells(lines[1:-1]) == [
        ["order", "Hz", "amplitude, m", "phase, deg"],
        ["1", "110", "2", "90.0"],
        ["2", "220", "0.0002", "0.0"],
        ["3", "330", "1", "180.0"],
    ]
    assert "87.5 %" in lines[-1] and "0.0125 rms" in lines[-1]
    assert cells(list(spectrum_text._harmonics(FIT, ""))[1])[0][2] == "amplitude"
    data = spectrum_text._fit(FIT)
    assert data["phases"] == pytest.approx([np.pi / 2, 0.0, np.pi, 0.0])
    assert (data["amplitudes"], data["drive"], data["residual"]) == (FIT.amplitudes.tolist(), 110.0, 0.0125)


def classified(*candidates: Match) -> ClassifiedPeak:
    peak = Peak.__new__(Peak)
    vars(peak).update(
        frequency=110.25, amplitude=0.5, frequency_uncertainty=0.0625, amplitude_uncertainty=0.03125
    )
    return ClassifiedPeak(peak, candidates)


DRIVE = Match(Harmonic(2, 110.0), 0.5, 1.0)
MODE = Match(NaturalMode(3, 111.0), -1.5, 2.0)
CYCLE = Match(LimitCycleLine(1, 3, 120.0), -9.75, 1.0)
FARTHER = Match(NaturalMode(1, 90.0), 20.25, 1.0)


def test_a_peak_is_told_with_what_it_may_be() -> None:
    peaks = [classified(DRIVE, MODE), classified(MODE, CYCLE), classified(FARTHER, CYCLE), classified()]
    rows = cells(list(spectrum_text._peaks(Made(peaks=peaks, signal=SIGNAL)))[1:])
    assert rows[0] == ["Hz", "+/-", "amplitude, m", "+/-", "may be", "bins off", "or also", "bins off"]
    start = ["110.25", "0.062", "0.5", "0.031"]
    assert rows[1:] == [
        [*start, "harmonic 2 (even)", "+0.50", "natural mode 3", "-1.50"],
        [*start, "natural mode 3", "-1.50"],
        [*start, "unexplained", "nearest: limit cycle 1, harmonic 3", "-9.75"],
        [*start, "unexplained"],
    ]
    assert spectrum_text._match_cells(Match(DRIVE.origin, -0.001, 1.0), "")[1] == "+0.00"


def test_a_peak_is_described_for_json() -> None:
    data = spectrum_text._peak(classified(DRIVE, MODE))
    assert (data["frequency"], data["amplitude"], data["ambiguous"]) == (110.25, 0.5, True)
    assert data["explanation"] == {"kind": "harmonic", "order": 2, "frequency": 110.0, "odd": False}
    assert data["candidates"][1] == {
        "kind": "natural mode",
        "number": 3,
        "frequency": 111.0,
        "distance_bins": -1.5,
        "tolerance_bins": 2.0,
        "fits": True,
    }
    data = spectrum_text._peak(classified(CYCLE))
    assert (data["explanation"], data["candidates"][0]["fits"]) == (None, False)
    assert data["candidates"][0]["kind"] == "limit cycle"


def test_candidates_are_listed() -> None:
    predictions = spectrum_text.Predictions("some", (0.0, 0.5, 70.5), 4e-5, (740.0,))
    analysis = Made(harmonics=FIT, notes=("a note",))
    lines = list(spectrum_text._candidates(analysis, predictions))
    assert lines[1:4] == [
        "  harmonics of 110 Hz",
        "  natural modes of some: 0.5 Hz, 70.5 Hz",
        "  stable limit cycles with a gap of 4e-05 m (harmonic balance): 740 Hz",
    ]
    assert "within 1 bin" in lines[4] and "or 1 %" in " ".join(lines[4:])
    assert lines[-1] == "  a note"
    analysis = Made(harmonics=None, notes=())
    lines = list(spectrum_text._candidates(analysis, spectrum_text.Predictions("some", (0.0,), None, ())))
    assert (lines[1], len(lines)) == ("  natural modes of some: none", 3)


def test_sound_is_told_with_its_full_scale() -> None:
    wav = Made(samples=800, sample_rate=8000, bit_depth=Made(value=24), full_scale=2e-3)
    line = spectrum_text._wav_line(wav, Made(signal=SIGNAL))
    assert "800 samples at 8000 Hz, resampled from 250 Hz, 24 bits" in line
    assert line.endswith("full scale is 0.002 m")
    wav.sample_rate = 250
    line = spectrum_text._wav_line(wav, Made(signal=Signal(SIGNAL.values, 250.0)))
    assert "resampled" not in line
    assert line.endswith("full scale is 0.002")


def shown(**changes: object) -> spectrum_text.Shown:
    spectrum = Made(bin_width=0.5, window=Made(word="hann"), mean=3.25)
    analysis = Made(
        signal=SIGNAL, spectrum=spectrum, harmonics=None, peaks=[], doubts=("doubt",), notes=("n",)
    )
    usual = {
        "file": Path("a.csv"),
        "analysis": analysis,
        "predictions": spectrum_text.Predictions("some", (50.0,), None, (740.0,)),
        "chosen": Made(full_scale_is_one=False, recording=Made(stretches=(SIGNAL,), gaps=()), faults=()),
        "averaged": None,
        "wav": None,
    }
    return spectrum_text.Shown(**usual | changes)


def test_a_spectrum_has_only_the_sections_that_there_are(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spectrum_text, "averaged_text", lambda averaged, unit: [f"{averaged} {unit}"])
    sections = spectrum_text.as_text(shown()).split("\n\n")
    assert len(sections) == 3
    assert sections[0].splitlines() == [
        "stroke [m] of a.csv: 500 samples at 250 Hz, 2 s",
        "bins 0.5 Hz apart, hann window, mean 3.25 taken off",
        "note: doubt",
    ]
    whole = shown(averaged="averaged")
    whole.analysis.harmonics = FIT
    whole.analysis.signal = Signal(SIGNAL.values, 250.0, "stroke", "m", interpolated=3)
    sections = spectrum_text.as_text(whole).split("\n\n")
    assert len(sections) == 5
    assert sections[0].splitlines()[2].startswith("3 samples were missing")
    assert sections[1].startswith("Harmonics")
    assert sections[3] == "averaged m"


def test_json_has_null_where_nothing_was_asked_for() -> None:
    data = json.loads(spectrum_text.as_json(shown()))
    for key in ("harmonics", "limit_cycles", "limit_cycle_frequencies", "averaged", "wav"):
        assert data[key] is None
    assert (data["notes"], data["natural_frequencies"]) == (["doubt", "n"], [50.0])
    assert data["spectrum"] == {"window": "hann", "bin_width": 0.5, "mean": 3.25}
    gap = spectrum_text.Predictions("some", (50.0,), 4e-5, (740.0,))
    whole = shown(predictions=gap, wav=Made(bit_depth=Made(value=24), samples=8))
    whole.analysis.harmonics = FIT
    data = json.loads(spectrum_text.as_json(whole))
    assert data["limit_cycles"] == data["limit_cycle_frequencies"] == [740.0]
    assert (data["wav"], data["harmonics"]["frequency"]) == ({"bit_depth": 24, "samples": 8}, 110.0)


def comparison(**changes: object) -> Made:
    usual = {
        "signal": SIGNAL,
        "frequency": 50.0,
        "simulated_frequency": 50.0,
        "found": True,
        "period_count": 2,
        "shift": 0.005,
        "residual": 0.25,
        "inverted_residual": 0.125,
        "opposite": False,
        "rest": 0.0625,
        "uncertainty": 0.125,
        "measured": np.array([3j, 1e-5, -0.375, 0.376]),
        "simulated": np.array([1.0, 2e-5, 4.0, 0.0]),
        "frequencies": np.array([25.0, 50.0, 75.0, 100.0]),
        "decibels": np.array([1.5, 0.0, -2.5, np.inf]),
        "phase_differences": np.array([np.pi / 2, 0.0, -np.pi / 4, 0.0]),
    }
    return Made(**usual | changes)


def test_lines_are_told_side_by_side() -> None:
    lines = list(overlay_text._lines(comparison()))
    assert "0.12 m" in lines[0]
    assert cells(lines[1:]) == [
        ["order", "Hz", "measured, m", "simulated, m", "dB", "phase, deg"],
        ["1/2", "25", "3", "1", "+1.50", "+90.0"],
        ["3/2", "75", "0.375", "4", "-2.50", "-45.0", "within noise"],
        ["4/2", "100", "0.376", "0", "+inf", "+0.0"],
    ]
    assert [row[0] for row in cells(list(overlay_text._lines(comparison(period_count=1)))[2:])] == list("134")
    told = " ".join(" ".join(overlay_text._alignment(Made(comparison=comparison()))).split())
    assert "0.005 s, 90 deg" in told and "4 lines is 25 % rms" in told and "0.0625 m rms" in told


def test_lines_are_described_for_json() -> None:
    assert overlay_text._line_json(comparison(), 2) == {
        "order": [3, 2],
        "frequency": 75.0,
        "measured": 0.375,
        "simulated": 4.0,
        "decibels": -2.5,
        "phase_difference": -np.pi / 4,
    }
    assert overlay_text._line_json(comparison(), 3)["decibels"] is None


def test_another_frequency_and_an_opposite_sign_are_noted() -> None:
    def notes(**changes: object) -> list[str]:
        chosen = Made(full_scale_is_one=False, signal=SIGNAL, faults=())
        compared = Made(chosen=chosen, comparison=comparison(**changes))
        return overlay_text._notes(compared)

    assert notes() == notes(frequency=50.09) == notes(frequency=49.91) == []
    assert notes(frequency=51.0)[0].startswith("the measured drive is +2 % off")
    assert notes(frequency=49.0)[0].startswith("the measured drive is -2 % off")
    (told,) = notes(opposite=True)
    assert "12.5 % instead of 25 %" in told


def test_an_averaged_spectrum_is_told() -> None:
    line = Made(frequency=50.0, amplitude=2.0, interval=(1.5, 2.5))
    asked = []
    averaged = Made(
        averages=7,
        segment=256,
        bin_width=0.5,
        noise_bandwidth=0.75,
        resolution=2.0,
        window=Made(word="hann"),
        equivalent_averages=5.5,
        interval=(0.5, 3.0),
        left_out=0,
        lines=lambda most: asked.append(most) or [line],
        frequency=np.array([0.0, 0.5]),
        density=np.array([1.0, 2.0]),
    )
    lines = list(averaged_text.averaged_text(averaged, "m"))
    assert cells(lines[-2:])[0][1] == "amplitude, m"
    assert cells(lines[-2:])[1] == ["50", "2", "1.5 to 2.5"]
    told = " ".join(" ".join(lines).split())
    assert "0.5 to 3 times" in told and "left out" not in told
    averaged.left_out = 9
    lines = list(averaged_text.averaged_text(averaged, ""))
    assert any(each.startswith("  9 samples") for each in lines)
    assert cells(lines[-2:])[0][1] == "amplitude"
    data = averaged_text.averaged_json(averaged)
    assert (data["frequencies"], data["densities"], data["lines"]) == ([0.0, 0.5], [1.0, 2.0], [vars(line)])
    assert len(set(asked)) == 1
