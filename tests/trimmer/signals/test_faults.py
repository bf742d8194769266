"""Faults of records: found where they were made, and nowhere else."""

import numpy as np
import pytest

from trimmer import Signal, faults
from trimmer.signals import Clipping, Dropout, FewSteps
from trimmer.signals.fault import FaultCertainty

RATE = 5000.0
TIMES = np.arange(5000) / RATE
SINE = np.sin(2 * np.pi * 109.8 * TIMES)
NOISE = np.random.default_rng(1).normal(size=5000)


def found(values: np.ndarray, **options: float) -> tuple:
    return faults(Signal(values, RATE, "a", "g", **options))


def clipping(values: np.ndarray, **options: float) -> Clipping | None:
    return next((fault for fault in found(values, **options) if isinstance(fault, Clipping)), None)


@pytest.mark.parametrize("level", [0.3, 0.6, 0.9, 0.99, 0.995])
@pytest.mark.parametrize("noise", [0.0, 0.02])
def test_a_clipped_record_is_told(level: float, noise: float) -> None:
    values = SINE + noise * NOISE
    told = clipping(np.clip(values, -level, level))
    assert told.largest == int((values >= level).sum()) and told.smallest == int((values <= -level).sum())
    assert "largest value and" in told.sentence and "smallest value" in told.sentence
    if level <= 0.9:
        assert told.certainty is FaultCertainty.LIKELY
    one_sided = clipping(np.minimum(values, level))
    assert (one_sided.smallest, one_sided.largest) == (0, told.largest)


@pytest.mark.parametrize("bits", [3, 5, 8, 12, 16])
@pytest.mark.parametrize("frequency", [109.8, 10.98, 1.3])
def test_coarse_steps_are_not_taken_for_clipping_or_dropouts(bits: int, frequency: float) -> None:
    values = np.round(2 ** (bits - 1) * 0.93 * np.sin(2 * np.pi * frequency * TIMES))
    kinds = {type(fault) for fault in found(values)}
    assert kinds == ({FewSteps} if bits <= 8 else set())


def test_steps_are_counted_with_the_noise_of_rounding() -> None:
    (told,) = found(np.round(15 * SINE) * 0.25)
    assert isinstance(told, FewSteps)
    assert (told.values, told.step) == (31, 0.25)
    assert told.bits == pytest.approx(np.log2(31))
    assert told.noise == pytest.approx(np.std(np.round(15 * SINE) * 0.25 - 15 * SINE * 0.25), rel=0.05)


@pytest.mark.parametrize(
    "values",
    [
        SINE,
        np.sin(2 * np.pi * 250 * TIMES),  # the same 20 samples over and over
        np.sign(np.sin(2 * np.pi * 250 * TIMES + 0.1)),  # a square wave is at its limits all the time
        np.zeros(100),
        NOISE,
        np.round(300 * NOISE),
        np.arange(100.0),
        np.array([1.0]),
    ],
)
def test_what_has_no_fault_has_none(values) -> None:
    assert found(values) == ()


def test_a_play_that_sticks_at_its_extremes_is_only_possibly_clipped() -> None:
    """The output of a friction-controlled play stands still at its extremes, into which it comes smoothly."""
    output = [0.0]
    for pin in 1.5e-3 * np.cos(2 * np.pi * 110 * np.arange(0, 0.1, 1e-5)):
        output.append(min(max(output[-1], pin - 2e-4), pin + 2e-4))
    for values in (np.array(output[1:]), np.round(1e7 * np.array(output[1:]))):
        told = clipping(values)
        assert told.certainty is FaultCertainty.POSSIBLE
        assert "if the motion does not stand still there" in told.sentence


@pytest.mark.parametrize("held", [True, False])
def test_dropouts_are_named_with_time_and_length(held: bool) -> None:
    values = SINE.copy()
    values[1003:1100] = values[1002] if held else 0.0
    values[3000:3050] = 0.0
    (told,) = found(values)
    assert isinstance(told, Dropout)
    assert told.begin == pytest.approx((1002 if held else 1003) / RATE)
    assert (told.end, told.others) == (pytest.approx(1099 / RATE), 1)
    assert told.value == (values[1002] if held else 0.0)
    assert "dropout" in told.sentence and "--from" in told.sentence


def test_scale_and_time_do_not_matter() -> None:
    values = np.clip(SINE, -0.5, 0.8)
    one, two = clipping(values), clipping(-3e-6 * values)
    assert one is not None and two is not None
    assert (one.certainty, one.largest, one.runs) == (two.certainty, two.smallest, two.runs)


@pytest.mark.parametrize(
    ("high", "low", "certainty"),
    [
        (1.0, 1.0, FaultCertainty.LIKELY),
        (1.0, 0.97, FaultCertainty.LIKELY),
        (0.97, 1.0, FaultCertainty.LIKELY),
        (1.0, 0.9, FaultCertainty.POSSIBLE),
        (0.9, 1.0, FaultCertainty.POSSIBLE),
    ],
)
def test_two_runs_are_likely_clipped_where_they_are_at_opposite_levels(high, low, certainty) -> None:
    values = 0.1 * NOISE
    values[500:504], values[2500:2505] = high, -low
    told = clipping(values)
    assert (told.certainty, told.largest, told.smallest, told.runs) == (certainty, 4, 5, 2)
    assert (told.first, told.level) == (0.1, max(high, low))
    values[4000:4003] = high  # a third run
    told = clipping(values)
    assert (told.certainty, told.largest, told.runs) == (FaultCertainty.LIKELY, 7, 3)


def test_a_record_of_nothing_but_cut_ends_does_not_tell_whether_it_is_cut() -> None:
    told = clipping(np.array([0.0, *[1.0, 1.0, 1.0, -1.0, -1.0, -1.0] * 4]))
    assert (told.certainty, told.runs) == (FaultCertainty.POSSIBLE, 8)
