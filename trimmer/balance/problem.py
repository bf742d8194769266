"""What is searched for limit cycles, as all steps of the search need it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.gain_table import GainTable
    from trimmer.balance.response import Response


@dataclass(frozen=True)
class Problem:
    """N(u, x) + 1/G(x) = 0 on the box of a table of N.

    Attributes:
        response: 1/G, or what stands for it.
        curve: N.
        table: N on a coarse grid.
        smallest_gain: Solutions with |N| below this are not looked for.
    """

    response: Response
    curve: ElementCurve
    table: GainTable
    smallest_gain: float
