"""From a file to what its peaks are: the parts together, on signals whose content is known."""

import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from trimmer.errors import SignalWarning, WrongTypeError
from trimmer.signals import Band, Signal, SignalError, read_signal, write_signal
from trimmer.spectra import Harmonic, LimitCycleLine, NaturalMode, Window, analyse_signal, fit_harmonics

RATE, DRIVE = 20_000.0, 109.845
MODES, CYCLES = (222.35, 354.84, 549.59, 1139.5), (733.6,)
PARTS = {DRIVE: 1e-3, 3 * DRIVE: 5e-5, 5 * DRIVE: 2e-5, 356.0: 1e-5, 733.0: 3e-5, 900.0: 5e-6}


@pytest.fixture
def signal() -> Signal:
    times = np.arange(20_001) / RATE
    values = sum(size * np.sin(2 * np.pi * f * times + f) for f, size in PARTS.items())
    return Signal(values, RATE, "q2-q4", "m")


@pytest.mark.parametrize("window", Window)
def test_each_part_of_a_signal_is_found_and_named(tmp_path: Path, signal: Signal, window: Window) -> None:
    write_signal(tmp_path / "a.csv", signal)
    analysis = analyse_signal(read_signal(tmp_path / "a.csv"), DRIVE, MODES, CYCLES, window, closed_loop=True)
    found = {round(each.peak.frequency, 3): each for each in analysis.peaks}
    assert sorted(found) == [pytest.approx(frequency, abs=0.05) for frequency in sorted(PARTS)]
    kinds = [each.explanation and type(each.explanation.origin) for _, each in sorted(found.items())]
    assert kinds == [Harmonic, Harmonic, NaturalMode, Harmonic, LimitCycleLine, None]
    expected = [PARTS.get(order * DRIVE, 0.0) for order in analysis.harmonics.orders]
    np.testing.assert_allclose(analysis.harmonics.amplitudes, expected, rtol=0, atol=1e-9)


def test_without_a_drive_there_are_no_harmonics(signal: Signal) -> None:
    analysis = analyse_signal(signal, limit=1)
    assert analysis.harmonics is None
    assert len(analysis.peaks) == 1
    assert analysis.peaks[0].candidates == ()


def test_a_limit_cycle_is_left_out_under_a_drive_and_the_note_says_why(signal: Signal) -> None:
    driven = analyse_signal(signal, DRIVE, MODES, CYCLES)
    assert not any(isinstance(m.origin, LimitCycleLine) for peak in driven.peaks for m in peak.candidates)
    (note,) = driven.notes
    assert "limit cycles are left out" in note
    assert "nothing feeds the output back" in note
    for options in ({"closed_loop": True}, {"drive_frequency": None}, {"limit_cycle_frequencies": ()}):
        given = {"drive_frequency": DRIVE, "limit_cycle_frequencies": CYCLES} | options
        assert analyse_signal(signal, **given).notes == ()


def test_of_a_converted_signal_only_peaks_within_its_band_are_told() -> None:
    times = np.arange(4000) / 2000.0
    values = sum(
        size * np.cos(2 * np.pi * frequency * times)
        for size, frequency in ((9.0, 50.0), (3.0, 150.0), (2.0, 250.0), (1.0, 350.0), (7.0, 700.0))
    )
    plain = Signal(values, 2000.0, "v", "m/s", trusted=Band(100.0, 400.0))

    def frequencies(converted: int, limit: int) -> list[float]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", SignalWarning)
            told = analyse_signal(replace(plain, converted=converted), limit=limit)
        return [round(each.peak.frequency) for each in told.peaks]

    assert frequencies(0, 3) == [50, 700, 150]
    assert frequencies(-1, 9) == [150, 250, 350]
    assert frequencies(1, 2) == [150, 250]
    with pytest.raises(ValueError, match="limit"):
        frequencies(1, 0)


def test_an_analysis_is_a_table_and_says_what_is_explained(signal: Signal) -> None:
    analysis = analyse_signal(signal, DRIVE, MODES, CYCLES, closed_loop=True)
    assert "6 peaks, 5 explained" in repr(analysis)
    rows = analysis.to_dataframe()
    for row, (frequency, size) in zip(
        rows.itertuples(index=False), sorted(PARTS.items(), key=lambda part: -part[1]), strict=True
    ):
        assert row[:2] == pytest.approx((frequency, size), rel=1e-6)
    assert rows.iloc[:, 5].tolist()[:2] == ["drive", "harmonic 3 (odd)"]


def test_a_harmonic_fit_is_a_table_and_a_curve() -> None:
    times = np.arange(300) / 2000.0
    values = 0.5 + 2.0 * np.cos(2 * np.pi * 50.0 * times - 0.4) + 0.3 * np.sin(2 * np.pi * 100.0 * times)
    fit = fit_harmonics(values, 2000.0, 50.0, 2)
    assert fit.to_dataframe().to_numpy() == pytest.approx(
        np.array([[1, 50, 2, -0.4], [2, 100, 0.3, -0.5 * np.pi]])
    )
    later = np.array([[0.0123], [7.7]])
    expected = 0.5 + 2.0 * np.cos(100 * np.pi * later - 0.4) + 0.3 * np.sin(200 * np.pi * later)
    assert fit.at(later) == pytest.approx(expected, abs=1e-10)
    assert "2 of 50 Hz explain 100.0000% of the variance" in repr(fit)


def test_what_is_no_signal_or_drive_is_refused(signal: Signal) -> None:
    with pytest.raises(WrongTypeError, match="signal"):
        analyse_signal(signal.values)  # type: ignore[arg-type]
    for drive in (0.0, -1.0, np.inf):
        with pytest.raises(SignalError, match="the frequency of the drive must be positive and finite"):
            analyse_signal(signal, drive)
