"""Conversion between displacement, velocity and acceleration, against motions that are known exactly."""

import numpy as np
import pytest

from trimmer import Signal, convert
from trimmer.signals import Conversion, MotionQuantity
from trimmer.signals.quantity import STANDARD_GRAVITY

RATE = 10_000.0
TIMES = 0.3 + np.arange(20_000) / RATE
LINES = ((110.0, 1e-3, 0.3), (220.0, 2e-4, 1.0), (330.0, 1e-4, -2.0), (770.0, 1e-5, 0.5))
UNITS = {0: "m", 1: "m/s", 2: "m/s2"}
NOISE = np.random.default_rng(0).normal(size=TIMES.size)
FIXED = {"lowest": 20.0, "highest": 3000.0}


def exact(times: np.ndarray, derivatives: int) -> np.ndarray:
    """Displacement of some lines, differentiated in closed form."""
    return sum(
        a * ((2j * np.pi * f) ** derivatives * np.exp(1j * (2 * np.pi * f * times + p))).real
        for f, a, p in LINES
    )


def made(values: np.ndarray, derivatives: int, quantity: str, **options: float) -> Conversion:
    return convert(Signal(values, RATE, "a", UNITS[derivatives], TIMES[0]), quantity, **options)


@pytest.mark.parametrize("source", [0, 1, 2])
@pytest.mark.parametrize("wanted", [0, 1, 2])
def test_lines_in_the_band_are_exact_up_to_what_the_ends_change(source: int, wanted: int) -> None:
    quantity = list(MotionQuantity)[wanted]
    conversion = made(exact(TIMES, source), source, quantity.word)
    signal = conversion.signal
    assert (signal.unit, signal.quantity, signal.converted) == (quantity.unit, quantity, wanted - source)
    error = np.abs(signal.values - exact(signal.times, wanted)).max()
    assert error <= max(3 * conversion.end_error, 1e-12 * np.abs(signal.values).max())
    assert conversion.end_error <= conversion.end_bound
    assert conversion.end_error < 0.02 * signal.values.std()
    left = (TIMES.size - signal.values.size) / RATE
    assert left == pytest.approx(2 * conversion.cut, abs=1e-9)


def test_offset_and_drift_do_not_matter_when_integrating() -> None:
    clean = made(exact(TIMES, 2), 2, "displacement").signal
    drifting = made(exact(TIMES, 2) + 300.0 - 80.0 * TIMES + 9.0 * TIMES**2, 2, "displacement").signal
    np.testing.assert_allclose(drifting.values, clean.values, atol=2e-3 * clean.values.std())


@pytest.mark.parametrize("size", [0.5, 5.0, 50.0])
def test_noise_in_the_result_is_as_told(size: float) -> None:
    """Acceleration with white noise, offset and drift; the drive has 478 m/s²."""
    conversion = made(exact(TIMES, 2) + size * NOISE + 30.0 + 20.0 * TIMES, 2, "displacement")
    error = conversion.signal.values - exact(conversion.signal.times, 0)
    assert 0.6 < conversion.noise / error.std() < 1.6
    assert conversion.noise < 0.12 * conversion.signal.values.std()
    assert (conversion.signal.trusted.lowest > 24.0) is (size == 50.0)
    if size == 50.0:
        assert "noise" in conversion.signal.trusted.lowest_reason


@pytest.mark.parametrize(("quantity", "integrals"), [("velocity", 1), ("displacement", 2)])
def test_integrated_white_noise_falls_with_the_frequency(quantity: str, integrals: int) -> None:
    """Of power 2/rate per hertz over (2 pi f)^(2 n), most of it at low frequencies; flanks add the same."""
    power = 1 - 2 * integrals
    told, white = np.empty(2), np.empty(2)
    for row, lowest in enumerate((200.0, 1000.0)):
        options = {"lowest": lowest, "highest": 3000.0}
        told[row] = made(exact(TIMES, 2) + 3.0 * NOISE, 2, quantity, **options).noise
        alone = made(3.0 * NOISE, 2, quantity, **options).signal.values.std()
        assert told[row] == pytest.approx(alone, rel=0.1)
        density = 2.0 * 9.0 / RATE * (2 * np.pi) ** (-2 * integrals)
        white[row] = np.sqrt(density * (3000.0**power - lowest**power) / power)
    assert told[0] / told[1] == pytest.approx(white[0] / white[1], rel=0.1)
    assert (told > white).all()


def test_noise_alone_is_called_that() -> None:
    assert any("no lines" in note for note in made(NOISE, 2, "displacement").signal.notes)


def test_it_is_linear_shifts_with_the_signal_and_keeps_the_scale() -> None:
    one, two = exact(TIMES, 2) + NOISE, np.roll(NOISE, 777)
    first, second = (made(x, 2, "displacement", **FIXED).signal.values for x in (one, two))
    both = made(2.5 * one - 7.0 * two, 2, "displacement", **FIXED).signal.values
    np.testing.assert_allclose(both, 2.5 * first - 7.0 * second, atol=1e-12 * np.abs(both).max())
    in_g = convert(Signal(one / STANDARD_GRAVITY, RATE, "a", "g"), "displacement", **FIXED).signal.values
    np.testing.assert_allclose(in_g, first, atol=1e-12 * np.abs(first).max())
    for size in (1e250, 1e-250):
        scaled = made(size * one, 2, "displacement", **FIXED)
        np.testing.assert_allclose(scaled.signal.values / size, first, atol=1e-12 * np.abs(first).max())
        assert scaled.noise / size == pytest.approx(made(one, 2, "displacement", **FIXED).noise)
    later = convert(Signal(one[1000:], RATE, "a", "m/s2"), "displacement", **FIXED)
    np.testing.assert_allclose(later.signal.values, first[1000:], atol=2 * later.end_bound)


def test_there_and_back_gives_what_is_in_the_band() -> None:
    """Also Parseval: the variance of the displacement is that of its lines."""
    displacement = made(exact(TIMES, 2), 2, "displacement").signal
    assert displacement.values.var() == pytest.approx(sum(a**2 / 2 for _, a, _ in LINES), rel=1e-3)
    for derivatives, quantity in ((1, "velocity"), (2, "acceleration")):
        back = convert(displacement, quantity).signal
        np.testing.assert_allclose(back.values, exact(back.times, derivatives), atol=2e-2 * back.values.std())


def test_what_lies_outside_is_cut_and_told() -> None:
    slow = 100.0 * np.sin(2 * np.pi * 3.0 * TIMES) + 50.0 * np.sin(2 * np.pi * 4500.0 * TIMES)
    conversion = made(exact(TIMES, 2) + slow, 2, "displacement")
    np.testing.assert_allclose(
        conversion.signal.values, exact(conversion.signal.times, 0), atol=4e-3 * np.abs(exact(TIMES, 0)).max()
    )
    whole = exact(TIMES, 2).var() + slow.var()
    assert conversion.outside == pytest.approx(slow.var() / whole, rel=0.02)
    assert f"{100 * conversion.outside:.2g} % of the variance" in " ".join(conversion.signal.notes)


def test_faults_of_the_source_are_told_though_the_result_hides_them() -> None:
    clipped = np.clip(exact(TIMES, 2), -400.0, 400.0)
    assert any("clipped" in note for note in made(clipped, 2, "displacement").signal.notes)


@pytest.mark.parametrize(
    ("unit", "quantity", "options", "message"),
    [
        ("V", "displacement", {}, "the unit 'V' does not tell whether it is a displacement"),
        ("m", "other", {}, "a signal can be converted to displacement, velocity or acceleration"),
        ("m", "speed", {}, "choose displacement, velocity, acceleration or other"),
        ("m/s2", "velocity", {"lowest": 2.0}, "too short to convert from 2 to 3906 Hz"),
        ("m/s2", "velocity", {"lowest": -2.0}, "lowest is -2.0: it must be above 0 Hz and below 3906.25 Hz"),
        ("m/s2", "velocity", {"highest": 5000.0}, "highest is 5000.0: it must be above 0 Hz"),
    ],
)
def test_what_cannot_be_converted_is_refused(unit, quantity, options, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        convert(Signal(exact(TIMES, 2), RATE, "a", unit), quantity, **options)
