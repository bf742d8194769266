"""Everything the report shows, finished and frozen: templates only loop over it and print it."""

from __future__ import annotations

from dataclasses import dataclass

from report.claim import Finding


@dataclass(frozen=True)
class Equation:
    """A displayed equation: LaTeX without dollar signs; ``thesis`` is its number in the thesis, or empty."""

    latex: str
    thesis: str = ""


@dataclass(frozen=True)
class DerivationStep:
    """A step of the derivation: Markdown prose, equations, and the claims it bears on."""

    id: str
    title: str
    text: str
    equations: tuple[Equation, ...]
    claims: tuple[str, ...] = ()


@dataclass(frozen=True)
class Figure:
    """A redrawn figure: its claim's id, Markdown caption, alternative text, and the SVG itself."""

    id: str
    title: str
    caption: str
    alternative_text: str
    svg: str


@dataclass(frozen=True)
class NomenclatureRow:
    """A symbol (LaTeX), its meaning and its SI unit (plain text)."""

    symbol: str
    meaning: str
    unit: str


@dataclass(frozen=True)
class ParameterRow:
    """A model parameter: symbol (LaTeX), meaning, value (digits) and SI unit."""

    symbol: str
    meaning: str
    value: str
    unit: str


@dataclass(frozen=True)
class Highlight:
    """A finding that matters most: the id of its claim, one sentence, and its size."""

    claim: str
    sentence: str
    size: str


@dataclass(frozen=True)
class Chapter:
    """A chapter or appendix of the thesis with the findings in it, in thesis order."""

    id: str
    number: str
    title: str
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class Provenance:
    """What the report was made from; nothing in it depends on the time or the machine of the build."""

    version: str
    commit: str
    date: str
    libraries: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Document:
    """The whole report."""

    title: str
    highlights: tuple[Highlight, ...]
    chapters: tuple[Chapter, ...]
    statements_in_thesis: int
    derivation: tuple[DerivationStep, ...]
    figures: tuple[Figure, ...]
    nomenclature: tuple[NomenclatureRow, ...]
    parameters: tuple[ParameterRow, ...]
    provenance: Provenance

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings, in thesis order."""
        return tuple(finding for chapter in self.chapters for finding in chapter.findings)
