"""The rate of samples that are at unequal distances, or one that is given; gaps between stamps."""

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
