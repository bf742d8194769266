"""Noise floor and kernel of conversions, against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.signals.band import EVERYWHERE, Band
from trimmer.signals.fault import FewSteps, Offset
from trimmer.signals.faults import faults
from trimmer.signals.noise_floor import powers
from trimmer.signals.omega_kernel import REACH, OmegaKernel
from trimmer.signals.signal import Signal, SignalError

RATE = 5000.0


@pytest.mark.parametrize("count", [4000, 4001])
def test_powers_are_the_variance_and_the_floor_is_that_of_noise(count: int) -> None:
    values = 3.0 * np.random.default_rng(7).normal(size=count) + 1e3 + 0.5 * np.arange(count)
    found = powers(values, RATE)
    assert found.frequency[:2].tolist() == pytest.approx([2 * RATE / count, 3 * RATE / count])
    assert found.frequency[-1] == pytest.approx(RATE * (count // 2) / count)
    assert found.total.sum() == pytest.approx(9.0, rel=0.05)
    assert found.floor.sum() == pytest.approx(9.0, rel=0.06)
    assert (found.floor <= found.total.clip(min=np.median(found.floor) * 2)).all()


def test_a_line_is_counted_with_half_its_square_and_hardly_moves_the_floor() -> None:
    times = np.arange(4000) / RATE
    noise = 0.01 * np.random.default_rng(8).normal(size=4000)
    found = powers(4.0 * np.cos(2 * math.pi * 625.0 * times) + noise, RATE)
    assert found.total.sum() == pytest.approx(8.0, rel=1e-3)
    near = abs(found.frequency - 625) < 3
    assert found.total[near].sum() == pytest.approx(8.0, rel=1e-3)
    assert found.floor.sum() == pytest.approx(1e-4, rel=0.1)


def test_the_last_bin_of_an_even_record_counts_once() -> None:
    # The window at half the sample rate has (-1)^k alone in one bin; its variance is 1.
    found = powers((-1.0) ** np.arange(400), RATE)
    # 2 |W|^2 / W^2 / 1.5 halved, and (1/2)^2 of 2 / 1.5 beside it.
    assert found.total[-2:].tolist() == pytest.approx([1 / 3, 2 / 3], rel=1e-2)


def signal(count: int = 20_000) -> Signal:
    return Signal(np.zeros(count), RATE, "a", "m/s²")


def test_the_kernel_is_as_long_as_its_narrowest_flank_asks() -> None:
    # Flanks from 20 to 40 Hz and from 1000 to 1250 Hz, or to half the sample rate.
    assert OmegaKernel.of(signal(), -1, Band(40.0, 1000.0)).reach == math.ceil(REACH / 20 * RATE)
    assert OmegaKernel.of(signal(), 1, Band(0.0, 1000.0)).reach == math.ceil(REACH / 250 * RATE)
    assert OmegaKernel.of(signal(), 1, Band(0.0, 2400.0)).reach == math.ceil(REACH / 100 * RATE)
    assert OmegaKernel.of(signal(1516), -1, Band(40.0, 1000.0)).reach == 750
    with pytest.raises(SignalError):
        OmegaKernel.of(signal(1515), -1, Band(40.0, 1000.0))


def test_the_response_is_a_power_of_j_omega_within_the_band() -> None:
    frequency = np.array([0.0, 19.0, 20.0, 30.0, 40.0, 300.0, 1000.0, 1125.0, 1250.0, 2500.0])
    for times in (-2, -1, 1, 2):
        found = OmegaKernel(times, Band(40.0, 1000.0), RATE, 9).response(frequency)
        with np.errstate(divide="ignore", invalid="ignore"):
            share = found[1:] / (2j * math.pi * frequency[1:]) ** times
        np.testing.assert_allclose(share, [0, 0, 0.5, 1, 1, 1, 0.5, 0, 0], atol=1e-9)
        assert found[0] == 0
    open_below = OmegaKernel(1, Band(0.0, 1000.0), RATE, 9).response(frequency[:3])
    np.testing.assert_allclose(open_below, 2j * math.pi * frequency[:3], rtol=1e-12)


@pytest.mark.parametrize("times", [1, 2, -1, -2])
def test_a_sine_is_differentiated_and_integrated(times: int) -> None:
    count, omega = 6000, 2 * math.pi * 200.0
    place = np.arange(count) / RATE
    kernel = OmegaKernel.of(signal(count), times, Band(0.0 if times > 0 else 60.0, 1000.0))
    values, error, bound = kernel.applied(np.sin(omega * place) + 3.0 + 5.0 * place)
    expected = omega**times * np.sin(omega * place + times * math.pi / 2)
    expected += 5.0 * (times == 1)
    inner = slice(kernel.reach, count - kernel.reach)
    assert len(values) == count - 2 * kernel.reach
    size = omega**times
    assert abs(values - expected[inner]).max() < 2e-3 * size
    assert 0 < error < bound < 3e-2 * size


def test_bands() -> None:
    band = Band(3.0, 7.0, "low", "high")
    assert [each in band for each in (2.9, 3.0, 5.0, 7.0, 7.1)] == [False, True, True, True, False]
    assert band.within(EVERYWHERE) == EVERYWHERE.within(band) == band
    narrow = Band(2.0, 5.0, "lower", "higher")
    assert band.within(narrow) == narrow.within(band) == Band(3.0, 5.0, "low", "higher")
    same = Band(3.0, 7.0, "other", "another")
    assert band.within(same) == band
    for each, parts in (
        (EVERYWHERE, ("half of the sample rate",)),
        (band, ("from 3 Hz (low)", "up to 7 Hz (high)")),
    ):
        assert all(part in each.sentence for part in parts)
    assert "up to" not in Band(3.0, lowest_reason="low").sentence
    assert "from" not in Band(highest=7.0, highest_reason="high").sentence


def test_a_large_offset_is_told_with_its_ratio() -> None:
    swing = np.sin(np.arange(300))
    for factor, told in ((3.2, True), (2.8, False), (-3.2, True)):
        values = swing - swing.mean()
        values = values + factor * values.std()
        offsets = [each for each in faults(Signal(values, RATE, "a", "g")) if isinstance(each, Offset)]
        assert bool(offsets) == told
        for each in offsets:
            assert (each.mean, each.ratio) == (pytest.approx(values.mean()), pytest.approx(3.2))
            assert (each.unit, each.kind) == ("g", "offset")
            assert "3.2 times the rms" in each.sentence


def test_few_values_at_uneven_steps_are_no_converters() -> None:
    even = np.tile([0.0, 2.0, 6.0, 14.0, -4.0], 40)
    (found,) = (each for each in faults(Signal(even, RATE)) if isinstance(each, FewSteps))
    assert (found.values, found.step, found.kind) == (5, 2.0, "few steps")
    assert (found.bits, found.noise) == (pytest.approx(math.log2(10)), pytest.approx(2 / math.sqrt(12)))
    uneven = np.tile(np.array([0.0, 1.0, 2.5001, 7.0, -3.0]), 40)
    assert not [each for each in faults(Signal(uneven, RATE)) if isinstance(each, FewSteps)]
