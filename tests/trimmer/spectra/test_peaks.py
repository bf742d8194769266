from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.quick import quick
from trimmer import WrongTypeError, peaks
from trimmer.signals import SignalError
from trimmer.spectra import Window, amplitude_spectrum
from trimmer.spectra.peaks import MOST_PEAKS

TAPERED = [window for window in Window if window is not Window.RECTANGULAR]
SAMPLES = 1000
RATE = 500.0
PARTED = {Window.RECTANGULAR: 3, Window.HANN: 3, Window.BLACKMAN_HARRIS: 5, Window.FLAT_TOP: 6}
"""Bins by which two sines must be apart, as ``peaks`` states."""


def sines(places, amplitudes, phases) -> np.ndarray:
    """Add sines up; places are in bins."""
    turns = 2 * np.pi * np.multiply.outer(np.arange(SAMPLES) / SAMPLES, np.asarray(places))
    return (np.asarray(amplitudes) * np.cos(turns + np.asarray(phases))).sum(axis=1)


def found(values: np.ndarray, window: Window, **options) -> np.ndarray:
    """Places in bins and amplitudes of the peaks, by place, shape (number, 2)."""
    spectrum = amplitude_spectrum(values, RATE, window)
    listed = [(peak.frequency / spectrum.bin_width, peak.amplitude) for peak in peaks(spectrum, **options)]
    return np.array(sorted(listed)).reshape(-1, 2)


@pytest.mark.parametrize("window", Window)
@settings(max_examples=15)
@given(place=st.floats(8, 490), amplitude=st.floats(1e-9, 1e9), phase=st.floats(-3.1, 3.1))
def test_one_sine_is_found_exactly(window: Window, place: float, amplitude: float, phase: float) -> None:
    spectrum = amplitude_spectrum(5 * amplitude + sines([place], [amplitude], [phase]), RATE, window)
    (peak,) = peaks(spectrum)
    assert peak.frequency / spectrum.bin_width == pytest.approx(place, abs=1e-9)
    assert peak.amplitude == pytest.approx(amplitude, rel=1e-9)
    assert peak.phase == pytest.approx(phase, abs=1e-8)


@pytest.mark.parametrize("window", Window)
@settings(max_examples=5)
@given(
    place=st.floats(10, 470),
    more=st.floats(0.0, 10.0),
    ratio=st.floats(0.5, 2.0),
    phases=st.tuples(st.floats(-3.1, 3.1), st.floats(-3.1, 3.1)),
)
def test_two_close_sines_are_found_exactly(window, place, more, ratio, phases) -> None:
    places = [place, place + PARTED[window] + more]
    result = found(sines(places, [1.0, ratio], phases), window)
    np.testing.assert_allclose(result, [[places[0], 1.0], [places[1], ratio]], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("window", TAPERED)
def test_harmonics_of_a_drive_that_falls_between_bins_are_found_exactly(window: Window) -> None:
    orders = np.arange(1, 30, 2)
    result = found(sines(15.123 * orders, orders**-2.0, orders), window)
    np.testing.assert_allclose(result, np.stack([15.123 * orders, orders**-2.0], axis=1), rtol=1e-9)


@pytest.mark.parametrize("window", TAPERED)
def test_leakage_is_no_peak_and_hides_none_that_is_larger(window: Window) -> None:
    """Beside a large sine between two bins, only what is there is found: nothing, or a small sine."""
    large, small = (100.4, 1.0), (160.7, 3e-3)
    assert len(found(sines([large[0]], [1.0], [0.3]), window)) == 1
    result = found(sines(*zip(large, small, strict=True), [0.3, 1.0]), window)
    np.testing.assert_allclose(result, [large, small], rtol=1e-8)


def test_without_a_window_leakage_counts_as_noise() -> None:
    assert len(found(sines([100.4], [1.0], [0.3]), Window.RECTANGULAR)) == 1
    small = sines([100.4, 160.7], [1.0, 3e-3], [0.3, 1.0])
    assert len(found(small, Window.RECTANGULAR)) == 1
    larger = found(sines([100.4, 160.7], [1.0, 0.1], [0.3, 1.0]), Window.RECTANGULAR)
    np.testing.assert_allclose(larger, [[100.4, 1.0], [160.7, 0.1]], rtol=1e-8)


@pytest.mark.parametrize("window", quick(Window, 1))
def test_white_noise_seldom_gives_a_peak(window: Window) -> None:
    random = np.random.default_rng(5)
    alarms = sum(len(found(random.normal(size=2000), window)) > 0 for _ in range(120))
    assert alarms <= 7  # 1.5 % stated; 8 or more of 120 have a probability of 0.05 %
    loud = sum(len(found(random.normal(size=2000), window, false_alarm=0.9)) > 0 for _ in range(50))
    assert loud > 15


def test_peaks_come_by_amplitude_up_to_a_limit_and_a_constant_has_none() -> None:
    spectrum = amplitude_spectrum(sines([50.2, 90.4, 130.6], [1.0, 3.0, 2.0], [0, 1, 2]), RATE)
    assert [round(peak.amplitude, 6) for peak in peaks(spectrum)] == [3.0, 2.0, 1.0]
    assert peaks(spectrum, limit=2) == peaks(spectrum)[:2]
    assert peaks(amplitude_spectrum(np.full(100, 3.0), 1.0)) == ()
    assert peaks(amplitude_spectrum(np.zeros(16), 1.0, Window.FLAT_TOP)) == ()
    values = np.zeros(5000)
    values[::5] = 1.0  # harmonics at every fifth of the sample rate
    values[::7] += np.sin(np.arange(715))
    assert len(peaks(amplitude_spectrum(values, 1.0, Window.RECTANGULAR), false_alarm=0.99)) <= MOST_PEAKS


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"limit": 0}, "limit is 0: ask for one peak or more"),
        ({"smallest": 1.0}, "smallest is 1.0"),
        ({"smallest": -0.1}, "smallest is -0.1"),
        ({"smallest": np.nan}, "smallest is nan"),
        ({"false_alarm": 0.0}, "false_alarm is 0.0: it is a probability"),
        ({"false_alarm": 1.0}, "false_alarm is 1.0"),
    ],
)
def test_options_out_of_their_range_are_refused(options, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        peaks(amplitude_spectrum(np.zeros(100), 1.0), **options)


def test_lines_below_a_ten_thousandth_of_the_largest_are_left_out_unless_asked_for() -> None:
    given = amplitude_spectrum(sines([100.0, 200.0, 300.0], [1.0, 1.2e-4, 0.8e-4], 0.3), RATE)
    assert [round(peak.frequency) for peak in peaks(given)] == [50, 100]
    assert [round(peak.frequency) for peak in peaks(given, smallest=0.7e-4)] == [50, 100, 150]
    with pytest.raises(WrongTypeError, match="spectrum"):
        peaks(np.zeros(100))  # type: ignore[arg-type]


def test_a_line_in_noise_that_falls_with_frequency_is_as_uncertain_as_in_white_noise_of_its_level() -> None:
    values = sines([200.3], [1.0], [0.4]) + 0.5 * np.random.default_rng(4).normal(size=SAMPLES)
    white = amplitude_spectrum(values, RATE)
    falling = (np.maximum(np.arange(white.lines.size), 1) / 200.3) ** -2.0
    (one,), (two,) = peaks(white), peaks(replace(white, lines=white.lines * falling, colour=-2))
    assert two.frequency == pytest.approx(one.frequency, abs=0.01)
    assert two.frequency_uncertainty == pytest.approx(one.frequency_uncertainty, rel=0.1)
    assert two.amplitude_uncertainty == pytest.approx(one.amplitude_uncertainty, rel=0.1)
