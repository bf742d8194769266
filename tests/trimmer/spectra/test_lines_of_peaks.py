"""Where lines are looked for, what is left beside them, and how they are fitted, with spectra by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.arrays import Reals
from trimmer.errors import WrongTypeError
from trimmer.spectra.lines import Lines, _fitted, added, bins_near, noise_beside, relaxed
from trimmer.spectra.noise import NEIGHBOURHOOD
from trimmer.spectra.peaks import _left, _maxima, _new_bins, peaks
from trimmer.spectra.spectrum import Spectrum, amplitude_spectrum
from trimmer.spectra.window import Window

NONE = Lines(np.empty(0, int), np.empty(0), np.empty(0, complex))


def spectrum(lines: Reals, window: Window = Window.RECTANGULAR, colour: int = 0) -> Spectrum:
    return Spectrum(lines.astype(complex), window, 2000.0, 2 * (lines.size - 1), 0.5, colour)


def silent(*bins: int) -> Lines:
    return Lines(np.array(bins), np.array(bins, float), np.zeros(len(bins), complex))


def sine(place: float, size: float, count: int = 1000) -> Reals:
    return size * np.cos(2.0 * np.pi * place * np.arange(count) / count + 0.3)


def test_lines_below_a_ten_thousandth_of_the_largest_are_left_out_unless_asked_for() -> None:
    given = amplitude_spectrum(sine(100.0, 1.0) + sine(200.0, 1.2e-4) + sine(300.0, 0.8e-4), 1000.0)
    assert [round(peak.frequency) for peak in peaks(given)] == [100, 200]
    assert [round(peak.frequency) for peak in peaks(given, smallest=0.7e-4)] == [100, 200, 300]
    with pytest.raises(WrongTypeError, match="spectrum"):
        peaks(np.zeros(100))


def test_of_equal_maxima_the_lower_frequency_comes_first() -> None:
    amplitude = np.full(31, 0.1)
    amplitude[[20, 5, 12]] = [2.0, 2.0, 3.0]
    assert _maxima(spectrum(amplitude), np.full(31, 1.0)).tolist() == [12, 5, 20]


def test_what_lines_show_is_taken_off_within_their_skirts_and_beside_candidates() -> None:
    given = spectrum(np.full(501, 7.0))
    line = Lines(np.array([100]), np.array([100.3]), np.array([1.0 + 0.5j]))
    changed = np.flatnonzero(_left(given, line, np.array([0, 400, 500])) != 7.0)
    assert changed.tolist() == [*range(3), *range(35, 166), *range(398, 403), *range(498, 501)]
    assert _left(given, NONE, np.array([400])).tolist() == [7.0] * 501


def test_hidden_lines_are_beside_a_line_and_larger_than_what_its_fit_leaves() -> None:
    given = spectrum(np.zeros(401))
    left = np.full(401, 0.1)
    left[[49, 52, 55, 80, 114, 117, 302, 305]] = [2.0, 3.0, 2.0, 1.9, 2.5, 9.0, 5.0, 5.1]
    left[301] = 5.0
    lines = silent(50, 300)
    threshold = np.full(401, 0.5)
    nothing = np.empty(0, int)
    assert _new_bins(given, lines, nothing, left, threshold).tolist() == [52, 114, 305]
    # A candidate need be larger than noise alone, but may not be beside a line.
    left[[151, 201, 231]] = [1.5, 0.4, 1.5]
    candidates = np.array([150, 200, 229, 51])
    assert _new_bins(given, lines, candidates, left, threshold).tolist() == [52, 114, 151, 305]
    assert _new_bins(given, NONE, candidates, left, threshold).tolist() == [52, 151]
    assert _new_bins(given, NONE, nothing, left, threshold).tolist() == []
    left[[298, 302]] = 4.0  # smaller than the misfit of 5 at bin 301
    assert _new_bins(given, lines, np.array([299]), left, threshold).tolist() == [52, 114, 298, 305]
    # With the Hann window the lobe has one bin more on either side, and bin 52 is a misfit.
    wide = spectrum(np.zeros(401), Window.HANN)
    assert _new_bins(wide, lines, nothing, left, threshold).tolist() == [305]
    # The lobe of a line may reach beyond the last bin.
    flat = spectrum(np.zeros(61), Window.FLAT_TOP)
    beside = np.full(61, 0.1)
    beside[[50, 60]] = 1.0, 0.9
    assert _new_bins(flat, silent(57), nothing, beside, threshold[:61]).tolist() == [50]
    beside[60] = 1.1
    assert _new_bins(flat, silent(57), nothing, beside, threshold[:61]).tolist() == []


@pytest.mark.parametrize("unit", [1.0, 1e-5])
def test_what_is_hidden_does_not_depend_on_the_unit(unit: float) -> None:
    left = np.full(401, 0.1 * unit)
    left[[50, 52, 300, 305]] = 0.5 * unit, 0.9 * unit, 2.0 * unit, 0.3 * unit
    found = _new_bins(
        spectrum(np.zeros(401)), silent(50, 300), np.empty(0, int), left, np.full(401, 0.2 * unit)
    )
    assert found.tolist() == [52]


@pytest.mark.parametrize(("window", "bandwidth"), [(Window.RECTANGULAR, 1.0), (Window.HANN, 1.5)])
def test_noise_is_the_median_of_every_third_bin_beside_the_lines(window: Window, bandwidth: float) -> None:
    """Of noise of 1 the median of |line| is sqrt(ln 2 * 4 bandwidth / samples)."""
    count = 4 * NEIGHBOURHOOD
    values = 1.0 + np.sqrt(np.arange(count))
    given = spectrum(values, window)
    scale = math.sqrt(given.samples / (4.0 * math.log(2.0) * bandwidth))
    here = 2 * NEIGHBOURHOOD
    bins = np.arange(here + -NEIGHBOURHOOD // 2, here + NEIGHBOURHOOD // 2, 3)
    lines = silent(int(bins[7]), int(bins[90]))
    apart = np.delete(bins, [7, 90])  # no other is within the lobe of either
    expected = scale * np.median(values[apart])
    assert noise_beside(given, lines, here + 0.4) == pytest.approx(expected, rel=1e-12)
    grey = spectrum(values * np.maximum(np.arange(count), 1), window, 1)
    assert noise_beside(grey, lines, here - 0.4) == pytest.approx(here * expected, rel=1e-12)


def test_noise_is_not_taken_from_the_ends_nor_from_beside_lines_if_there_is_else() -> None:
    values = np.ones(40)
    values[[0, -1]] = 1e9
    scale = math.sqrt(78.0 / (4.0 * math.log(2.0)))
    few = spectrum(values)
    assert noise_beside(few, silent(20), 2.0) == pytest.approx(scale, rel=1e-12)
    assert noise_beside(few, silent(20), 38.0) == pytest.approx(scale, rel=1e-12)
    # Of bins 1, 2 and 4, not of 0.
    tiny = spectrum(np.array([0.0, 10.0, 2.0, 0.0, 5.0, 0.0]))
    assert noise_beside(tiny, silent(9), 2.0) == pytest.approx(5.0 * math.sqrt(10.0 / (4.0 * math.log(2.0))))
    everywhere = silent(*range(40))
    assert noise_beside(few, everywhere, 20.0) == pytest.approx(scale, rel=1e-12)


def test_what_lines_show_is_no_noise() -> None:
    given = amplitude_spectrum(sine(100.3, 2.0), 1000.0, Window.RECTANGULAR)
    line = Lines(np.array([100]), np.array([100.3]), np.array([2.0 * np.exp(0.3j)]))
    assert noise_beside(given, line, 100.3) < 0.01 * noise_beside(given, silent(100), 100.3)


def test_bins_within_a_reach_rise() -> None:
    assert bins_near(np.array([7, 20]), 1).tolist() == [[6, 7, 8], [19, 20, 21]]
    assert bins_near(np.array([7]), 2).tolist() == [[5, 6, 7, 8, 9]]


@pytest.mark.parametrize("window", [Window.HANN, Window.FLAT_TOP])
def test_steps_of_the_fit_converge_on_a_line_but_stay_beside_their_bin(window: Window) -> None:
    given = spectrum(np.zeros(201), window)
    bins = np.array([33, 70, 90, 120])
    places = np.array([33.3, 69.8, 91.2, 118.7])
    amplitudes = np.array([2.0 - 1.0j, 0.5j, 1.0, 1.0])
    shown = amplitudes[:, None] * window.transform(bins_near(bins, 1) - places[:, None], 400)
    lines = Lines(bins, bins.astype(float), np.ones(4, complex))
    for _ in range(8):
        lines = _fitted(given, lines, shown)
    assert lines.bins is bins
    assert lines.places == pytest.approx([33.3, 69.8, 90.75, 119.25], abs=1e-10)
    assert lines.amplitudes[:2] == pytest.approx(amplitudes[:2], abs=1e-10)
    near = _fitted(given, Lines(bins[:1], np.array([33.29]), np.ones(1, complex)), shown[:1])
    assert near.places == pytest.approx([33.3], abs=2e-4)


def test_a_line_is_added_to_others_and_both_are_fitted_without_each_other() -> None:
    values = sine(100.3, 2.0) + sine(107.6, 0.7)
    given = amplitude_spectrum(values, 1000.0, Window.HANN)
    first = Lines(np.array([100]), np.array([100.3]), np.array([2.0 * np.exp(0.3j)]))
    both = added(given, first, np.array([108]))
    assert both.bins.tolist() == [100, 108]
    assert both.places == pytest.approx([100.3, 107.6], abs=1e-6)
    assert np.abs(both.amplitudes) == pytest.approx([2.0, 0.7], abs=1e-5)
    alone = added(given, NONE, np.array([100, 108]))
    assert np.abs(alone.places - [100.3, 107.6]).max() > 1e-6
    turns = relaxed(given, alone)
    assert turns.bins.tolist() == [100, 108]
    assert turns.places == pytest.approx([100.3, 107.6], abs=1e-11)
    assert turns.amplitudes == pytest.approx(np.exp(0.3j) * np.array([2.0, 0.7]), abs=1e-10)
