"""The parts of averaged spectra by hand: segments, noise beside a bin, lines and side lobes."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.stats import chi2

from trimmer.signals.band import Band
from trimmer.signals.signal import Signal, SignalError
from trimmer.spectra.averaged import (
    AveragedLine,
    AveragedSpectrum,
    _equivalent,
    _segment,
    _segments,
    averaged_spectrum,
    line_interval,
)
from trimmer.spectra.window import Window

RATE = 2000.0


def averaged(density: list[float] | np.ndarray, **rest) -> AveragedSpectrum:
    """Bins 2 Hz apart, of segments of twice as many samples."""
    values = np.array(density, float)
    given = {"window": Window.HANN, "segment": 2 * (values.size - 1), "averages": 9, "left_out": 0} | rest
    return AveragedSpectrum(2.0 * np.arange(values.size), values, equivalent_averages=5.0, **given)


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
    large = -1e141 * (1.0 + np.abs(values))
    for stretches in ([large, values], [values, large]):
        with pytest.raises(SignalError, match="cannot be squared"):
            averaged_spectrum([Signal(each, RATE) for each in stretches])
    assert averaged_spectrum(Signal(np.zeros(400), RATE)).density.max() == 0.0
    usual = averaged_spectrum(Signal(values, RATE))
    assert (usual.segment, usual.window) == (averaged_spectrum(Signal(values, RATE), 8).segment, Window.HANN)
    signal = Signal(values, RATE, trusted=Band(1.0, 90.0))
    assert averaged_spectrum(signal).trusted == Band(1.0, 90.0)
    assert averaged_spectrum(signal).left_out == 0


@pytest.mark.parametrize(
    ("place", "below", "above"),
    [
        (100, range(60, 99), range(102, 140)),
        (20, range(1, 19), range(22, 60)),
        (190, range(150, 189), range(192, 201)),
        (1, range(0), range(3, 41)),
        (200, range(160, 199), range(0)),
    ],
)
def test_noise_is_the_median_of_forty_bins_on_either_side(place: int, below: range, above: range) -> None:
    density = 1.0 + np.sqrt(np.arange(201.0))
    near = np.array([*below, *above])
    factor = 1.0 / (1.0 - 2.0 / 90.0) ** 3
    assert averaged(density)._noise(place) == pytest.approx(np.median(density[near]) * factor, rel=1e-12)
    grey = averaged(density * np.arange(201.0) ** 4, colour=2)._noise(place)
    assert grey == pytest.approx(place**4 * np.median(density[near]) * factor, rel=1e-12)


def test_lines_are_looked_for_up_to_both_ends_of_the_trusted_band() -> None:
    density = np.ones(201)
    density[[2, 50, 120, 199]] = 30.0, 40.0, 90.0, 50.0
    assert [round(each.frequency) for each in averaged(density).lines(9)] == [240, 398, 100, 4]
    within = averaged(density, trusted=Band(100.0, 240.0)).lines(9)
    assert [round(each.frequency) for each in within] == [240, 100]
    # Below the main lobe of the mean, and at half the sample rate, nothing is looked for.
    edges = np.ones(201)
    edges[[1, 200]] = 90.0
    assert averaged(edges).lines(9) == ()
    assert averaged(density, trusted=Band(101.0, 101.9)).lines(9) == ()
    assert averaged(np.zeros(201)).lines(9) == ()
    # Only the top of a broad peak counts, not its flanks.
    for flank in ([90.0, 60.0, 40.0], [40.0, 60.0, 90.0]):
        broad = np.ones(201)
        broad[80:83] = flank
        assert len(averaged(broad).lines(9)) == 1
    flat = np.ones(201)
    flat[[80, 81]] = 30.0
    (line,) = averaged(flat).lines(9)
    assert line.frequency == pytest.approx(161.0)  # halfway between two equal bins


def test_a_line_is_never_less_than_nothing() -> None:
    density = np.full(201, 5.0)
    density[100] = 4.0
    line = averaged(density)._line(100)
    assert (line.amplitude, line.interval[0]) == (0.0, 0.0)
    power = 4.0 * 3.0
    _, gain = averaged(density)._between(100)
    high = line_interval(power, power, 5.0)[1]
    assert line.interval[1] == pytest.approx(math.sqrt(2.0 * high) / gain)


def test_far_above_the_noise_the_root_of_power_scatters_by_one() -> None:
    """The mean of its square is freedom plus noncentrality, and that of a root with variance 1 plus 1."""
    root, half = math.sqrt(6e6), 1.959963984540054
    expected = [((root + sign * half) ** 2 - 5.0) / 6.0 for sign in (-1.0, 1.0)]
    assert line_interval(1e6, 1.0, 3.0) == pytest.approx(expected, rel=1e-13)
    assert line_interval(4e6, 4.0, 3.0) == pytest.approx([4.0 * each for each in expected], rel=1e-13)


def test_an_averaged_spectrum_keeps_what_its_signal_was() -> None:
    values = np.random.default_rng(1).normal(size=400)
    parts = [Signal(each, RATE, converted=-2) for each in (values, values[:100], values[:30])]
    given = averaged_spectrum(parts, 4, "blackman-harris")
    assert (given.window, given.colour) == (Window.BLACKMAN_HARRIS, -2)
    assert given.left_out == sum(size for size in (400, 100, 30) if size < given.segment) > 0
    assert given.frequency == pytest.approx(np.arange(given.segment // 2 + 1) * RATE / given.segment)
    with pytest.raises(ValueError, match="averages"):
        averaged_spectrum(parts, 0)
    # 16 samples are the fewest of a segment.
    assert averaged_spectrum(Signal(values[:16], RATE), 1).segment == 16
    with pytest.raises(SignalError, match="15 samples are too few"):
        averaged_spectrum(Signal(values[:15], RATE), 1)
