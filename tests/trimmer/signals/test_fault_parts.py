"""Runs of equal samples and what they show, from records of a few samples that are written by hand."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

from trimmer.errors import WrongTypeError
from trimmer.signals.fault import Certainty, Clipping, Dropout, FewSteps, Offset
from trimmer.signals.faults import _clipped_runs, _clipping, _dropout, _few_steps, _Runs, faults
from trimmer.signals.signal import Signal

RATE = 500.0


def signal(values: Sequence[float] | np.ndarray, **options: float) -> tuple[Signal, _Runs]:
    record = Signal(np.asarray(values, dtype=float), RATE, "a", "g", 0.4, **options)
    return record, _Runs.of(record.values)


def summed(*steps: float) -> np.ndarray:
    """Samples from 0 on with these steps between them."""
    return np.concatenate([[0.0], np.cumsum(steps)])


def dropout(values: Sequence[float] | np.ndarray) -> Dropout | None:
    return _dropout(*signal(values))


def test_only_signals_are_looked_at() -> None:
    with pytest.raises(WrongTypeError, match="signal must be"):
        faults([1.0, 2.0])  # type: ignore[arg-type]


def test_runs_of_equal_samples() -> None:
    _, runs = signal([1.0, 1.0, 2.0, 2.0, 2.0, 0.5])
    assert (runs.begins.tolist(), runs.lengths.tolist()) == ([0, 2, 5], [2, 3, 1])
    assert (runs.levels.tolist(), runs.step) == ([0.5, 1.0, 2.0], 0.5)
    before, after = runs._jumps
    assert (before.tolist(), after.tolist()) == ([0.0, 1.0, 1.5], [1.0, 1.5, 0.0])
    assert runs.at(2.0).tolist() == [False, True, False]


@pytest.mark.parametrize(
    ("values", "abrupt"),
    [
        ([0, 1, 13, 13], [False, False, False]),
        ([0, 1, 14, 14], [False, True, True]),
        ([14, 14, 1, 0], [True, True, False]),
    ],
)
def test_a_run_is_abrupt_beside_a_jump_of_more_than_twelve_steps(
    values: list[int], abrupt: list[bool]
) -> None:
    assert signal(values)[1].abrupt.tolist() == abrupt


STAND = summed(-1, 0, 1, 2, 1, 0, 0, -1, -2, -1, 0, 1)
"""A motion with the curvature 1 that stops for three samples: only next to the stop it is bent otherwise."""


@pytest.mark.filterwarnings("error")
def test_what_is_cut_off_comes_faster_than_its_curvature_can_stop() -> None:
    cut = summed(5, 5, 5, 2, 0, 0, -2, -5, -5, -5)
    for values, expected in ((STAND, False), (cut, True), (-cut, True), (np.tile(STAND, 3), False)):
        _, runs = signal(values)
        assert runs.cut(runs.lengths == 3) is expected
    # A step of twice the change of steps is not enough, on either side.
    for before, after in (((5, 5), (-3, -4.5)), ((4.5, 3), (-5, -5)), ((5, 5), (-4, -6))):
        _, runs = signal(summed(9, *before, 2, 0, 0, -2, *after))
        assert runs.cut(runs.lengths == 3) is False


@pytest.mark.filterwarnings("error")
def test_noise_beside_a_run_says_that_it_is_cut_off() -> None:
    """Of three values of the curvature before the run the sign changes twice."""
    values = summed(1, 2, 1, 2, 5, 0, 0)
    _, runs = signal(values)
    assert runs.cut(runs.lengths == 3) is True
    _, fewer = signal(values[1:])
    assert fewer.cut(fewer.lengths == 3) is False
    # Without noise there must be three samples on either side.
    smooth = summed(5, 5, 5, 5, 5, 2, 0, 0)
    _, runs = signal(smooth)
    assert runs.cut(runs.lengths == 3) is False
    _, runs = signal(smooth[::-1])
    assert runs.cut(runs.lengths == 3) is False


@pytest.mark.parametrize(("first", "last", "expected"), [(3, 3, True), (2, 3, False), (3, 2, False)])
def test_three_samples_are_looked_at_on_either_side(first: int, last: int, expected: bool) -> None:
    """Two runs, of which one is at the begin or the end of the record, with a line of 20 between them."""
    up, down = [5.0] * first, [-5.0] * last
    left = summed(*up[1:], 2, 0, 0, -2, *[-5.0] * 20)
    right = summed(*[5.0] * 20, 2, 0, 0, -2, *down[1:])
    for values, which in ((left, first), (right, last)):
        _, runs = signal(values)
        assert runs.cut(runs.lengths == 3) is (which == 3)
    assert expected is (first == last == 3)


@pytest.mark.parametrize(("cut", "whole"), [(3, True), (2, False)])
def test_three_of_five_runs_must_be_cut_off(cut: int, whole: bool) -> None:
    stopped = (5, 5, 5, 2, 0, 0, -2, -5, -5, -5)
    stands = (6, 3, 2, 2, 0, 0, -2, -2, -3, -6)
    _, runs = signal(summed(*cut * stopped, *(5 - cut) * stands))
    assert int((runs.lengths == 3).sum()) == 5
    assert runs.cut(runs.lengths == 3) is whole


def test_which_runs_of_an_extreme_look_clipped() -> None:
    wave = [0, 1, 2, 1, 0, -1, -2, -1]
    record, runs = signal([*wave, 40, 40, 40, *wave, 40, *wave, 40, 40])
    # The single sample and the pair are as abrupt; only at full scale a pair is enough.
    assert runs.begins[_clipped_runs(record, runs, 40.0)].tolist() == [8]
    for scale, begins in ((40.0, [8, 28]), (40.0 / 0.999, [8, 28]), (40.1, [8])):
        record, runs = signal(record.values, full_scale=scale)
        assert runs.begins[_clipped_runs(record, runs, 40.0)].tolist() == begins
    for scale, begins in ((math.inf, [8]), (40.0, [8, 28])):
        record, runs = signal(-np.abs(record.values), full_scale=scale)
        assert runs.begins[_clipped_runs(record, runs, -40.0)].tolist() == begins
    # One into which the signal comes in steps of 5 is not as abrupt.
    record, runs = signal([*wave, 40, 40, 40, *wave, 10, 20, 30, 35, 40, 40, 40, 35, 30, 20, 10, *wave])
    assert runs.begins[_clipped_runs(record, runs, 40.0)].tolist() == [8]


@pytest.mark.parametrize(("length", "samples", "clipped"), [(7, 20, 1), (8, 20, 0), (9, 40, 1), (10, 40, 0)])
def test_a_run_of_a_quarter_of_the_record_or_of_eight_samples_is_no_crest(
    length: int, samples: int, clipped: int
) -> None:
    # A level next to the largest is so frequent that the number of samples at it tells nothing.
    rest = np.resize([30.0, 0.0, 30.0, 1.0, 30.0], samples - length)
    record, runs = signal([*rest, *length * [60.0]])
    assert int(_clipped_runs(record, runs, 60.0).sum()) == clipped


def test_with_coarse_steps_an_extreme_counts_that_is_more_than_three_times_as_frequent() -> None:
    """The level next to the largest has one sample, that next to the smallest four."""
    top, bottom = [3, 5, 5, 3, 5, 5, 4, 5], [2, 0, 0, 1, 1, 0, 0, 1, 1]
    record, runs = signal([*top, *bottom])
    assert runs.begins[_clipped_runs(record, runs, 5.0)].tolist() == [1, 4]
    assert not _clipped_runs(record, runs, 0.0).any()
    record, runs = signal([-value for value in (*top, *bottom)])
    assert runs.begins[_clipped_runs(record, runs, -5.0)].tolist() == [1, 4]
    assert not _clipped_runs(record, runs, 0.0).any()
    for count, many in ((3, False), (4, True)):
        record, runs = signal([0, 1, 2, *count * [3]])
        assert _clipped_runs(record, runs, 3.0).any() == many
    # Of 1000 samples five are enough, four are not.
    slow = np.resize([0.0, 1.0, 2.0, 1.0], 1000)
    for count, many in ((4, False), (5, True)):
        values = slow.copy()
        values[[200, 201, *range(300, 298 + count)]], values[400] = 4.0, 3.0
        record, runs = signal(values)
        assert _clipped_runs(record, runs, 4.0).any() == many


def test_clipping_of_three_levels_and_what_is_told_of_it() -> None:
    values = [0, 1, 0, 1, 30, 30, 30, 1, 0, 1, 0]
    assert _clipping(*signal(values)) == Clipping(Certainty.POSSIBLE, 3, 0, 1, 11, 0.4 + 4 / RATE, 30.0)
    assert _clipping(*signal([0, 0, 0, 0, 1])) is None
    lower = _clipping(*signal([-value for value in values]))
    assert lower == Clipping(Certainty.POSSIBLE, 0, 3, 1, 11, 0.4 + 4 / RATE, 30.0)


@pytest.mark.parametrize(
    ("full_scale", "certainty"),
    [
        (30.0, Certainty.CERTAIN),
        (30.0 / 0.999, Certainty.CERTAIN),
        (30.1, Certainty.LIKELY),
        (math.inf, Certainty.LIKELY),
        (1e6, Certainty.LIKELY),
    ],
)
def test_only_at_full_scale_it_is_certain(full_scale: float, certainty: Certainty) -> None:
    noisy = [0, 2, 1, 2, 0, 1, 0, 2, 0, 1]
    values = [*noisy, 30, 30, 30, *noisy, -30, -30, -30, -30, *noisy]
    found = _clipping(*signal(values, full_scale=full_scale))
    assert found == Clipping(certainty, 3, 4, 2, 37, 0.4 + 10 / RATE, 30.0)
    # The other extreme has the same size, but one sample alone.
    single = _clipping(*signal([*noisy, 30, 30, 30, *noisy, 30, 30, 30, *noisy, -30, *noisy]))
    assert single == Clipping(Certainty.POSSIBLE, 6, 0, 2, 47, 0.4 + 10 / RATE, 30.0)
    # Two runs at one extreme alone are not enough, three are.
    for count, known in ((2, Certainty.POSSIBLE), (3, Certainty.LIKELY)):
        several = _clipping(*signal([*count * [*noisy, 30, 30, 30], *noisy]))
        assert several == Clipping(known, 3 * count, 0, count, 10 + 13 * count, 0.4 + 10 / RATE, 30.0)


@pytest.mark.parametrize(
    ("value", "found"), [(2.9, False), (3.0, False), (3.1, True), (98.9, True), (99.0, False), (99.5, False)]
)
def test_a_dropout_is_no_crest(value: float, found: bool) -> None:
    """From 1 to 101 two percent of the range are 2."""
    values = [1.0, 50.0, 101.0, 51.0, *20 * [value], 101.0, 50.0, 1.0, 49.5]
    assert (dropout(values) is not None) is found
    assert (dropout([-each for each in values]) is not None) is found


@pytest.mark.parametrize(("usual", "least"), [(1, 16), (2, 16), (3, 24)])
def test_a_dropout_is_far_longer_than_other_runs(usual: int, least: int) -> None:
    wave = [1.0, 101.0, 2.0, *np.repeat([50.0, 51.0, 70.0, 30.0], usual)]
    for length, found in ((least - 1, False), (least, True)):
        values = [*wave, *length * [0.0], *wave, *wave, 1.0, *wave]
        assert (dropout(values) is not None) is found
    # Samples at zero are no usual runs, neither are crests.
    zeros = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 80.0]
    assert dropout([*zeros, *zeros, *zeros, *wave[: 4 * usual], *least * [0.0], 30.0]) is not None
    # Between crests alone sixteen samples at zero are enough.
    crests = [100.0, -100.0, 99.0, -99.0]
    assert dropout([*crests, *16 * [0.0], *crests]) is not None
    assert dropout([*crests, *15 * [0.0], *crests]) is None


def test_what_is_told_of_the_longest_dropout() -> None:
    wave = [1.0, 50.0, 101.0, 51.0]
    values = [*wave, *17 * [20.0], *wave, *19 * [0.0], *wave, *18 * [30.0], *wave]
    assert dropout(values) == Dropout(0.4 + 25 / RATE, 0.4 + 43 / RATE, 0.0, 19, 2)
    assert dropout([*wave, *17 * [20.0]]) == Dropout(0.4 + 4 / RATE, 0.4 + 20 / RATE, 20.0, 17, 0)
    # One that comes slowly stands still; two levels are a square wave.
    assert dropout([*np.arange(0.0, 41.0), *20 * [41.0], *np.arange(42.0, 90.0)]) is None
    assert dropout([*20 * [0.0], *20 * [1.0]]) is None


def test_few_steps_are_counted_from_three_on() -> None:
    values = np.resize([0.0, 1.0, 2.0], 60)
    assert _few_steps(*signal(values)) == FewSteps(3, 1.0, math.log2(3.0), 1.0 / math.sqrt(12.0), "g")
    assert _few_steps(*signal(values[:59])) is None
    moved = _few_steps(*signal(values + 0.25))
    assert moved is not None
    assert (moved.values, moved.step) == (3, 1.0)
    assert _few_steps(*signal(np.resize([0.0, 1.0], 60))) is None
    found = _few_steps(*signal(np.resize([0.1 * k for k in (0, 1, 2, 3, 7)], 100)))
    assert found is not None
    assert (found.values, found.step) == (5, pytest.approx(0.1))
    assert (found.bits, found.noise) == (pytest.approx(3.0), pytest.approx(0.1 / math.sqrt(12.0)))
    assert _few_steps(*signal(np.resize([0.0, 1.0, 2.5], 60))) is None
    for count in (256, 257):
        steps = _few_steps(*signal(np.resize(np.arange(float(count)), 20 * count)))
        assert (steps is not None) is (count == 256)


@pytest.mark.parametrize(("mean", "told"), [(2.99, False), (-2.99, False), (3.01, True), (-3.01, True)])
def test_a_mean_is_large_from_three_times_the_rest_on(mean: float, told: bool) -> None:
    values = np.array([1.0, -1.0, 1.0, -1.0]) + mean
    assert faults(signal(values)[0]) == (
        (Offset(pytest.approx(mean), pytest.approx(abs(mean)), "g"),) if told else ()
    )


def test_sentences_name_numbers_and_units() -> None:
    one = Clipping(Certainty.CERTAIN, 3, 0, 1, 11, 0.4, 30.0).sentence
    assert one.startswith(
        "3 of 11 samples have the largest value, in 1 run from 0.4 s on: the measurement is clipped"
    )
    both = Clipping(Certainty.LIKELY, 3, 4, 2, 11, 0.4, 30.0).sentence
    assert (
        "3 of 11 samples have the largest value and 4 of 11 samples have the smallest value, in 2 runs"
        in both
    )
    assert "(as 2 more)" in Dropout(0.1, 0.2, 0.0, 19, 2).sentence
    assert "more" not in Dropout(0.1, 0.2, 0.0, 19, 0).sentence
    assert (
        "steps of 0.5 (3.0 bits used): rounding adds about 0.14 rms"
        in FewSteps(8, 0.5, 3.0, 0.1443, "").sentence
    )
    assert Offset(-20.0, 28.3, "g").sentence.startswith("the mean, -20 g, is 28.3 times")
    assert Offset(-20.0, 28.3, "").sentence.startswith("the mean, -20, is")
    kinds = (
        Clipping(Certainty.LIKELY, 3, 4, 2, 11, 0.4, 30.0),
        Dropout(0, 1, 0, 19, 0),
        FewSteps(3, 1, 2, 1, ""),
    )
    assert [fault.kind for fault in (*kinds, Offset(1, 4, ""))] == [
        "clipping",
        "dropout",
        "few steps",
        "offset",
    ]
