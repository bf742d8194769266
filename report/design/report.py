"""Everything that the report on a design shows, finished and frozen."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import final

from report.design.origin import Origin
from report.design.sliders import Sliders, sliders
from report.pages.derivation import DerivationStep
from report.pages.figure import Figure
from trimmer.design.design import Design


@dataclass(frozen=True)
class SymbolRow:
    """A symbol of the equations: LaTeX, meaning, value with its unit as text."""

    symbol: str
    meaning: str
    value: str


@dataclass(frozen=True)
class Equations:
    """The derivation of the mechanism."""

    # Steps that a designer wants: equations with closed contact, laws of contact and friction
    first: tuple[DerivationStep, ...]
    rest: tuple[DerivationStep, ...]  # The other steps
    symbols: tuple[SymbolRow, ...]  # What the letters mean


@dataclass(frozen=True)
class Report:
    """What every report on designs has."""

    title: str  # Its title, plain text
    figures: Mapping[str, Figure]  # By the names under which its text asks for them
    origin: Origin  # What it was made from, and when

    @property
    def subtitle(self) -> str:
        """The line below the title."""
        return self.origin.line

    @property
    def explorable(self) -> Sliders | None:
        """What a reader can move; None where there is nothing."""
        return None


@final
@dataclass(frozen=True)
class DesignReport(Report):
    """The report on one design: what was computed, and the derivation; without it if that is too long."""

    design: Design
    equations: Equations | None

    @cached_property
    def explorable(self) -> Sliders | None:
        """The sliders over the motions that were solved for; None if there are none."""
        return sliders(self.design) if self.design.grid is not None else None
