"""What a branch is followed of: the map of a state to the state a period later, over one number."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from trimmer.arrays import Reals
from trimmer.branches.period_maps.strobe import Restart
from trimmer.motion.part import Phase

Signature = Mapping[tuple[str, Phase], int]
"""How many phases of each kind begin in each part, by name, during a passage."""


class Passage(Protocol):
    """The motion from a state over one period.

    Attributes:
        end: State at the end, shape (n,).
        jacobian: Derivative of ``end`` by the state, all changes of phase included, n x n.
        monodromy: The matrix whose eigenvalues are the multipliers, n x n: ``jacobian``, unless the period is
            a part of the state.
        sizes: Magnitude of each entry over the passage, positive where the entry ever moves, shape (n,).
        signature: The phases that begin in it.
        events: Number of events.
        grazed: Names of the rigid walls that are touched without speed.
        is_linear: Whether nothing but one linear mode of what nothing drives is met: a center.
        middle: End of its first half, if the passage is one of a doubled map, shape (n,); None otherwise.
    """

    @property
    def end(self) -> Reals: ...  # noqa: D102

    @property
    def jacobian(self) -> Reals: ...  # noqa: D102

    @property
    def monodromy(self) -> Reals: ...  # noqa: D102

    @property
    def sizes(self) -> Reals: ...  # noqa: D102

    @property
    def signature(self) -> Signature: ...  # noqa: D102

    @property
    def events(self) -> int: ...  # noqa: D102

    @property
    def grazed(self) -> tuple[str, ...]: ...  # noqa: D102

    @property
    def is_linear(self) -> bool: ...  # noqa: D102

    @property
    def middle(self) -> Reals | None: ...  # noqa: D102

    def shortest(self, part: str, phase: Phase) -> float:
        """Return how long the shortest phase of a kind lasts, or pauses, s; not finite if it is not known."""
        ...

    def opens(self, part: str, phase: Phase) -> bool:
        """Say whether the shortest of them is a pause, in which a contact opens or what sticks slips."""
        ...

    def rate(self) -> Reals:
        """Return the derivative of ``end`` by the number that is varied, shape (n,)."""
        ...

    def strobed(self, state: Reals) -> Reals:
        """Return the state at the start of a drive period, (n,), from that at which the passage begins."""
        ...

    def restart(self, tangent: Reals) -> Restart | None:
        """Return the orbit as one that had better be followed, from another instant; None as it is.

        Args:
            tangent: Direction of the branch, shape (n + 1,), in the units of the state and the value.
        """
        ...


class PeriodMap(Protocol):
    """A continuous, piecewise smooth map of n states, whose fixed points are the orbits.

    Attributes:
        size: Number n of states.
        mirrored: Whether a passage is half a period and its end is taken with changed signs, so that the
            fixed points are the orbits with x(t + T/2) = -x(t).
        doublings: How often it was doubled.
        single: The map of which this is two passages; None if it was not doubled.
    """

    @property
    def size(self) -> int: ...  # noqa: D102

    @property
    def mirrored(self) -> bool: ...  # noqa: D102

    @property
    def doublings(self) -> int: ...  # noqa: D102

    @property
    def single(self) -> PeriodMap | None: ...  # noqa: D102

    def doubled(self) -> PeriodMap:
        """Return the map of two passages; that of a mirrored map is a whole period without mirror."""
        ...

    def passage(self, value: float, state: Reals) -> Passage:
        """Follow the motion from a state, shape (n,), with a value of the number that is varied.

        Raises:
            TrimmerError: if the motion cannot be followed.
        """
        ...

    def phases(self, value: float, state: Reals) -> list[Reals]:
        """Return the states of an orbit at which a passage of this map may begin.

        Args:
            value: Value of the number that is varied.
            state: State at the start of a drive period, shape (n,); any of an orbit without a drive.
        """
        ...
