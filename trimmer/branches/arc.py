"""A short piece of a branch, on which orbits are found by how far they are along a direction."""

import itertools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy.optimize

from trimmer.arrays import Reals, norm
from trimmer.branches.orbit import Place, Problem

NARROWEST = 1e-13  # Distance along the branch, in its coordinates without units, to which a point is located
STEEPEST = 4.0  # How much steeper than its chord a smooth curve may be on a part of it
APART = 1e-7  # Distance of orbits that rounding can bring about where slope and plane are all but singular
ROUNDING = 4.0 * float(np.finfo(float).eps)


class LostError(Exception):
    """No orbit was found on an arc where one must be, or one that does not belong to it."""


@dataclass(frozen=True, eq=False)
class Arc:
    """The piece of a branch beyond a point, seen along a direction."""

    problem: Problem  # The orbits and their scale
    origin: Reals  # Coordinates of the point, shape (n + 1,)
    direction: Reals  # A unit vector, shape (n + 1,)

    def distance(self, place: Place) -> float:
        """Return how far a place is along the direction."""
        return float(self.direction @ (place.position - self.origin))

    @property
    def narrowest(self) -> float:
        """Return the least distance that rounding leaves."""
        return max(NARROWEST, ROUNDING * float(abs(self.origin).max()))

    def predicted(self, place: Place, distance: float) -> Reals:
        """Return the coordinates at a distance on the tangent of a place, or straight on if it has none."""
        tangent = place.tangent(self.direction)
        ahead = self.direction if tangent is None else tangent / (tangent @ self.direction)
        return place.position + (distance - self.distance(place)) * ahead

    def at(self, distance: float, guess: Reals) -> Place | None:
        """Find the orbit at a distance from a guess, shape (n + 1,); None if Newton's method fails."""
        offset = float(self.direction @ self.origin) + distance
        return self.problem.correct(guess, self.direction, offset)

    def between(self, distance: float, left: Place, right: Place) -> Place | None:
        """Find the orbit at a distance between two orbits; None if there is none near."""
        first, last = self.distance(left), self.distance(right)
        share = (distance - first) / (last - first)
        place = self.at(distance, left.position + share * (right.position - left.position))
        for neighbour in (left, right):
            if place is None:
                place = self.at(distance, self.predicted(neighbour, distance))
        return place

    def smooth(self, distance: float, left: Place, right: Place) -> Place:
        """Find the orbit at a distance on the smooth curve between two orbits.

        Raises:
            LostError: if none is found, or if its phases are not those of both.
        """
        place = self.between(distance, left, right)
        if place is None or place.signature != left.signature:
            raise LostError
        return place

    def root(self, function: Callable[[Place], float], left: Place, right: Place) -> Place:
        """Find the orbit where a function changes its sign between two orbits on a smooth curve.

        Raises:
            LostError: if an orbit between them is not found.
        """
        known = {self.distance(left): left, self.distance(right): right}

        def at(distance: float) -> Place:
            if distance not in known:
                before = max(each for each in known if each < distance)
                after = min(each for each in known if each > distance)
                known[distance] = self.smooth(distance, known[before], known[after])
            return known[distance]

        first, last = known
        root = at(
            scipy.optimize.brentq(
                lambda distance: function(at(distance)),
                first,
                last,
                xtol=self.narrowest,
                rtol=ROUNDING,
                disp=False,
            )
        )
        self._check_joined([known[each] for each in sorted(known)])
        return root

    def _check_joined(self, places: list[Place]) -> None:
        """Check that neighbours among places on a smooth curve are no farther apart than their distances say.

        Raises:
            LostError: if some are: between them the places have jumped to another curve.
        """
        chord = places[-1].position - places[0].position
        steepness = STEEPEST * float(norm(chord) / (self.direction @ chord))
        for left, right in itertools.pairwise(places):
            ahead = self.distance(right) - self.distance(left)
            apart = norm(right.position - left.position)
            if apart > steepness * ahead + APART:
                raise LostError
