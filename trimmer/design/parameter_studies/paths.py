"""The branch through the working point over each of its numbers, and how far its motion reaches."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.branches import BranchEnd, FollowedBranch, FollowedOrbit, FollowSettings, SpecialKind
from trimmer.branches.follow import follow
from trimmer.deadline import NEVER, Deadline
from trimmer.design.analysis.found_motion import FoundMotion
from trimmer.design.varied_places import NumberRole, VariedNumber
from trimmer.mechanism.mechanism import Mechanism

LARGEST_STEP = 0.02  # Largest change of the number between two orbits, as a share of one side of the range
CELLS = 24  # Share of the range of a gain above zero at which its branch ends


@dataclass(frozen=True, eq=False)
class SpecialOnPath:
    """A special point of a branch.

    Attributes:
        kind: What happens there.
        value: Value of the number.
        stroke: Peak to peak of each output there, by name, m.
        parts: Names of the parts whose phases change there.
    """

    kind: SpecialKind
    value: float
    stroke: Mapping[str, float]
    parts: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class PathSide:
    """The branch from the working point to one end of the range.

    Attributes:
        end: That end.
        values: Of the number, (n,).
        stable: Whether each orbit is, (n,).
        stroke: Peak to peak of each output by name, m, (n,).
        measures: What targets bound, by key, SI units, (n,).
        special: The special points, in the order in which they were met.
        reason: Why it ends.
        message: The same as a sentence.
    """

    end: float
    values: Reals
    stable: Flags
    stroke: Mapping[str, Reals]
    special: tuple[SpecialOnPath, ...]
    reason: BranchEnd
    message: str
    measures: Mapping[str, Reals] = field(default_factory=dict)

    @property
    def reaches(self) -> float | None:
        """Value up to which the motion stays stable; None if it does up to the end of what was followed.

        It is the special point at which stability is lost, or the last stable orbit before.
        """
        unstable = np.flatnonzero(~self.stable)
        if not unstable.size:
            return None if self._left or self.cut else float(self.values[-1])
        before = float(self.values[max(int(unstable[0]) - 1, 0)])
        after = float(self.values[int(unstable[0])])
        low, high = sorted((before, after))
        return next(
            (each.value for each in self.special if each.kind in LOSING and low <= each.value <= high), before
        )

    @property
    def first_special(self) -> tuple[SpecialOnPath, ...]:
        """The special points up to where stability is lost."""
        reach = self.reaches
        if reach is None:
            return self.special
        found = []
        for each in self.special:
            if abs(each.value - self.values[0]) > abs(reach - self.values[0]):
                break
            found.append(each)
            if each.value == reach:
                break
        return tuple(found)

    @property
    def cut(self) -> bool:
        """Whether it was ended as the time was over, so that what lies beyond is not known."""
        return self.reason is BranchEnd.OUT_OF_TIME

    @property
    def _left(self) -> bool:
        return self.reason is BranchEnd.LEFT_AT_STOP

    @property
    def losing(self) -> SpecialKind | None:
        """What happens where stability is lost; None if it is not, or nothing special was found there."""
        reach = self.reaches
        return next((each.kind for each in self.special if each.kind in LOSING and each.value == reach), None)


LOSING = (SpecialKind.FOLD, SpecialKind.PERIOD_DOUBLING, SpecialKind.TORUS, SpecialKind.SYMMETRY_BREAKING)
"""Special points at which an orbit may lose its stability."""


@dataclass(frozen=True, eq=False)
class NumberPath:
    """The branch through the working point over one number.

    Attributes:
        varied: The number.
        periods: Drive periods after which its motions repeat; 1 without a drive.
        down, up: To smaller and to larger values; None where the range ends at the working point.
    """

    varied: VariedNumber
    periods: int
    down: PathSide | None
    up: PathSide | None

    @property
    def hardly_begun(self) -> bool:
        """Whether the time was over before another orbit was found to either side."""
        return all(side is None or (side.cut and len(side.values) < 2) for side in (self.down, self.up))


def path_through(
    mechanism: Mechanism,
    varied: VariedNumber,
    motion: FoundMotion,
    most_points: int,
    deadline: Deadline = NEVER,
    *,
    keys: tuple[str, ...] = (),
) -> NumberPath:
    """Follow a periodic motion of the working point over one number to both ends of its range."""
    periods = motion.period_count or 1
    begin = motion.state if motion.driven else np.append(motion.state, motion.period or 0.0)
    sides: list[PathSide | None] = []
    # A gain of nothing may leave no controller.
    lowest = float(varied.values(CELLS)[0]) if varied.role is NumberRole.GAIN else varied.lowest
    for end in (lowest, varied.highest):
        if end == varied.value:
            sides.append(None)
            continue
        bounds = (min(varied.value, end), max(varied.value, end))
        settings = FollowSettings(
            most_points=most_points,
            largest_step=LARGEST_STEP,
            switches=0,
            quiet=True,
            bounds=bounds,
            deadline=deadline,
        )
        counted = periods if motion.driven else None
        branch = follow(
            mechanism, varied.place, varied.value, end, periods=counted, state=begin, settings=settings
        )
        sides.append(_side(branch, end, keys) if branch.points else None)
    return NumberPath(varied, periods, *sides)


def _side(branch: FollowedBranch, end: float, keys: tuple[str, ...]) -> PathSide:
    names = list(branch.units)
    # Each orbit keeps its whole motion once it was measured: hundreds of them would fill the memory.
    found = [
        (orbit.outputs, [orbit.measure(key) for key in keys])
        for orbit in (FollowedOrbit(point.point, point.map) for point in branch.points)
    ]
    strokes = [{name: outputs[name].peak_to_peak for name in names} for outputs, _ in found]
    special = tuple(
        SpecialOnPath(
            each.kind,
            each.value,
            {name: measure.peak_to_peak for name, measure in branch.outputs_at(each).items()},
            each.parts,
        )
        for each in branch.special
    )
    return PathSide(
        end,
        np.array([point.value for point in branch.points]),
        np.array([point.stable for point in branch.points], dtype=bool),
        {name: np.array([each[name] for each in strokes]) for name in names},
        special,
        branch.reason,
        branch.message,
        {key: np.array([measures[at] for _, measures in found]) for at, key in enumerate(keys)},
    )
