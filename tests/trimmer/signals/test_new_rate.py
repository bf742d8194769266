"""The rate at which samples with unequal time stamps are resampled, and what is told of their gaps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from trimmer.signals import sampling
from trimmer.signals.sampling import Stamped
from trimmer.signals.text_file import SignalFileError
from trimmer.signals.time_stamps import Spacing

SPACING = Spacing(
    rate=500.00049,
    begins=(0,),
    equal=False,
    rounding=0.0,
    rate_uncertainty=0.0,
    jitter=1e-4,
    worst=1,
    usual=2e-3,
)


def test_the_rate_to_resample_at_is_that_of_the_samples_or_a_higher_one() -> None:
    assert sampling._new_rate(SPACING, None, "file") == 500.0
    # A rate is that of the samples, too, if it is off by less than one in a thousand.
    for given in (499.8, 500.0, 501.0, 4000.0):
        assert sampling._new_rate(SPACING, given, "file") == given
    for given in (499.2, 250.0):
        with pytest.raises(SignalFileError, match=f"file: {given:g} Hz is less than the 500 samples"):
            sampling._new_rate(SPACING, given, "file")


def test_a_rate_must_agree_with_equal_stamps_as_far_as_they_tell() -> None:
    assert sampling._agreed(SPACING, None, "file") == SPACING.rate
    assert sampling._agreed(SPACING, 500.4, "file") == 500.4
    with pytest.raises(SignalFileError, match="file"):
        sampling._agreed(SPACING, 502.0, "file")
    assert sampling._agreed(replace(SPACING, rate_uncertainty=0.01), 502.0, "file") == 502.0


def test_gaps_lie_between_the_stamps_around_them() -> None:
    times = np.array([1.0, 1.002, 1.012, 1.014, 1.0165, 1.0185])
    stamped = Stamped(times, np.zeros(6), range(7, 13), "file")
    first, second = sampling._gaps(stamped, replace(SPACING, begins=(0, 2, 4)))
    assert (first.begin, first.end, first.line, first.missing) == (1.002, 1.012, 9, 4)
    # Where less than two intervals are left open, a sample is missing all the same.
    assert (second.begin, second.end, second.line, second.missing) == (1.014, 1.0165, 11, 1)


def test_rows_that_repeat_both_stamp_and_value_are_left_out() -> None:
    times = np.array([0.0, 1.0, 1.0, 2.0, 3.0, 4.0, 4.0])
    values = np.array([5.0, 6.0, 6.0, 6.0, 7.0, 8.0, 9.0])
    kept, repeated = sampling._without_repetition(Stamped(times, values, range(2, 9), "file"))
    assert repeated == 1
    assert kept.times.tolist() == [0.0, 1.0, 2.0, 3.0, 4.0, 4.0]
    assert kept.values.tolist() == [5.0, 6.0, 6.0, 7.0, 8.0, 9.0]
    assert (list(kept.lines), kept.place) == ([2, 3, 5, 6, 7, 8], "file")


def test_stamps_that_mostly_repeat_are_left_as_they_are() -> None:
    two_of_three = Stamped(np.array([0.0, 0.0, 0.0, 1.0]), np.zeros(4), range(4), "file")
    assert sampling._without_repetition(two_of_three) == (two_of_three, 0)
    half = Stamped(np.array([0.0, 0.0, 1.0]), np.zeros(3), range(3), "file")
    assert sampling._without_repetition(half)[1] == 1


def test_stretches_too_short_for_a_spline_are_left_out() -> None:
    """Rows of 4, 3 and 12 at unequal distances: the middle ones are too few."""
    rng = np.random.default_rng(4)
    steps = 1e-3 * rng.choice([0.8, 1.2], 300)
    steps[[3, 6]] = 0.1
    times = np.concatenate([[0.0], np.cumsum(steps)])
    stamped = Stamped(times, np.cos(300 * times), range(2, 303), "file")
    split = sampling.Sampling("resample", "split")
    rate, stretches, gaps = sampling.stretches_of(stamped, None, split)
    assert [each.start for each in stretches] == [0.0, pytest.approx(times[7])]
    assert len(gaps) == 2
    assert rate == pytest.approx(1000.0, rel=0.05)
    for each in stretches:
        assert any(note.startswith("1 stretches of fewer than 4 samples") for note in each.notes)
    with pytest.raises(SignalFileError, match=r"file: no stretch has the 4 samples"):
        sampling.stretches_of(
            Stamped(np.array([0.0, 1.0, 2.5]), np.array([1.0, 4.0, 2.0]), range(3), "file"), None, split
        )
