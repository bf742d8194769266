"""Curves over a map: where folds, period doublings, grazings and their like lie in both of its numbers.

Branches over the first number are followed at a few values of the second, and each of their special points is
followed from there over both.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from trimmer.arguments import require_instance, whole_number
from trimmer.arrays import Reals
from trimmer.branches.branch import BranchEnd
from trimmer.branches.follow import FollowedBranch, follow
from trimmer.branches.follow_special import follow_special
from trimmer.branches.locus import Locus, LocusEnd, LocusRanges, LocusSettings
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.errors import MapError
from trimmer.maps.inputs import varied
from trimmer.maps.result import MotionMap
from trimmer.mechanism.mechanism import Mechanism
from trimmer.response.settling import orbit_from_rest

MOST_ORBITS = 600
"""Orbits after which a branch is left."""
MOST_POINTS = 200
"""Points after which a curve is left, on either side of where it was found."""
LARGEST_STEP = 0.05
"""Largest distance of points on a curve, as a share of the ranges."""
SMALLEST_STEP = 3e-4
"""The same below which a curve is given up."""
LINES = 3
MOST_CURVES = 8
SAME = 5e-3
"""Distance in shares of the ranges within which a special point lies on a curve that is known."""
SAME_ORBIT = 1e-4
"""Difference of two orbits, relative to the states, within which they are the same."""
SAME_STATE = 5e-2
"""Distance of the states then, relative to their sizes on the curve."""


@dataclass(frozen=True, eq=False)
class SpecialCurve:
    """A curve on which a special point lies.

    Attributes:
        sides: The locus from where it was found, on either side; one if it closes.
    """

    sides: tuple[Locus, ...]

    @property
    def kind(self) -> SpecialKind:
        """What happens there."""
        return self.sides[0].kind

    @property
    def parts(self) -> tuple[str, ...]:
        """Names of the parts whose phases change there."""
        return self.sides[0].parts

    @property
    def periods(self) -> int:
        """Drive periods after which the orbits repeat."""
        return self.sides[0].periods

    @cached_property
    def values(self) -> Reals:
        """Values of both numbers along the curve, SI units, (points, 2)."""
        return np.concatenate([self.sides[-1].values[:0:-1], self.sides[0].values][-len(self.sides) :])

    @cached_property
    def states(self) -> Reals:
        """States at the start of a drive period, (points, n)."""
        return np.concatenate([self.sides[-1].states[:0:-1], self.sides[0].states][-len(self.sides) :])

    @property
    def residual(self) -> float:
        """Largest difference of an orbit's end and start, relative to the sizes of the states."""
        return float(max(np.nanmax(side.residual) for side in self.sides))

    @property
    def ends(self) -> tuple[Locus, ...]:
        """The sides in the order of the curve's ends; one that closes has one."""
        return self.sides[::-1]

    @property
    def name(self) -> str:
        """What it is, with the parts, for a legend."""
        parts = f", {' and '.join(self.parts)}" if self.parts else ""
        return f"{self.kind.word}{parts}"

    def holds(self, point: SpecialPoint, second: float, spans: Reals) -> bool:
        """Say whether it passes a special point at a value of the second number, as near as can be told."""
        if (point.kind, point.parts) != (self.kind, self.parts):
            return False
        sizes = abs(self.states).max(axis=0)
        sizes = np.where(sizes > 0.0, sizes, 1.0)
        target = np.array([point.value, second]) / spans
        return any(
            _passes(values / spans, states / sizes, target, point.state / sizes)
            for values, states in zip(_pairs(self.values), _pairs(self.states), strict=True)
        )


def _pairs(rows: Reals) -> Iterator[Reals]:
    """Yield each two rows that follow one another, (2, n)."""
    return (np.array(pair) for pair in pairwise(rows))


def _passes(values: Reals, states: Reals, target: Reals, state: Reals) -> bool:
    chord = values[1] - values[0]
    length = float(chord @ chord)
    share = float(np.clip(chord @ (target - values[0]) / length, 0.0, 1.0)) if length else 0.0
    near = np.linalg.norm(values[0] + share * chord - target) <= SAME
    between = states[0] + share * (states[1] - states[0])
    return bool(near and abs(between - state).max() <= SAME_STATE)


@dataclass(frozen=True, eq=False)
class SpecialCurves:
    """The curves over a map.

    Attributes:
        curves: The curves, in the order in which they were found.
        searched: What was looked for and where, in a sentence.
    """

    curves: tuple[SpecialCurve, ...]
    searched: str

    @property
    def drawn(self) -> list[tuple[str, Reals]]:
        """The curves as ``MotionMap.plot`` takes them, ordered by their names."""
        return sorted(((curve.name, curve.values) for curve in self.curves), key=lambda each: each[0])


@dataclass(frozen=True, eq=False)
class _Line:
    """The branches at one value of the second number; none if the mechanism settles at neither end."""

    second: float
    branches: tuple[FollowedBranch, ...]


def special_curves(
    result: MotionMap, *, lines: int = LINES, most_curves: int = MOST_CURVES, quiet: bool = False
) -> SpecialCurves:
    """Look for special points on a map over two numbers, and follow them.

    Args:
        result: The map; its ranges are what is looked at, and its cells do not matter.
        lines: Values of the second number, evenly spread inside its range, at which branches over the first
            are followed from what the mechanism settles to at both of its ends.
        most_curves: Number of curves for each line after which no other special point is followed; what one
            does not need is left to the next.
        quiet: Show no progress bar.

    Raises:
        MapError: if the map is not over two numbers.
        MechanismError: if one of them must be whole, or cannot have a value in between.
        WrongTypeError, ValueError: if an argument cannot be used.
    """
    require_instance("result", result, MotionMap, "a MotionMap")
    whole_number("lines", lines, 1)
    whole_number("most_curves", most_curves, 1)
    if len(result.places) != 2 or min(result.shape) < 2:
        raise MapError("curves lie over two numbers, and the map is not over two with several values each")
    ranges = LocusRanges(*((float(values.min()), float(values.max())) for values in result.values))
    lowest, highest = ranges.second
    seconds = lowest + (np.arange(lines) + 0.5) / lines * (highest - lowest)
    found = [_line(result, ranges, float(second), quiet) for second in seconds]
    curves, left = _curves(found, result.places[1], ranges, most_curves, quiet)
    return SpecialCurves(tuple(curves), _searched(result, found, curves, left))


def _line(result: MotionMap, ranges: LocusRanges, second: float, quiet: bool) -> _Line:
    """Follow the branches at a value of the second number from both ends of the first."""
    settings = FollowSettings(most_points=MOST_ORBITS, quiet=quiet)
    branches: list[FollowedBranch] = []
    for start, stop in (ranges.first, ranges.first[::-1]):
        mechanism = varied(result.inputs.mechanism, result.places, (start, second))
        if branches and _reaches(branches[0], mechanism):
            continue
        branch = follow(mechanism, result.places[0], start, stop, settings=settings)
        branches += [] if branch.reason is BranchEnd.NO_START else [branch]
    return _Line(second, tuple(branches))


def _reaches(branch: FollowedBranch, mechanism: Mechanism) -> bool:
    """Say whether a branch ends with what a mechanism settles to from rest, or it does not settle."""
    if branch.reason is not BranchEnd.LEFT_AT_STOP:
        return False
    found = orbit_from_rest(mechanism, FollowSettings().most_periods)
    if found is None:
        return True
    end = branch.points[-1].state
    sizes = np.where(end != 0.0, abs(end), 1.0)
    return bool(
        found.periods == branch.periods and (abs(found.instant.state - end) / sizes).max() <= SAME_ORBIT
    )


def _with_parted(branch: FollowedBranch) -> Iterator[FollowedBranch]:
    yield branch
    for each in branch.branches:
        yield from _with_parted(each)


def _curves(
    lines: Sequence[_Line], place: str, ranges: LocusRanges, most: int, quiet: bool
) -> tuple[list[SpecialCurve], int]:
    """Return the curves, and how many special points were left since there were enough."""
    spans = np.array([highest - lowest for lowest, highest in ranges.both])
    curves: list[SpecialCurve] = []
    left = 0
    for number, line in enumerate(lines, start=1):
        for branch, point in _points(line):
            if any(curve.holds(point, line.second, spans) for curve in curves):
                continue
            if len(curves) < most * number:
                curves.append(_curve(branch, point, place, ranges, quiet))
            else:
                left += 1
    return curves, left


def _points(line: _Line) -> Iterator[tuple[FollowedBranch, SpecialPoint]]:
    for begun in line.branches:
        for branch in _with_parted(begun):
            yield from ((branch, point) for point in branch.special)


def _curve(
    branch: FollowedBranch, point: SpecialPoint, place: str, ranges: LocusRanges, quiet: bool
) -> SpecialCurve:
    settings = LocusSettings(
        most_points=MOST_POINTS, largest_step=LARGEST_STEP, smallest_step=SMALLEST_STEP, quiet=quiet
    )
    lowest, highest = ranges.second
    up = follow_special(branch, point, place, highest, ranges=ranges, settings=settings)
    if up.reason is LocusEnd.CLOSED:
        return SpecialCurve((up,))
    return SpecialCurve((up, follow_special(branch, point, place, lowest, ranges=ranges, settings=settings)))


def _searched(result: MotionMap, lines: Sequence[_Line], curves: Sequence[SpecialCurve], left: int) -> str:
    first, second = result.places
    at = ", ".join(f"{line.second:.6g}" for line in lines)
    unsettled = [f"{line.second:.6g}" for line in lines if not line.branches]
    count = sum(1 for line in lines for _ in _points(line))
    told = (
        f"the branches over {first} from what it settles to at both ends, and those that part from them, at "
        f"{second} = {at}: "
        f"{count} special points, which lie on {len(curves)} curves"
    )
    if unsettled:
        told += f"; at {', '.join(unsettled)} it settles at neither end of {first}, and nothing was followed"
    for line in lines:
        early = [branch.message for branch in line.branches if not branch.success]
        told += "".join(f"; at {line.second:.6g} a branch ends early: {each}" for each in early)
    if left:
        told += f"; {left} special points more were not followed"
    return f"{told}; others were not looked for"
