"""Where 1/G goes to zero, at a pole of G on the imaginary axis, and N does at the edge of a dead band.

There no box tells their sum from zero, however small. But the phase of either has a limit: that of -1/G at
the pole, that of N at the edge (``trimmer.elements.small_gains``). On an interval of frequency that ends in
the pole -1/G = C d**k exp(r), where d is the distance from the pole, k its order, and r the sum of
±ln(1 ± j d/D) over the other roots, each at D from the pole. It is bounded by
|ln(1 + z) - z| <= |z|**2 / (2 - 2 |z|). The interval holds no solution if bounds of both phases, or of both
sizes, exclude each other for all d in it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.inverse_response import InverseResponse
from trimmer.elements.small_gains import COASTING, LEAST, SmallGains


@dataclass(frozen=True)
class EmptyInterval:
    """An interval of x without a solution; ``least`` bounds |1/G| at the limit that is not the pole."""

    lower: float
    upper: float
    least: float


_HALVINGS = 60  # How far towards a pole an interval is looked for, in octaves

_ROUNDED_SUM = 1e-10  # Relative size of a sum over the roots that may be rounding of these

_ROUNDING = 1e-12  # Angle, rad, below which the limits of the phases of -1/G and N are taken for equal


def poles_on_axis(response: InverseResponse) -> Reals:
    """Return Im s >= 0 of the places on the axis where poles of G outnumber zeros, over the reference."""
    places = np.unique(response.poles[(response.poles.real == 0) & (response.poles.imag >= 0)].imag)
    return np.array([place for place in places if _order(response, place) > 0])


def empty_intervals(
    response: InverseResponse, small: SmallGains, place: float
) -> Iterator[EmptyInterval | None]:
    """Prove that there is no solution next to a pole on the axis, below it and above it.

    Yields for each side at positive frequencies an interval that ends in the pole; None without a proof.
    """
    sides = (1.0,) if place == 0 else (-1.0, 1.0)
    for side in sides:
        neighbourhood = _Neighbourhood.of(response, small, place, side)
        distance = neighbourhood.empty_up_to()
        if distance is None:
            yield None
        else:
            ends = sorted((place, place + side * distance))
            x_lower, x_upper = (_log(end * response.reference) for end in ends)
            yield EmptyInterval(x_lower, x_upper, small.scale * neighbourhood.least_at(distance))


def _log(omega: float) -> float:
    return math.log(omega) if omega > 0 else -math.inf


def _order(response: InverseResponse, place: float) -> int:
    return int(response.exponents[response.roots == 1j * place].sum())


@dataclass(frozen=True)
class _Neighbourhood:
    """One side of a pole on the axis; frequencies and distances are over the reference of the response."""

    place: float  # Im s of the pole
    side: float  # 1 above it, -1 below it
    order: int  # k
    size: float  # |C| over the scale of N
    heading: float  # Phase of C less that of N in the limit, rad
    turns: Complexes  # ±j/D of each other root, with the sign that r has them
    lag: float  # gamma over frequency
    largest: float  # |N| over its scale up to which its phase is known
    small: SmallGains  # What is known of that phase

    @classmethod
    def of(cls, response: InverseResponse, small: SmallGains, place: float, side: float) -> _Neighbourhood:
        """Take the factors of 1/G apart."""
        others = response.roots != 1j * place
        apart, exponents = 1j * place - response.roots[others], response.exponents[others]
        order = _order(response, place)
        factor = -response.gain * (1j * side) ** order * np.prod(apart**exponents)
        heading = float(np.angle(factor / small.direction))
        return cls(
            place,
            side,
            order,
            float(abs(factor)) / small.scale,
            0.0 if abs(heading) < _ROUNDING else heading,
            exponents * 1j * side / apart,
            small.lag * response.reference,
            small.reach,
            small,
        )

    def empty_up_to(self) -> float | None:
        """Find a distance within which there is no solution."""
        sizes = np.abs(self.turns)
        limits = [0.5 / sizes.max()] if sizes.size else []
        limits += [0.5 * self.place] if self.place > 0 else []
        limits += [(self.largest / self.size) ** (1.0 / self.order)] if 0 < self.size < math.inf else []
        distance = min(limits, default=0.0)
        distance = 1.0 if distance == math.inf else distance
        for _ in range(_HALVINGS):
            if not 0 < distance < math.inf:
                return None
            if self._is_empty(distance):
                return float(distance)
            distance *= 0.5
        return None

    def least_at(self, distance: float) -> float:
        """Lower bound of |1/G| at a distance, over the scale of N."""
        growth, _ = self._growth(distance)
        return self.size * distance**self.order * math.exp(-growth)

    def _growth(self, distance: float) -> tuple[float, float]:
        """Bounds of |r|, and of |r| less its part that is linear in the distance, up to a distance."""
        reach = np.abs(self.turns) * distance
        remainder = float((reach**2 / (2.0 - 2.0 * reach)).sum() + _ROUNDED_SUM * reach.sum())
        return float(reach.sum()) + remainder, remainder

    def _is_empty(self, distance: float) -> bool:
        """Whether there is no solution up to a distance; each bound that holds there holds nearer too."""
        growth, remainder = self._growth(distance)
        smallest = self.least_at(distance)
        largest = smallest * math.exp(2.0 * growth)
        if largest > self.largest:
            return False
        if largest < self._least_gain(distance):
            return True
        steepest, behind = self.small.steepest * math.sqrt(largest), self.small.behind * largest
        trend = float(self.turns.imag.sum()) * distance
        lowest, highest = self.heading + trend - remainder, self.heading + trend + remainder
        if self.heading != 0:
            lowest, highest = min(lowest, self.heading - remainder), max(highest, self.heading + remainder)
        # The phase of -1/G is on one side of that of N, and with many roots does not come round to the other.
        within_a_turn = lowest > steepest - 2.0 * math.pi
        behind_it = highest < -behind and within_a_turn
        before_it = steepest < lowest and highest < 2.0 * math.pi - behind
        if self.heading != 0:
            return behind_it or before_it
        if behind_it or (before_it and (self.order >= 2 or steepest == 0)):
            return True
        if highest == 0 and self.lag == 0 and self.small.gentlest > 0:
            return True
        return (
            self.small.gentlest > 0  # else N may be behind its direction
            and self.order <= 2
            and self._is_decided(distance, smallest)
            and highest < self.small.gentlest * math.sqrt(smallest)
            and within_a_turn
        )

    def _least_gain(self, distance: float) -> float:
        """Lower bound of |N| that stays above |1/G| as the distance gets smaller; 0 if there is none."""
        if self.place == 0 and self.order < 2:
            return 0.0
        nearest = self.place + min(self.side, 0.0) * distance if self.place > 0 else distance
        return min(LEAST * (self.lag * nearest) ** 2, self.largest)

    def _is_decided(self, distance: float, smallest: float) -> bool:
        """Whether N is large enough beside gamma for the lower bound of its phase, as near as can be."""
        if self.lag == 0:
            return True
        return self.place == 0 and smallest >= COASTING * (self.lag * distance) ** 2
