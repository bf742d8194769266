"""Limit cycles where N is bounded, as for backlash: search in the whole plane of amplitude and frequency."""

import math

import numpy as np

from trimmer.arrays import Reals
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve, GainTable
from trimmer.balance.exclusion import EquationInBox
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.loop import range_of_roots
from trimmer.balance.search import SearchedRegion, SearchResult, find_all
from trimmer.balance.vanishing import EmptyInterval, empty_intervals, poles_on_axis

SMALLEST_GAIN = 1e-10
"""|N| over its maximum below which no solution is looked for, if G has a pole on the imaginary axis next to
which nothing is proven."""

FINEST_GAIN = 1e-13  # The same, if something is proven only closer to the pole than doubles tell N from 0

_BESIDE_ROOTS = 2.0  # How far the blocks of the table go beyond the roots of G, in x

_BESIDE_SOLUTIONS = 0.5  # How far the range that is reported goes beyond what was found, in x

_GROWING = 2.0 ** np.arange(1, 8) - 1.0
"""Limits of the blocks beyond, each twice as wide as the one before: 55 decades on either side."""

_SMALL = 1e-4  # |1/G| over the largest |N| from which on the search needs no proof about a pole at the origin

_METHOD = "exclusion, and test of uniqueness, on boxes of amplitude and frequency"


def solve_bounded(
    response: InverseResponse, curve: ElementCurve, omega_range: tuple[float, float] | None
) -> SearchedRegion:
    """Find all solutions where N is bounded; ``omega_range`` in rad/s, all frequencies if None."""
    roots = range_of_roots(response, _BESIDE_ROOTS)
    if omega_range is None:
        breaks = np.concatenate([roots[0] - _GROWING[::-1], response.breaks(*roots), roots[1] + _GROWING])
    else:
        breaks = response.breaks(math.log(omega_range[0]), math.log(omega_range[1]))
    next_to_poles = _next_to_poles(response, curve, breaks)
    empty = tuple(filter(None, next_to_poles))
    table = GainTable.of(curve, _cut(breaks, empty) if empty else breaks)
    smallest_gain = _smallest_gain(next_to_poles, table)
    result = find_all(EquationInBox(response, curve, table, smallest_gain, empty))
    omegas = omega_range or _range_with_all(result, roots)
    return SearchedRegion(_METHOD, result, omegas, omega_range is None, smallest_gain)


def _range_with_all(result: SearchResult, roots: tuple[float, float]) -> tuple[float, float]:
    """Angular frequencies, rad/s, of the roots of G and of all that was found; nothing is beyond them."""
    found = np.concatenate([result.x, result.undecided.x_lower, result.undecided.x_upper])
    lowest = min(roots[0], float(found.min(initial=math.inf)) - _BESIDE_SOLUTIONS)
    highest = max(roots[1], float(found.max(initial=-math.inf)) + _BESIDE_SOLUTIONS)
    return math.exp(lowest), math.exp(highest)


def _next_to_poles(
    response: InverseResponse, curve: ElementCurve, breaks: Reals
) -> list[EmptyInterval | None]:
    """Find intervals next to the poles on the axis that hold no solution; None where that is not proven."""
    places = poles_on_axis(response)
    if places.size == 0:
        return []
    with np.errstate(divide="ignore"):
        x = np.log(places * response.reference)
    inside = (x >= breaks[0]) & (x <= breaks[-1])
    # ln omega never gets to a pole at the origin, but maybe so near that 1/G is too small for the search.
    small_response = abs(response.value(breaks[:1])[0]) < _SMALL * _rough_gain(curve, breaks)
    near = places[inside | ((places == 0) & small_response)]
    small = curve.element.small_gains()
    if small is None:
        return [None] * near.size
    return [interval for place in near for interval in empty_intervals(response, small, place)]


def _rough_gain(curve: ElementCurve, breaks: Reals) -> float:
    """Upper bound of |N|."""
    u_upper = curve.edge(breaks[[0, -1]]).max(keepdims=True)
    with np.errstate(all="ignore"):
        disk = curve.disks(Cells(np.zeros(1), np.atleast_1d(u_upper), breaks[:1], breaks[-1:]))
    return float(np.abs(disk.centre[0]) + disk.radius[0])


def _cut(breaks: Reals, empty: tuple[EmptyInterval, ...]) -> Reals:
    """Add the ends of intervals to the breaks, and leave out those beside the origin."""
    ends = np.array([end for interval in empty for end in (interval.lower, interval.upper)])
    lowest = max((each.upper for each in empty if each.lower == -math.inf), default=-math.inf)
    everything = np.union1d(breaks, np.clip(ends, breaks[0], breaks[-1]))
    kept = everything[everything >= lowest]
    return kept if kept.size > 1 else everything


def _smallest_gain(next_to_poles: list[EmptyInterval | None], table: GainTable) -> float:
    """|N| below which solutions are not looked for; 0 if all are."""
    if None in next_to_poles:
        smallest_gain = SMALLEST_GAIN * table.largest_gain
        return 0.0 if table.smallest_gain >= smallest_gain else smallest_gain
    finest = FINEST_GAIN * table.largest_gain
    return finest if any(interval and interval.least < finest for interval in next_to_poles) else 0.0
