"""The pieces of work from which curves over a map are made; each can be done by another process."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar, cast

import numpy as np

from trimmer.branches.branch import BranchEnd
from trimmer.branches.follow import follow
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.loci.follow_special import follow_special
from trimmer.branches.loci.locus import Locus, LocusRanges, LocusSettings
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialPoint
from trimmer.maps.inputs import varied
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.subject import Subject
from trimmer.progress import progress_bar
from trimmer.response.settling.settling import orbit_from_rest
from trimmer.runners.runner import Runner

MOST_ORBITS = 600  # Orbits after which a branch is left
MOST_POINTS = 200  # Points after which a curve is left, on either side of where it was found
LARGEST_STEP = 0.05  # Largest distance of points on a curve, as a share of the ranges
SMALLEST_STEP = 3e-4  # The same below which a curve is given up
SAME_ORBIT = 1e-4  # Difference of two orbits, relative to the states, within which they are the same

Piece = TypeVar("Piece")
Made = TypeVar("Made")


@dataclass(frozen=True, eq=False)
class Line:
    """The branches at one value of the second number; none if the mechanism settles at neither end."""

    second: float
    branches: tuple[FollowedBranch, ...]


@dataclass(frozen=True)
class LineWork:
    """Follows the branches at a value of the second number from both ends of the first."""

    subject: Subject  # The mechanism or loop that is varied
    places: tuple[str, ...]  # Places of the two numbers
    ranges: LocusRanges  # Their ranges

    def __call__(self, second: float) -> Line:
        """Return the branches at a value of the second number."""
        settings = FollowSettings(most_points=MOST_ORBITS, quiet=True)
        branches: list[FollowedBranch] = []
        for start, stop in (self.ranges.first, self.ranges.first[::-1]):
            mechanism = varied(self.subject, self.places, (start, second))
            if branches and _reaches(branches[0], mechanism):
                continue
            branch = follow(cast("Mechanism", mechanism), self.places[0], start, stop, settings=settings)
            branches += [] if branch.reason is BranchEnd.NO_START else [branch]
        return Line(second, tuple(branches))


def _reaches(branch: FollowedBranch, mechanism: Subject) -> bool:
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


@dataclass(frozen=True, eq=False)
class Side:
    """A special point, and the value of the second number towards which it is to be followed."""

    branch: FollowedBranch
    point: SpecialPoint
    stop: float


@dataclass(frozen=True)
class SideWork:
    """Follows special points to one side."""

    place: str  # Place of the second number
    ranges: LocusRanges  # Ranges of both numbers

    def __call__(self, side: Side) -> Locus:
        """Return the locus of a special point to one side."""
        settings = LocusSettings(
            most_points=MOST_POINTS, largest_step=LARGEST_STEP, smallest_step=SMALLEST_STEP, quiet=True
        )
        return follow_special(
            side.branch, side.point, self.place, side.stop, ranges=self.ranges, settings=settings
        )


def bare(branch: FollowedBranch) -> FollowedBranch:
    """Return a branch without its orbits, as it goes to another process with a point of it."""
    return replace(
        branch, map=replace(branch.map, single=None), points=(), special=(), branches=(), parted=None
    )


@dataclass(frozen=True, eq=False)
class _Numbered:
    """Work whose results say of which piece they are."""

    work: Callable[[object], object]

    def __call__(self, piece: tuple[int, object]) -> tuple[int, object]:
        return piece[0], self.work(piece[1])


def in_order(
    runner: Runner, work: Callable[[Piece], Made], pieces: Sequence[Piece], name: str, quiet: bool
) -> list[Made]:
    """Return what work makes of pieces, in their order, behind a progress bar."""
    results: Iterator[tuple[int, Made]] = runner.results(_Numbered(work), list(enumerate(pieces)))  # type: ignore[arg-type]
    bar = progress_bar(results, name, quiet=quiet, total=len(pieces))
    return [made for _, made in sorted(bar, key=lambda result: result[0])]
