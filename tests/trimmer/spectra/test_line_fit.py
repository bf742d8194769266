"""What is said of the fit of a few lines to their bins is so."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.spectra.line_fit import Bins, bins_around
from trimmer.spectra.lines import Lines
from trimmer.spectra.spectrum import amplitude_spectrum
from trimmer.spectra.window import Window

NOISE = 1e-3


def around(window: Window, *sines: tuple[float, complex]) -> Bins:
    """Return the bins around the first of some sines: their places in bins, and complex amplitudes."""
    turns = np.exp(2j * np.pi * np.outer(np.arange(600) / 600, [place for place, _ in sines]))
    spectrum = amplitude_spectrum((turns @ [size for _, size in sines]).real, 600.0, window)
    place, size = sines[0]
    lines = Lines(np.array([round(place)]), np.array([place]), np.array([size]))
    return bins_around(spectrum, lines, np.array([0]), NOISE)


@pytest.mark.parametrize("window", Window)
@pytest.mark.parametrize("apart", [-1.5, 1.0, 3.25])
def test_a_promise_is_kept(window: Window, apart: float) -> None:
    """A line beside a larger one lowers the misfit by what is promised, about where that says."""
    other = (80.25 + apart, 2e-3 * np.exp(2j))
    bins = around(window, (80.25, 1.0 + 0.5j), other)
    alone = bins.refined(np.array([80.25]))
    gain, place = bins.promise(alone)
    both = bins.refined(np.array([80.25, place]))
    assert gain == pytest.approx(alone.misfit - both.misfit, rel=0.05)
    assert abs(place - other[0]) <= 0.25
    assert both.explains
    assert both.places == pytest.approx([80.25, other[0]], abs=1e-4)
    assert both.amplitudes == pytest.approx([1.0 + 0.5j, other[1]], abs=1e-5)


@pytest.mark.parametrize("window", Window)
def test_slopes_are_those_of_what_is_left(window: Window) -> None:
    """By amplitudes, and by places with amplitudes that stay: what is left falls by the slope."""
    bins = around(window, (80.3, 1.0 - 0.5j), (81.6, 0.4j))
    places = np.array([80.2, 81.7])
    fit = bins.at(places)
    step = 1e-6
    whitened = bins.whitener @ bins.left_by(places, fit.amplitudes)
    np.testing.assert_allclose(fit.left, [*whitened.real, *whitened.imag], atol=1e-9 * abs(whitened).max())
    for number, slope in enumerate(fit.slopes.T):
        moved, changed = places.copy(), fit.amplitudes.copy()
        if number < 2:
            moved[number] += step
        else:
            changed[(number - 2) // 2] += (step, 1j * step)[number % 2]
        fallen = (whitened - bins.whitener @ bins.left_by(moved, changed)) / step
        np.testing.assert_allclose(
            slope, [*fallen.real, *fallen.imag], rtol=1e-4, atol=1e-4 * abs(fallen).max()
        )


@pytest.mark.parametrize("window", Window)
def test_deviations_and_gains_are_those_of_the_normal_equations(window: Window) -> None:
    """By Cramér and Rao; and a small line that is left out raises the misfit by its gain."""
    bins = around(window, (80.3, 1.0), (82.7, 4e-3 * np.exp(1j)))
    fit = bins.refined(np.array([80.3, 82.7]))
    covariance = np.linalg.inv(fit.slopes.T @ fit.slopes)
    np.testing.assert_allclose(fit.spreads[0], np.sqrt(covariance.diagonal()[:2]), rtol=1e-6)
    for number, phase in enumerate(np.angle(fit.amplitudes)):
        along = np.array([np.cos(phase), np.sin(phase)])
        part = covariance[2 + 2 * number : 4 + 2 * number, 2 + 2 * number : 4 + 2 * number]
        assert fit.spreads[1][number] == pytest.approx(np.sqrt(along @ part @ along), rel=1e-6)
    without = bins.refined(np.array([80.3]))
    assert fit.gains[1] == pytest.approx(without.misfit - fit.misfit, rel=0.05)


@pytest.mark.parametrize("window", Window)
def test_the_best_pairs_of_a_grid_come_first(window: Window) -> None:
    bins = around(window, (80.0, 1.0), (80.8, 0.7j))
    pairs = list(bins.pairs(80.0))
    misfits = [bins.at(pair).misfit for pair in pairs]
    assert len(pairs) == 3 and misfits == sorted(misfits)
    grid = 80.0 + np.arange(-3.0, 3.1, 0.4)
    every = [bins.at(np.array([a, b])).misfit for a in grid for b in grid if a < b]
    assert misfits == pytest.approx(sorted(every)[:3], rel=1e-6)
