"""Changes of numbers with which a mechanism would meet its targets, as far as they were tried."""

import math
from dataclasses import dataclass

from trimmer.design.specification.targets import Target
from trimmer.design.trials.surroundings import Around, Beside

LEAST = 0.02  # Logarithm of a factor up to which a number is as it was


@dataclass(frozen=True)
class Change:
    """Another number, in an SI unit, at a dotted place: before now, and after."""

    place: str
    unit: str
    before: float
    after: float


@dataclass(frozen=True)
class Remedy:
    """A change of one number, or of two at once.

    Attributes:
        changes: The changes.
        around: What the mechanism does then, at the point and beside it.
        beside: Whether it was looked at beside the point too: under all conditions, or as many as there was
            time for.
        meeting: How many of several starts lead to a motion that meets all targets; None if not tried.
    """

    changes: tuple[Change, ...]
    around: Around
    beside: bool
    meeting: int | None = None

    @property
    def is_needed(self) -> bool:
        """Whether each of its changes is one."""
        return all(abs(math.log(each.after / each.before)) > LEAST for each in self.changes)

    @property
    def margin(self) -> float:
        """Smallest margin of all targets under all conditions; negative if one is missed."""
        return self.around.margin(*Beside)


@dataclass(frozen=True)
class Mend:
    """What a single number does for a target that is missed.

    Attributes:
        target: The target.
        change: The change after which it is met, of all that were tried the one that misses fewest others;
            None if none meets it.
        value: What the target bounds then; None without a change.
        missed: The targets that are missed then.
        helpless: Places of the numbers of which no value that was tried meets it.
        strongest: Places of all that were tried, those first that move it most.
    """

    target: Target
    change: Change | None
    value: float | None
    missed: tuple[Target, ...]
    helpless: tuple[str, ...]
    strongest: tuple[str, ...]


@dataclass(frozen=True)
class Remedies:
    """What was tried to meet the targets.

    Attributes:
        found: Changes that meet all targets at the point and beside it, those with large margins first.
        nearest: Without such a change, the one with the largest margin of those that were tried; else None.
        mends: What a single number does for each target that is missed.
        starts: From how many starts each of those that were found was tried.
        tried: Places that were tried.
        trials: How many motions were computed.
    """

    found: tuple[Remedy, ...]
    nearest: Remedy | None
    mends: tuple[Mend, ...]
    starts: int
    tried: tuple[str, ...]
    trials: int
