"""The parts of spectra and peaks by hand: windows, thresholds, maxima and noise."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from trimmer.signals.signal import SignalError
from trimmer.spectra.lines import Lines, leakage, noise_beside
from trimmer.spectra.noise import noise_threshold
from trimmer.spectra.peaks import _inside, _is_maximum, _left, _maxima, _threshold
from trimmer.spectra.spectrum import Spectrum, amplitude_spectrum
from trimmer.spectra.window import Window

RATE = 2000.0


def spectrum(lines: list[complex], window: Window = Window.RECTANGULAR, colour: int = 0) -> Spectrum:
    values = np.array(lines, complex)
    return Spectrum(values, window, RATE, 2 * (values.size - 1), 0.5, colour)


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
    assert Window.RECTANGULAR.transform(x, 12) == pytest.approx(expected, abs=1e-14)


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
    grey = replace(given, colour=-1)
    coloured = _threshold(replace(grey, lines=lines * grey.noise_shape), 0.0, 0.01)
    assert coloured == pytest.approx(noise * grey.noise_shape)
    assert grey.noise_shape[10] == pytest.approx(0.1)


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
    line = Lines(np.array([33]), np.array([33.3]), np.array([amplitude]))
    bins = np.array([20, 33, 34, 60])
    assert leakage(given, line, bins) == pytest.approx(given.lines[bins], abs=1e-2)
    left = _left(given, line, np.array([2]))
    assert left[20:60].max() < 1e-2
    assert left[99] == given.amplitude[99]  # beyond the skirt nothing is taken off
    assert left[97] != given.amplitude[97]
    nothing = Lines(np.empty(0, int), np.empty(0), np.empty(0, complex))
    assert leakage(given, nothing, bins).tolist() == [0.0] * 4


@pytest.mark.parametrize("window", [Window.RECTANGULAR, Window.HANN])
def test_noise_beside_a_peak_is_that_of_the_samples(window: Window) -> None:
    noise = 0.3 * np.random.default_rng(8).normal(size=40_000)
    given = amplitude_spectrum(noise, RATE, window)
    nothing = Lines(np.array([5000]), np.array([5000.0]), np.array([0j]))
    # 133 bins: the median is uncertain by about a tenth; so the mean of many places.
    levels = [noise_beside(given, nothing, place) for place in np.arange(500.0, 19_000.0, 400.0)]
    assert np.mean(levels) == pytest.approx(0.3, rel=0.03)
    assert noise_beside(given, nothing, 3.0) == pytest.approx(0.3, rel=0.3)
    assert noise_beside(given, nothing, 19_998.0) == pytest.approx(0.3, rel=0.3)
