from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy import signal as scipy_signal

from trimmer.signals.signal import SignalError
from trimmer.spectra.spectrum import FEWEST_SAMPLES, amplitude_spectrum
from trimmer.spectra.window import Window

SCIPY_NAMES = {
    Window.RECTANGULAR: "boxcar",
    Window.HANN: "hann",
    Window.BLACKMAN_HARRIS: "blackmanharris",
    Window.FLAT_TOP: "flattop",
}
SIGNALS = arrays(np.float64, st.integers(FEWEST_SAMPLES, 64), elements=st.floats(-1e6, 1e6))
WINDOWS = st.sampled_from(Window)


@pytest.mark.parametrize("window", Window)
@pytest.mark.parametrize("count", [64, 65])
def test_windows_are_those_of_scipy(window: Window, count: int) -> None:
    expected = scipy_signal.get_window(SCIPY_NAMES[window], count, fftbins=True)
    np.testing.assert_allclose(window.samples(count), expected, rtol=0, atol=1e-15)


@pytest.mark.parametrize("window", Window)
@pytest.mark.parametrize("count", [16, 17, 500])
def test_the_transform_of_a_window_is_its_sum(window: Window, count: int) -> None:
    bins = np.concatenate([np.linspace(-1.5 * count, 1.5 * count, 601), np.arange(-count, count + 1)])
    turns = np.exp(-2j * np.pi * np.outer(bins, np.arange(count)) / count)
    expected = turns @ window.samples(count) / window.samples(count).sum()
    np.testing.assert_allclose(window.transform(bins, count), expected, rtol=0, atol=3e-13)


@pytest.mark.parametrize("window", Window)
def test_the_half_width_ends_the_main_lobe(window: Window) -> None:
    beyond = np.arange(window.half_width, 20)
    assert np.abs(window.transform(beyond, 1000)).max() < 1e-9
    assert np.abs(window.transform(window.half_width - 1, 1000)) > 1e-3


@pytest.mark.parametrize("window", Window)
@pytest.mark.parametrize("count", [200, 201])
@pytest.mark.parametrize("bin_number", [20, 37, 80])
def test_a_sine_on_a_bin_shows_its_amplitude_and_phase(window: Window, count: int, bin_number: int) -> None:
    phases = 2 * np.pi * bin_number * np.arange(count) / count
    spectrum = amplitude_spectrum(-7.0 + 3e-5 * np.cos(phases + 0.7), 20_000, window)
    assert spectrum.frequency[bin_number] == pytest.approx(bin_number * 20_000 / count, rel=1e-15)
    assert spectrum.amplitude[bin_number] == pytest.approx(3e-5, rel=1e-10)
    assert np.angle(spectrum.lines[bin_number]) == pytest.approx(0.7, abs=1e-9)
    assert spectrum.mean == pytest.approx(-7.0, rel=1e-15)
    assert spectrum.amplitude[0] < 1e-15


def test_flat_top_shows_the_amplitude_between_bins_too() -> None:
    for offset in np.linspace(-0.5, 0.5, 11):
        phases = 2 * np.pi * (50 + offset) * np.arange(2000) / 2000
        shown = amplitude_spectrum(np.cos(phases), 1.0, Window.FLAT_TOP).amplitude.max()
        assert abs(20 * np.log10(shown)) < 0.011


def test_half_the_sample_rate_is_not_doubled() -> None:
    shown = amplitude_spectrum(0.5 * np.cos(np.pi * np.arange(20)), 20.0, Window.RECTANGULAR)
    assert (shown.frequency[-1], shown.amplitude[-1]) == (10.0, pytest.approx(0.5, rel=1e-12))


@given(SIGNALS, WINDOWS)
def test_the_spectrum_is_that_of_scipy(values, window: Window) -> None:
    """SciPy's power spectrum is the mean square of each line."""
    frequency, power = scipy_signal.periodogram(
        values, fs=8000.0, window=SCIPY_NAMES[window], detrend="constant", scaling="spectrum"
    )
    spectrum = amplitude_spectrum(values, 8000.0, window)
    np.testing.assert_allclose(spectrum.frequency, frequency, rtol=1e-14)
    expected = np.sqrt(power)
    last = spectrum.amplitude.size - (1 if values.size % 2 == 0 else 0)
    expected[1:last] *= np.sqrt(2.0)
    size = np.abs(values).max()
    np.testing.assert_allclose(spectrum.amplitude, expected, rtol=1e-9, atol=1e-12 * size + 1e-150)


@given(SIGNALS)
def test_mean_squares_are_kept(values) -> None:
    """Parseval: without a window, variance is the sum of the mean squares of the lines."""
    spectrum = amplitude_spectrum(values, 1.0, Window.RECTANGULAR)
    squares = 0.5 * spectrum.amplitude**2
    if values.size % 2 == 0:
        squares[-1] *= 2.0
    scale = np.abs(values).max() ** 2
    assert squares[1:].sum() == pytest.approx(values.var(), rel=1e-10, abs=1e-14 * scale)


@given(SIGNALS, st.floats(-100, 100), st.floats(-100, 100), WINDOWS, st.data())
def test_the_spectrum_is_linear(values, a: float, b: float, window: Window, data) -> None:
    others = data.draw(arrays(np.float64, values.size, elements=st.floats(-1e6, 1e6)))
    first, second = (amplitude_spectrum(each, 1.0, window).lines for each in (values, others))
    together = amplitude_spectrum(a * values + b * others, 1.0, window).lines
    size = 100 * (np.abs(values).max() + np.abs(others).max())
    np.testing.assert_allclose(together, a * first + b * second, rtol=0, atol=1e-12 * size + 1e-300)


@given(SIGNALS, st.integers(0, 100))
def test_a_shift_in_time_leaves_amplitudes(values, shift: int) -> None:
    """For the periodic continuation of a record, which is what the transform sees."""
    before = amplitude_spectrum(values, 1.0, Window.RECTANGULAR).amplitude
    after = amplitude_spectrum(np.roll(values, shift), 1.0, Window.RECTANGULAR).amplitude
    np.testing.assert_allclose(after, before, rtol=0, atol=1e-12 * np.abs(values).max() + 1e-300)


@given(SIGNALS, st.integers(-250, 250), WINDOWS)
def test_scaling_by_powers_of_two_is_exact(values, exponent: int, window: Window) -> None:
    """The unit of a signal does not matter: micrometres lose no more digits than metres."""
    before = amplitude_spectrum(values, 1.0, window)
    after = amplitude_spectrum(values * 2.0**exponent, 1.0, window)
    subnormal = 1e-290
    np.testing.assert_allclose(after.lines, before.lines * 2.0**exponent, rtol=1e-14, atol=subnormal)


@given(SIGNALS, st.floats(-1e6, 1e6), WINDOWS)
def test_a_constant_moves_the_mean_alone(values, constant: float, window: Window) -> None:
    before, after = (amplitude_spectrum(each, 1.0, window) for each in (values, values + constant))
    size = np.abs(values).max() + abs(constant)
    np.testing.assert_allclose(after.lines, before.lines, rtol=0, atol=1e-12 * size + 1e-300)
    assert after.mean == pytest.approx(before.mean + constant, abs=1e-14 * size)


def test_the_bin_width_is_the_inverse_of_the_records_length() -> None:
    """The thesis's simulation: 10002300 Hz and 1000231 samples, from 0 s to 0.1 s with both ends."""
    spectrum = amplitude_spectrum(np.zeros(1000231), 10002300.0)
    assert spectrum.bin_width == pytest.approx(10 * (1 - 1 / 1000231), rel=1e-14)


@pytest.mark.parametrize(
    ("values", "rate", "message"),
    [
        (np.zeros(15), 1.0, "15 samples are too few for a spectrum; 16 or more are needed"),
        (np.zeros(20), -1.0, "sample rate must be a positive number of hertz"),
        (np.full(20, np.inf), 1.0, "not finite"),
        (np.zeros((20, 2)), 1.0, "one dimension"),
    ],
)
def test_what_has_no_spectrum_is_refused(values, rate: float, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        amplitude_spectrum(values, rate)
