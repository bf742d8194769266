"""Undecided boxes put together into regions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.limit_cycle import UndecidedRegion

if TYPE_CHECKING:
    from trimmer.balance.cells import Cells
    from trimmer.balance.element_curve import ElementCurve

_TOUCHING = 1e-9
"""Gap in x below which two boxes belong together."""


def undecided_regions(cells: Cells, curve: ElementCurve) -> tuple[UndecidedRegion, ...]:
    """Join boxes whose ranges of x touch, and give the range of amplitude and frequency of each group."""
    if len(cells) == 0:
        return ()
    order = np.argsort(cells.x_lower)
    reached = np.maximum.accumulate(cells.x_upper[order])
    starts = np.flatnonzero(cells.x_lower[order][1:] > reached[:-1] + _TOUCHING) + 1
    regions = []
    for group in np.split(order, starts):
        members = cells.take(group)
        largest, smallest = members.u_upper.max(), members.u_lower.min()
        amplitudes = (float(curve.amplitude(largest)), _amplitude_of_lowest(curve, float(smallest)))
        omegas = (float(np.exp(members.x_lower.min())), float(np.exp(members.x_upper.max())))
        regions.append(UndecidedRegion(amplitudes, omegas))
    return tuple(regions)


def _amplitude_of_lowest(curve: ElementCurve, u: float) -> float:
    return float(curve.amplitude(np.asarray(u))) if u > 0 else float("inf")
