import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy import signal as scipy_signal

from trimmer.signals import SignalError
from trimmer.spectra import Window, amplitude_spectrum
from trimmer.spectra.spectrum import FEWEST_SAMPLES

SCIPY_NAMES = {
    Window.RECTANGULAR: "boxcar",
    Window.HANN: "hann",
    Window.BLACKMAN_HARRIS: "blackmanharris",
    Window.FLAT_TOP: "flattop",
}
SIGNALS = arrays(np.float64, st.integers(FEWEST_SAMPLES, 64), elements=st.floats(-1e6, 1e6))
WINDOWS = st.sampled_from(Window)


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


@settings(max_examples=10)
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
