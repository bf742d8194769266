"""A branch of periodic orbits over one number."""

from __future__ import annotations

from dataclasses import dataclass

from trimmer.arrays import Complexes, Reals
from trimmer.branches.period_maps.driven_passage import Signature
from trimmer.branches.special import SpecialPoint
from trimmer.choices import Choice
from trimmer.kept_property import cached_property

NEUTRAL = 1e-9  # Distance from the unit circle that rounding can give a multiplier


class BranchEnd(Choice):
    """Why a branch ends."""

    LEFT_AT_START = "it leaves the interval where it began"
    LEFT_AT_STOP = "it leaves the interval at the other end"
    CLOSED = "it closes on itself"
    REJOINED = "it joins the branch with half the period, or the symmetric one"
    TORN = (
        "the motion jumps, as where something just fails to stick, or static friction gives way at once, and "
        "no orbit lies beyond"
    )
    GRAZED = "a rigid wall is touched there without speed, where an impact is born or dies"
    INFINITE_PERIOD = "its period grows without bound"
    HOPF = (
        "the linear loop loses its stability there (Hopf): the motion meets no corner, and repeats in any "
        "smaller size"
    )
    NOT_ISOLATED = (
        "a multiplier is 1, so that no single orbit goes on: as where something sticks all the time, which "
        "it could do anywhere, or where nothing is lost"
    )
    STEP_TOO_SMALL = "no orbit was found near the last one"
    MOST_POINTS = "it has as many points as were asked for at most"
    OUT_OF_TIME = "the time that was allowed is over"
    NO_START = "no orbit was found at the start"

    @property
    def is_success(self) -> bool:
        """Whether the branch was followed to an end of the interval, around, or to one that it joins."""
        failures = (
            BranchEnd.NOT_ISOLATED,
            BranchEnd.STEP_TOO_SMALL,
            BranchEnd.MOST_POINTS,
            BranchEnd.OUT_OF_TIME,
            BranchEnd.NO_START,
        )
        return self not in failures


@dataclass(frozen=True, eq=False)
class BranchPoint:
    """An orbit on a branch.

    Attributes:
        value: Value of the number that is varied.
        state: State at the start of a drive period, shape (n,).
        multipliers: Floquet multipliers of the whole period by falling modulus, shape (n,).
        signature: The phases that begin during a passage.
        events: Events during a period, a number.
    """

    value: float
    state: Reals
    multipliers: Complexes
    signature: Signature
    events: int

    @cached_property
    def stable(self) -> bool:
        """Whether neighbouring motions approach it: all multipliers lie inside the unit circle."""
        return bool((abs(self.multipliers) < 1.0 - NEUTRAL).all())


@dataclass(frozen=True, eq=False)
class Branch:
    """A branch of periodic orbits."""

    points: tuple[BranchPoint, ...]  # The orbits, in the order in which they were followed
    special: tuple[SpecialPoint, ...]  # The special points, in the same order
    reason: BranchEnd  # Why the branch ends
    message: str  # The same as a sentence, with the value at which it ends
    # Branches that part from this one at period doubling and symmetry breaking, and those that it joins there
    branches: tuple[Branch, ...] = ()
    # The special point at which this one parts from another; None if it was begun by itself
    parted: SpecialPoint | None = None
    # How often the passage is doubled where the branch begins; once less, perhaps, where it has gone on along
    # the symmetric branch
    doublings: int = 0

    @property
    def success(self) -> bool:
        """Whether it was followed to an end of the interval, around, or to one that it joins."""
        return self.reason.is_success
