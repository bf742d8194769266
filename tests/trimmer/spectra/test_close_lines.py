"""Lines closer than a window parts them: resolved, or shown as one whose uncertainty holds them, and said."""

import math

import numpy as np
import pytest
from scipy.optimize import least_squares

from tests.quick import quick
from trimmer import Signal, analyse_signal, peaks
from trimmer.errors import SignalWarning
from trimmer.signals import Band
from trimmer.spectra import Window, amplitude_spectrum

SAMPLES = 1000
TIMES = np.arange(SAMPLES) / SAMPLES  # of a record, so that places are in bins


def sine(place: float, amplitude: float = 1.0, phase: float = 0.3) -> np.ndarray:
    return amplitude * np.cos(2 * np.pi * place * TIMES + phase)


def found(values: np.ndarray, window: Window = Window.HANN) -> list:
    return sorted(
        peaks(amplitude_spectrum(values, float(len(values)), window)), key=lambda peak: peak.frequency
    )


def least_squares_of_samples(values: np.ndarray, places: list[float], noise: float) -> tuple[list, list]:
    """Return places and their standard deviations from all samples, by SciPy."""
    columns = [part(2 * np.pi * place * TIMES) for place in places for part in (np.cos, np.sin)]
    parts = np.linalg.lstsq(np.column_stack([*columns, np.ones(SAMPLES)]), values, rcond=None)[0]
    begin = np.append(np.column_stack([places, parts[:-1].reshape(-1, 2)]).ravel(), parts[-1])

    def left(numbers: np.ndarray) -> np.ndarray:
        turns = 2 * np.pi * np.outer(TIMES, numbers[:-1:3])
        return np.cos(turns) @ numbers[1:-1:3] + np.sin(turns) @ numbers[2::3] + numbers[-1] - values

    fit = least_squares(left, begin, x_scale="jac", xtol=1e-15, ftol=1e-15)
    covariance = noise**2 * np.linalg.inv(fit.jac.T @ fit.jac)
    return fit.x[:-1:3].tolist(), np.sqrt(covariance.diagonal()[:-1:3]).tolist()


@pytest.mark.parametrize("window", Window)
@pytest.mark.parametrize("apart", [1.2, 1.7, 2.4])
def test_close_lines_are_as_exact_as_all_samples_allow(window: Window, apart: float) -> None:
    noise = 1e-3
    values = sine(150.37) + sine(150.37 + apart, 0.2, 2.0)
    values += noise * np.random.default_rng(5).normal(size=SAMPLES)
    best, deviations = least_squares_of_samples(values, [150.37, 150.37 + apart], noise)
    shown = found(values, window)
    assert [peak.resolved for peak in shown] == [True, True]
    for peak, place, deviation in zip(shown, best, deviations, strict=True):
        assert abs(peak.frequency - place) < 1.5 * deviation
        assert 0.8 * deviation < peak.frequency_uncertainty < 1.6 * deviation


@pytest.mark.parametrize("window", Window)
def test_a_line_far_away_is_not_moved_by_two_that_were_taken_for_one(window: Window) -> None:
    shown = found(sine(100.3) + sine(101.7, 0.8, 2.0) + sine(180.4, 0.5, 1.0), window)
    assert [peak.frequency for peak in shown] == pytest.approx([100.3, 101.7, 180.4], abs=1e-7)
    assert all(peak.resolved for peak in shown)


UNSTEADY = {
    "two within half a bin": sine(200.2) + sine(200.65, 0.6, 2.0),
    "drifts": np.cos(2 * np.pi * (200.2 * TIMES + 0.8 * (TIMES**2 - TIMES))),
    "dies out": np.exp(-2.0 * TIMES) * sine(200.2),
    "swells slowly": (1 + 0.4 * np.cos(2 * np.pi * 0.4 * TIMES)) * sine(200.2),
}


@pytest.mark.parametrize("window", quick(Window, 1))
@pytest.mark.parametrize("kind", UNSTEADY)
def test_what_is_no_steady_sine_is_wide_and_said_to_be_such(kind: str, window: Window) -> None:
    values = UNSTEADY[kind] + 1e-4 * np.random.default_rng(3).normal(size=SAMPLES)
    with pytest.warns(SignalWarning, match="no single steady sine explains the peaks at (199|200)"):
        analysis = analyse_signal(Signal(values, float(SAMPLES)), window=window)
    largest = analysis.peaks[0].peak
    assert not largest.resolved
    assert abs(largest.frequency - 200.2) < 2 * largest.frequency_uncertainty
    assert largest.frequency_uncertainty < 2.0
    axes = analysis.plot()
    assert "no single steady sine" in [text.get_text() for text in axes.get_legend().get_texts()]


def test_only_what_lies_in_the_band_is_given() -> None:
    spectrum = amplitude_spectrum(sine(100.3) + sine(101.7, 0.8) + sine(300.2, 0.1), float(SAMPLES))
    assert [round(peak.frequency) for peak in peaks(spectrum, band=Band(lowest=200.0))] == [300]
    assert [round(peak.frequency) for peak in peaks(spectrum, 1, band=Band(highest=200.0))] == [100]


def pair(seed: int) -> tuple[np.ndarray, Window, list[float]]:
    """Return the samples of two lines 1 to 6 bins apart, of any sizes, phases and noise, and their places."""
    random = np.random.default_rng(seed)
    count, window = int(random.choice([256, 600, 1000, 4096])), list(Window)[random.integers(4)]
    first = random.uniform(20, count / 2 - 20)
    places = [first, first + random.choice([-1, 1]) * random.uniform(1.0, 6.0)]
    times, phases = np.arange(count) / count, random.uniform(-np.pi, np.pi, 2)
    values = np.cos(2 * np.pi * places[0] * times + phases[0])
    values += 10.0 ** random.uniform(-4, 0) * np.cos(2 * np.pi * places[1] * times + phases[1])
    noise = random.choice([0.0, 1.0]) * 10.0 ** random.uniform(-6, -1)
    return values + noise * random.normal(size=count), window, places


def misses(seeds: range) -> list[float]:
    """Return how many standard deviations each line that is shown is away from the nearest that there is."""
    shown = [
        (peak, places)
        for seed in seeds
        for values, window, places in [pair(seed)]
        for peak in found(values, window)
    ]
    return [
        min(abs(peak.frequency - place) for place in places) / (peak.frequency_uncertainty + 1e-9)
        for peak, places in shown
    ]


def test_the_uncertainty_of_close_lines_holds_the_truth() -> None:
    away = np.array(misses(range(10)))
    assert len(away) > 14
    assert (away < 4.0).all()


@pytest.mark.slow
def test_the_uncertainty_of_many_close_lines_holds_the_truth() -> None:
    away = np.array(misses(range(1000, 1500)))
    assert (away > 3.0).sum() <= 0.01 * len(away)
    assert away.max() < 5.0


def test_an_unlikely_second_line_is_not_claimed_in_noise() -> None:
    """Of lone lines hardly any is doubted: the likelihood ratio allows one in some 10^5."""
    random = np.random.default_rng(9)
    count, wide = 0, 0
    for _ in range(30):
        values = sine(random.uniform(50, 450), 1.0, random.uniform(-3, 3)) + 0.03 * random.normal(
            size=SAMPLES
        )
        shown = peaks(amplitude_spectrum(values, float(SAMPLES)), limit=1)
        count += not shown[0].resolved
        bound = 1.90 * math.sqrt(6.0) / math.pi * 0.03 / math.sqrt(SAMPLES)
        wide += shown[0].frequency_uncertainty > 1.5 * bound
    assert count == 0
    assert wide < 0.15 * 30


@pytest.mark.parametrize("noise", quick([0.0, 0.01], 1))
def test_a_comb_of_close_lines_is_found_whole(noise: float) -> None:
    """35 lines 5.3 bins apart in 400 samples: few bins show noise alone, and not all are fitted together."""
    places, times = 8.2 + 5.3 * np.arange(35), np.arange(400) / 400
    sizes = 1.0 + 0.5 * np.cos(np.arange(35))
    values = np.cos(2 * np.pi * np.outer(times, places) + np.arange(35)) @ sizes
    values += noise * np.random.default_rng(3).normal(size=400)
    with pytest.warns(SignalWarning, match=r"35 peaks from 8\.[12].* to 188\.[34].* no more than 24 of"):
        analysis = analyse_signal(Signal(values, 400.0), limit=40)
    shown = sorted((each.peak for each in analysis.peaks), key=lambda peak: peak.frequency)
    assert all(peak.resolved for peak in shown)
    uncertain = np.array([peak.frequency_uncertainty for peak in shown])
    off = abs(np.array([peak.frequency for peak in shown]) - places)
    np.testing.assert_array_less(off, 4.0 * uncertain + 1e-9)
    assert uncertain.max() < 0.2 * noise + 1e-9
    np.testing.assert_allclose([peak.amplitude for peak in shown], sizes, rtol=0.5 * noise + 1e-9)


def test_lines_that_leave_no_bin_apart_are_as_certain_as_they_say() -> None:
    """Each bin is within the main lobe of one, so that noise is taken from what all together leave."""
    places, times = np.arange(6.2, 195.0, 8.6), np.arange(400) / 400
    values = np.cos(2 * np.pi * np.outer(times, places) + np.arange(22)).sum(axis=1)
    values += 0.01 * np.random.default_rng(3).normal(size=400)
    shown = found(values, Window.BLACKMAN_HARRIS)
    assert all(peak.resolved for peak in shown)
    off = np.array([peak.frequency for peak in shown]) - places
    assert 0.5 < np.std(off / [peak.frequency_uncertainty for peak in shown]) < 1.5
