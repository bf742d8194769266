"""Limit cycles where N is bounded, as for backlash: search in the whole plane of amplitude and frequency."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.element_curve import GainTable
from trimmer.balance.search import Problem, Searched, find_all

if TYPE_CHECKING:
    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.inverse_response import InverseResponse
    from trimmer.balance.search import SearchResult


SMALLEST_GAIN = 1e-6
"""|N| over its maximum below which no solution is looked for, if G has a pole on the imaginary axis."""

_BESIDE_ROOTS = 2.0
"""How far the blocks of the table go beyond the roots of G, in x."""

_BESIDE_SOLUTIONS = 0.5
"""How far the range that is reported goes beyond what was found, in x."""

_GROWING = 2.0 ** np.arange(1, 8) - 1.0
"""Limits of the blocks beyond, each twice as wide as the one before: 55 decades on either side."""

_METHOD = "exclusion, and test of uniqueness, on boxes of amplitude and frequency"


def solve_bounded(
    response: InverseResponse, curve: ElementCurve, omega_range: tuple[float, float] | None
) -> Searched:
    """Find all solutions where N is bounded; ``omega_range`` in rad/s, all frequencies if None."""
    roots = _range_of_roots(response)
    if omega_range is None:
        breaks = np.concatenate([roots[0] - _GROWING[::-1], response.breaks(*roots), roots[1] + _GROWING])
    else:
        breaks = response.breaks(math.log(omega_range[0]), math.log(omega_range[1]))
    table = GainTable.of(curve, breaks)
    smallest_gain = _smallest_gain(response, table)
    result = find_all(Problem(response, curve, table, smallest_gain))
    omegas = omega_range or _range_with_all(result, roots)
    return Searched(_METHOD, result, omegas, omega_range is None, smallest_gain)


def _range_with_all(result: SearchResult, roots: tuple[float, float]) -> tuple[float, float]:
    """Angular frequencies, rad/s, of the roots of G and of all that was found; nothing is beyond them."""
    found = np.concatenate([result.x, result.undecided.x_lower, result.undecided.x_upper])
    lowest = min(roots[0], float(found.min(initial=math.inf)) - _BESIDE_SOLUTIONS)
    highest = max(roots[1], float(found.max(initial=-math.inf)) + _BESIDE_SOLUTIONS)
    return math.exp(lowest), math.exp(highest)


def _range_of_roots(response: InverseResponse) -> tuple[float, float]:
    """Smallest and largest x of the roots of G, widened by ``_BESIDE_ROOTS`` on either side."""
    sizes = np.abs(response.roots[response.roots != 0]) * response.reference
    lowest, highest = sizes.min(initial=response.reference), sizes.max(initial=response.reference)
    return math.log(lowest) - _BESIDE_ROOTS, math.log(highest) + _BESIDE_ROOTS


def _smallest_gain(response: InverseResponse, table: GainTable) -> float:
    """|N| below which solutions are not looked for; 0 if |G| is bounded or N does not vanish."""
    bounded = not np.any(response.poles.real == 0)
    smallest_gain = SMALLEST_GAIN * table.largest_gain
    return 0.0 if bounded or table.smallest_gain >= smallest_gain else smallest_gain
