"""The sample rate from time stamps, and whether they are at equal distances."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trimmer.arrays import Reals
from trimmer.signals.text_file import SignalFileError

STAMP_TOLERANCE = 0.05
"""How far a time stamp may be from its place, in sampling intervals: room for stamps that are rounded."""

RATE_TOLERANCE = 1e-3
"""How far a sample rate that is given may be from that of the time stamps, relative."""

_DIGITS = 15


def rate_of(times: Reals, lines: Sequence[int], place: str) -> float:
    """Find the sample rate from time stamps at equal distances.

    If a rate of at most 15 digits gives just these stamps as start + k/rate, to the last bit, it is that one;
    so such a rate survives being written as stamps that start at 0.

    Args:
        times: Time stamps, s, shape (n,).
        lines: Number of the line of each, from 1.
        place: File, for messages.

    Returns:
        Sample rate, Hz.

    Raises:
        SignalFileError: if there are fewer than two stamps, one is missing, they do not rise, or one is
            farther from equal distances than ``STAMP_TOLERANCE``.
    """
    missing = np.flatnonzero(np.isnan(times))
    if missing.size:
        raise SignalFileError(f"{place}, line {lines[int(missing[0])]}: the time stamp is missing")
    if times.size < 2:
        raise SignalFileError(f"{place}: one time stamp gives no sample rate")
    steps = np.diff(times)
    falling = np.flatnonzero(~(steps > 0))
    if falling.size:
        at = int(falling[0])
        raise SignalFileError(
            f"{place}, line {lines[at + 1]}: time stamp {times[at + 1]:.9g} s does not come after "
            f"{times[at]:.9g} s of line {lines[at]}; write stamps with more digits, or leave them out and "
            "give the sample rate"
        )
    mean_step = (times[-1] - times[0]) / (times.size - 1)
    apart = np.abs(times - times[0] - mean_step * np.arange(times.size)).max()
    if apart > STAMP_TOLERANCE * mean_step:
        usual = float(np.median(steps))
        unusual = np.abs(steps - usual)
        at = int(
            np.argmax(unusual > 0.5 * unusual.max())
        )  # the first: a late stamp is followed by a short step
        raise SignalFileError(
            f"{place}, line {lines[at + 1]}: time stamps are not at equal distances: this one comes "
            f"{steps[at]:.6g} s after the last, where {usual:.6g} s is usual; a spectrum needs equal "
            "distances, so look for samples left out, or resample"
        )
    return _rate_with_fewest_digits(times, float(1.0 / mean_step))


def _rate_with_fewest_digits(times: Reals, rate: float) -> float:
    counts = np.arange(times.size)
    for digits in range(1, _DIGITS + 1):
        candidate = float(f"{rate:.{digits}g}")
        if np.array_equal(times[0] + counts / candidate, times):
            return candidate
    return rate


def agreed_rate(given: float, stamped: float, place: str) -> float:
    """Return the sample rate that was given, if it agrees with that of the time stamps.

    Args:
        given: Sample rate that was given, Hz.
        stamped: Sample rate of the time stamps, Hz.
        place: File, for messages.

    Raises:
        SignalFileError: if the two differ by more than ``RATE_TOLERANCE``.
    """
    if abs(given - stamped) > RATE_TOLERANCE * stamped:
        raise SignalFileError(
            f"{place}: the time stamps are those of {stamped:.6g} Hz, not of {given:.6g} Hz as was given; "
            "are the stamps in another unit, or is the rate that of another recording?"
        )
    return given
