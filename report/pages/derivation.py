"""The derivation in a report: steps, symbols, parameters, and corrected programs."""

from __future__ import annotations

from dataclasses import dataclass

from report.pages.figure import CodeLines, Equation, Figure


@dataclass(frozen=True)
class DerivationStep:
    """A step of the derivation: Markdown prose and equations.

    Attributes:
        id: Identifier, unique among all steps.
        title: Heading.
        text: Prose.
        equations: Shown after the prose.
        claims: Ids of the claims on the equations that it shows.
        others: Ids of the other claims that rest on it.
        code: The lines that do what the step says.
        picture: Shown before the equations, if there is one.
        folded: Whether the equations are so long that a reader of the page asks for them first.
    """

    id: str
    title: str
    text: str
    equations: tuple[Equation, ...]
    claims: tuple[str, ...] = ()
    others: tuple[str, ...] = ()
    code: tuple[CodeLines, ...] = ()
    picture: Figure | None = None
    folded: bool = False


@dataclass(frozen=True)
class NomenclatureRow:
    """A symbol (LaTeX), its meaning and SI unit (plain text), and the id of the step that has it first."""

    symbol: str
    meaning: str
    unit: str
    first: str = ""


@dataclass(frozen=True)
class ParameterRow:
    """A model parameter: symbol (LaTeX), meaning, value (digits) and SI unit."""

    symbol: str
    meaning: str
    value: str
    unit: str
