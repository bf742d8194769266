"""The sample rate from time stamps, and where these are not at equal distances."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.signals.text_file import SignalFileError

STAMP_TOLERANCE = 0.05
"""How far a time stamp may be from its place, in sampling intervals: room for stamps that are rounded."""

RATE_TOLERANCE = 1e-3  # How far a sample rate that is given may be from that of the time stamps, relative

ROUNDED = 0.75
"""How far a rounded time stamp may be from its place, in units of its last digit.

Rounding moves it by at most half a unit; the rest is for the line that is fitted.
"""

_FEWEST_ROUNDED = 20
_FEWEST_UNUSUAL = 3
_MOST_GAPS = 0.1
_DIGITS = 15
_SUM_DIGITS = 14
_WRAPPED = 0.5
"""Share of the range of all stamps by which one must fall to look like the new begin of a counter."""


@dataclass(frozen=True)
class Spacing:
    """How the samples of a record lie in time."""

    rate: float  # Sample rate, Hz: the mean one within the stretches
    begins: tuple[int, ...]  # Place of the first sample of each stretch without a gap, from 0; the first is 0
    equal: bool  # Whether samples lie at equal distances, as far as the stamps can tell
    # Last digit of the stamps, s, if they are rounded to more than ``STAMP_TOLERANCE``; else 0
    rounding: float
    rate_uncertainty: float  # How far off the rate can be because of that, relative
    jitter: float  # Standard deviation of the stamps from equal distances, s
    worst: int  # Place of the sample whose distance to the last is the most unusual
    usual: float  # Usual distance of samples, s


def spacing_of(times: Reals, lines: Sequence[int], place: str) -> Spacing:
    """Find the sample rate of stamps, s, (n,), and where distances are not equal.

    If a rate of at most 15 digits gives just these stamps as start + k/rate, to the last bit, it is that
    one; so such a rate survives being written as stamps that start at 0. A distance counts as a gap if it
    is longer than the usual one by half of it, and by the last digit of rounded stamps, or by six
    standard deviations of distances that are not equal. Stamps that fall, as those of a counter that
    wraps around, are refused.
    """
    _check_present(times, lines, place)
    steps = np.diff(times)
    _check_rising(times, steps < 0, lines, place)
    usual = float(np.median(steps[steps > 0])) if (steps > 0).any() else 0.0
    stretches = _stretches(times, steps, usual)
    if not stretches.rounding:
        _check_rising(times, steps <= 0, lines, place)
    unusual = np.abs(steps - usual)
    return Spacing(
        rate=_rate(times, stretches),
        begins=stretches.begins,
        equal=stretches.equal,
        rounding=stretches.rounding,
        rate_uncertainty=stretches.rounding / float(times[-1] - times[0]),
        jitter=float(stretches.apart.std()),
        # The first of the largest: a late stamp is followed by a short step.
        worst=int(np.argmax(unusual > 0.5 * unusual.max())) + 1,
        usual=usual,
    )


class _Stretches(NamedTuple):
    """A way to see the stamps: where stretches begin, their common step, what stamps are off, s."""

    begins: tuple[int, ...]
    step: float
    apart: Reals
    equal: bool
    rounding: float


def _stretches(times: Reals, steps: Reals, usual: float) -> _Stretches:
    """Find the simplest way to see the stamps: equal, rounded, with gaps, rounded with gaps, unequal.

    Rounding makes several steps unusual. One or two that are longer are taken for gaps, though a rate beside
    the round one would explain them too.
    """
    digit = last_digit(times)
    several = int((np.abs(steps - usual) > STAMP_TOLERANCE * usual).sum()) >= _FEWEST_UNUSUAL
    coarse = digit if digit > STAMP_TOLERANCE * usual and several else 0.0
    exact = _seen(times, _breaks(steps, 1.5 * usual), coarse)
    ways = [_seen(times, (0,), coarse)]
    if len(exact.begins) <= _MOST_GAPS * times.size and not exact.rounding:
        ways.append(exact)
    if coarse:
        ways.append(_seen(times, _breaks(steps, 1.5 * usual + coarse), coarse))
    for way in ways:
        if way.equal:
            return way
    scatter = 1.4826 * float(np.median(np.abs(steps - usual)))
    return _seen(times, _breaks(steps, usual + max(0.5 * usual, 6.0 * scatter)), 0.0)


def _breaks(steps: Reals, longest: float) -> tuple[int, ...]:
    return (0, *(int(gap) + 1 for gap in np.flatnonzero(steps > longest)))


def _seen(times: Reals, begins: tuple[int, ...], coarse: float) -> _Stretches:
    step, apart = _fitted(times, begins, coarse)
    farthest = float(np.abs(apart).max())
    fine = farthest <= STAMP_TOLERANCE * step
    several = np.unique(times).size >= _FEWEST_ROUNDED
    rounded = not fine and several and farthest <= ROUNDED * coarse
    return _Stretches(begins, step, apart, fine or rounded, coarse if rounded else 0.0)


def last_digit(times: Reals) -> float:
    """Return the unit of the last digit of stamps, s: decimal, or that of single precision; 0 if none."""
    span = float(np.abs(times).max())
    for decimals in range(10):
        scaled = times * 10.0**decimals
        whole = np.rint(scaled)
        if np.ptp(whole) == 0 < np.ptp(times):
            continue  # Stamps that differ by less than the digit say nothing about it.
        if np.abs(scaled - whole).max() <= max(1e-6, 4 * np.spacing(span * 10.0**decimals)):
            return float(10.0**-decimals)
    single = times.astype(np.float32)
    return float(np.spacing(single.max())) if np.array_equal(single.astype(np.float64), times) else 0.0


def _check_present(times: Reals, lines: Sequence[int], place: str) -> None:
    missing = np.flatnonzero(np.isnan(times))
    if missing.size:
        raise SignalFileError(f"{place}, line {lines[int(missing[0])]}: the time stamp is missing")
    if times.size < 2:
        raise SignalFileError(f"{place}: one time stamp gives no sample rate")


def _check_rising(times: Reals, wrong: Flags, lines: Sequence[int], place: str) -> None:
    """Refuse the first step that is wrong; a fall over much of the range is that of a counter."""
    if not wrong.any():
        return
    at = int(np.flatnonzero(wrong)[0])
    told = (
        f"{place}, line {lines[at + 1]}: time stamp {times[at + 1]:.9g} s does not come after "
        f"{times[at]:.9g} s of line {lines[at]}"
    )
    fall = float(times[at] - times[at + 1])
    if fall > _WRAPPED * float(times.max() - times.min()):
        raise SignalFileError(
            f"{told}: a counter that wraps around, or a second record in the file; make the stamps rise, "
            "split the file, or leave them aside and give the sample rate (--ignore-time --rate HZ)"
        )
    raise SignalFileError(
        f"{told}; write stamps with more digits, or leave them aside and give the sample rate "
        "(--ignore-time --rate HZ)"
    )


def _fitted(times: Reals, begins: tuple[int, ...], coarse: float) -> tuple[float, Reals]:
    """Fit stretches at one rate; return the step, s, and what stamps are off, s, (n,).

    One stretch of exact stamps is fitted by its ends, which gives the step to the last digit; others by least
    squares.
    """
    if len(begins) == 1 and not coarse:
        step = float((times[-1] - times[0]) / (times.size - 1))
        return step, np.asarray(times - times[0] - step * np.arange(times.size))
    places = np.split(np.arange(times.size), begins[1:])
    counts = np.concatenate([part - part.mean() for part in places])
    stamps = np.concatenate([times[part] - times[part].mean() for part in places])
    square = float(counts @ counts)
    step = float(counts @ stamps) / square if square else float(np.median(np.diff(times)))
    return step, np.asarray(stamps - step * counts)


def _rate(times: Reals, stretches: _Stretches) -> float:
    rate = 1.0 / stretches.step
    if len(stretches.begins) > 1:
        return float(f"{rate:.{_SUM_DIGITS}g}")  # a sum over stretches is not exact in its last digit
    return _rate_with_fewest_digits(times, rate)


def _rate_with_fewest_digits(times: Reals, rate: float) -> float:
    counts = np.arange(times.size)
    for digits in range(1, _DIGITS + 1):
        candidate = float(f"{rate:.{digits}g}")
        if np.array_equal(times[0] + counts / candidate, times):
            return candidate
    return rate


def agreed_rate(given: float, stamped: float, tolerance: float, place: str) -> float:
    """Return the sample rate that was given, Hz, if it agrees with that of the time stamps, relatively."""
    if abs(given - stamped) > tolerance * stamped:
        raise SignalFileError(
            f"{place}: the time stamps are those of {stamped:.6g} Hz, not of {given:.6g} Hz as was given; "
            "are the stamps in another unit, or is the rate that of another recording? To use the rate alone "
            "leave the stamps aside (--ignore-time)"
        )
    return given
