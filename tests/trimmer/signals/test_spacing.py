"""How samples lie in time: every number that is told about stamps, on stamps made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.signals import time_stamps
from trimmer.signals.sampling import Sampling, Stamped, stretches_of
from trimmer.signals.text_file import SignalFileError
from trimmer.signals.time_stamps import (
    RATE_TOLERANCE,
    STAMP_TOLERANCE,
    Spacing,
    agreed_rate,
    last_digit,
    spacing_of,
)


def spacing(times: np.ndarray) -> Spacing:
    return spacing_of(times, range(2, 2 + len(times)), "file")


def test_equal_distances() -> None:
    found = spacing(3.0 + np.arange(50) / 691.0)
    assert (found.rate, found.begins, found.equal, found.rounding) == (691.0, (0,), True, 0.0)
    assert found.rate_uncertainty == 0.0
    assert found.jitter == pytest.approx(0.0, abs=1e-15)
    assert found.usual == pytest.approx(1 / 691, rel=1e-11)


def test_gaps_divide_the_record_and_do_not_change_the_rate() -> None:
    times = np.delete(np.arange(60) * 0.25, [10, 11, 40])
    found = spacing(times)
    assert (found.rate, found.begins, found.equal, found.rounding) == (4.0, (0, 10, 38), True, 0.0)
    assert found.worst == 10
    _, parts, gaps = stretches_of(
        Stamped(times, np.arange(57.0), range(2, 59), "file"), None, Sampling(gaps="split")
    )
    assert [(gap.begin, gap.end, gap.line, gap.missing) for gap in gaps] == [
        (2.25, 3.0, 12, 2),
        (9.75, 10.25, 40, 1),
    ]
    assert [(part.start, len(part.values), part.values[0]) for part in parts] == [
        (0.0, 10, 0.0),
        (3.0, 28, 10.0),
        (10.25, 19, 38.0),
    ]


def test_rounded_stamps_are_seen_by_their_last_digit() -> None:
    times = np.round(np.arange(300) / 300.0, 2)
    found = spacing(times)
    assert (found.begins, found.equal, found.rounding) == ((0,), True, 0.01)
    assert found.rate == pytest.approx(300, rel=1e-2)
    assert found.rate_uncertainty == pytest.approx(0.01 / times[-1], rel=1e-12)
    # The error of rounding is uniform over a digit.
    assert found.jitter == pytest.approx(0.01 / np.sqrt(12), rel=0.1)


def test_rounded_stamps_with_a_gap() -> None:
    times = np.round(np.delete(np.arange(400) / 40.0, range(100, 120)), 2)
    found = spacing(times)
    assert (found.begins, found.equal, found.rounding) == ((0, 100), True, 0.01)
    assert found.rate == pytest.approx(40.0, rel=1e-4)


def test_rounding_is_no_gap_beside_one() -> None:
    # Steps of 0.02 and 0.03 s explain each other; only the twenty missing samples are a gap.
    found = spacing(np.round(np.delete(np.arange(400) * 0.0205, range(100, 120)), 2))
    assert (found.begins, found.equal, found.rounding) == ((0, 100), True, 0.01)
    assert found.rate == pytest.approx(1 / 0.0205, rel=1e-3)


@pytest.mark.parametrize(("late", "equal"), [(0.9, True), (1.1, False), (-0.9, True), (-1.1, False)])
def test_a_stamp_may_be_off_by_a_share_of_the_distance(late: float, equal: bool) -> None:
    times = np.arange(21) * 4e-5
    times[7] += late * STAMP_TOLERANCE * 4e-5
    found = spacing(times)
    assert found.equal == equal
    assert found.worst == 7
    assert found.jitter == pytest.approx(abs(late) * STAMP_TOLERANCE * 4e-5 * np.sqrt(20) / 21, rel=1e-6)


def test_unequal_distances_have_gaps_where_they_are_far_beyond_the_scatter() -> None:
    steps = np.tile([0.8, 1.0, 1.2], 20)
    steps[31] = 2.85
    found = spacing(np.concatenate([[0.0], np.cumsum(steps)]))
    assert (found.equal, found.begins) == (False, (0, 32))
    # The scatter of steps is 1.4826 * 0.2: six of them are more than 1.7.
    steps[31] = 2.7
    assert spacing(np.concatenate([[0.0], np.cumsum(steps)])).begins == (0,)


def test_the_worst_is_the_late_stamp_and_not_the_step_after_it() -> None:
    times = np.arange(30.0)
    times[12] += 0.4
    assert spacing(times).worst == 12


@pytest.mark.parametrize(
    ("times", "digit"),
    [
        ([0.0, 1.0, 20.0], 1.0),
        ([0.0, 0.5, 1.25], 0.01),
        ([-0.125, 0.5], 1e-3),
        ([0.0, 1 / 3], 0.0),
        ([0.0], 1.0),
        ([0.0, 1e-6, 3e-6], 1e-6),
    ],
)
def test_the_last_digit(times: list[float], digit: float) -> None:
    assert last_digit(np.array(times)) == pytest.approx(digit, rel=1e-12)


def test_the_last_digit_of_single_precision_is_that_of_the_largest_stamp() -> None:
    times = np.array([1 / 3, 5 / 3, 20 / 3], dtype=np.float32).astype(np.float64)
    assert last_digit(times) == 2.0**-21


@pytest.mark.parametrize("share", [-1.01, -0.99, 0.99, 1.01])
def test_a_given_rate_agrees_within_a_tolerance(share: float) -> None:
    given = 500.0 * (1 + share * RATE_TOLERANCE)
    if abs(share) < 1:
        assert agreed_rate(given, 500.0, RATE_TOLERANCE, "file") == given
    else:
        with pytest.raises(SignalFileError):
            agreed_rate(given, 500.0, RATE_TOLERANCE, "file")


def test_a_step_is_fitted_by_the_ends_or_over_stretches() -> None:
    times = np.array([1.0, 2.1, 2.9, 4.0])
    step, apart = time_stamps._fitted(times, (0,), 0.0)
    assert step == 1.0
    assert apart.tolist() == pytest.approx([0.0, 0.1, -0.1, 0.0])
    # Least squares: (-1.5, -0.5, 0.5, 1.5) . times / 5.
    step, apart = time_stamps._fitted(times, (0,), 0.1)
    assert step == pytest.approx((1.5 * 3.0 + 0.5 * 0.8) / 5)
    assert apart.tolist() == pytest.approx(
        (times - times.mean() - step * np.array([-1.5, -0.5, 0.5, 1.5])).tolist()
    )
    step, _ = time_stamps._fitted(np.array([0.0, 1.0, 7.0, 8.5]), (0, 2), 0.0)
    assert step == pytest.approx(1.25)
    # Stretches of one sample each have the usual step.
    step, _ = time_stamps._fitted(np.array([0.0, 1.0, 3.0]), (0, 1, 2), 0.0)
    assert step == 1.5


def test_repeated_rows_are_left_out_when_resampling_unless_most_repeat() -> None:
    times = np.array([0.0, 1.0, 1.0, 2.3, 3.1, 4.0, 5.2])
    values = np.array([1.0, 2.0, 2.0, 3.0, 4.0, 3.0, 2.0])
    stamped = Stamped(times, values, range(2, 9), "file")
    rate, (part,), gaps = stretches_of(stamped, None, Sampling("resample"))
    assert gaps == ()
    assert rate == pytest.approx(5 / 5.2, rel=1e-5)
    assert part.values[0] == 1.0
    assert "repeat the row before and its time stamp: 1" in part.notes[0]
    different = Stamped(times, values + np.arange(7), range(2, 9), "file")
    with pytest.raises(SignalFileError, match="line 4"):
        stretches_of(different, None, Sampling("resample"))


def test_stretches_that_are_too_short_for_a_spline_are_left_out() -> None:
    times = np.array([0.0, 1.2, 2.0, 3.2, 4.0, 30.0, 31.2, 32.0, 90.0, 91.2, 92.0, 93.1])
    stamped = Stamped(times, np.sin(times), range(2, 14), "file")
    _, parts, gaps = stretches_of(stamped, 2.0, Sampling("resample", "split"))
    assert [part.start for part in parts] == [0.0, 90.0]
    assert len(gaps) == 2
    assert any("1 stretches of fewer than 4 samples" in note for note in parts[0].notes)
    short = Stamped(times[5:8], np.zeros(3), range(3), "file")
    with pytest.raises(SignalFileError, match="no stretch has"):
        stretches_of(short, 2.0, Sampling("resample", "split"))
    with pytest.raises(SignalFileError, match="resample at a higher rate"):
        stretches_of(stamped, 0.5, Sampling("resample", "split"))
