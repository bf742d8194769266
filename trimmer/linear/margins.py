"""Margins of a loop 1 + L = 0 from its frequency response, and what of its motion neither dies nor grows."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import scipy.optimize

from trimmer.arrays import Complexes, Reals

NULL = 1e-12  # Singular value over the largest entry up to which a balanced matrix has a null vector
TAKES_PART = 1e-6  # Share of the largest entry of null vectors from which on a state takes part in them


SMALLEST = 1e-9
"""Factor of the gain down to which there are limits, and one over it up to which.

At a pole on the axis it would be 0; at a zero infinite, as at half the sampling rate by Tustin's rule.
"""


class Margin(NamedTuple):
    """A margin and the angular frequency at which it is, rad/s; NaN where there is none."""

    value: float
    omega: float


@dataclass(frozen=True)
class Margins:
    """How far a loop is from -1."""

    # Largest factor below 1 of the gain at which the closed loop is at its limit; 0 if there is none
    lower_gain: Margin
    upper_gain: Margin  # The least one above 1; infinite if there is none
    phase: Margin  # Least phase that may be lost, or won if it is negative, rad; infinite if there is none
    modulus: Margin  # Least distance of L from -1

    @property
    def gain(self) -> Margin:
        """The one of both gain margins that is nearer to 1; infinite if there is none."""
        if self.lower_gain.value * self.upper_gain.value > 1.0:
            return self.lower_gain
        return self.upper_gain


def margins_of(ratio: Callable[[float], complex], omegas: Reals, ends: Sequence[float]) -> Margins:
    """Find the margins of L(omega), which crosses an axis at most once between rising omegas, rad/s.

    At the ends L is real, beside crossings: 0, and half the sampling rate.
    """
    values = np.array([ratio(omega) for omega in omegas])
    real = [*_crossings(omegas, values.imag, lambda omega: ratio(omega).imag), *ends]
    at_limit = [
        Margin(-1.0 / place.real, omega)
        for omega, place in ((omega, ratio(omega)) for omega in real)
        if -1.0 / SMALLEST < place.real < -SMALLEST
    ]
    sizes = np.hypot(values.real, values.imag)
    phases = [
        Margin(math.remainder(math.pi + float(np.angle(ratio(omega))), math.tau), omega)
        for omega in _crossings(omegas, sizes - 1.0, lambda omega: abs(ratio(omega)) - 1.0)
    ]
    below = [each for each in at_limit if each.value <= 1.0]
    above = [each for each in at_limit if each.value > 1.0]
    return Margins(
        max(below, default=Margin(0.0, math.nan)),
        min(above, default=Margin(math.inf, math.nan)),
        min(phases, key=lambda each: abs(each.value), default=Margin(math.inf, math.nan)),
        _nearest(ratio, omegas, values),
    )


def _nearest(ratio: Callable[[float], complex], omegas: Reals, values: Complexes) -> Margin:
    place = int(np.argmin(abs(1.0 + values)))
    low, high = omegas[max(place - 1, 0)], omegas[min(place + 1, len(omegas) - 1)]
    least = scipy.optimize.minimize_scalar(
        lambda omega: abs(1.0 + ratio(omega)),
        bounds=(low, high),
        method="bounded",
        options={"xatol": 1e-10 * high},
    )
    return Margin(float(least.fun), float(least.x))


def _crossings(omegas: Reals, values: Reals, function: Callable[[float], float]) -> Iterator[float]:
    for place in np.flatnonzero(np.sign(values[1:]) * np.sign(values[:-1]) < 0):
        low, high = omegas[place], omegas[place + 1]
        yield float(scipy.optimize.brentq(function, low, high, xtol=1e-14 * high, rtol=1e-14))


@dataclass(frozen=True, eq=False)
class StandingStates:
    """What of x' = A x, or of x <- x + A x, neither dies nor grows like an exponential."""

    free: tuple[int, ...]  # States that may have any value, for ever
    running: tuple[int, ...]  # States that grow with a power of the time
    rest: Reals  # A without all that, which has no eigenvalue 0, (m, m)


def standing_states(matrix: Reals) -> StandingStates:
    """Part the null space of a balanced matrix, (n, n), and what leads into it, from the rest.

    A step takes the null space out; what A then maps into it is the null space of what is left, and so on
    (a staircase). So no power of A is formed, in which slow states would vanish.
    """
    size, left, turned = float(np.abs(matrix).max(initial=0.0)), matrix, np.eye(len(matrix))
    basis = np.zeros((len(matrix), 0))
    while len(left):
        _, values, rows = np.linalg.svd(left)
        count = int((values <= NULL * size).sum())
        if not count:
            break
        kept, taken = rows[: len(rows) - count].T, rows[len(rows) - count :].T
        basis, turned = np.hstack([basis, turned @ taken]), turned @ kept
        left = kept.T @ left @ kept
    grows = _taking_part(matrix @ basis, NULL * size)
    return StandingStates(tuple(sorted(_taking_part(basis, 0.0) - grows)), tuple(sorted(grows)), left)


def _taking_part(vectors: Reals, least: float) -> set[int]:
    sizes = np.abs(vectors).max(axis=1, initial=0.0)
    return set(np.flatnonzero(sizes > max(least, TAKES_PART * sizes.max(initial=0.0))).tolist())
