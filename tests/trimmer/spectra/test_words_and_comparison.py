"""What peaks may be, lines compared, doubts and tables, by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from trimmer.errors import WrongTypeError
from trimmer.signals.band import Band
from trimmer.signals.signal import Signal, SignalError
from trimmer.spectra.analysis import analyse_signal
from trimmer.spectra.classification import (
    OPEN_LOOP,
    ClassifiedPeak,
    Harmonic,
    LimitCycleLine,
    Match,
    NaturalMode,
    Tolerance,
    classify,
    fundamentals,
)
from trimmer.spectra.comparison import (
    Comparison,
    SimulatedLines,
    _fit,
    _residual,
    best_angle,
    compare_motions,
    found_frequency,
)
from trimmer.spectra.doubts import _SAME, aliasing_doubt, band_doubts, resolution_doubts
from trimmer.spectra.harmonics import fit_harmonics
from trimmer.spectra.peaks import (
    Peak,
    peaks,
)
from trimmer.spectra.spectrum import Spectrum
from trimmer.spectra.window import Window

RATE = 2000.0


def spectrum(lines: list[complex], window: Window = Window.RECTANGULAR, colour: int = 0) -> Spectrum:
    values = np.array(lines, complex)
    return Spectrum(values, window, RATE, 2 * (values.size - 1), 0.5, colour)


def test_a_peak_is_explained_by_what_fits() -> None:
    mode, cycle = NaturalMode(2, 300.0), LimitCycleLine(1, 3, 330.0)
    near, far = Match(mode, -2.0, 2.0), Match(cycle, 2.1, 2.0)
    assert (near.fits, far.fits) == (True, False)
    peak = Peak(300.0, 1.0, 0.0)
    both = ClassifiedPeak(peak, (near, replace(far, distance=1.0)))
    assert (both.explanation, both.second, both.ambiguous) == (near, replace(far, distance=1.0), True)
    one = ClassifiedPeak(peak, (near, far))
    assert (one.explanation, one.second, one.ambiguous) == (near, None, False)
    none = ClassifiedPeak(peak, ())
    assert (none.explanation, none.second) == (None, None)
    assert ClassifiedPeak(peak, (far,)).explanation is None
    assert ClassifiedPeak(peak, (near,)).second is None


def test_distances_are_told_in_bins_with_their_sign() -> None:
    (found,) = classify([Peak(331.0, 1.0, 0.0)], 2.0, 110.0, (0.0, 300.0), tolerance=Tolerance(1.5, 0.02))
    harmonic, mode = found.candidates
    assert (harmonic.origin, harmonic.distance, harmonic.tolerance) == (Harmonic(3, 330.0), 0.5, 1.5)
    assert (mode.origin, mode.distance, mode.tolerance) == (NaturalMode(2, 300.0), 15.5, 3.0)
    (low,) = classify([Peak(20.0, 1.0, 0.0)], 2.0, 110.0)
    assert low.candidates[0].origin == Harmonic(1, 110.0)
    (cycle,) = classify([Peak(330.0, 1.0, 0.0)], 2.0, None, (), (60.0, 111.0))
    assert cycle.candidates[0].origin == LimitCycleLine(2, 3, 333.0)
    assert cycle.candidates[0].distance == -1.5


def test_fundamentals_are_drive_modes_and_cycles() -> None:
    expected = (Harmonic(1, 110.0), NaturalMode(2, 300.0), LimitCycleLine(1, 1, 730.0))
    assert fundamentals(110.0, (0.0, 300.0), (730.0,)) == expected
    assert fundamentals(None, (), ()) == ()


def test_the_best_angle_is_that_of_the_largest_sum() -> None:
    angle, orders = 2.345, np.arange(1, 6)
    sizes = np.array([1.0, 0.3, 0.7, 0.2, 0.9])
    assert best_angle(sizes * np.exp(1j * orders * angle)) == pytest.approx(angle, abs=1e-14)
    products = np.array([0.4 - 0.3j, 0.2j, -0.7, 0.1 + 0.1j])
    grid = np.linspace(0.0, 2.0 * np.pi, 200_001)
    sums = (products @ np.exp(-1j * np.outer(np.arange(1, 5), grid))).real
    found = best_angle(products)
    assert found % (2 * np.pi) == pytest.approx(grid[sums.argmax()], abs=1e-4)
    slope = (products * -1j * np.arange(1, 5) * np.exp(-1j * np.arange(1, 5) * found)).real.sum()
    assert slope == pytest.approx(0.0, abs=1e-14)
    assert best_angle(np.zeros(3, complex)) == 0.0


def compared(**changes) -> Comparison:
    given = {
        "signal": Signal(np.zeros(40), RATE, "x", "m"),
        "frequency": 100.0,
        "found": True,
        "simulated_frequency": 110.0,
        "period_count": 2,
        "measured": np.array([3.0 + 0j, 4j]),
        "simulated": np.array([3.0 + 0j, 2.0 + 0j]),
        "uncertainty": 0.1,
        "shift": 0.0,
        "inverted_residual": 0.5,
        "rest": 0.2,
    }
    return Comparison(**(given | changes))


def test_lines_are_compared_one_by_one() -> None:
    both = compared()
    assert both.period == 0.02
    assert both.frequencies.tolist() == [50.0, 100.0]
    assert both.decibels == pytest.approx([0.0, 20.0 * math.log10(2.0)])
    assert both.phase_differences == pytest.approx([0.0, 0.5 * math.pi])
    assert both.residual == pytest.approx(math.sqrt(20.0) / 5.0)
    assert both.opposite
    assert not compared(inverted_residual=0.81 * both.residual).opposite
    times, measured, simulated = both.waveforms(4)
    assert times == pytest.approx([0.0, 0.005, 0.01, 0.015])
    # 3 cos x - 4 sin 2x and 3 cos x + 2 cos 2x.
    assert measured == pytest.approx([3.0, 0.0, -3.0, 0.0], abs=1e-12)
    assert simulated == pytest.approx([5.0, -2.0, -1.0, -2.0], abs=1e-12)
    rows = [list(row) for row in both._table().rows()]
    assert rows[1] == pytest.approx([100.0, 4.0, 2.0, 20.0 * math.log10(2.0), 0.5 * math.pi])
    turned = compared(simulated=np.array([-3.0 + 0j, 2j]), measured=np.array([-3.0 + 0j, 4j]))
    assert [list(row)[1:3] for row in turned._table().rows()] == [[3.0, 3.0], [4.0, 2.0]]
    assert "2 lines at 100 Hz, difference 89.443% rms" in repr(both)
    assert _residual(np.zeros(2, complex), np.ones(2, complex)) == math.inf


def test_no_more_lines_are_fitted_than_the_measurement_shows() -> None:
    signal = Signal(np.random.default_rng(2).normal(size=400), RATE, "x", "m")
    many = SimulatedLines(np.ones(90, complex), 100.0)
    # Hann's lobe of 2 of 400 samples: up to 995 Hz.
    assert _fit(signal, many, 100.0).coefficients.size == 9
    assert _fit(replace(signal, trusted=Band(0.0, 430.0)), many, 100.0).coefficients.size == 4
    assert _fit(signal, SimulatedLines(np.ones(3, complex), 100.0), 100.0).coefficients.size == 3
    assert _fit(signal, SimulatedLines(np.ones(5, complex), 100.0, 2), 100.0).frequency == 50.0
    with pytest.raises(SignalError, match="show no drive at 400 Hz"):
        _fit(signal, SimulatedLines(np.ones(1, complex), 100.0, 2), 400.0)


def test_a_comparison_holds_what_was_found() -> None:
    times = np.arange(1000) / RATE
    lines = np.array([1e-3, 2e-4j])
    values = (
        (2.0 * lines * np.exp(1j * 0.3 * np.array([1, 2])))
        @ np.exp(2j * np.pi * 100.0 * np.outer([1, 2], times))
    ).real
    found = compare_motions(Signal(values, RATE, "x", "m"), SimulatedLines(lines, 101.0), 100.0)
    assert (found.found, found.frequency, found.simulated_frequency, found.period_count) == (
        False,
        100.0,
        101.0,
        1,
    )
    assert found.measured == pytest.approx(2.0 * lines * np.exp(1j * 0.3 * np.array([1, 2])), rel=1e-9)
    assert found.simulated == pytest.approx(0.5 * found.measured, rel=1e-9)
    # A simulation that begins 0.3 rad earlier in its period: so the rest of it later.
    assert found.shift == pytest.approx((2.0 * np.pi - 0.3) / (2.0 * np.pi) / 100.0)
    assert found.residual == pytest.approx(0.5)
    # -(cos a + 0.04 cos 2a) is at most 0.96: of the squares 4.16 + 1.04 - 4 0.96 are left.
    assert found.inverted_residual == pytest.approx(math.sqrt(1.36 / 4.16), rel=1e-9)
    signal = Signal(values, RATE, "x", "m")
    assert found_frequency(signal, SimulatedLines(lines, 102.9)) == pytest.approx(100.0, rel=1e-6)
    with pytest.raises(SignalError, match="no line of the measurement"):
        found_frequency(signal, SimulatedLines(lines, 103.2))
    # The second harmonic, when it is the largest, is one of the drive too.
    second = Signal(values - 0.9 * 2e-3 * np.cos(2 * np.pi * 100.0 * times + 0.3), RATE, "x", "m")
    assert found_frequency(second, SimulatedLines(lines, 101.0)) == pytest.approx(100.0, rel=1e-5)
    noisy = Signal(values + 5e-3 * np.sin(2 * np.pi * 700.0 * times), RATE, "x", "m")
    with pytest.raises(SignalError, match="explain only"):
        found_frequency(noisy, SimulatedLines(lines[:1], 101.0))


def test_simulated_lines_are_complex_numbers_in_a_row() -> None:
    assert SimulatedLines(np.array([1.0, 2.0]), 3.0).displacement.dtype == complex
    assert "2 lines at 1/4 of 3 Hz" in repr(SimulatedLines(np.array([1.0, 2.0]), 3.0, 4))
    for wrong in ([], [[1.0]], [1, 2], [np.inf], ["a"], [[1.0], [1.0, 2.0]]):
        with pytest.raises(SignalError, match="one dimension"):
            SimulatedLines(wrong, 3.0)
    with pytest.raises(SignalError, match="frequency must be positive"):
        SimulatedLines([1.0], -3.0)
    with pytest.raises(ValueError, match="period_count"):
        SimulatedLines([1.0], 3.0, 0)
    with pytest.raises(WrongTypeError, match="simulated"):
        compare_motions(Signal(np.zeros(40), RATE, "x", "m"), np.ones(3))
    with pytest.raises(WrongTypeError, match="signal"):
        compare_motions(np.zeros(40), SimulatedLines([1.0], 3.0))


def test_doubts_of_resolution_depend_on_the_length_of_the_record() -> None:
    given = spectrum([0.0] * 101, Window.HANN)  # 0.1 s, bins 10 Hz apart, 3 are needed

    def doubts(drive: float | None, *frequencies: float) -> list[str]:
        return list(resolution_doubts(given, drive, [NaturalMode(1, each) for each in frequencies]))

    assert doubts(30.0) == doubts(None) == doubts(None, 100.0, 130.0) == doubts(None, 100.0, 100.0) == []
    (short,) = doubts(29.0)
    assert "record of 0.1 s holds 2.9 periods" in short
    assert "0.1034 s or more" in short
    (near,) = doubts(None, 129.0, 100.0, 200.0)
    assert "at 100 Hz and natural mode 1 at 129 Hz are 2.9 bins apart" in near
    assert "0.1034 s or more" in near
    assert len(doubts(29.0, 100.0, 110.0, 120.0)) == 3
    # Two that differ by rounding only are the same.
    for size in (1e5, 1e-5):
        assert doubts(None, size, size * (1.0 + 0.5 * _SAME)) == []
        assert len(doubts(None, size, size * (1.0 + 2.0 * _SAME))) == 1


def test_peaks_outside_the_band_are_named_up_to_five() -> None:
    band = Band(10.0, 50.0)
    found = [Peak(frequency, 1.0, 0.0) for frequency in (10.0, 50.0, 9.0)]
    (told,) = band_doubts(band, found)
    assert "peaks at 9 Hz;" in told
    assert list(band_doubts(band, found[:2])) == []
    (five,) = band_doubts(band, [Peak(60.0 + k, 1.0, 0.0) for k in range(5)])
    assert "..." not in five
    (six,) = band_doubts(band, [Peak(60.0 + k, 1.0, 0.0) for k in range(6)])
    assert "64, ..." in six
    assert "65" not in six


def test_an_alias_is_told_at_half_of_the_rate_and_above() -> None:
    assert aliasing_doubt(49.9, 100.0) is None
    told = aliasing_doubt(50.0, 100.0)
    assert told is not None
    assert "more than 100 Hz" in told


def test_harmonics_are_told_in_a_table_and_at_any_time() -> None:
    times = np.arange(300) / RATE
    values = 0.5 + 2.0 * np.cos(2 * np.pi * 50.0 * times - 0.4) + 0.3 * np.sin(2 * np.pi * 100.0 * times)
    fit = fit_harmonics(values, RATE, 50.0, 2)
    rows = [list(row) for row in fit._table().rows()]
    assert rows[0] == pytest.approx([1, 50.0, 2.0, -0.4])
    assert rows[1] == pytest.approx([2, 100.0, 0.3, -0.5 * math.pi])
    later = np.array([[0.0123], [7.7]])
    expected = 0.5 + 2.0 * np.cos(100 * np.pi * later - 0.4) + 0.3 * np.sin(200 * np.pi * later)
    assert fit.at(later) == pytest.approx(expected, abs=1e-10)
    assert "2 of 50 Hz explain 100.0000% of the variance" in repr(fit)


def test_an_analysis_is_told_in_a_table() -> None:
    times = np.arange(2000) / RATE
    values = 2.0 * np.cos(2 * np.pi * 100.2 * times + 0.5) + 0.3 * np.cos(2 * np.pi * 433.0 * times)
    analysis = analyse_signal(Signal(values, RATE, "x", "m"), natural_frequencies=(100.0,))
    first, second = ([*row] for row in analysis._table().rows())
    assert first[:3] == pytest.approx([100.2, 2.0, 0.5], abs=1e-6)
    assert first[5] == "natural mode 1"
    assert first[6] == pytest.approx(0.2, abs=1e-6)
    assert not first[7]
    assert second[0] == pytest.approx(433.0)
    assert second[5:7] == [None, None]
    assert "2 peaks, 1 explained, bins 1 Hz apart" in repr(analysis)
    with pytest.raises(ValueError, match="limit"):
        analyse_signal(Signal(values, RATE, "x", "m"), limit=0)
    assert len(peaks(analysis.spectrum, 1)) == 1


def test_an_analysis_counts_what_is_explained_and_refuses_what_is_no_signal_or_drive() -> None:
    times = np.arange(2000) / RATE
    values = sum(np.cos(2 * np.pi * frequency * times) for frequency in (100.2, 433.0, 700.0))
    signal = Signal(values, RATE, "x", "m")
    assert "3 peaks, 1 explained" in repr(analyse_signal(signal, natural_frequencies=(100.0,)))
    driven = analyse_signal(signal, 100.2, limit_cycle_frequencies=(433.0,))
    assert driven.notes == (OPEN_LOOP,)
    assert analyse_signal(signal, 100.2, limit_cycle_frequencies=(433.0,), closed_loop=True).notes == ()
    with pytest.raises(WrongTypeError, match="signal"):
        analyse_signal(values)
    for drive in (0.0, -1.0, math.inf):
        with pytest.raises(SignalError, match="the frequency of the drive must be positive and finite"):
            analyse_signal(signal, drive)
