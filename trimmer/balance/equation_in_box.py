"""The equation of harmonic balance on a box of amplitude and frequency, as the search takes it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

if TYPE_CHECKING:
    from trimmer.balance.element_curve import ElementCurve, GainTable
    from trimmer.balance.inverse_response import InverseGain
    from trimmer.balance.vanishing import EmptyInterval


@final
@dataclass(frozen=True)
class EquationInBox:
    """N(u, x) + 1/G(x) = 0 on the box of a table of N.

    Attributes:
        response: 1/G, or the function that takes its place.
        curve: N.
        table: N on a coarse grid.
        smallest_gain: Solutions with |N| below this are not looked for.
        empty: Intervals of x, each between two breaks of the table, that are proven to hold no solution.
    """

    response: InverseGain
    curve: ElementCurve
    table: GainTable
    smallest_gain: float
    empty: tuple[EmptyInterval, ...] = ()
