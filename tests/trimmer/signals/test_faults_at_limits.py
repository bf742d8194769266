"""Where a fault begins: records of a few samples beside each limit, looked at as users do."""

import math
from collections.abc import Sequence

import numpy as np
import pytest

from trimmer import Signal, WrongTypeError, faults
from trimmer.signals import Clipping, Dropout, FewSteps, Offset
from trimmer.signals.fault import Fault, FaultCertainty

POSSIBLE, LIKELY, CERTAIN = FaultCertainty.POSSIBLE, FaultCertainty.LIKELY, FaultCertainty.CERTAIN
RATE = 500.0
WAVE = [0, 1, 2, 1, 0, -1, -2, -1]
NOISY = [0, 2, 1, 2, 0, 1, 0, 2, 0, 1]


def found(kind: type[Fault], values: Sequence[float] | np.ndarray, **options: float) -> Fault | None:
    looked = faults(Signal(np.asarray(values, dtype=float), RATE, "a", "g", 0.4, **options))
    return next((fault for fault in looked if isinstance(fault, kind)), None)


@pytest.mark.parametrize(
    ("values", "scale", "expected"),
    [
        # Three levels; a single run is only possibly clipped.
        ([0, 1, 0, 1, 30, 30, 30, 1, 0, 1, 0], math.inf, (POSSIBLE, 3, 0, 1, 4)),
        ([0, 0, 0, 0, 1], math.inf, None),
        # A pair counts at full scale alone, which begins at 0.999 of it.
        ([*WAVE, 40, 40, *WAVE], math.inf, None),
        ([*WAVE, 40, 40, *WAVE], 40.0 / 0.999, (CERTAIN, 2, 0, 1, 8)),
        ([*WAVE, 40, 40, *WAVE], 40.1, None),
        # Two runs at one extreme are few; at both, or three, they are many.
        ([*NOISY, 30, 30, 30, *NOISY, 30, 30, 30, *NOISY], math.inf, (POSSIBLE, 6, 0, 2, 10)),
        ([*(3 * [*NOISY, 30, 30, 30]), *NOISY], math.inf, (LIKELY, 9, 0, 3, 10)),
        ([*NOISY, 30, 30, 30, *NOISY, -30, -30, -30, -30, *NOISY], 1e6, (LIKELY, 3, 4, 2, 10)),
        ([*NOISY, 30, 30, 30, *NOISY, -30, -30, -30, -30, *NOISY], 30, (CERTAIN, 3, 4, 2, 10)),
        # A jump of 12 steps is a rounded crest, of 13 is not; the level below has as many samples.
        ([0, 1, *(4 * [2]), 14, 14, 14, *(4 * [2]), 1], math.inf, None),
        ([0, 1, *(4 * [2]), 15, 15, 15, *(4 * [2]), 1], math.inf, (POSSIBLE, 3, 0, 1, 6)),
        # Coarse steps: more than three times as many samples as the next level has.
        ([0, 1, 2, 3, 3, 3], math.inf, None),
        ([0, 1, 2, 3, 3, 3, 3], math.inf, (POSSIBLE, 4, 0, 1, 3)),
        # A quarter of the record is no crest.
        ([*np.resize([30.0, 0, 30, 1, 30], 13), *(7 * [60.0])], math.inf, (POSSIBLE, 7, 0, 1, 13)),
        ([*np.resize([30.0, 0, 30, 1, 30], 12), *(8 * [60.0])], math.inf, None),
        ([*np.resize([30.0, 0, 30, 1, 30], 31), *(9 * [60.0])], math.inf, (POSSIBLE, 9, 0, 1, 31)),
        ([*np.resize([30.0, 0, 30, 1, 30], 30), *(10 * [60.0])], math.inf, None),
    ],
)
def test_clipping_begins_at_its_limits(values, scale: float, expected) -> None:
    assert_clipped(found(Clipping, values, full_scale=scale), expected, len(values))
    mirrored = found(Clipping, [-value for value in values], full_scale=scale)
    turned = expected and (expected[0], expected[2], expected[1], *expected[3:])
    assert_clipped(mirrored, turned, len(values))


def assert_clipped(told: Fault | None, expected: tuple | None, samples: int) -> None:
    if expected is None:
        assert told is None
        return
    assert isinstance(told, Clipping)
    certainty, largest, smallest, runs, place = expected
    assert (told.certainty, told.largest, told.smallest, told.runs) == (certainty, largest, smallest, runs)
    assert (told.samples, told.first) == (samples, pytest.approx(0.4 + place / RATE))


@pytest.mark.parametrize(("cut", "certainty"), [(3, LIKELY), (2, POSSIBLE)])
def test_three_of_five_runs_must_come_faster_than_their_curvature_stops(cut, certainty) -> None:
    stopped, stands = (5, 5, 5, 2, 0, 0, -2, -5, -5, -5), (10, 3, 2, 2, 0, 0, -2, -2, -3, -10)
    values = np.cumsum([0.0, 0.1, -0.1, *cut * stopped, *(5 - cut) * stands])
    told = found(Clipping, np.round(values, 9))
    assert isinstance(told, Clipping)
    assert (told.runs, told.certainty) == (5, certainty)


@pytest.mark.parametrize(
    ("value", "dropped"),
    [(2.9, False), (3.0, False), (3.1, True), (98.9, True), (99.0, False), (99.5, False)],
)
def test_a_dropout_is_no_crest(value: float, dropped: bool) -> None:
    """From 1 to 101 two percent of the range are 2."""
    values = np.array([1.0, 50.0, 101.0, 51.0, *20 * [value], 101.0, 50.0, 1.0, 49.5])
    assert (found(Dropout, values) is not None) is dropped
    assert (found(Dropout, -values) is not None) is dropped


@pytest.mark.parametrize(("usual", "least"), [(1, 16), (2, 16), (3, 24)])
def test_a_dropout_is_far_longer_than_other_runs(usual: int, least: int) -> None:
    wave = [1.0, 101.0, 2.0, *np.repeat([50.0, 51.0, 70.0, 30.0], usual)]
    for length, dropped in ((least - 1, False), (least, True)):
        values = [*wave, *length * [0.0], *wave, *wave, 1.0, *wave]
        assert (found(Dropout, values) is not None) is dropped
    crests = [100.0, -100.0, 99.0, -99.0]
    assert found(Dropout, [*crests, *16 * [0.0], *crests]) is not None
    assert found(Dropout, [*crests, *15 * [0.0], *crests]) is None


def test_what_is_told_of_dropouts() -> None:
    wave = [1.0, 50.0, 101.0, 51.0]
    values = [*wave, *17 * [20.0], *wave, *19 * [0.0], *wave, *18 * [30.0], *wave]
    told = found(Dropout, values)
    assert told == Dropout(0.4 + 25 / RATE, 0.4 + 43 / RATE, 0.0, 19, 2)
    assert "(as 2 more)" in told.sentence
    alone = found(Dropout, [*wave, *17 * [20.0]])
    assert alone == Dropout(0.4 + 4 / RATE, 0.4 + 20 / RATE, 20.0, 17, 0)
    assert "more" not in alone.sentence
    # One that comes slowly stands still; two levels are a square wave.
    assert found(Dropout, [*np.arange(0.0, 41.0), *20 * [41.0], *np.arange(42.0, 90.0)]) is None
    assert found(Dropout, [*20 * [0.0], 1.0, *20 * [0.0]]) is None


@pytest.mark.parametrize(
    ("levels", "samples", "expected"),
    [
        ([0.0, 1.0, 2.0], 60, (3, 1.0, math.log2(3.0))),
        ([0.25, 1.25, 2.25], 60, (3, 1.0, math.log2(3.0))),
        ([0.0, 1.0, 2.0], 59, None),
        ([0.0, 1.0], 60, None),
        ([0.1 * k for k in (0, 1, 2, 3, 7)], 100, (5, 0.1, 3.0)),
        ([0.0, 1.0, 2.5], 60, None),
        (range(256), 20 * 256, (256, 1.0, 8.0)),
        (range(257), 20 * 257, None),
    ],
)
def test_few_steps_are_even_and_frequent(levels, samples: int, expected) -> None:
    told = found(FewSteps, np.resize(np.asarray(levels, dtype=float), samples))
    assert (told is None) is (expected is None)
    if isinstance(told, FewSteps):
        assert (told.values, told.step, told.bits) == pytest.approx(expected)
        assert told.noise == pytest.approx(told.step / math.sqrt(12.0))
        assert f"steps of {told.step:.3g} g ({told.bits:.1f} bits used)" in told.sentence


@pytest.mark.parametrize(("mean", "large"), [(2.99, False), (-2.99, False), (3.01, True), (-3.01, True)])
def test_a_mean_is_large_from_three_times_the_rest_on(mean: float, large: bool) -> None:
    told = faults(Signal(np.array([1.0, -1.0, 1.0, -1.0]) + mean, RATE, "a", "g"))
    assert told == ((Offset(pytest.approx(mean), pytest.approx(abs(mean)), "g"),) if large else ())
    assert all(fault.sentence.startswith(f"the mean, {mean:.3g} g, is 3.01 times") for fault in told)


def test_only_signals_are_looked_at() -> None:
    with pytest.raises(WrongTypeError, match="signal must be"):
        faults([1.0, 2.0])  # type: ignore[arg-type]
