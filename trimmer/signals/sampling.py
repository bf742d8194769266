"""Values and time stamps of a file as stretches at equal distances, with what was done to them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.choices import Choice
from trimmer.signals.band import EVERYWHERE, Band
from trimmer.signals.faults import faults
from trimmer.signals.recording import Gap, told_gaps
from trimmer.signals.signal import Signal
from trimmer.signals.text_file import SignalFileError
from trimmer.signals.time_stamps import RATE_TOLERANCE, Spacing, agreed_rate, spacing_of

_FEWEST = 4


class TimeStamps(Choice):
    """What is done with time stamps.

    ``EQUAL``: they must be at equal distances, as far as their digits tell. ``RESAMPLE``: if they are not,
    samples are brought to equal distances by a cubic spline. ``IGNORE``: they are left aside.
    """

    EQUAL = "equal"
    RESAMPLE = "resample"
    IGNORE = "ignore"


class Gaps(Choice):
    """What is done about gaps. ``REFUSE``: they are an error. ``SPLIT``: each stretch stands for itself."""

    REFUSE = "refuse"
    SPLIT = "split"


@dataclass(frozen=True)
class Sampling:
    """How samples are taken from a file; each may also be given by its word.

    Attributes:
        stamps: What is done with time stamps.
        gaps: What is done about gaps; no gap is ever bridged.

    Raises:
        ChoiceError: if one is none of those there are.
    """

    stamps: TimeStamps = TimeStamps.EQUAL
    gaps: Gaps = Gaps.REFUSE

    def __post_init__(self) -> None:
        object.__setattr__(self, "stamps", TimeStamps.chosen(self.stamps, "stamps"))
        object.__setattr__(self, "gaps", Gaps.chosen(self.gaps, "gaps"))


@dataclass(frozen=True, eq=False)
class EvenSamples:
    """Samples at equal distances, (n,), from a start, s, the band in which they hold, and notes."""

    values: Reals
    start: float
    trusted: Band = EVERYWHERE
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Stamped:
    """Time stamps, s, and samples, (n,), with the number of the line of each, from 1."""

    times: Reals
    values: Reals
    lines: Sequence[int]
    place: str


def stretches_of(
    stamped: Stamped, given: float | None, sampling: Sampling
) -> tuple[float, list[EvenSamples], tuple[Gap, ...]]:
    """Return sample rate, Hz, stretches and gaps; a rate that was given, Hz, is checked."""
    resample = sampling.stamps is TimeStamps.RESAMPLE
    stamped, repeated = _without_repetition(stamped) if resample else (stamped, 0)
    spacing = spacing_of(stamped.times, stamped.lines, stamped.place)
    gaps = _gaps(stamped, spacing)
    if gaps and sampling.gaps is Gaps.REFUSE:
        raise SignalFileError(
            f"{_place_of(stamped, spacing.begins[1], spacing)}; {told_gaps(gaps)}: use the stretches between "
            "them (--gaps split), or --ignore-time --rate HZ if nothing is missing"
        )
    notes = _notes(spacing, gaps, repeated)
    parts = list(zip(spacing.begins, (*spacing.begins[1:], stamped.times.size), strict=True))
    if spacing.equal:
        rate = _agreed(spacing, given, stamped.place)
        return (
            rate,
            [
                EvenSamples(stamped.values[begin:end], float(stamped.times[begin]), notes=notes)
                for begin, end in parts
            ],
            gaps,
        )
    if not resample:
        raise SignalFileError(_unequal(stamped, spacing))
    rate = _new_rate(spacing, given, stamped.place)
    whole = [(begin, end) for begin, end in parts if end - begin >= _FEWEST]
    if not whole:
        raise SignalFileError(f"{stamped.place}: no stretch has the {_FEWEST} samples that a spline needs")
    if len(whole) < len(parts):
        notes = (*notes, f"{len(parts) - len(whole)} stretches of fewer than {_FEWEST} samples are left out")
    return rate, [_resampled(stamped, slice(*part), rate, notes) for part in whole], gaps


def _without_repetition(stamped: Stamped) -> tuple[Stamped, int]:
    """Leave out rows that repeat the stamp and the value of the row before."""
    same = (np.diff(stamped.times) == 0) & (np.diff(stamped.values) == 0)
    if not same.any() or same.mean() > 0.5:
        return stamped, 0
    kept = np.flatnonzero(np.concatenate([[True], ~same]))
    lines = [stamped.lines[place] for place in kept.tolist()]
    return Stamped(stamped.times[kept], stamped.values[kept], lines, stamped.place), int(same.sum())


def _gaps(stamped: Stamped, spacing: Spacing) -> tuple[Gap, ...]:
    return tuple(
        Gap(
            begin=float(stamped.times[place - 1]),
            end=float(stamped.times[place]),
            line=stamped.lines[place],
            missing=max(1, round(float(stamped.times[place] - stamped.times[place - 1]) * spacing.rate) - 1),
        )
        for place in spacing.begins[1:]
    )


def _notes(spacing: Spacing, gaps: tuple[Gap, ...], repeated: int) -> tuple[str, ...]:
    notes = [told_gaps(gaps)] if gaps else []
    if repeated:
        notes.append(f"rows left out because they repeat the row before and its time stamp: {repeated}")
    if spacing.rounding:
        unseen = int(spacing.rounding * spacing.rate)
        notes.append(
            f"time stamps are rounded to {spacing.rounding:.3g} s, where samples are "
            f"{1 / spacing.rate:.4g} s apart; equal distances explain them all, at {spacing.rate:.8g} Hz to "
            f"{100 * spacing.rate_uncertainty:.2g} %"
            + (f"; a gap of up to {unseen} samples would not be seen" if unseen else "")
        )
    return tuple(notes)


def _agreed(spacing: Spacing, given: float | None, place: str) -> float:
    if given is None:
        return spacing.rate
    return agreed_rate(given, spacing.rate, max(RATE_TOLERANCE, spacing.rate_uncertainty), place)


def _unequal(stamped: Stamped, spacing: Spacing) -> str:
    return (
        f"{_place_of(stamped, spacing.worst, spacing)}; stamps are {spacing.jitter:.2g} s off (standard "
        "deviation). Have the samples resampled (--resample), or if they were taken at equal distances and "
        "only the stamps are inexact, leave these aside (--ignore-time --rate HZ)"
    )


def _place_of(stamped: Stamped, at: int, spacing: Spacing) -> str:
    step = float(stamped.times[at] - stamped.times[at - 1])
    return (
        f"{stamped.place}, line {stamped.lines[at]}: time stamps are not at equal distances: this one comes "
        f"{step:.6g} s after the last, where {spacing.usual:.6g} s is usual"
    )


def _new_rate(spacing: Spacing, given: float | None, place: str) -> float:
    """Return the rate to resample at: not below that of the samples, since lines would show at others."""
    if given is None:
        return float(f"{spacing.rate:.6g}")
    if given < (1.0 - RATE_TOLERANCE) * spacing.rate:
        raise SignalFileError(
            f"{place}: {given:g} Hz is less than the {spacing.rate:.6g} samples per second that there are, "
            "and what lies above half of it would show at other frequencies; resample at a higher rate"
        )
    return given


def _resampled(stamped: Stamped, part: slice, rate: float, notes: tuple[str, ...]) -> EvenSamples:
    times = stamped.times[part]
    band = trusted_band(times)
    steps = np.diff(times)
    told = (
        f"{times.size} samples at unequal distances ({steps.min():.4g} to {steps.max():.4g} s) "
        f"are resampled at {rate:.6g} Hz by a cubic spline: lines above {band.highest:.4g} Hz can be off by "
        "more than 1 %, and there are images of them"
    )
    measured = stamped.values[part]
    wrong = faults(Signal(measured, rate, start=float(times[0])))  # a spline would hide them
    notes = (*notes, *(fault.sentence for fault in wrong), told)
    return EvenSamples(resampled(times, measured, rate), float(times[0]), band, notes)


SPLINE_ERROR = 0.01
"""Largest error of a line, relative to its amplitude, up to the frequency that counts as trusted."""

_BOUND = 5.0 / 384.0
"""Error of a cubic spline with exact end slopes over h^4 max|f''''|, on any mesh of largest step h (Hall and
Meyer, Journal of Approximation Theory 16, 1976). The ends here have no slopes, so it holds inside."""


def resampled(times: Reals, values: Reals, rate: float) -> Reals:
    """Evaluate the cubic spline through samples, (n,), n >= 4, at a rate, Hz, from the first time, s, on."""
    from scipy.interpolate import CubicSpline

    count = math.floor((times[-1] - times[0]) * rate * (1 + 1e-12)) + 1
    return np.asarray(CubicSpline(times, values)(times[0] + np.arange(count) / rate))


def trusted_band(times: Reals) -> Band:
    """Return the band in which the spline changes no line by more than ``SPLINE_ERROR``.

    A line at f has a fourth derivative of (2 pi f)^4 times its amplitude; the largest step decides.
    """
    longest = float(np.diff(times).max())
    highest = (SPLINE_ERROR / _BOUND) ** 0.25 / (2 * math.pi * longest)
    return Band(
        highest=highest,
        highest_reason=f"cubic spline over steps of up to {longest:.4g} s, lines exact to "
        f"{100 * SPLINE_ERROR:g} %",
    )
