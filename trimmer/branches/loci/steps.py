"""Stepping along a locus: where the next point is looked for, how far on, and why there is none.

A point is predicted by the parabola through the last three. Then the number that changes more is held, and
the point is found again on a short piece of branch over the other; so a locus may turn in either number.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.loci.locus import LocusEnd, LocusSettings
from trimmer.branches.loci.search import PREDICTING, LocusPoint, Search, Track, apart, found_again, restart
from trimmer.progress import progress_bar

FIRST_STEP = 2e-3  # Length of the first step, as a share of the ranges
FIRST_REACHES = (1e-2, 1e-3, 1e-1)
"""Distances at which the first points are looked for, in coordinates without units, in their order."""
REACH = 0.5  # Distance from a prediction within which a point is looked for, relative to the step
LEAST_REACH = 2e-5
WORST = 0.2  # Error of a prediction, relative to the step, above which the step is shortened
MUCH_SHORTER = 0.1
LARGEST_MOVE = 0.2  # Largest length of a step, states included
ACCURATE = 0.03  # Error of a prediction, relative to the step, below which the next step is longer
SHARP = 0.05  # Share of the numbers in a step, against the states, below which a locus turns sharply back
CLOSES = 1e-3  # Distance from the first point, in ranges, within which a locus may close


def followed(search: Search, track: Track, sign: float, settings: LocusSettings) -> LocusEnd:
    """Add point after point to a track, and return why it ends."""
    length = min(FIRST_STEP, settings.largest_step)
    bar = progress_bar(description=search.sought.kind.word, quiet=settings.quiet, unit=" points")
    with bar:
        restart(search, track)
        while len(track.points) < settings.most_points:
            made = _step(search, track, sign, length)
            if made is None:
                length *= 0.5
                if length < settings.smallest_step:
                    return _obstacle(track)
                continue
            point, error = made
            track.points.append(point)
            restart(search, track)
            bar.update()
            if not search.inside(point.values) or (abs(point.values - 0.5) >= 0.5 - 1e-12).any():
                return LocusEnd.LEFT
            if _closed(track.points):
                return LocusEnd.CLOSED
            length = _next_length(track.points, length * (2.0 if error < ACCURATE else 1.0), settings)
    return LocusEnd.MOST_POINTS


def _next_length(points: Sequence[LocusPoint], wanted: float, settings: LocusSettings) -> float:
    """Return a length at which the two numbers change no more than they may."""
    before, last = points[-2:]
    share = float(np.linalg.norm(last.values - before.values)) / apart(before, last.values, last.state)
    return min(wanted, LARGEST_MOVE, settings.largest_step / max(share, 1e-300))


def _step(search: Search, track: Track, sign: float, length: float) -> tuple[LocusPoint, float] | None:
    """Return the next point and the error of its prediction relative to the step; None if none was found."""
    if len(track.points) == 1:
        return _second_point(search, track, sign, length)
    before, last = track.points[-2:]
    predicted = _predicted(track.points, length)
    ahead = predicted[0] - last.values
    holds = [int(each) for each in np.argsort(-abs(ahead))]
    rooms = _rooms(last.values, ahead)
    if rooms.min() <= 1.0:
        border = int(np.argmin(rooms))
        predicted = _predicted(track.points, length * float(rooms[border]))
        predicted[0][border] = 1.0 if ahead[border] > 0.0 else 0.0
        holds = [border]
    values, state = predicted
    move = apart(last, values, state)
    # After a step that was too long its direction says little: a much shorter one finds a better.
    worst = WORST if length > MUCH_SHORTER * apart(before, last.values, last.state) else REACH
    for held in holds:
        found = found_again(search, track, held, values, state, max(LEAST_REACH, REACH * move))
        if found is not None and apart(found, values, state) <= worst * move:
            return found, apart(found, values, state) / move
    return None


def _second_point(
    search: Search, track: Track, sign: float, length: float
) -> tuple[LocusPoint, float] | None:
    (start,) = track.points
    values = np.clip(start.values + np.array([0.0, sign * length]), 0.0, 1.0)
    for reach in FIRST_REACHES:
        found = found_again(search, track, 1, values, start.state, reach)
        if found is not None:
            return found, 0.0
    return None


def _predicted(points: Sequence[LocusPoint], length: float) -> tuple[Reals, Reals]:
    """Return values, (2,), and state, (n,), farther on by a length, on the curve through the last points."""
    last = points[-PREDICTING:]
    rows = [np.append(point.values, point.state) for point in last]
    chords = [apart(left, right.values, right.state) for left, right in pairwise(last)]
    at = np.cumsum([0.0, *chords])
    ahead = at[-1] + length
    predicted = np.zeros(len(rows[0]))
    for own, row in zip(at, rows, strict=True):
        others = at[at != own]
        predicted += np.prod((ahead - others) / (own - others)) * row
    return predicted[:2], predicted[2:]


def _rooms(values: Reals, ahead: Reals) -> Reals:
    """Return how much of a step leads to the border of either number, (2,)."""
    room = np.where(ahead > 0.0, 1.0 - values, values)
    return np.asarray(room / np.maximum(abs(ahead), 1e-300))


def _closed(points: Sequence[LocusPoint]) -> bool:
    """Say whether the last step passes the first point."""
    if len(points) < 4:
        return False
    first, before, last = points[0], points[-2], points[-1]
    chord = last.values - before.values
    share = float(chord @ (first.values - before.values)) / float(chord @ chord)
    if not 0.0 < share <= 1.0:
        return False
    state = before.strobed + share * (last.strobed - before.strobed)
    begin = replace(first, state=first.strobed)
    return apart(begin, before.values + share * chord, state) <= CLOSES + 0.1 * float(np.linalg.norm(chord))


def _obstacle(track: Track) -> LocusEnd:
    if len(track.points) > 2:
        before, last = track.points[-2:]
        moved = np.linalg.norm(last.values - before.values)
        if moved < SHARP * np.linalg.norm((last.state - before.state) / last.sizes):
            return LocusEnd.CUSP
    return LocusEnd.CHANGED if track.others else LocusEnd.LOST
