"""Frequencies outside of which no limit cycle of an element with bounded N can exist."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.element_curve import GainDisks
    from trimmer.balance.inverse_response import InverseResponse

_OCTAVES = 200
"""How far from the roots of G a bound is looked for."""


def highest_omega(response: InverseResponse, largest_gain: float) -> float | None:
    """Find omega, rad/s, above which |G| < 1/largest_gain; None if there is none.

    |1/G| >= |gain| omega**r prod(1 - |p|/omega) / prod(1 + |z|/omega), which rises with omega beyond the
    poles.
    """
    poles, zeros = _magnitudes(response)
    omega = 2.0 * max(poles.max(initial=0.0), zeros.max(initial=0.0), 0.5)
    for _ in range(_OCTAVES):
        bound = (omega**response.relative_degree) * np.prod(1 - poles / omega) / np.prod(1 + zeros / omega)
        if abs(response.gain) * bound > largest_gain:
            return float(omega * response.reference)
        omega *= 2.0
    return None


def lowest_omega(
    response: InverseResponse, gains: GainDisks, smallest_gain: float, start: float = math.inf
) -> float | None:
    """Find omega, rad/s, below which there is no solution with |N| >= smallest_gain; None if there is none.

    Args:
        response: 1/G.
        gains: Disks that together hold N at these frequencies.
        smallest_gain: Smallest |N| that is looked for.
        start: Largest omega/reference to consider.
    """
    poles, zeros = (each[each > 0] for each in _magnitudes(response))
    away = response.roots != 0
    static = response.gain * np.prod((-response.roots[away]) ** response.exponents[away])
    order = response.order_at_zero
    largest = float((np.abs(gains.centre) + gains.radius).max())
    omega = min(0.5 * poles.min(initial=1.0), 0.5 * zeros.min(initial=1.0), start)
    for _ in range(_OCTAVES):
        growth = math.exp(-np.log1p(-omega / np.concatenate([poles, zeros])).sum()) - 1.0
        leading = abs(static) * omega**order
        if order == 0:
            excluded = bool(np.all(np.abs(gains.centre + static) > gains.radius + leading * growth))
        elif order > 0:
            excluded = leading * (1.0 + growth) < smallest_gain
        else:
            excluded = leading / (1.0 + growth) > largest
        if excluded:
            return float(omega * response.reference)
        omega /= 2.0
    return None


def _magnitudes(response: InverseResponse) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    sizes = np.abs(response.roots)
    is_pole = response.exponents > 0
    return sizes[is_pole], sizes[~is_pole]
