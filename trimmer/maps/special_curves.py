"""Curves over a map: where folds, period doublings, grazings and their like lie in both of its numbers.

Branches over the first number are followed at a few values of the second, and each of their special points is
followed from there over both.
"""

from collections.abc import Iterator, Sequence

import numpy as np

from trimmer.arguments import require_instance, whole_number
from trimmer.branches import FollowedBranch, LocusEnd, LocusRanges, SpecialPoint
from trimmer.errors import MapError
from trimmer.maps.meetings import meetings
from trimmer.maps.result import MotionMap
from trimmer.maps.special_curve import SpecialCurve, SpecialCurves
from trimmer.maps.special_work import Line, LineWork, Side, SideWork, bare, in_order
from trimmer.runners import ProcessRunner, Runner, SerialRunner

LINES = 3
MOST_CURVES = 8


def special_curves(
    result: MotionMap,
    *,
    lines: int = LINES,
    most_curves: int = MOST_CURVES,
    runner: Runner | None = None,
    quiet: bool = False,
) -> SpecialCurves:
    """Look for special points on a map over two numbers, and follow them.

    What is found does not depend on who does the work.

    Args:
        result: The map; its ranges are what is looked at, and its cells do not matter.
        lines: Values of the second number, evenly spread inside its range, at which branches over the first
            are followed from what the mechanism settles to at both of its ends.
        most_curves: Number of curves for each line after which no other special point is followed; what one
            does not need is left to the next.
        runner: Who does the work; by default processes on all cores.
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
    runner = ProcessRunner(chunk=1) if runner is None else runner
    ranges = LocusRanges(*((float(values.min()), float(values.max())) for values in result.values))
    lowest, highest = ranges.second
    seconds = [float(lowest + (line + 0.5) / lines * (highest - lowest)) for line in range(lines)]
    work = LineWork(result.inputs.subject, result.places, ranges)
    found = in_order(runner, work, seconds, "branches", quiet)
    search = _CurveSearch(runner, SideWork(result.places[1], ranges), quiet)
    for number, line in enumerate(found, start=1):
        search.add(line, most_curves * number)
    spans = np.array([highest - lowest for lowest, highest in ranges.both])
    met = meetings(search.curves, spans)
    return SpecialCurves(tuple(search.curves), _searched(result, found, search), met)


class _CurveSearch:
    """The curves that were found so far."""

    def __init__(self, runner: Runner, work: SideWork, quiet: bool) -> None:
        self.runner, self.work, self.quiet = runner, work, quiet
        self.spans = np.array([highest - lowest for lowest, highest in work.ranges.both])
        self.curves: list[SpecialCurve] = []
        self.left = 0

    def add(self, line: Line, most: int) -> None:
        """Follow the special points of a line that lie on no curve yet, until there are enough curves."""
        waiting = [each for each in _points(line) if self._inside(each[1])]
        while waiting:
            fresh = [each for each in waiting if not self._held(line, each[1])]
            room = most - len(self.curves)
            if room <= 0:
                self.left += len(fresh)
                return
            waiting = fresh[min(room, self._at_once) :]
            for point, curve in self._followed(fresh[: min(room, self._at_once)]):
                # One that was followed at the same time may have turned out to lie on the curve before.
                if not self._held(line, point):
                    self.curves.append(curve)

    @property
    def _at_once(self) -> int:
        """How many points are followed at once; each goes to two sides."""
        if isinstance(self.runner, SerialRunner):
            return 1
        return max(self.runner.count // 2, 1) if isinstance(self.runner, ProcessRunner) else 4

    def _inside(self, point: SpecialPoint) -> bool:
        lowest, highest = self.work.ranges.first
        return lowest <= point.value <= highest

    def _held(self, line: Line, point: SpecialPoint) -> bool:
        return any(curve.holds(point, line.second, self.spans) for curve in self.curves)

    def _followed(
        self, points: Sequence[tuple[FollowedBranch, SpecialPoint]]
    ) -> Iterator[tuple[SpecialPoint, SpecialCurve]]:
        lowest, highest = self.work.ranges.second
        sides = [Side(bare(branch), point, stop) for branch, point in points for stop in (highest, lowest)]
        loci = in_order(self.runner, self.work, sides, "special points", self.quiet)
        for (_, point), up, down in zip(points, loci[::2], loci[1::2], strict=True):
            yield point, SpecialCurve((up,) if up.reason is LocusEnd.CLOSED else (up, down))


def _points(line: Line) -> Iterator[tuple[FollowedBranch, SpecialPoint]]:
    for begun in line.branches:
        for branch in begun.all():
            yield from ((branch, point) for point in branch.special)


def _searched(result: MotionMap, lines: Sequence[Line], search: _CurveSearch) -> str:
    first, second = result.places
    at = ", ".join(f"{line.second:.6g}" for line in lines)
    unsettled = [f"{line.second:.6g}" for line in lines if not line.branches]
    count = sum(1 for line in lines for _ in _points(line))
    told = (
        f"the branches over {first} from what it settles to at both ends, and those that part from them, at "
        f"{second} = {at}: "
        f"{count} special points, which lie on {len(search.curves)} curves"
    )
    if unsettled:
        told += f"; at {', '.join(unsettled)} it settles at neither end of {first}, and nothing was followed"
    for line in lines:
        early = [branch.message for branch in line.branches if not branch.success]
        told += "".join(f"; at {line.second:.6g} a branch ends early: {each}" for each in early)
    if search.left:
        told += f"; {search.left} special points more were not followed"
    return (
        f"{told}; others were not looked for, nor two grazings, or phases of stick, that come and go between "
        "two neighbouring orbits of a branch"
    )
