import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from trimmer.errors import WrongTypeError
from trimmer.signals import SignalError
from trimmer.spectra import Window, fit_harmonics
from trimmer.spectra.harmonics import MOST_HARMONICS

RATE = 20_000.0
WEIGHTS = [Window.RECTANGULAR, Window.HANN, Window.BLACKMAN_HARRIS]


def periodic(drive: float, coefficients, mean: float, samples: int) -> np.ndarray:
    times = np.arange(samples) / RATE
    orders = np.arange(1, len(coefficients) + 1)
    return mean + (np.exp(2j * np.pi * drive * np.outer(times, orders)) @ np.asarray(coefficients)).real


@settings(max_examples=25)
@given(
    drive=st.floats(80.0, 400.0),
    samples=st.integers(1200, 3000),
    window=st.sampled_from(WEIGHTS),
    seed=st.integers(0, 1000),
)
def test_a_periodic_signal_is_fitted_exactly_whatever_the_length_of_the_record(
    drive: float, samples: int, window: Window, seed: int
) -> None:
    random = np.random.default_rng(seed)
    coefficients = random.normal(size=20) + 1j * random.normal(size=20)
    values = periodic(drive, coefficients, 3.0, samples)
    fit = fit_harmonics(values, RATE, drive, window=window)
    assert list(fit.orders) == list(range(1, MOST_HARMONICS + 1))
    np.testing.assert_allclose(fit.coefficients, coefficients, rtol=0, atol=1e-9)
    assert fit.mean == pytest.approx(3.0, abs=1e-9)
    assert fit.residual < 1e-9
    assert fit.explained == pytest.approx(1.0, abs=1e-12)
    np.testing.assert_allclose(fit.at(np.arange(samples) / RATE), values, rtol=0, atol=1e-9)


@pytest.mark.parametrize("window", WEIGHTS)
def test_the_fit_is_that_of_numpy(window: Window) -> None:
    """On a signal that is not periodic, with a design matrix that is written down column by column."""
    random = np.random.default_rng(2)
    values, drive, count = random.normal(size=700) + 0.5, 173.21, 6
    angles = 2 * np.pi * drive * np.arange(700) / RATE
    columns = [np.ones(700)]
    for order in range(1, count + 1):
        columns += [np.cos(order * angles), -np.sin(order * angles)]
    roots = np.sqrt(np.maximum(window.samples(700), 0.0))
    expected, *_ = np.linalg.lstsq(roots[:, None] * np.stack(columns, axis=1), roots * values, rcond=None)
    fit = fit_harmonics(values, RATE, drive, count, window)
    assert fit.mean == pytest.approx(expected[0], rel=1e-10)
    np.testing.assert_allclose(fit.coefficients, expected[1::2] + 1j * expected[2::2], rtol=1e-9)
    left = values - np.stack(columns, axis=1) @ expected
    assert fit.residual == pytest.approx(np.sqrt(np.mean(left**2)), rel=1e-10)
    assert fit.explained == pytest.approx(max(0.0, 1 - np.mean(left**2) / values.var()), rel=1e-10)


def test_the_hann_window_keeps_another_line_out() -> None:
    """A limit cycle beside the drive: the spectrum of the harmonics alone shows less of it with a window."""
    times = np.arange(2000) / RATE
    drive, other = 1e-3 * np.sin(2 * np.pi * 109.845 * times), 3e-5 * np.sin(2 * np.pi * 733.6 * times)
    plain, hann = (fit_harmonics(drive + other, RATE, 109.845, window=w) for w in WEIGHTS[:2])
    assert np.abs(plain.amplitudes - np.eye(20)[0] * 1e-3).max() > 1e-6
    assert np.abs(hann.amplitudes - np.eye(20)[0] * 1e-3)[:4].max() < 1e-8


def test_a_constant_signal_is_explained() -> None:
    for value in (0.0, 0.1):
        fit = fit_harmonics(np.full(1000, value), RATE, 100.0)
        assert (fit.mean, fit.explained) == (pytest.approx(value), pytest.approx(1.0))
        assert fit.amplitudes.max() < 1e-15


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"drive_frequency": 0.0}, "frequency of the drive must be a positive number of hertz, not 0.0"),
        ({"drive_frequency": -110.0}, "not -110.0"),
        ({"drive_frequency": np.nan}, "not nan"),
        ({"drive_frequency": True}, "not True"),
        ({"drive_frequency": 9.9}, r"the record lasts 0.1 s; 0.10101 s or more are needed for a drive of 9"),
        ({"drive_frequency": 19.0, "window": Window.HANN}, r"0.105263 s or more are .* \(hann window\)"),
        (
            {"drive_frequency": 9996.0},
            "a drive of 9996 Hz is not seen .* 20000 Hz, only what is up to 9995 Hz",
        ),
        ({"drive_frequency": 110.0, "count": 0}, "0 harmonics of 110 Hz: samples at 20000 Hz determine 1 to"),
        ({"drive_frequency": 110.0, "count": 91}, "91 harmonics of 110 Hz"),
        ({"drive_frequency": 110.0, "window": Window.FLAT_TOP}, "cannot be fitted with the flat-top window"),
    ],
)
def test_a_drive_that_cannot_be_fitted_is_an_error(options, message: str) -> None:
    with pytest.raises((SignalError, WrongTypeError), match=message):
        fit_harmonics(np.zeros(2000), RATE, **options)


@pytest.mark.parametrize("samples", [16, 17, 23, 39, 61])
def test_as_many_harmonics_as_can_be_are_determined_by_the_samples(samples: int) -> None:
    """With one period in the record there are (samples - 1) / 2 at most: two unknowns each, and the mean."""
    values = np.random.default_rng(samples).normal(size=samples)
    fit = fit_harmonics(values, samples * 0.5, 0.5)
    most = (samples - 1) // 2
    assert fit.coefficients.size == min(most, 20)
    assert fit_harmonics(values, samples * 0.5, 0.5, most).coefficients.size == most
    with pytest.raises(SignalError, match=f"determine 1 to {most}"):
        fit_harmonics(values, samples * 0.5, 0.5, most + 1)
