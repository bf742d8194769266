"""How far the corrected results hold."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from report.document.extra import ExtraChapter
from report.pages.figure import Figure


@dataclass(frozen=True)
class Digits:
    """Parameters (LaTeX) that are printed with a number of digits, and what these leave open at most, %."""

    number: str
    symbols: tuple[str, ...]
    left_open: str


@dataclass(frozen=True)
class EffectRow:
    """A corrected prediction and what the parameters do to it.

    ``quantity`` and ``unit`` are plain text; ``nominal`` is the value at the thesis's parameters;
    ``largest`` (LaTeX) is the parameter with the largest effect, ``reach`` what it does; ``band`` holds nine
    tenths of the samples.
    """

    quantity: str
    unit: str
    nominal: str
    largest: str
    reach: str
    band: str


@dataclass(frozen=True)
class SurvivalRow:
    """A finding on a claim, in how many samples it holds, and on what that rests, in words."""

    claim: str
    finding: str
    holds: str
    because: str


@dataclass(frozen=True)
class Robustness(ExtraChapter):
    """How far the corrected results hold when parameters change by ``percent``.

    ``left_out`` of the ``samples`` have a loop without a stable limit cycle, and are in no band.
    """

    percent: int
    samples: int
    left_out: int
    digits: tuple[Digits, ...]
    effects: tuple[EffectRow, ...]
    survivals: tuple[SurvivalRow, ...]
    figure: Figure

    @property
    def figures(self) -> tuple[Figure, ...]:
        """Its only figure."""
        return (self.figure,)

    @property
    def named(self) -> Mapping[str, str]:
        """Claims whose findings survive or not."""
        return {row.claim: "how far it holds" for row in self.survivals}
