"""Everything the report shows, finished and frozen: templates only loop over it and print it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from report.claim import Finding


@dataclass(frozen=True)
class Equation:
    """A displayed equation: LaTeX without dollar signs.

    ``thesis`` is its number in the thesis, ``words`` Markdown prose before it; both may be empty.
    """

    latex: str
    thesis: str = ""
    words: str = ""


@dataclass(frozen=True)
class CodeLines:
    """A function or class of this project: path of its file, name, first and last line, and its text."""

    path: str
    name: str
    first: int
    last: int
    text: str


@dataclass(frozen=True)
class Figure:
    """A redrawn figure: its claim's id, Markdown caption, alternative text, and the SVG itself."""

    id: str
    title: str
    caption: str
    alternative_text: str
    svg: str


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
class Slider:
    """A number that a reader can move.

    Attributes:
        name: What the script calls it.
        label: What the reader is told it is, as plain text.
        minimum: Least value; of the decimal logarithm if ``logarithmic``.
        maximum: Largest value, likewise.
        value: Value to begin with, likewise.
        logarithmic: Whether the slider moves the decimal logarithm.
        factor: From the SI unit to the unit that is shown.
        unit: The unit that is shown, as plain text.
    """

    name: str
    label: str
    minimum: float
    maximum: float
    value: float
    logarithmic: bool
    factor: float
    unit: str


@dataclass(frozen=True)
class Panel:
    """A drawing of the explorable: title, least and largest x and y, and what it shows, as plain text."""

    title: str
    limits: tuple[float, float, float, float]
    description: str


@dataclass(frozen=True)
class Explorable:
    """What a reader can move: the formulas as a script, sliders, panels, and a picture for print."""

    formulas: str
    sliders: tuple[Slider, ...]
    panels: tuple[Panel, ...]
    still: Figure


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


@dataclass(frozen=True)
class Highlight:
    """A finding that matters most: the id of its claim, one sentence, and its size."""

    claim: str
    sentence: str
    size: str


@dataclass(frozen=True)
class Answer:
    """A research question, its answers in the thesis and now (Markdown), and the ids of the claims behind."""

    question: str
    thesis: str
    now: str
    claims: tuple[str, ...] = ()


@dataclass(frozen=True)
class CorrectedResult:
    """A prediction of the thesis beside the corrected ones.

    ``claim`` is the id of its claim; ``quantity`` and ``remark`` are plain text with TeX mathematics between
    dollar signs. The three values are digits in ``unit``, or words, or empty where there is none.
    """

    claim: str
    quantity: str
    printed: str
    harmonic_balance: str
    exact_orbit: str
    unit: str = ""
    remark: str = ""


@dataclass(frozen=True)
class Follows:
    """A claim (its id) that follows from another in the thesis, and how, in a few words of plain text."""

    claim: str
    source: str
    how: str


@dataclass(frozen=True)
class Section:
    """A section of the thesis: number, title, and the ids of the figures in it."""

    number: str
    title: str
    figures: tuple[str, ...] = ()


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
class Program:
    """A corrected program of appendix A: file name, id of the claim on what it corrects (or empty), text.

    ``title`` says what it computes, ``faults`` what was wrong in the thesis's listing; both are plain text.
    """

    name: str
    claim: str
    title: str
    faults: tuple[str, ...]
    text: str


@dataclass(frozen=True)
class Document:
    """The whole report, or a part of it: ``omitted`` are the chapters that a partial report leaves out.

    ``further_statements`` is how many statements were found by a second reading, ``solution`` the steps from
    the equations to numbers, ``step_of`` the id of the step that each claim rests on.
    """

    title: str
    highlights: tuple[Highlight, ...]
    chapters: tuple[Chapter, ...]
    statements_in_thesis: int
    derivation: tuple[DerivationStep, ...]
    figures: tuple[Figure, ...]
    nomenclature: tuple[NomenclatureRow, ...]
    parameters: tuple[ParameterRow, ...]
    provenance: Provenance
    programs: tuple[Program, ...] = ()
    describing_functions: tuple[DerivationStep, ...] = ()
    solution: tuple[DerivationStep, ...] = ()
    step_of: Mapping[str, str] = field(default_factory=dict)
    explorable: Explorable | None = None
    spread: tuple[Follows, ...] = ()
    answers: tuple[Answer, ...] = ()
    corrected: tuple[CorrectedResult, ...] = ()
    sections: tuple[Section, ...] = ()
    omitted: tuple[Chapter, ...] = ()
    further_statements: int = 0

    @property
    def steps(self) -> tuple[DerivationStep, ...]:
        """All steps of the derivation, in their order."""
        return (*self.derivation, *self.describing_functions, *self.solution)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings, in thesis order."""
        return tuple(finding for chapter in self.chapters for finding in chapter.findings)
