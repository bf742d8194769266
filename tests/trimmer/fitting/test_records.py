"""Noise and lines of records whose spectra are made by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.fitting.known import measured
from trimmer import Signal
from trimmer.fitting.measured import WINDOW_SHARE, MeasuredLines, _floor, _Record, measure_lines
from trimmer.signals.signal import SignalError

RATE, COUNT, DRIVE = 2000.0, 2000, 50.0
TIMES = np.arange(COUNT) / RATE


def record(*values: np.ndarray, period_count: int = 1, unit: str = "m", rate: float = RATE) -> _Record:
    signals = {f"s{place}": Signal(each, rate, f"s{place}", unit) for place, each in enumerate(values)}
    return _Record(signals, DRIVE, True, period_count)


def test_lines_are_whitened_by_their_factors() -> None:
    factors = np.array([[[2.0, 0.0], [1.0 - 1.0j, 0.5]], [[3.0, 0.0], [0.0, 4.0]]])
    found = measured(np.ones((2, 2), complex), factors, periods=20.0, period_count=2)
    np.testing.assert_allclose(found.deviations, [[2.0, 1.5], [3.0, 4.0]])
    lines = np.array([[2.0, 1.0], [6.0, 8.0j]])
    np.testing.assert_allclose(found.whitened(lines), [[1.0, 2.0j], [2.0, 2.0j]])
    np.testing.assert_allclose(found.frequencies, [25.0, 50.0])
    assert (found.outputs, found.derivatives) == (("s0", "s1"), (0, 0))
    assert found.periods == pytest.approx(20.0)


def test_the_floor_is_the_mean_power_between_stretches() -> None:
    power = np.concatenate([np.full(100, 2.0), np.full(100, 8.0)]) * math.log(2.0)
    free = np.ones(200, bool)
    free[:5] = free[120] = False
    power[120] = 1e9
    found = _floor(power, free)
    # Three stretches of 65 or less: from 5 to 69, 70 to 135, 136 to 199.
    assert found[[0, 37, 168, 199]] == pytest.approx([2.0, 2.0, 8.0, 8.0])
    assert np.all(np.diff(found) >= 0)
    few = _floor(np.array([1.0, 3.0, 100.0, 5.0]), np.array([True, True, False, True]))
    np.testing.assert_allclose(few, 3.0 / math.log(2.0))


def test_bins_beside_a_line_hold_no_noise() -> None:
    made = record(np.zeros(COUNT))
    rests = np.full((1, COUNT // 2 + 1), 1e-3 + 0j)
    free, strays = made._between(np.ones((10, 1), complex), rests)
    # Bins of 1 Hz, lines at each 50 Hz up to 500 Hz; more than 2.5 bins from each, and up to 525 Hz.
    expected = [at for at in range(525) if min(at % 50, 50 - at % 50) > 2]
    assert np.flatnonzero(free).tolist() == expected
    assert strays == ()


def test_lines_that_stand_out_are_strays_and_their_bins_no_noise() -> None:
    rests = np.full((2, COUNT // 2 + 1), 1e-3 + 0j)
    rests[0, 118:121] = 0.02, 0.05, 0.04
    rests[1, 74:77] = 0.1, 0.2, 0.1
    free, strays = record(np.zeros(COUNT), np.zeros(COUNT))._between(np.ones((10, 2), complex), rests)
    assert [each.output for each in strays] == ["s1", "s0"]
    half, other = strays
    assert (half.fraction, half.amplitude) == ((3, 2), 0.2)
    assert half.ratio == pytest.approx((0.2 / 1e-3) ** 2 * math.log(2.0))
    assert other.fraction is None
    # A ratio of 0.8 of two bins: (2 * 0.8 - 1) / (0.8 + 1) of a bin beside the larger one.
    assert other.frequency == pytest.approx(119 + 0.6 / 1.8)
    assert not free[116:123].any()
    assert free[115]
    assert free[123]
    assert not free[72:79].any()


def test_noise_is_that_of_the_bins_around_a_line() -> None:
    made = record(np.zeros(COUNT), np.zeros(COUNT))
    rests = np.full((2, COUNT // 2 + 1), 2.0 + 0j)
    rests[1] = 4.0j
    rests[:, 300:] *= 3.0
    between = np.ones(COUNT // 2 + 1, bool)
    covariances, freedom, small = made._noise(np.ones((10, 2), complex), rests, between)
    # Half of the mean of the products; those of 4 i and 2 are 8 i.
    np.testing.assert_allclose(covariances[0], [[2.0, -4.0j], [4.0j, 8.0]])
    np.testing.assert_allclose(covariances[8], 9.0 * covariances[0])
    # 61 bins lie within 30 of a line, the nearest 60 and one as far.
    assert freedom == pytest.approx(2 * 61 / WINDOW_SHARE)
    assert not small


def test_the_last_bin_of_a_spectrum_is_no_noise() -> None:
    # Half the rate is 970 Hz, and the 19 lines lie at 950 Hz and below: noise counts up to 975 Hz.
    made = record(np.zeros(1940), rate=1940.0)
    free, _ = made._between(np.ones((19, 1), complex), np.full((1, 971), 1e-3 + 0j))
    assert free[953:970].all()
    assert not free[970]


def test_noise_is_seen_in_four_bins_of_each_output_at_least() -> None:
    made = record(np.zeros(COUNT), np.zeros(COUNT))
    rests = np.full((2, COUNT // 2 + 1), 2.0 + 0j)
    between = np.zeros(COUNT // 2 + 1, bool)
    between[60:67] = True
    with pytest.raises(SignalError, match="too short to see noise between its lines"):
        made._noise(np.ones((3, 2), complex), rests, between)
    between[67] = True
    _, freedom, _ = made._noise(np.ones((3, 2), complex), rests, between)
    assert freedom == pytest.approx(2 * 8 / WINDOW_SHARE)


def test_a_line_below_a_share_of_the_largest_modulus_is_no_stray() -> None:
    # The largest line is 50 000 i, and a ten-millionth of that 5e-3: noise is taken to be no less.
    made = record(np.zeros(COUNT))
    sizes = np.ones((10, 1), complex)
    sizes[4] = -5e4j
    rests = np.full((1, COUNT // 2 + 1), 1e-6 + 0j)
    rests[0, 75] = 1e-2
    _, strays = made._between(sizes, rests)
    assert strays == ()
    rests[0, 75] = 4e-2
    _, (stray,) = made._between(sizes, rests)
    assert stray.ratio == pytest.approx(0.5 * 4e-2**2 / 5e-3**2, rel=1e-9)


@pytest.mark.parametrize(
    ("rate", "samples", "count"), [(2000.0, 2000, 19), (1013.0, 1000, 10), (1002.0, 1000, 9)]
)
def test_lines_up_to_what_the_window_leaves_below_half_the_rate_are_taken(
    rate: float, samples: int, count: int
) -> None:
    # A window's main lobe, 2 bins to either side, ends below half the rate: 0.5 rate (1 - 4 / samples).
    assert math.floor(0.5 * rate * (1 - 4 / samples) / DRIVE) == count
    assert record(np.zeros(samples), rate=rate)._count() == count


def test_noise_is_that_of_half_a_drive_frequency_to_either_side_at_least() -> None:
    # Over 2 s bins are 0.5 Hz wide, so that 25 Hz are 50 of them.
    made = record(np.zeros(4000))
    between = np.ones(2001, bool)
    _, freedom, _ = made._noise(np.ones((10, 1), complex), np.full((1, 2001), 2.0 + 0j), between)
    assert freedom == pytest.approx(2 * 101 / WINDOW_SHARE)


def test_hardly_any_noise_is_taken_to_be_a_share_of_the_largest_line() -> None:
    made = record(np.zeros(COUNT), np.zeros(COUNT))
    lines = np.ones((10, 2), complex)
    lines[3] = 5.0, 7.0
    rests = np.zeros((2, COUNT // 2 + 1), complex)
    rests[1] = 1e-3
    covariances, _, small = made._noise(lines, rests, np.ones(COUNT // 2 + 1, bool))
    assert small
    np.testing.assert_allclose(covariances[0], [[25e-14, 0.0], [0.0, 5e-7]], atol=1e-20)


def noisy(values: np.ndarray, seed: int = 3) -> np.ndarray:
    return np.asarray(values + 1e-3 * np.random.default_rng(seed).normal(size=COUNT))


def tone(order: float, size: complex = 1.0) -> np.ndarray:
    return np.asarray((size * np.exp(2j * np.pi * order * DRIVE * TIMES)).real)


def lines(*values: np.ndarray, drive: float | None = DRIVE, unit: str = "m") -> MeasuredLines:
    signals = {f"s{place}": Signal(each, RATE, f"s{place}", unit) for place, each in enumerate(values)}
    return measure_lines(signals, DRIVE, drive)


def test_lines_up_to_a_quarter_beyond_the_last_that_is_seen_are_kept() -> None:
    found = lines(noisy(tone(1)), noisy(tone(1, 0.3j) + tone(9, 0.5), 4))
    assert len(found.lines) == 12 + 2
    np.testing.assert_allclose(found.lines[[0, 8]], [[1.0, 0.3j], [0.0, 0.5]], atol=3e-4)
    assert not found.found
    assert not found.noiseless
    assert len(lines(noisy(tone(1))).lines) == 4
    assert lines(tone(1)).noiseless


def test_lines_at_fractions_make_a_longer_period_where_the_record_has_enough() -> None:
    half = noisy(tone(1) + tone(1.5, 0.2j))
    found = lines(half)
    assert (found.period_count, found.strays) == (2, ())
    assert found.lines[2, 0] == pytest.approx(0.2j, abs=3e-4)
    short = measure_lines({"s": Signal(half[:920], RATE, "s", "m")}, DRIVE, DRIVE)
    assert (short.period_count, [each.fraction for each in short.strays]) == (1, [(3, 2)])


def test_units_are_those_of_the_system() -> None:
    values = noisy(tone(1))
    found, micro = lines(values), lines(values, unit="um")
    np.testing.assert_allclose(micro.lines, 1e-6 * found.lines, rtol=1e-9)
    assert micro.deviations == pytest.approx(1e-6 * found.deviations, rel=1e-6, abs=0.0)
