"""The band of a conversion, what is cut off and told: closed forms for lines, noise and flanks."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import i0

from trimmer import Signal, convert
from trimmer.signals import Band, SignalError
from trimmer.signals.noise_floor import powers

RATE, COUNT = 1000.0, 4000
TIMES = 0.3 + np.arange(COUNT) / RATE
SINE = np.sin(2 * np.pi * 50.0 * TIMES)


def record(values: np.ndarray = SINE, unit: str = "m", **options) -> Signal:
    return Signal(values, RATE, "a", unit, TIMES[0], **options)


@pytest.mark.parametrize(
    ("unit", "options", "trusted", "ends", "cut"),
    [
        # 4 s at 1000 Hz: 8 times 3/(4 s) is 6 Hz; 1000 Hz/2.56 is 390.625 Hz; 3 over the flank is cut off.
        ("m/s2", {}, None, (6.0, 390.625), 1.0),
        ("m", {}, None, (0.0, 390.625), 3 / 97.65625),
        ("m/s2", {"lowest": 20.0}, None, (20.0, 390.625), 0.3),
        ("m", {"lowest": 20.0, "highest": 450.0}, None, (20.0, 450.0), 0.3),
        ("m", {"highest": 450.0}, None, (0.0, 450.0), 0.06),
        ("m/s2", {"sensor_corner": 5.0}, None, (15.0, 390.625), 0.4),
        ("m/s2", {"sensor_corner": 1.0, "highest": 300.0}, None, (6.0, 300.0), 1.0),
        ("m/s2", {"lowest": 10.0, "sensor_corner": 5.0}, None, (10.0, 390.625), 0.6),
        ("m/s2", {}, Band(8.0, 90.0), (8.0, 90.0), 0.75),
        ("m/s2", {"lowest": 30.0, "highest": 80.0}, Band(8.0, 90.0), (30.0, 80.0), 0.2),
        # A lower end that was cut before is not cut again when differentiating, unless it is asked for.
        ("m", {}, Band(40.0, 200.0), (40.0, 200.0), 0.06),
        ("m", {"lowest": 40.0}, Band(40.0, 200.0), (40.0, 200.0), 0.15),
    ],
)
def test_ends_of_the_band_and_what_is_cut_off(unit: str, options, trusted, ends, cut: float) -> None:
    source = record(unit=unit) if trusted is None else record(unit=unit, trusted=trusted)
    found = convert(source, "velocity", **options)
    assert (found.signal.trusted.lowest, found.signal.trusted.highest) == pytest.approx(ends)
    assert found.cut == pytest.approx(math.ceil(round(cut * RATE, 6)) / RATE)
    assert found.signal.start == pytest.approx(TIMES[0] + found.cut)
    assert found.signal.values.size == COUNT - 2 * round(found.cut * RATE)


@pytest.mark.parametrize(
    "options",
    [
        {"highest": 500.0},
        {"highest": 0.0},
        {"lowest": 0.0},
        {"lowest": 390.625},
        {"lowest": 80.0, "highest": 80.0},
        {"sensor_corner": 0.0},
        {"sensor_corner": 500.0},
    ],
)
def test_frequencies_out_of_their_range_are_refused(options) -> None:
    with pytest.raises(SignalError, match="it must be above 0 Hz and below"):
        convert(record(unit="m/s2"), "velocity", **options)


def test_a_record_must_leave_sixteen_samples() -> None:
    assert convert(record(SINE[:616], "m/s2"), "velocity", lowest=20.0).signal.values.size == 16
    with pytest.raises(SignalError, match=r"0\.3 s are lost at either end"):
        convert(record(SINE[:615], "m/s2"), "velocity", lowest=20.0)
    with pytest.raises(SignalError, match="63 samples are too few to convert; 64 or more"):
        convert(record(SINE[:63]), "velocity")


@pytest.mark.parametrize(("unit", "power"), [("m/s2", -1), ("m/s", -1), ("m", 1)])
def test_white_noise_bounds_the_band_where_it_is_a_hundredth_of_the_variance(unit: str, power: int) -> None:
    """Integrated twice, once, and differentiated: noise beyond 3/4 or 9/8 of the bound, as flanks pass.

    White noise has 2 s^2/rate per hertz, the line of 200 Hz the amplitude 1. With (2 pi f)^2 for each
    differentiation, noise beyond f adds up to a power of f; the bound follows from that by hand.
    """
    times = {"m/s2": -2, "m/s": -1, "m": 1}[unit]
    size = {"m/s2": 2e-2, "m/s": 0.1, "m": 2e-2}[unit]
    time = np.arange(100_000) / 4000.0
    values = np.cos(2 * np.pi * 200.0 * time) + size * np.random.default_rng(5).normal(size=time.size)
    found = convert(
        Signal(values, 4000.0, "a", unit), "displacement" if power < 0 else "velocity"
    ).signal.trusted
    density, order, line = 2 * size**2 / 4000.0, 2 * times + 1, 0.5 * 200.0 ** (2 * times)
    noise = (0.01 * line / density) * abs(order)
    bound = noise ** (1 / order) / (1.125 if power > 0 else 0.75)
    assert (found.highest if power > 0 else found.lowest) == pytest.approx(bound, rel=0.1)
    assert (found.lowest == 0.0) if power > 0 else (found.highest == pytest.approx(4000 / 2.56))


@pytest.mark.parametrize("quantity", ["velocity", "displacement", "acceleration"])
@pytest.mark.parametrize("frequency", [15.0, 17.0, 25.0, 150.0, 210.0, 225.0, 240.0])
def test_flanks_are_integrals_of_a_kaiser_window(quantity: str, frequency: float) -> None:
    """From half of the lowest frequency to it, and from the highest to a quarter above it."""
    unit = {"velocity": "m/s2", "displacement": "m/s2", "acceleration": "m"}[quantity]
    times = {"velocity": -1, "displacement": -2, "acceleration": 2}[quantity]
    found = convert(
        record(np.cos(2 * np.pi * frequency * TIMES), unit), quantity, lowest=20.0, highest=200.0
    ).signal

    def risen(share: float) -> float:
        window = quad(lambda x: float(i0(10.0 * math.sqrt(1.0 - x * x))), -1.0, min(max(share, -1.0), 1.0))
        return window[0] / quad(lambda x: float(i0(10.0 * math.sqrt(1.0 - x * x))), -1.0, 1.0)[0]

    weight = risen((2 * frequency - 30.0) / 10.0) * (1.0 - risen((2 * frequency - 450.0) / 50.0))
    omega = 2 * np.pi * frequency
    exact = weight * (np.exp(1j * omega * found.times) * (1j * omega) ** times).real
    np.testing.assert_allclose(found.values, exact, atol=3e-3 * omega**times)


@pytest.mark.parametrize(
    ("frequency", "outside"), [(40.0, 1 / 6), (200.0, 1 / 6), (39.75, 5 / 6), (200.25, 5 / 6)]
)
def test_the_ends_belong_to_the_band(frequency: float, outside: float) -> None:
    """A line at a bin of 1/4 Hz has 4/6 of its variance there and 1/6 in either neighbour, as Hann's has."""
    line = record(np.cos(2 * np.pi * frequency * (TIMES - TIMES.mean())), "m/s2")
    assert convert(line, "velocity", lowest=40.0, highest=200.0).outside == pytest.approx(outside, abs=1e-4)


@pytest.mark.parametrize("size", [1e250, -1e250])
def test_squares_stay_finite_whatever_the_sign(size: float) -> None:
    values = SINE - 0.999
    values[17] = 0.0
    one, large = convert(record(values), "velocity"), convert(record(size * values), "velocity")
    assert large.signal.values == pytest.approx(size * one.signal.values, rel=1e-9, abs=1e-12 * abs(size))
    for name in ("noise", "end_error", "end_bound"):
        assert getattr(large, name) == pytest.approx(abs(size) * getattr(one, name), rel=1e-6)
    still = convert(record(np.zeros(COUNT)), "velocity")
    assert (still.noise, still.outside, still.end_bound) == (pytest.approx(0.0, abs=1e-100), 0.0, 0.0)


def test_what_is_told_of_a_conversion() -> None:
    found = convert(record(SINE, "m/s2", notes=("from a test",)), "velocity").signal
    assert found.trusted == Band(6.0, 390.625, "length of the record", "sample rate over 2.56")
    assert (found.name, found.unit, found.converted) == ("a as velocity", "m/s", -1)
    assert math.isinf(found.full_scale)
    assert (found.notes[0], len(found.notes)) == ("from a test", 4)
    assert found.notes[1].startswith(
        "acceleration converted to velocity in the frequency domain, trusted from 6 Hz"
    )
    assert found.notes[1].endswith(": mean, drift and slow motion are lost")
    assert found.notes[2].startswith("1 s are cut off at either end;")
    derived = convert(record(), "acceleration").signal
    assert derived.converted == 2 and derived.notes[0].endswith(": the mean is lost")
    same = convert(record(1e3 * SINE, "mm", full_scale=5.0), "displacement")
    assert (same.cut, same.end_error, same.end_bound, same.outside) == (0.0, 0.0, 0.0, 0.0)
    assert math.isnan(same.noise) and same.signal.full_scale == pytest.approx(5e-3)


def test_what_is_unknown_beyond_the_ends_changes_the_rest_within_the_bound() -> None:
    """The middle of a record goes on otherwise outside it, though nowhere larger."""
    ending = np.where(np.abs(TIMES - TIMES.mean()) < 1.0, SINE, -np.sign(SINE))
    middle = slice(1000, 3000)
    cut = convert(replace(record(), values=ending[middle]), "velocity")
    whole = convert(record(ending), "velocity").signal
    reach = round(cut.cut * RATE)
    begin = 1000 + reach - round((whole.start - TIMES[0]) * RATE)
    other = whole.values[begin : begin + cut.signal.values.size]
    assert 0 < np.abs(cut.signal.values - other).max() <= cut.end_bound
    assert cut.end_error <= cut.end_bound


@pytest.mark.parametrize(("count", "line"), [(1000, 40), (999, 40), (1000, 500), (999, 499)])
def test_powers_add_up_to_the_variance(count: int, line: int) -> None:
    places = np.arange(count)
    phase = 2 * np.pi * line * (places - 0.5 * (count - 1)) / count + (0.3 if line == 40 else 0)
    found = powers(3.0 * np.cos(phase) + 7.0 - 0.01 * places, 500.0)
    assert found.frequency[[0, 1, -1]] == pytest.approx(500.0 / count * np.array([2, 3, count // 2]))
    if line == 40:
        assert found.total.sum() == pytest.approx(4.5, rel=1e-3)
        assert found.total[[37, 38, 39]] == pytest.approx([0.75, 3.0, 0.75], rel=1e-2)
    # All bins of both signs, of which those beside 0 Hz are left out.
    weights = 0.5 - 0.5 * np.cos(2 * np.pi * places / count)
    both = np.abs(np.fft.fft(3.0 * np.cos(phase) * weights)) ** 2 / weights.sum() ** 2 / 1.5
    assert found.total.sum() == pytest.approx(both[2 : count - 1].sum(), rel=1e-3, abs=0.0)
    noise = powers(3.0 * np.random.default_rng(7).normal(size=4 * count), 500.0)
    assert noise.floor.sum() == pytest.approx(9.0, rel=0.1)
