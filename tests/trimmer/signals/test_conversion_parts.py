"""The parts of a conversion: its kernel, the noise floor, what is told; values are worked out by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.fft import next_fast_len
from scipy.integrate import quad
from scipy.special import i0

from trimmer.errors import WrongTypeError
from trimmer.signals import noise_floor
from trimmer.signals.band import Band
from trimmer.signals.convert import convert
from trimmer.signals.noise_floor import powers
from trimmer.signals.omega_kernel import OmegaKernel, _flank, _highest_end
from trimmer.signals.quantity import Quantity
from trimmer.signals.signal import Signal, SignalError

RATE, COUNT = 1000.0, 4000
TIMES = 0.3 + np.arange(COUNT) / RATE
SINE = np.sin(2 * np.pi * 50.0 * TIMES)


def record(values: np.ndarray = SINE, unit: str = "m", **options) -> Signal:
    return Signal(values, RATE, "a", unit, TIMES[0], **options)


def test_nothing_is_changed_or_lost_where_the_quantity_is_wanted_already() -> None:
    signal = record(1e3 * SINE, "mm")
    found = convert(signal, Quantity.DISPLACEMENT)
    assert found.source is signal
    assert (found.signal.unit, found.signal.sample_rate) == ("m", RATE)
    assert (found.cut, found.end_error, found.end_bound, found.outside) == (0.0, 0.0, 0.0, 0.0)
    assert math.isnan(found.noise)
    with pytest.raises(WrongTypeError, match="signal must be"):
        convert(SINE, "velocity")  # type: ignore[arg-type]
    with pytest.raises(SignalError, match="63 samples are too few to convert; 64 or more"):
        convert(record(SINE[:63]), "velocity")
    with pytest.raises(SignalError, match=r"too short to convert from 0 to 390\.6 Hz: 0\.031 s are lost"):
        convert(record(SINE[:64]), "velocity")


@pytest.mark.parametrize("size", [1e250, -1e250])
def test_squares_stay_finite_whatever_the_sign(size: float) -> None:
    values = SINE - 0.999
    values[17] = 0.0
    one, large = convert(record(values), "velocity"), convert(record(size * values), "velocity")
    assert large.signal.values == pytest.approx(size * one.signal.values, rel=1e-9, abs=1e-12 * abs(size))
    for name in ("noise", "end_error", "end_bound"):
        assert getattr(large, name) == pytest.approx(abs(size) * getattr(one, name), rel=1e-6)
    assert large.outside == pytest.approx(one.outside, rel=1e-9, abs=0.0)
    still = convert(record(np.zeros(COUNT)), "velocity")
    assert (still.noise, still.outside, still.end_bound) == (pytest.approx(0.0, abs=1e-100), 0.0, 0.0)


def test_what_is_told_of_a_conversion() -> None:
    signal = record(SINE, "m/s2", notes=("from a test",))
    found = convert(signal, "velocity")
    # 8 times 3 over 4 s; 1000 Hz over 2.56. Half of 6 Hz is the flank, 3 Hz wide: 3/3 Hz is the reach.
    band = Band(6.0, 390.625, "length of the record", "sample rate over 2.56")
    assert found.signal.trusted == band
    assert found.cut == pytest.approx(1.0)
    assert (found.signal.start, found.signal.values.size) == (pytest.approx(1.3), 2000)
    assert (found.signal.name, found.signal.unit, found.signal.converted) == ("a as velocity", "m/s", -1)
    assert math.isinf(found.signal.full_scale)
    notes = found.signal.notes
    assert notes[0] == "from a test"
    assert notes[1].startswith(
        "acceleration converted to velocity in the frequency domain, trusted from 6 Hz"
    )
    assert notes[1].endswith(": mean, drift and slow motion are lost")
    assert notes[2].startswith("1 s are cut off at either end;")
    assert len(notes) == 4
    derived = convert(record(), "velocity").signal
    assert (derived.trusted.lowest, derived.converted) == (0.0, 1)
    assert any(note.endswith(": the mean is lost") for note in derived.notes)
    assert convert(record(), "acceleration").signal.converted == 2


def test_a_lower_end_that_was_cut_before_is_not_cut_again_when_differentiating() -> None:
    """The flank from 200 Hz to 250 Hz reaches 3/50 s; that below 40 Hz would reach 3/20 s."""
    source = record(trusted=Band(40.0, 200.0, "before", "above"))
    for quantity in ("velocity", "acceleration"):
        found = convert(source, quantity)
        assert found.cut == pytest.approx(0.06)
        assert found.signal.trusted == source.trusted
        assert convert(source, quantity, lowest=40.0).cut == pytest.approx(0.15)
    assert convert(replace(source, unit="m/s2"), "velocity").cut == pytest.approx(0.15)


@pytest.mark.parametrize(
    ("frequency", "outside"), [(40.0, 1 / 6), (200.0, 1 / 6), (39.75, 5 / 6), (200.25, 5 / 6)]
)
def test_the_ends_belong_to_the_band(frequency: float, outside: float) -> None:
    """A line at a bin of 1/4 Hz has 4/6 of its variance there and 1/6 in either neighbour, as Hann's has."""
    line = record(np.cos(2 * np.pi * frequency * (TIMES - TIMES.mean())), "m/s2")
    assert convert(line, "velocity", lowest=40.0, highest=200.0).outside == pytest.approx(outside, abs=1e-4)


@pytest.mark.parametrize(("count", "line"), [(1000, 40), (999, 40), (1000, 500), (999, 499)])
def test_powers_add_up_to_the_variance(count: int, line: int) -> None:
    places = np.arange(count)
    values = 3.0 * np.cos(
        2 * np.pi * line * (places - 0.5 * (count - 1)) / count + (0.3 if line == 40 else 0)
    )
    found = powers(values + 7.0 - 0.01 * places, 500.0)
    assert found.frequency[[0, 1, -1]] == pytest.approx(500.0 / count * np.array([2, 3, count // 2]))
    assert found.total.shape == found.floor.shape == found.frequency.shape
    if line == 40:
        assert found.total.sum() == pytest.approx(4.5, rel=1e-3)
        assert found.total[[37, 38, 39]] == pytest.approx([0.75, 3.0, 0.75], rel=1e-2)
    # All bins of both signs, of which those beside 0 Hz are left out.
    weights = 0.5 - 0.5 * np.cos(2 * np.pi * places / count)
    both = np.abs(np.fft.fft(values * weights)) ** 2 / weights.sum() ** 2 / 1.5
    assert found.total.sum() == pytest.approx(both[2 : count - 1].sum(), rel=1e-3, abs=0.0)


def test_the_floor_is_the_median_between_1_over_1_3_and_1_3_times_a_frequency() -> None:
    """Of powers that rise evenly the median is the middle one; the median of noise is ln 2 times its mean."""
    count = 200
    floor = noise_floor._floor(np.arange(float(count)))
    places = np.unique(np.geomspace(2, count - 1, 160).astype(int)).tolist()
    assert {2, 3, 20, 30, 199} <= set(places)
    for place in places:
        low = max(2, min(int(place / 1.3), place - 12))
        high = min(max(math.ceil(1.3 * place), place + 12), count - 1)
        assert floor[place] == pytest.approx(0.5 * (low + high) / math.log(2.0), rel=1e-12)
    assert floor[2] == pytest.approx(8.0 / math.log(2.0))
    assert floor[:2].tolist() == [floor[2]] * 2
    # Between two places it is a straight line on logarithmic scales.
    between = next(place for place in range(3, count) if place not in places)
    low, high = max(p for p in places if p < between), min(p for p in places if p > between)
    share = math.log(between / low) / math.log(high / low)
    assert floor[between] == pytest.approx(floor[low] ** (1 - share) * floor[high] ** share)
    assert noise_floor._floor(np.zeros(40)).max() < 1e-300
    assert noise_floor._floor(np.ones(3)) == pytest.approx([1.0 / math.log(2.0)] * 3)


@pytest.mark.parametrize(
    ("band", "reach"),
    [
        (Band(20.0, 390.0), 300),  # 3 over 10 Hz
        (Band(0.0, 200.0), 60),  # 3 over 50 Hz
        (Band(0.0, 390.0), 31),  # 487.5 Hz are below half of the rate: 3 over 97.5 Hz, rounded up
        (Band(0.0, 450.0), 60),  # 3 over 50 Hz, as 562.5 Hz are not
        (Band(300.0, 450.0), 60),
    ],
)
def test_the_kernel_reaches_three_periods_of_the_narrowest_flank(band: Band, reach: int) -> None:
    assert OmegaKernel.of(record(), 1, band) == OmegaKernel(1, band, RATE, reach)
    OmegaKernel.of(record(SINE[: 2 * reach + 16]), 1, band)
    with pytest.raises(SignalError, match=f"{reach / RATE:.4g} s are lost at either end"):
        OmegaKernel.of(record(SINE[: 2 * reach + 15]), 1, band)


@pytest.mark.parametrize("times", [-2, -1, 1, 2])
def test_the_response_is_a_power_of_j_omega_in_the_band_and_half_of_it_in_the_middle_of_a_flank(
    times: int,
) -> None:
    frequency = np.array([0.0, 10.0, 15.0, 20.0, 100.0, 200.0, 225.0, 250.0, 400.0])
    weight = np.array([0.0, 0.0, 0.5, 1.0, 1.0, 1.0, 0.5, 0.0, 0.0])
    exact = np.zeros(9, dtype=complex)
    exact[1:] = weight[1:] * (2j * np.pi * frequency[1:]) ** times
    kernel = OmegaKernel(times, Band(20.0, 200.0), RATE, 300)
    np.testing.assert_allclose(kernel.response(frequency), exact, rtol=1e-10, atol=1e-10)
    open_below = OmegaKernel(times, Band(0.0, 200.0), RATE, 60).response(frequency[:4])
    np.testing.assert_allclose(open_below[1:], (2j * np.pi * frequency[1:4]) ** times, rtol=1e-12)
    assert open_below[0] == 0
    slow = OmegaKernel(times, Band(0.0, 200.0), RATE, 60).response(np.array([1e-3, 0.5]))
    np.testing.assert_allclose(slow, (2j * np.pi * np.array([1e-3, 0.5])) ** times, rtol=1e-12)
    assert (_highest_end(Band(0, 200.0), RATE), _highest_end(Band(0, 450.0), RATE)) == (250.0, 500.0)


def test_a_flank_is_the_integral_of_a_kaiser_window() -> None:
    def window(x: float) -> float:
        return float(i0(10.0 * math.sqrt(1.0 - x * x)))

    whole = quad(window, -1.0, 1.0)[0]
    for share in (-0.5, 0.0, 0.1, 0.7):
        exact = quad(window, -1.0, share)[0] / whole
        assert _flank(np.array([15.0 + 5.0 * share]), 10.0, 20.0)[0] == pytest.approx(exact, abs=1e-7)
    assert _flank(np.array([0.0, 10.0, 20.0, 30.0]), 10.0, 20.0).tolist() == [0.0, 0.0, 1.0, 1.0]


@pytest.mark.parametrize("times", [1, 2])
def test_the_kernel_differentiates_a_line_and_a_ramp_inside_the_record(times: int) -> None:
    """Of a ramp of 3/s the derivative is 3; the second one is nothing."""
    omega, kernel = 2 * np.pi * 50.0, OmegaKernel(times, Band(0.0, 200.0), RATE, 60)
    values, about, most = kernel.applied(SINE + 5.0 + 3.0 * TIMES)
    inner = TIMES[60:-60]
    exact = omega * np.cos(omega * inner) / omega**0 if times == 1 else -(omega**2) * np.sin(omega * inner)
    np.testing.assert_allclose(values, exact + (3.0 if times == 1 else 0.0), atol=3e-3 * omega**times)
    assert 0 < about <= most
    # With a lower end the ramp is taken off for good.
    above, *_ = OmegaKernel(times, Band(20.0, 200.0), RATE, 300).applied(SINE + 3.0 * TIMES)
    np.testing.assert_allclose(above, exact[240:-240], atol=3e-3 * omega**times)


def test_what_the_ends_change_is_bounded_by_the_rest_of_the_kernel() -> None:
    """The bound is the largest value times what the kernel has beyond its reach."""
    kernel = OmegaKernel(1, Band(0.0, 200.0), RATE, 60)
    values = SINE - np.polynomial.Polynomial.fit(TIMES, SINE, 1)(TIMES)
    length = next_fast_len(4120, real=True)
    response = kernel.response(np.arange(length // 2 + 1) * (RATE / length))
    impulse = np.abs(np.fft.irfft(response, length))
    found = kernel.applied(values)[2]
    assert found == pytest.approx(np.abs(values).max() * impulse[61 : length - 60].sum(), rel=1e-6)
