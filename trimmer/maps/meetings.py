"""Where curves over a map meet: where they cross with one orbit, or one ends on another."""

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.loci.locus import LocusEnd
from trimmer.maps.special_curve import Meeting, SpecialCurve, are_alike

NEAR = 2e-2  # Distance, as a share of the ranges, within which a curve that was lost ends on another one
LOST = (LocusEnd.LOST, LocusEnd.CHANGED, LocusEnd.CUSP)  # Reasons to end that another curve may explain


def meetings(curves: Sequence[SpecialCurve], spans: Reals) -> tuple[Meeting, ...]:
    """Return where curves meet, by their numbers.

    Two curves that cross with different orbits do not meet, since their motions have nothing to do with each
    other.

    Args:
        curves: The curves, over the same two numbers.
        spans: Lengths of the ranges of the two numbers, (2,).
    """
    found: list[Meeting] = []
    for (number, curve), (other_number, other) in combinations(enumerate(curves), 2):
        pair = number, other_number
        if curve.states.shape[1] != other.states.shape[1]:
            continue
        found += [Meeting(pair, values, False, 0.0) for values in _crossings(curve, other, spans)]
        ends = [*_ends(curve, other, spans), *_ends(other, curve, spans)]
        found += [Meeting(pair, values, True, apart) for values, apart in ends]
    return tuple(_apart(found, spans))


def _apart(found: Sequence[Meeting], spans: Reals) -> list[Meeting]:
    """Return one meeting of each pair near a place: where one ends, if one does, else the first."""
    kept: list[Meeting] = []
    for meeting in sorted(found, key=lambda each: (each.curves, not each.ends, each.distance)):
        near = [
            each
            for each in kept
            if each.curves == meeting.curves
            and np.linalg.norm((each.values - meeting.values) / spans) <= NEAR
        ]
        kept += [] if near else [meeting]
    return kept


def _crossings(curve: SpecialCurve, other: SpecialCurve, spans: Reals) -> Iterator[Reals]:
    """Yield the values at which pieces of two curves cross with like states."""
    ours, theirs = curve.values / spans, other.values / spans
    for at in range(len(ours) - 1):
        ahead = ours[at + 1] - ours[at]
        for there in range(len(theirs) - 1):
            aside = theirs[there + 1] - theirs[there]
            matrix = np.column_stack([ahead, -aside])
            if abs(np.linalg.det(matrix)) <= 1e-9 * np.linalg.norm(ahead) * np.linalg.norm(aside):
                continue
            shares = np.linalg.solve(matrix, theirs[there] - ours[at])
            if not ((shares >= 0.0) & (shares < 1.0)).all():
                continue
            state = _between(curve.states, at, shares[0])
            if _alike(curve, other, state, _between(other.states, there, shares[1])):
                yield (ours[at] + shares[0] * ahead) * spans


def _ends(curve: SpecialCurve, other: SpecialCurve, spans: Reals) -> Iterator[tuple[Reals, float]]:
    """Yield where a curve that was lost ends near another one, and how near."""
    theirs = other.values / spans
    for side in curve.sides:
        if side.reason not in LOST:
            continue
        end = side.values[-1] / spans
        places = [(at, _nearest(theirs[at], theirs[at + 1], end)) for at in range(len(theirs) - 1)]
        apart, at, share = min(
            (float(np.linalg.norm(_between(theirs, at, share) - end)), at, share) for at, share in places
        )
        if apart <= NEAR and _alike(curve, other, side.states[-1], _between(other.states, at, share)):
            yield side.values[-1], apart


def _nearest(first: Reals, last: Reals, point: Reals) -> float:
    chord = last - first
    length = float(chord @ chord)
    return float(np.clip(chord @ (point - first) / length, 0.0, 1.0)) if length else 0.0


def _between(rows: Reals, at: int, share: float) -> Reals:
    return np.asarray(rows[at] + share * (rows[at + 1] - rows[at]))


def _alike(curve: SpecialCurve, other: SpecialCurve, state: Reals, another: Reals) -> bool:
    sizes = np.maximum(abs(curve.states).max(axis=0), abs(other.states).max(axis=0))
    return are_alike(state, another, sizes)
