"""The parts of spectra by hand: thresholds, segments, lines, alignment, tables and doubts."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from trimmer.signals.band import Band
from trimmer.signals.signal import Signal, SignalError
from trimmer.spectra.analysis import analyse_signal
from trimmer.spectra.averaged import (
    AveragedLine,
    AveragedSpectrum,
    _equivalent,
    _segment,
    _segments,
    averaged_spectrum,
    line_interval,
)
from trimmer.spectra.classification import (
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
from trimmer.spectra.doubts import aliasing_doubt, band_doubts, resolution_doubts
from trimmer.spectra.harmonics import fit_harmonics
from trimmer.spectra.noise import noise_threshold
from trimmer.spectra.peaks import (
    Peak,
    _inside,
    _is_maximum,
    _leakage,
    _left,
    _Lines,
    _maxima,
    _noise,
    _peak,
    _threshold,
    peaks,
)
from trimmer.spectra.spectrum import Spectrum, amplitude_spectrum
from trimmer.spectra.window import Window, _dirichlet

RATE = 2000.0


def spectrum(lines: list[complex], window: Window = Window.RECTANGULAR, colour: int = 0) -> Spectrum:
    values = np.array(lines, complex)
    return Spectrum(values, window, RATE, 2 * (values.size - 1), 0.5, colour)


def averaged(density: list[float] | np.ndarray, **rest) -> AveragedSpectrum:
    """Bins 2 Hz apart, of segments of twice as many samples."""
    values = np.array(density, float)
    given = {"window": Window.HANN, "segment": 2 * (values.size - 1), "averages": 9, "left_out": 0} | rest
    return AveragedSpectrum(2.0 * np.arange(values.size), values, equivalent_averages=5.0, **given)


def test_windows_have_their_widths_and_bandwidths() -> None:
    # Harris, 1978, table 1: 1, 1.5 and 2 bins; flat-top 3.77.
    bandwidths = [window.noise_bandwidth for window in Window]
    assert bandwidths == pytest.approx([1.0, 1.5, 2.0, 3.77], abs=5e-3)
    for window in Window:
        weights = window.samples(64)
        assert window.noise_bandwidth == pytest.approx(64 * (weights @ weights) / weights.sum() ** 2)
    assert [window.parted for window in Window] == [3, 3, 5, 6]
    assert [window.half_width for window in Window] == [1, 2, 4, 5]


def test_the_kernel_of_a_window_has_the_period_of_its_samples() -> None:
    x = np.array([0.3, 5.0, 7.7, 20.4, -13.2])
    n = np.arange(12)
    expected = np.exp(-2j * np.pi * np.outer(x, n) / 12).sum(axis=1) / 12
    assert _dirichlet(x, 12) == pytest.approx(expected, abs=1e-14)


def test_a_spectrum_tells_its_bins_and_how_noise_lies_in_them() -> None:
    given = spectrum([1.0, 3 - 4j, 0.5j, 2.0, 0.0], colour=-2)
    assert given.bin_width == 250.0
    assert given.frequency.tolist() == [0.0, 250.0, 500.0, 750.0, 1000.0]
    assert given.amplitude.tolist() == [1.0, 5.0, 0.5, 2.0, 0.0]
    assert given.noise_shape.tolist() == [1.0, 1.0, 0.25, 1.0 / 9.0, 0.0625]
    rows = [list(row) for row in given._table().rows()]
    assert rows[1] == [250.0, 5.0, pytest.approx(math.atan2(-4.0, 3.0))]
    assert len(rows) == 5
    assert "5 bins 250 Hz apart, rectangular window, mean 0.5" in repr(given)


def test_too_few_samples_for_a_spectrum() -> None:
    assert amplitude_spectrum(np.ones(16), RATE).samples == 16
    with pytest.raises(SignalError, match="15 samples are too few"):
        amplitude_spectrum(np.ones(15), RATE)


def test_the_threshold_of_white_noise_is_that_of_rayleigh() -> None:
    # Median 2: s = 2/√(2 ln 2); exceeded in any of 50 bins with 1 %: s √(2 ln 5000).
    level = noise_threshold(np.full(50, 2.0), 0.01)
    assert level == pytest.approx(
        np.full(50, 2.0 / math.sqrt(2 * math.log(2)) * math.sqrt(2 * math.log(5000.0)))
    )
    # Half of the bins are 1, the others 3: the neighbourhood decides on long spectra.
    long = noise_threshold(np.repeat([1.0, 3.0], 1000), 0.01)
    assert long[-1] == pytest.approx(3.0 * long[0])


def test_a_bin_must_exceed_noise_and_a_share_of_the_largest() -> None:
    lines = np.full(101, 1.0, complex)
    lines[0], lines[40] = 1e9, 5000.0
    given = spectrum(list(lines))
    noise = math.sqrt(math.log(101 / 0.01) / math.log(2.0))
    assert _threshold(given, 1e-4, 0.01) == pytest.approx(np.full(101, noise))
    assert _threshold(given, 0.1, 0.01) == pytest.approx(np.full(101, 500.0))
    coloured = _threshold(replace(given, lines=lines * given.noise_shape, colour=-1), 0.0, 0.01)
    assert coloured[10] == pytest.approx(0.1 * coloured[1])


def test_maxima_lie_within_the_bins_that_are_looked_at() -> None:
    amplitude = np.array([9.0, 1.0, 2.0, 1.0, 5.0, 5.0, 1.0, 3.0, 1.0, 7.0, 1.0])
    assert _is_maximum(amplitude, np.array([2, 4, 5, 7])).tolist() == [True, True, False, True]
    assert _is_maximum(np.array([5.0, 5.0, 1.0]), np.array([1])).tolist() == [False]
    given = spectrum(list(amplitude.astype(complex)))
    assert _inside(given, np.array([3, 8, 9, 2, 1, 2])).tolist() == [2, 3, 8]
    assert _inside(replace(given, window=Window.HANN), np.arange(11)).tolist() == [3, 4, 5, 6, 7, 8]
    assert _maxima(given, np.full(11, 1.5)).tolist() == [4, 7, 2]
    assert _maxima(given, np.full(11, 3.0)).tolist() == [4]


def test_a_line_and_its_mirror_image_show_in_all_bins() -> None:
    times = np.arange(200) / RATE
    amplitude = 0.7 * np.exp(0.4j)
    values = (amplitude * np.exp(2j * np.pi * 33.3 * RATE / 200 * times)).real
    given = amplitude_spectrum(values, RATE)
    line = _Lines(np.array([33]), np.array([33.3]), np.array([amplitude]))
    bins = np.array([20, 33, 34, 60])
    assert _leakage(given, line, bins) == pytest.approx(given.lines[bins], abs=1e-2)
    left = _left(given, line, np.array([2]))
    assert left[20:60].max() < 1e-2
    assert left[99] == given.amplitude[99]  # beyond the skirt nothing is taken off
    assert left[97] != given.amplitude[97]
    nothing = _Lines(np.empty(0, int), np.empty(0), np.empty(0, complex))
    assert _leakage(given, nothing, bins).tolist() == [0.0] * 4


def test_a_peak_has_the_bounds_of_cramer_and_rao_times_the_loss() -> None:
    given = spectrum([0.0] * 101, Window.HANN)  # 200 samples, bins 10 Hz apart
    peak = _peak(given, 20.5, 3 - 4j, 0.2)
    assert (peak.frequency, peak.amplitude) == (205.0, 5.0)
    assert peak.phase == pytest.approx(math.atan2(-4.0, 3.0))
    share = 0.2 / math.sqrt(200.0)
    assert peak.frequency_uncertainty == pytest.approx(1.90 * math.sqrt(6) / math.pi * share / 5.0 * 10.0)
    assert peak.amplitude_uncertainty == pytest.approx(1.35 * math.sqrt(2.0) * share)


@pytest.mark.parametrize("window", [Window.RECTANGULAR, Window.HANN])
def test_noise_beside_a_peak_is_that_of_the_samples(window: Window) -> None:
    noise = 0.3 * np.random.default_rng(8).normal(size=40_000)
    given = amplitude_spectrum(noise, RATE, window)
    nothing = _Lines(np.array([5000]), np.array([5000.0]), np.array([0j]))
    # 133 bins: the median is uncertain by about a tenth; so the mean of many places.
    levels = [_noise(given, nothing, place) for place in np.arange(500.0, 19_000.0, 400.0)]
    assert np.mean(levels) == pytest.approx(0.3, rel=0.03)
    assert _noise(given, nothing, 3.0) == pytest.approx(0.3, rel=0.3)
    assert _noise(given, nothing, 19_998.0) == pytest.approx(0.3, rel=0.3)


def test_segments_overlap_by_half() -> None:
    assert [_segments(samples, 10) for samples in (9, 10, 14, 15, 20)] == [0, 1, 1, 2, 3]
    assert [_segments(samples, 5) for samples in (4, 5, 7, 8, 11)] == [0, 1, 1, 2, 3]
    assert _segment([20], 3) == 10
    assert _segment([20], 1) == 20
    assert _segment([20, 9], 4) == 9
    assert _segment([3], 9) == 0


def test_equivalent_averages_of_overlapping_segments() -> None:
    # Welch, 1967: halves that overlap share (1/4)/(3/8)... for Hann 1/6, for no window 1/2.
    assert _equivalent(np.ones(100), 8) == pytest.approx(8 / (1 + 2 * (7 / 8) * 0.25))
    assert _equivalent(Window.HANN.samples(1000), 8) == pytest.approx(8 / (1 + 2 * (7 / 8) / 36))
    assert _equivalent(np.ones(100), 1) == 1.0


def test_an_averaged_spectrum_tells_its_scales() -> None:
    given = averaged([4.0, 9.0, 16.0])
    assert (given.bin_width, given.noise_bandwidth, given.resolution) == (2.0, 3.0, 6.0)
    assert given.amplitude == pytest.approx(np.sqrt([24.0, 54.0, 96.0]))
    low, high = given.interval
    assert (low, high) == pytest.approx((10 / chi2.ppf(0.975, 10), 10 / chi2.ppf(0.025, 10)))
    rows = [list(row) for row in given._table().rows()]
    assert rows == [
        [0.0, 4.0, pytest.approx(24.0**0.5)],
        [2.0, 9.0, pytest.approx(54.0**0.5)],
        [4.0, 16.0, pytest.approx(96.0**0.5)],
    ]
    assert "3 bins 2 Hz apart, 9 segments, hann window" in repr(given)


def test_the_noise_beside_a_bin_leaves_out_its_own_lobe() -> None:
    density = np.ones(201)
    density[98:103] = 50.0
    factor = 1.0 / (1.0 - 2.0 / 90.0) ** 3  # of the median of chi-squared with 10 degrees of freedom
    assert averaged(density)._noise(100) == pytest.approx(factor)
    alone = np.full(201, 1e9)
    alone[60:99] = 2.0
    alone[102:140] = 4.0
    assert averaged(alone)._noise(100) == pytest.approx(3.0 * factor, rel=0.4)
    coloured = averaged(np.arange(201.0) ** 2.0, colour=1)
    assert coloured._noise(100) == pytest.approx(1e4 * factor)
    assert averaged([1.0, 2.0, 3.0])._noise(1) == 0.0


def test_a_line_between_bins_is_placed_by_its_larger_neighbour() -> None:
    segment = 400
    for offset in (0.3, -0.2):
        shape = np.abs(Window.HANN.transform(np.arange(201.0) - 100.0 - offset, segment)) ** 2
        given = averaged(7.0 * shape)
        place, gain = given._between(100)
        assert place == pytest.approx(offset, abs=6e-4)
        assert gain == pytest.approx(abs(Window.HANN.transform(offset, segment)), abs=1e-3)
        line = given._line(100)
        assert line.frequency == pytest.approx(200.0 + 2.0 * offset, abs=2e-3)
        noise = given._noise(100) * 3.0
        assert line.amplitude == pytest.approx(math.sqrt(2.0 * 7.0 * 3.0 - 2.0 * noise / gain**2), rel=2e-3)
        power = float(given.density[100]) * 3.0
        low, high = line_interval(power, min(noise, power), 5.0)
        assert line.interval == pytest.approx([math.sqrt(2.0 * each) / gain for each in (low, high)])


def test_side_lobes_of_a_larger_line_are_left_out() -> None:
    given = averaged(np.ones(201))

    def line(bins: float, amplitude: float) -> AveragedLine:
        return AveragedLine(2.0 * bins, amplitude, (0.0, 1.0))

    large = line(100.0, 1.0)
    assert not given._is_apart(line(101.9, 0.9), large)
    assert not given._is_apart(line(98.1, 0.9), large)
    # The first side lobe of Hann is -31.5 dB at 2.36 bins: 0.0267.
    for bins in (102.4, 97.6):
        assert not given._is_apart(line(bins, 0.050), large)
        assert given._is_apart(line(bins, 0.056), large)
    kept = given._apart([large, line(102.4, 0.05), line(150.0, 0.04), line(151.0, 0.03)])
    assert [each.frequency for each in kept] == [200.0, 300.0]


def test_lines_are_the_bins_above_the_noise_by_falling_amplitude() -> None:
    density = np.ones(201)
    density[[50, 120, 160]] = 30.0, 90.0, 2.0
    found = averaged(density).lines(9)
    assert [round(each.frequency) for each in found] == [240, 100]
    assert len(averaged(density).lines(1)) == 1
    assert [round(each.frequency) for each in averaged(density, trusted=Band(0.0, 100.0)).lines(9)] == [100]
    assert averaged(density, trusted=Band(101.0, 239.0)).lines(9) == ()
    with pytest.raises(ValueError, match="limit"):
        averaged(density).lines(0)
    # Twice the noise in one bin of 198 is common: 1 % in any needs the factor below.
    factor = chi2.isf(0.01 / 198, 10) / 10 / (1.0 - 2.0 / 90.0) ** 3
    for share, count in ((0.99, 0), (1.01, 1)):
        density = np.ones(201)
        density[80] = share * factor
        assert len(averaged(density).lines(9)) == count


def test_samples_whose_squares_are_out_of_range_are_refused() -> None:
    values = np.random.default_rng(1).normal(size=400)
    for scale in (1e-141, 1e141):
        with pytest.raises(SignalError, match="cannot be squared"):
            averaged_spectrum(Signal(scale * values / np.abs(values).max(), RATE))
    assert averaged_spectrum(Signal(np.zeros(400), RATE)).density.max() == 0.0
    signal = Signal(values, RATE, trusted=Band(1.0, 90.0))
    assert averaged_spectrum(signal).trusted == Band(1.0, 90.0)
    assert averaged_spectrum(signal).left_out == 0


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
