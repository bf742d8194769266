"""Newton's method for one orbit on a branch, in coordinates without units.

With P the map of a period the unknowns are the state x and the number p, and the equations are P(p, x) = x
and one plane that cuts the branch. P is only piecewise smooth, so each step must bring the miss down; a step
that does not is halved.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import numpy as np

from trimmer.arrays import Complexes, Places, Reals, norm
from trimmer.branches.null_vector import normal_to
from trimmer.branches.period_maps.driven_map import DrivenMap
from trimmer.branches.period_maps.driven_passage import DrivenPassage
from trimmer.errors import TrimmerError
from trimmer.kept_property import cached_property
from trimmer.motion.part import Phase

MOST_ITERATIONS = 14
MOST_HALVINGS = 4
CLOSED = 3e-12
"""Miss of an orbit that counts as closed where rounding stops Newton, relative to the states' sizes."""
EXACT = 1e-13
"""Miss at which Newton's method stops, since only rounding is left."""
ON_PLANE = 1e-14
"""Distance from a plane within which a position lies on it."""


@cache
def pairs(count: int) -> tuple[Places, Places]:
    """Return the first and the second places of all pairs out of a number of multipliers."""
    first, second = np.triu_indices(count, 1)
    return first, second


@dataclass(frozen=True, eq=False)
class Place:
    """A state and a value, with the passage from there. Coordinates are relative to the scale of a problem.

    Attributes:
        problem: The problem.
        position: State and value, shape (n + 1,).
        passage: The motion over a period.
        known: The same place in another scale; None if there is none.
    """

    problem: Problem
    position: Reals
    passage: DrivenPassage
    known: Place | None = None

    @property
    def value(self) -> float:
        """Value of the number, in its unit."""
        return self.problem.value(self.position)

    @property
    def strobed(self) -> Reals:
        """State at the start of a drive period, shape (n,), in its units."""
        return self.passage.strobed(self.problem.state(self.position))

    @cached_property
    def miss(self) -> Reals:
        """End minus state, shape (n,)."""
        miss: Reals = self.passage.end / self.problem.sizes - self.position[:-1]
        return miss

    @cached_property
    def error(self) -> float:
        """Largest miss of an entry."""
        return float(abs(self.miss).max())

    @cached_property
    def jacobian(self) -> Reals:
        """Derivative of the end by the state, n x n."""
        sizes = self.problem.sizes
        jacobian: Reals = self.passage.jacobian * sizes / sizes[:, None]
        return jacobian

    @cached_property
    def slope(self) -> Reals:
        """Derivative of the miss by the position, n x (n + 1)."""
        rate = self.passage.rate / self.problem.sizes * self.problem.span
        return np.column_stack([self.jacobian - np.eye(len(self.miss)), rate])

    @cached_property
    def monodromy(self) -> Reals:
        """The matrix whose eigenvalues are the multipliers, n x n."""
        sizes = self.problem.sizes
        monodromy: Reals = self.passage.monodromy * sizes / sizes[:, None]
        return monodromy

    @cached_property
    def multipliers(self) -> Complexes:
        """Multipliers of the passage, shape (n,); they are the same in any scale."""
        if self.known is not None:
            return self.known.multipliers
        return np.asarray(np.linalg.eigvals(self.monodromy), dtype=np.complex128)

    @cached_property
    def signature(self) -> frozenset[tuple[tuple[str, Phase], int]]:
        """The phases that begin during the passage, in a form to compare."""
        return frozenset((key, count) for key, count in self.passage.signature.items() if count)

    @cached_property
    def along(self) -> tuple[Reals, float] | None:
        """A unit vector along the branch, (n + 1,), and the determinant of slope and it; None if singular."""
        if self.known is not None:
            return self._rescaled(self.known)
        try:
            along, turn = normal_to(self.slope)
        except TrimmerError:
            return None
        return (along, turn) if turn and math.isfinite(turn) else None

    def _rescaled(self, known: Place) -> tuple[Reals, float] | None:
        """Return the unit vector along the branch, and the determinant, of the same place in another scale.

        What scales the rows of the slope scales its columns inversely, so that only the length counts.
        """
        if known.along is None:
            return None
        along, turn = known.along
        along = along.copy()
        along[:-1] *= known.problem.sizes / self.problem.sizes
        length = norm(along)
        return along / length, turn * length

    def tangent(self, reference: Reals) -> Reals | None:
        """Return the unit tangent, shape (n + 1,), that points along a reference; None if there is no one."""
        if self.along is None:
            return None
        along, _ = self.along
        ahead = float(along @ reference)
        return along * math.copysign(1.0, ahead) if ahead else None

    def tests(self, reference: Reals) -> tuple[float, float, float, float] | None:
        """Return the last entry of the tangent, ``doubling``, ``orientation`` and ``torus``."""
        if self.along is None:
            return None
        ahead, (last, turned) = float(self.along[0] @ reference), self._turned
        sign = math.copysign(1.0, ahead)
        return (sign * last, self.doubling, sign * turned, self.torus) if ahead else None

    @cached_property
    def _turned(self) -> tuple[float, float]:
        """Last entry of the vector along the branch, and the determinant of slope and it, if there is one."""
        along, turn = self.along or (np.zeros(1), 0.0)
        return float(along[-1]), float(along @ along) * turn

    @cached_property
    def doubling(self) -> float:
        """Product of all multipliers plus 1, which changes its sign where a period doubles."""
        if self.known is not None:
            return self.known.doubling
        return float(np.multiply.reduce(self.multipliers + 1.0).real)

    @cached_property
    def products(self) -> Complexes:
        """Products of all pairs of multipliers; one of them is 1 where a pair crosses the circle."""
        first, second = pairs(len(self.multipliers))
        products: Complexes = self.multipliers[first] * self.multipliers[second]
        return products

    @cached_property
    def torus(self) -> float:
        """Product of all of them less 1."""
        if self.known is not None:
            return self.known.torus
        return float(np.multiply.reduce(self.products - 1.0).real)

    def orientation(self, tangent: Reals) -> float:
        """Return the determinant of slope and tangent.

        Its sign is the same all along a branch, even where the slope jumps as at a grazing: the slopes on
        both sides differ by a matrix of rank one that acts along the normal of the border. It changes where
        another branch crosses.
        """
        # What the tangent has of the rows of the slope adds nothing to it.
        along, turn = self.along or (tangent, 0.0)
        return float(along @ tangent) * turn

    def correction(self, normal: Reals, offset: float) -> Reals | None:
        """Return Newton's step to the plane normal · position = offset, shape (n + 1,); None if singular.

        On a plane of one value the derivative by the value is not needed, which costs as much as a passage.
        """
        ahead = offset - normal @ self.position
        try:
            if normal[:-1].any():
                correction = np.linalg.solve(np.vstack([self.slope, normal]), np.append(-self.miss, ahead))
            else:
                step = ahead / normal[-1]
                rest = -self.miss - (self.slope[:, -1] * step if abs(step) > ON_PLANE else 0.0)
                correction = np.append(np.linalg.solve(self.jacobian - np.eye(len(rest)), rest), step)
        except (np.linalg.LinAlgError, TrimmerError):
            return None
        return correction if np.isfinite(correction).all() else None


@dataclass(frozen=True, eq=False)
class Problem:
    """The orbits of a map, and the scale of their coordinates.

    Attributes:
        map: The map.
        span: Length of the interval of values, in their unit; positive.
        sizes: Scale of each entry of the state, shape (n,).
    """

    map: DrivenMap
    span: float
    sizes: Reals

    def position(self, value: float, state: Reals) -> Reals:
        """Return the coordinates of a state, shape (n,), and a value."""
        return np.append(state / self.sizes, value / self.span)

    def value(self, position: Reals) -> float:
        """Return the value of coordinates, in its unit."""
        return float(position[-1]) * self.span

    def state(self, position: Reals) -> Reals:
        """Return the state of coordinates, shape (n,), in its units."""
        return position[:-1] * self.sizes

    def place(self, position: Reals) -> Place | None:
        """Follow the motion from coordinates; None if it cannot be followed."""
        try:
            passage = self.map.passage(self.value(position), self.state(position))
        except TrimmerError:
            return None
        place = Place(self, position, passage)
        return place if math.isfinite(place.error) and math.isfinite(place.jacobian.sum()) else None

    def adopted(self, place: Place) -> Place:
        """Return a place of the same problem with other sizes of the states as one of this problem."""
        position = place.position.copy()
        position[:-1] *= place.problem.sizes / self.sizes
        return Place(self, position, place.passage, place.known or place)

    def correct(self, guess: Reals, normal: Reals, offset: float) -> Place | None:
        """Solve for the orbit on the plane normal · position = offset; None if Newton's method fails."""
        place = self.place(guess)
        if place is None:
            return None
        for _ in range(MOST_ITERATIONS):
            following = self._improved(place, normal, offset) if place.error > EXACT else None
            if following is None:
                break
            place, before = following, place
            if place.error > 0.5 * before.error < 0.5 * CLOSED:
                break
        return place if place.error <= CLOSED else None

    def _improved(self, place: Place, normal: Reals, offset: float) -> Place | None:
        """Take Newton's step, shortened as long as it does not bring the miss down; None if nothing does."""
        correction = place.correction(normal, offset)
        if correction is None:
            return None
        share = 1.0
        for _ in range(MOST_HALVINGS if place.error > CLOSED else 1):
            trial = self.place(place.position + share * correction)
            if trial is not None and trial.error < place.error:
                return trial
            share *= 0.5
        return None
