"""Time stamps seen in each of the ways that there are, from a few stamps whose places are known."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from trimmer.signals import time_stamps
from trimmer.signals.sampling import Stamped, _new_rate, _resampled
from trimmer.signals.text_file import SignalFileError
from trimmer.signals.time_stamps import _breaks, _fitted, _seen, agreed_rate, last_digit, spacing_of


def spaced(times: np.ndarray) -> time_stamps.Spacing:
    return spacing_of(times, range(1, times.size + 1), "f")


HOLES = np.delete(np.arange(100), [25, 50, 75])
"""Three samples of a hundred are missing, evenly: a lower rate with rounded stamps would explain them."""


def test_missing_samples_beside_a_gap_are_gaps_unless_there_are_many() -> None:
    found = spaced(np.concatenate([HOLES, 500 + HOLES]) / 1000.0)
    assert found.begins == (0, 25, 49, 73, 97, 122, 146, 170)
    assert (found.equal, found.rounding, found.rate, found.rate_uncertainty) == (True, 0.0, 1000.0, 0.0)
    # Every fifth one is missing of 800 Hz in milliseconds: these are rounded, and only 3 ms are a gap.
    rounded = np.floor(np.arange(200) * 1.25)
    found = spaced(np.concatenate([rounded, rounded[-1] + 3 + rounded]) / 1000.0)
    assert (found.begins, found.equal, found.rounding) == ((0, 200), True, 1e-3)
    assert found.rate == pytest.approx(800.0, rel=2e-3)
    assert found.rate_uncertainty == pytest.approx(1e-3 / 0.499, rel=1e-2)
    found = spaced(np.concatenate([rounded, rounded[-1] + 2 + rounded]) / 1000.0)
    assert found.begins == (0,)


@pytest.mark.parametrize(
    ("pattern", "longest"),
    [((0.9, 1.0, 1.1), 1.0 + 6.0 * 1.4826 * 0.1), ((1.0, 1.0, 1.0, 0.8, 1.2), 1.5)],
)
def test_a_gap_among_unequal_distances_is_longer_than_their_scatter(pattern, longest: float) -> None:
    for length, begins in ((longest - 0.02, (0,)), (longest + 0.02, (0, 61))):
        steps = np.concatenate([np.resize(pattern, 60), [length], np.resize(pattern, 60)])
        found = spaced(np.concatenate([[0.0], np.cumsum(steps)]) * 0.0123456789)
        assert (found.begins, found.equal, found.rounding) == (begins, False, 0.0)
        assert found.usual == pytest.approx(0.0123456789)


def test_stamps_that_are_mostly_repeated_have_the_step_between_those_that_differ() -> None:
    found = spaced(np.floor(np.arange(90) / 3.0))
    assert (found.usual, found.equal, found.rounding) == (1.0, True, 1.0)
    assert found.rate == pytest.approx(3.0, rel=0.02)
    with pytest.raises(SignalFileError, match="line 2: time stamp 5 s does not come after 5 s"):
        spaced(np.full(3, 5.0))


def test_a_short_record_with_stamps_of_nanoseconds_is_not_rounded_to_seconds() -> None:
    steps = np.resize([1.0, 1.0, 1.0, 3.0, 0.5], 100)
    found = spaced(np.concatenate([[0.0], np.cumsum(steps)]) * 1e-9)
    assert (found.equal, found.rounding) == (False, 0.0)


def test_what_is_told_of_unequal_distances() -> None:
    times = np.cumsum([0.0, 1.0, 1.0, 1.3, 0.7, 1.0, 1.5, 0.4, 1.0, 1.1]) * 0.0314159
    found = spaced(times)
    # The largest is off by 0.6; the first that is off by more than half of that comes seventh.
    assert (found.worst, found.usual, found.equal) == (6, pytest.approx(0.0314159), False)
    step = times[-1] / 9
    assert found.rate == pytest.approx(1.0 / step)
    assert found.jitter == pytest.approx(np.std(times - step * np.arange(10)))
    alike = spaced(np.array([0.0, 1.0, 2.0, 3.5, 4.5, 5.6]) * 0.0314159)
    assert (alike.worst, alike.begins) == (3, (0,))


def test_steps_that_are_longer_begin_a_stretch() -> None:
    assert _breaks(np.array([1.0, 1.5, 2.0, 1.0, 9.0]), 1.5) == (0, 3, 5)
    assert _breaks(np.array([1.0]), 1.5) == (0,)


@pytest.mark.filterwarnings("error")
def test_one_stretch_is_fitted_by_its_ends_and_others_by_least_squares() -> None:
    step, apart = _fitted(np.array([1.0, 2.3, 4.0, 7.0]), (0,), 0.0)
    assert (step, apart.tolist()) == (2.0, pytest.approx([0.0, -0.7, -1.0, 0.0]))
    step, apart = _fitted(np.array([0.0, 1.0, 2.0, 10.0, 11.2, 12.4]), (0, 3), 0.0)
    assert (step, apart.tolist()) == (pytest.approx(1.1), pytest.approx([0.1, 0.0, -0.1, -0.1, 0.0, 0.1]))
    step, apart = _fitted(np.array([0.0, 1.0, 5.0]), (0,), 1.0)
    assert (step, apart.tolist()) == (2.5, pytest.approx([0.5, -1.0, 0.5]))
    step, apart = _fitted(np.array([0.0, 3.0, 10.0]), (0, 1, 2), 0.0)
    assert (step, apart.tolist()) == (5.0, [0.0, 0.0, 0.0])


def test_stamps_are_rounded_ones_if_twenty_differ_and_none_is_far_off() -> None:
    thirds = np.floor(np.arange(90) / 3.0)
    assert _seen(thirds, (0,), 1.0)[3:] == (True, 1.0)
    assert _seen(thirds[:60], (0,), 1.0)[3:] == (True, 1.0)
    assert _seen(thirds[:57], (0,), 1.0)[3:] == (False, 0.0)
    assert _seen(thirds, (0,), 0.4)[3:] == (False, 0.0)
    assert _seen(thirds, (0,), 0.0)[3:] == (False, 0.0)
    assert _seen(np.arange(30.0), (0,), 1.0)[3:] == (True, 0.0)
    # One stamp of three is off by just a twentieth of the step.
    assert _seen(np.array([0.0, 20.0 + 1.0, 40.0]), (0,), 0.0).equal
    assert not _seen(np.array([0.0, 20.0 + 1.01, 40.0]), (0,), 0.0).equal


@pytest.mark.parametrize(
    ("times", "digit"),
    [
        (np.arange(30.0) * 7, 1.0),
        (np.arange(30) * 7e-3, 1e-3),
        (np.arange(30) * 7e-9, 1e-9),
        (np.arange(30) * 3e-10, 0.0),
        (1.7e9 + np.arange(30) * 7e-3, 1e-3),
        (-1.7e9 + np.arange(30) * 7e-3, 1e-3),
        (np.concatenate([[0.0], 1.7e9 + np.arange(30) * 7e-3]), 1e-3),
        (np.sqrt(np.arange(30)), 0.0),
        (np.zeros(3), 1.0),
        (np.array([2.0, 2.0 + 5e-7]), 1e-7),
        ((100.0 + np.sqrt(np.arange(30))).astype(np.float32).astype(float), 2.0**-17),
    ],
)
def test_the_last_digit_of_stamps(times: np.ndarray, digit: float) -> None:
    assert last_digit(times) == digit


@pytest.mark.parametrize(
    ("times", "lines", "message"),
    [
        (
            [5.0, 15.0, 14.0, 5.1],
            [2, 3, 7, 8],
            "f, line 7: time stamp 14 s does not come after 15 s of line 3; write",
        ),
        ([5.0, 15.0, 9.9, 16.0], [2, 3, 7, 8], "f, line 7: time stamp 9.9 s does not come .*; write"),
        (
            [5.0, 15.0, 9.0, 16.0],
            [2, 3, 7, 8],
            "f, line 7: time stamp 9 s does not come .*: a counter that wraps",
        ),
        ([5.0, 5.0, 6.0], [2, 3, 4], "f, line 3: time stamp 5 s does not come after 5 s of line 2; write"),
        ([5.0, math.nan, math.nan], [2, 3, 4], "f, line 3: the time stamp is missing"),
        ([5.0], [2], "f: one time stamp gives no sample rate"),
    ],
)
def test_stamps_that_cannot_be_used_are_named(times, lines, message: str) -> None:
    with pytest.raises(SignalFileError, match=f"^{message}"):
        spacing_of(np.array(times), lines, "f")


def test_a_rate_has_as_few_digits_as_explain_the_stamps() -> None:
    for rate in (5.0, 44_100.0, 123.456789012345, 0.1):
        for start in (0.0, 0.25):
            assert spaced(start + np.arange(200) / rate).rate == rate
    # Beyond 15 digits it is what the ends give.
    assert spaced(np.arange(7) * 0.3).rate == 1.0 / (1.8 / 6) != 3.33333333333333
    # Over several stretches fourteen digits are told.
    third = np.concatenate([np.arange(30), np.arange(40, 70)]) * 0.3
    assert spaced(third).rate == 3.3333333333333


@pytest.mark.parametrize("given", [1001.0, 999.0, 1000.0])
def test_a_rate_that_is_given_may_be_a_thousandth_off(given: float) -> None:
    assert agreed_rate(given, 1000.0, 1e-3, "f") == given
    for off in (1001.1, 998.9):
        with pytest.raises(
            SignalFileError, match=f"^f: the time stamps are those of 1000 Hz, not of {off} Hz"
        ):
            agreed_rate(off, 1000.0, 1e-3, "f")


def test_resampling_tells_distances_and_what_a_spline_would_hide() -> None:
    times = 5.0 + np.concatenate([[0.0], np.cumsum(np.resize([0.9e-3, 1.1e-3], 199))])
    values = np.clip(np.sin(2 * np.pi * 20.0 * times) + 1e-3 * np.cos(1e5 * times), -0.5, 0.5)
    values[:50] = np.sin(2 * np.pi * 20.0 * times[:50]) * 0.4
    found = _resampled(Stamped(times, values, range(200), "f"), slice(10, 180), 1000.0, ("before",))
    assert (found.start, found.notes[0], len(found.notes)) == (times[10], "before", 3)
    assert "from 5.0" in found.notes[1]
    assert "likely to be clipped" in found.notes[1] or "clipped" in found.notes[1]
    assert found.notes[2].startswith(
        "170 samples at unequal distances (0.0009 to 0.0011 s) are resampled at 1000 Hz"
    )
    assert found.trusted.highest > 0


@pytest.mark.parametrize(
    ("given", "rate"), [(None, 1000.12), (999.2, 999.2), (1000.5, 1000.5), (4000.0, 4000.0)]
)
def test_samples_are_not_brought_to_fewer(given: float | None, rate: float) -> None:
    spacing = replace(spaced(np.arange(9.0)), rate=1000.123)
    assert _new_rate(spacing, given, "f") == rate
    with pytest.raises(SignalFileError, match=r"f: 999 Hz is less than the 1000\.12 samples"):
        _new_rate(spacing, 999.0, "f")


@pytest.mark.parametrize(("bits", "digit"), [(0, 1e-3), (1, 1e-3), (-3, 1e-3), (5, 1e-5)])
def test_the_last_digit_may_be_four_roundings_off(bits: int, digit: float) -> None:
    times = 1.7e9 + np.arange(30) * 7e-3
    times[5] += bits * np.spacing(times[5])
    assert last_digit(times) == digit
