"""A motion of a cell, in words too, and which motions of a cell are one."""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from trimmer.maps.measures import CellMeasures
from trimmer.maps.settle import strobed_sizes
from trimmer.one_orbit import LEAST_KNOWN, SAME, ClosedCurve, are_one
from trimmer.response.periodic.shooting import CLOSED
from trimmer.response.results.response import MotionKind


@dataclass(frozen=True)
class CellMotion:
    """A motion of a cell.

    Attributes:
        kind: Kind of motion.
        period_count: Drive periods after which it repeats; 0 if it does not.
        periods: Drive periods that were waited; 0 without a drive.
        largest_multiplier: Largest modulus of the Floquet multipliers; None where there is no exact orbit.
        lyapunov: Growth of small distances per drive period, or per s without a drive, as a logarithm; None
            where it was not measured.
        states: At the start of each period of the orbit, (period_count, n) as tuples; of a motion that does
            not repeat only the last one.
        measures: Over the period, or over the last ``WINDOW`` drive periods; None where the motion failed or
            grew beyond all bounds.
        starts: How many starts of the cell led to it.
        failure: Why the motion ended before its time, or the cell could not be begun; empty if neither.
        neutral: Whether it is one of many orbits or places of rest side by side.
        holding: Of a motion at rest: the statuses of all contacts and frictions.
    """

    kind: MotionKind
    period_count: int = 0
    periods: int = 0
    largest_multiplier: float | None = None
    lyapunov: float | None = None
    states: tuple[tuple[float, ...], ...] = ()
    measures: CellMeasures | None = None
    starts: int = 1
    failure: str = ""
    neutral: bool = False
    holding: tuple[int, ...] = ()

    def as_data(self) -> dict[str, Any]:
        """Return the motion as data for JSON, which ``typed`` reads."""
        return {**asdict(self), "kind": self.kind.word}


def described(motion: CellMotion) -> str:
    """Return what a motion is, in plain words, such as ``period 3`` or ``not settled``."""
    return "failed" if motion.failure else motion.kind.described(motion.period_count)


def waited_for(description: str, waited: str) -> str:
    """Add to what a motion is how long was waited, such as ``300 drive periods``, if it rests on that.

    What had not settled by then may do so later: chaos too may be a transient.
    """
    begun = {
        MotionKind.CHAOTIC.described(None): "chaotic over",
        MotionKind.UNDECIDED.described(None): "not settled within",
    }.get(description)
    return description if begun is None else f"{begun} {waited}"


def stands_for_its_kind(motion: CellMotion) -> bool:
    """Say whether a motion counts as one with all of its kind: it does not repeat, and is not exact."""
    repeats = motion.kind is MotionKind.PERIODIC or motion.kind is MotionKind.REST
    return not (repeats or motion.failure or motion.neutral)


def same_motion(first: CellMotion, second: CellMotion) -> bool:
    """Return whether two motions of one cell are one.

    Periodic motions are told apart by their orbits, of which mirror images are two, and those at rest by
    their places. Neutral ones, of which there is one beside the other without end, are one if they are of one
    size, or rest on the same parts. Those that do not repeat are told apart by their kind, and where both are
    exact by their size.
    """
    if first.kind is not second.kind or first.failure != second.failure:
        return False
    if first.kind is MotionKind.PERIODIC or first.kind is MotionKind.REST:
        if first.period_count != second.period_count:
            return False
        if not (first.neutral and second.neutral):
            return alike(first, second)
        at_rest = first.kind is MotionKind.REST  # What is told of its size is rounding.
        return first.holding == second.holding if at_rest else of_one_size(first, second)
    return not (first.neutral and second.neutral) or of_one_size(first, second)


def of_one_size(first: CellMotion, second: CellMotion) -> bool:
    """Return whether two neutral motions hold the same parts, and are of one size: strokes, accelerations."""
    if first.measures is None or second.measures is None:
        return first.holding == second.holding
    pairs = [
        (size, theirs[name])
        for ours, theirs in (
            (first.measures.peak_to_peak, second.measures.peak_to_peak),
            (first.measures.rms_acceleration, second.measures.rms_acceleration),
        )
        for name, size in ours.items()
    ]
    return first.holding == second.holding and all(
        abs(size - other) <= SAME * max(abs(size), abs(other)) for size, other in pairs
    )


def alike(first: CellMotion, second: CellMotion, apart: float = SAME) -> bool:
    """Return whether the orbits of two periodic motions differ by no more than a share of their sizes."""
    return are_one(_curve(first), _curve(second), apart)


def _curve(motion: CellMotion) -> ClosedCurve:
    """Return the orbit of a periodic motion as the closed curve by which it is compared.

    Of the orbit its states at the starts of drive periods are known, and the largest multiplier: no other one
    that is near 1 is farther from the unit circle. Its residual is at most that at which a return is closed.
    """
    states = np.array(motion.states)
    apart = 1.0 - (motion.largest_multiplier or 0.0)
    known = min(CLOSED / apart, LEAST_KNOWN) if apart > SAME else 0.0
    return ClosedCurve(float(len(states)), states[:, None], strobed_sizes(states), known)
