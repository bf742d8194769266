"""Newton's method for one orbit on a branch, in coordinates without units.

With P the map of a period the unknowns are the state x and the number p, and the equations are P(p, x) = x
and one plane that cuts the branch. P is only piecewise smooth, so each step must bring the miss down; a step
that does not is halved.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.branches.period_map import Passage, PeriodMap, Phase
from trimmer.errors import TrimmerError

MOST_ITERATIONS = 14
MOST_HALVINGS = 4
CLOSED = 1e-9
"""Miss of an orbit that counts as closed where rounding stops Newton, relative to the states' sizes."""
EXACT = 1e-13
"""Miss at which Newton's method stops, since only rounding is left."""
NEARLY = 1e-10
"""Miss below which a step that fails to halve it shows that only rounding is left."""


@dataclass(frozen=True, eq=False)
class Place:
    """A state and a value, with the passage from there. Coordinates are relative to the scale of a problem.

    Attributes:
        position: State and value, shape (n + 1,).
        passage: The motion over a period.
        miss: End minus state, shape (n,).
        slope: Derivative of the miss by the position, n x (n + 1).
    """

    position: Reals
    passage: Passage
    miss: Reals
    slope: Reals

    @cached_property
    def error(self) -> float:
        """Largest miss of an entry."""
        return float(abs(self.miss).max())

    @cached_property
    def multipliers(self) -> Complexes:
        """Eigenvalues of the derivative of the passage's end by its state, shape (n,)."""
        size = len(self.miss)
        return np.asarray(np.linalg.eigvals(self.slope[:, :size] + np.eye(size)), dtype=np.complex128)

    @cached_property
    def signature(self) -> frozenset[tuple[tuple[str, Phase], int]]:
        """The phases that begin during the passage, in a form to compare."""
        return frozenset((key, count) for key, count in self.passage.signature.items() if count)

    def tangent(self, reference: Reals) -> Reals | None:
        """Return the unit tangent, shape (n + 1,), that points along a reference; None if there is no one."""
        unit = np.zeros(len(reference))
        unit[-1] = 1.0
        try:
            tangent = np.linalg.solve(np.vstack([self.slope, reference]), unit)
        except np.linalg.LinAlgError:
            return None
        length = np.linalg.norm(tangent)
        return tangent / length if np.isfinite(length) else None

    def orientation(self, tangent: Reals) -> float:
        """Return the determinant of slope and tangent.

        Its sign is the same all along a branch, even where the slope jumps as at a grazing: the slopes on
        both sides differ by a matrix of rank one that acts along the normal of the border. It changes where
        another branch crosses.
        """
        return float(np.linalg.det(np.vstack([self.slope, tangent])))


@dataclass(frozen=True, eq=False)
class Problem:
    """The orbits of a map, and the scale of their coordinates.

    Attributes:
        map: The map.
        span: Length of the interval of values, in their unit; positive.
        sizes: Scale of each entry of the state, shape (n,).
    """

    map: PeriodMap
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
            rate = passage.rate() / self.sizes * self.span
        except TrimmerError:
            return None
        miss = passage.end / self.sizes - position[:-1]
        inner = passage.jacobian * self.sizes / self.sizes[:, None] - np.eye(len(miss))
        slope = np.column_stack([inner, rate])
        finite = np.isfinite(slope).all() and np.isfinite(miss).all()
        return Place(position, passage, miss, slope) if finite else None

    def rescaled(self, place: Place, sizes: Reals) -> tuple[Problem, Place]:
        """Return the problem and a place of it with other sizes of the states."""
        problem = replace(self, sizes=sizes)
        ratio = self.sizes / sizes
        position, slope = place.position.copy(), place.slope * ratio[:, None]
        position[:-1] *= ratio
        slope[:, :-1] /= ratio
        return problem, Place(position, place.passage, place.miss * ratio, slope)

    def correct(self, guess: Reals, normal: Reals, offset: float) -> Place | None:
        """Solve for the orbit on the plane normal · position = offset; None if Newton's method fails."""
        place = self.place(guess)
        for _ in range(MOST_ITERATIONS):
            if place is None or place.error <= EXACT:
                return place
            following = self._improved(place, normal, offset)
            if following is None or following.error > 0.5 * place.error < 0.5 * NEARLY:
                best = place if following is None or place.error < following.error else following
                return best if best.error <= CLOSED else None
            place = following
        return place if place is not None and place.error <= CLOSED else None

    def _improved(self, place: Place, normal: Reals, offset: float) -> Place | None:
        """Take Newton's step, shortened as long as it does not bring the miss down; None if nothing does."""
        matrix = np.vstack([place.slope, normal])
        gap = np.append(-place.miss, offset - normal @ place.position)
        try:
            correction = np.linalg.solve(matrix, gap)
        except np.linalg.LinAlgError:
            return None
        share = 1.0
        for _ in range(MOST_HALVINGS if place.error > NEARLY else 1):
            trial = self.place(place.position + share * correction)
            if trial is not None and trial.error < place.error:
                return trial
            share *= 0.5
        return None
