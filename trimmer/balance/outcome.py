"""What both ways of solving hand on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trimmer.balance.search import SearchResult


@dataclass(frozen=True)
class Outcome:
    """Solutions in u and x, and where they were looked for.

    Attributes:
        method: How, in words.
        result: What was found.
        omegas: Range of angular frequency, rad/s.
        outside_excluded: Whether it is proven that there are none outside that range.
        smallest_gain: |N| below which none were looked for; 0 if it is proven that there are none either.
    """

    method: str
    result: SearchResult
    omegas: tuple[float, float]
    outside_excluded: bool
    smallest_gain: float
