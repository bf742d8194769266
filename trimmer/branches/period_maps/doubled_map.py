"""Two passages as one: the map whose fixed points have twice the period."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.period_maps.period_map import Passage, PeriodMap, Signature
from trimmer.motion.part import Phase


@dataclass(frozen=True, eq=False)
class DoubledPassage:
    """Two passages, the second from the end of the first."""

    first: Passage  # The first
    second: Passage  # The second

    @property
    def end(self) -> Reals:
        """State at the end, shape (n,)."""
        return self.second.end

    @property
    def jacobian(self) -> Reals:
        """Derivative of the end by the state, n x n."""
        return self.second.jacobian @ self.first.jacobian

    @property
    def monodromy(self) -> Reals:
        """The matrix whose eigenvalues are the multipliers, n x n."""
        return self.second.monodromy @ self.first.monodromy

    @property
    def sizes(self) -> Reals:
        """Magnitude of each entry over both passages, shape (n,)."""
        return np.maximum(self.first.sizes, self.second.sizes)

    @property
    def signature(self) -> Signature:
        """The phases that begin in either passage."""
        return Counter(self.first.signature) + Counter(self.second.signature)

    @property
    def events(self) -> int:
        """Number of events."""
        return self.first.events + self.second.events

    @property
    def is_linear(self) -> bool:
        """Whether it is a center of one linear mode."""
        return self.first.is_linear and self.second.is_linear

    @property
    def grazed(self) -> tuple[str, ...]:
        """Names of the rigid walls that are touched without speed in either passage."""
        return tuple(dict.fromkeys((*self.first.grazed, *self.second.grazed)))

    @property
    def middle(self) -> Reals:
        """End of the first passage, shape (n,)."""
        return self.first.end

    def shortest(self, part: str, phase: Phase) -> float:
        """Return how long the shortest phase of a kind lasts, s."""
        return min(self.first.shortest(part, phase), self.second.shortest(part, phase))

    def opens(self, part: str, phase: Phase) -> bool:
        """Say whether the shortest of them is a pause."""
        shorter = min(self.first, self.second, key=lambda each: each.shortest(part, phase))
        return shorter.opens(part, phase)

    def rate(self) -> Reals:
        """Return the derivative of the end by the number that is varied, shape (n,)."""
        return self.second.jacobian @ self.first.rate() + self.second.rate()

    def strobed(self, state: Reals) -> Reals:
        """Return the state at the start of a drive period: that from which it was followed, shape (n,)."""
        return state

    def restart(self, tangent: Reals) -> None:
        """Return nothing: it goes on from where it begins."""


@dataclass(frozen=True, eq=False)
class DoubledMap:
    """The map of two passages. Of a mirrored map it is a whole period, without mirror."""

    single: PeriodMap  # The map of one passage
    mirrored: bool = False

    @property
    def size(self) -> int:
        """Number of states."""
        return self.single.size

    @property
    def doublings(self) -> int:
        """How often the passage is doubled."""
        return self.single.doublings + 1

    def doubled(self) -> DoubledMap:
        """Return the map of two such passages."""
        return DoubledMap(self)

    def passage(self, value: float, state: Reals) -> DoubledPassage:
        """Follow two passages.

        Raises:
            TrimmerError: if one of them cannot be followed.
        """
        first = self.single.passage(value, state)
        return DoubledPassage(first, self.single.passage(value, first.end))

    def phases(self, value: float, state: Reals) -> list[Reals]:
        """Return the states of an orbit at which a passage may begin: the one that is known."""
        return [state]
