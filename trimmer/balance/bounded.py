"""Limit cycles where N is bounded, as for backlash: search in the whole plane of amplitude and frequency."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.cells import Cells
from trimmer.balance.errors import FrequencyRangeError
from trimmer.balance.frequency_range import highest_omega, lowest_omega
from trimmer.balance.outcome import Outcome
from trimmer.balance.search import FIRST_ROWS, Problem, SearchLimits, find_all

if TYPE_CHECKING:
    from trimmer.balance.element_curve import ElementCurve, GainDisks
    from trimmer.balance.inverse_response import InverseResponse

SMALLEST_GAIN = 1e-6
"""|N| over its maximum below which no solution is looked for."""

EDGE = 1e-9
"""Relative distance of u from the edge of the domain within which no solution is looked for."""

_COLUMNS = 64
"""Intervals of x on which N is bounded if it depends on x."""

_FAR = 12.0 * math.log(10.0)
"""How far from the roots of G, in x, an element that depends on frequency is examined."""

_METHOD = "exclusion, and test of uniqueness, on boxes of amplitude and frequency"


def solve_bounded(
    response: InverseResponse, curve: ElementCurve, omega_range: tuple[float, float] | None
) -> Outcome:
    """Find all solutions with a bounded N.

    Raises:
        FrequencyRangeError: if a range is needed and not given.
    """
    if omega_range is None:
        middle = math.log(response.reference)
        gains = _gains(curve, middle - _FAR, middle + _FAR)
        omegas = _derived_range(response, curve, gains)
    else:
        gains = _gains(curve, math.log(omega_range[0]), math.log(omega_range[1]))
        omegas = omega_range
    x_lower, x_upper = math.log(omegas[0]), math.log(omegas[1])
    largest = _largest(gains)
    limits = SearchLimits(SMALLEST_GAIN * largest, largest)
    box = Cells(*(np.array([side]) for side in (0.0, _u_upper(curve, x_lower, x_upper), x_lower, x_upper)))
    problem = Problem(response, curve, box, limits, None if curve.depends_on_x else gains)
    return Outcome(_METHOD, find_all(problem), omegas, omega_range is None)


def _derived_range(response: InverseResponse, curve: ElementCurve, gains: GainDisks) -> tuple[float, float]:
    """Find a range outside of which there is no solution, given disks that hold all N."""
    largest = _largest(gains)
    highest = highest_omega(response, largest)
    lowest = lowest_omega(response, gains, SMALLEST_GAIN * largest)
    if lowest is None and curve.depends_on_x:
        middle = math.log(response.reference)
        far = _gains(curve, middle - 2.0 * _FAR, middle - _FAR)
        lowest = lowest_omega(response, far, SMALLEST_GAIN * largest, math.exp(-_FAR))
    if lowest is None or highest is None:
        end = "low" if lowest is None else "high"
        raise FrequencyRangeError(
            f"no range of frequencies can be derived: at {end} frequencies nothing excludes a limit cycle "
            f"(|N| reaches up to {largest:.4g}); give omega_range=(lowest, highest), rad/s"
        )
    return lowest, highest


def _gains(curve: ElementCurve, x_lower: float, x_upper: float) -> GainDisks:
    """Disks that together hold all N on a range of x."""
    breaks = np.linspace(x_lower, x_upper, _COLUMNS + 1 if curve.depends_on_x else 2)
    rows = np.linspace(0.0, _u_upper(curve, x_lower, x_upper), FIRST_ROWS + 1)
    disks = curve.disks(Cells.grid(rows, breaks[:-1], breaks[1:]))
    return disks.take(np.flatnonzero(disks.exists))


def _u_upper(curve: ElementCurve, x_lower: float, x_upper: float) -> float:
    """Largest u to search; the edge of the domain rises or falls with x, but not both."""
    return float(curve.edge(np.array([x_lower, x_upper])).max()) * (1.0 - EDGE)


def _largest(disks: GainDisks) -> float:
    return float((np.abs(disks.centre) + disks.radius).max())
