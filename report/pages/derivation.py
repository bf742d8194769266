"""The derivation in a report: steps, symbols, parameters, and corrected programs."""

from dataclasses import dataclass

from report.pages.figure import CodeLines, Equation, Figure


@dataclass(frozen=True)
class DerivationStep:
    """A step of the derivation: Markdown prose and equations."""

    id: str  # Identifier, unique among all steps
    title: str  # Heading
    text: str  # Prose
    equations: tuple[Equation, ...]  # Shown after the prose
    claims: tuple[str, ...] = ()  # Ids of the claims on the equations that it shows
    others: tuple[str, ...] = ()  # Ids of the other claims that rest on it
    code: tuple[CodeLines, ...] = ()  # The lines that do what the step says
    picture: Figure | None = None  # Shown before the equations, if there is one
    folded: bool = False  # Whether the equations are so long that a reader of the page asks for them first


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
