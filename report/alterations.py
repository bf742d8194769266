"""Whether the claims would notice a misprint: each printed side is changed on purpose and compared again."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Self, final

from report.claim import Claim, Comparison, Part


@final
@dataclass(frozen=True)
class Alterations:
    """How many printed sides were changed, and how many of the changes were noticed."""

    tried: int = 0
    noticed: int = 0

    def __add__(self, other: Self) -> Self:
        """Return the counts of both together."""
        return type(self)(self.tried + other.tried, self.noticed + other.noticed)


def alter(claims: Iterable[Claim]) -> Alterations:
    """Change the printed side of every part that can be checked, in every way that it offers.

    What is changed is the printed side where it is right and the corrected one where it is wrong, so that
    each change makes a right statement wrong; it is noticed if the statement is then not called right.
    """
    tried = noticed = 0
    for claim in claims:
        for part in claim.parts:
            if isinstance(part, Part):
                changed = [altered.compare().agrees for _, altered in _right(part.comparison).mutations()]
                tried += len(changed)
                noticed += changed.count(False)
    return Alterations(tried, noticed)


def _right(comparison: Comparison) -> Comparison:
    return comparison if comparison.compare().agrees else comparison.corrected()
