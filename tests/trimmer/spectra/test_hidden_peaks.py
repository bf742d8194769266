"""Small lines beside large ones, and how uncertain a peak says that it is, on random signals."""

import numpy as np
import pytest

from tests.quick import examples, quick
from tests.trimmer.spectra.test_peaks import SAMPLES, sines
from trimmer import peaks
from trimmer.spectra import Window, amplitude_spectrum

LEVELS = (20, 40, 60, 80)  # How far the small line is below the large one, dB
NEAREST, FARTHEST = 4.0, 30.0  # Distance of the two, bins
NOISE = 0.1  # Standard deviation of white noise over the small amplitude


def errors(level: int, seed: int, noise: float = NOISE) -> tuple[np.ndarray, np.ndarray, int]:
    """Errors of place (bins) and relative amplitude of large and small line, each also over its uncertainty.

    Returns:
        Errors, shape (2, 2); errors over uncertainties, shape (2, 2); number of peaks beside the two.
    """
    random = np.random.default_rng(seed)
    large = random.uniform(60, 440)
    places = np.array([large, large + random.choice([-1, 1]) * random.uniform(NEAREST, FARTHEST)])
    amplitudes = np.array([1.0, 10 ** (-level / 20)])
    values = sines(places, amplitudes, random.uniform(-3, 3, size=2))
    values = values + noise * amplitudes[1] * random.normal(size=SAMPLES)
    found = peaks(amplitude_spectrum(values, SAMPLES, Window.HANN), smallest=1e-5)
    nearest = [min(found, key=lambda peak, place=place: abs(peak.frequency - place)) for place in places]
    off = np.array([[peak.frequency - place, peak.amplitude - amplitude]
                    for peak, place, amplitude in zip(nearest, places, amplitudes, strict=True)])  # fmt: skip
    uncertain = np.array([[peak.frequency_uncertainty, peak.amplitude_uncertainty] for peak in nearest])
    return off / [[1.0, 1.0], [1.0, amplitudes[1]]], off / uncertain, len(found) - 2


@pytest.mark.parametrize("level", quick(LEVELS, 2))
def test_a_small_line_beside_a_large_one_is_as_exact_as_it_says(level: int) -> None:
    signals = examples(40, 400)
    results = [errors(level, 1000 * level + number) for number in range(signals)]
    pulls = np.array([pull for _, pull, _ in results])
    assert np.abs(pulls).max() < 7.0  # all lines are found: a missed one is off by 4 bins
    spread = 4.0 / np.sqrt(2 * signals)
    np.testing.assert_allclose(pulls.std(axis=0), 1.0, atol=0.15 + spread)
    np.testing.assert_allclose(pulls.mean(axis=0), 0.0, atol=2.0 * spread)
    assert sum(more for _, _, more in results) <= max(3, 0.03 * signals)  # 1 % of false alarms is asked for


@pytest.mark.parametrize("level", LEVELS)
def test_without_noise_a_small_line_is_exact(level: int) -> None:
    for seed in range(8):
        off, _, more = errors(level, seed, noise=0.0)
        assert more == 0
        np.testing.assert_allclose(off, 0.0, atol=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(("window", "factor"), quick(zip(Window, (0.9, 1.5, 2.1, 6.5), strict=True), 1))
def test_the_uncertainty_is_that_of_repeated_measurements(window: Window, factor: float) -> None:
    """In bins the scatter is the factor that ``peaks`` states over that of the samples and their root."""
    random = np.random.default_rng(2)
    errors, pulls, trials = [], [], 120
    for _ in range(trials):
        place = random.uniform(100, 101)
        values = sines([place], [3.0], [random.uniform(-3, 3)]) + 0.2 * random.normal(size=SAMPLES)
        (peak,) = peaks(amplitude_spectrum(values, SAMPLES, window), limit=1)
        off = np.array([peak.frequency - place, peak.amplitude - 3.0])
        errors.append(off)
        pulls.append(off / [peak.frequency_uncertainty, peak.amplitude_uncertainty])
    np.testing.assert_allclose(np.std(pulls, axis=0), 1.0, atol=0.25)
    scatter = np.std(errors, axis=0)[0]
    assert scatter / (0.2 / 3.0 / np.sqrt(SAMPLES)) == pytest.approx(factor, rel=0.25)
    assert np.abs(np.mean(pulls, axis=0)).max() < 4.0 / np.sqrt(trials)


@pytest.mark.parametrize("window", Window)
@pytest.mark.parametrize("decay", quick([1e-4, 1e-3, 1e-2], 1))
def test_beside_a_vibration_that_dies_out_nothing_hidden_is_claimed(window: Window, decay: float) -> None:
    times = np.arange(4000)
    for frequency in np.linspace(0.11, 0.1108, 3):
        values = np.exp(-decay * times) * np.cos(2 * np.pi * frequency * times)
        assert len(peaks(amplitude_spectrum(values, 1.0, window))) <= 2
