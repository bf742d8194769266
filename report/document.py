"""Everything the report shows, finished and frozen: templates only loop over it and print it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from report.claim import Finding
from report.text_copy import BuildTime, TextCopy


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
    """A finding that matters most: where it stands (ids of claims or places), and what to do.

    ``sentence`` and ``action`` are Markdown; the grade shown is that of the first place.
    """

    places: tuple[str, ...]
    sentence: str
    action: str


@dataclass(frozen=True)
class Opening:
    """The first screen: what holds and what does not, what matters most, what a designer does (Markdown)."""

    sentences: str
    highlights: tuple[Highlight, ...]
    figure: Figure
    do: tuple[str, ...]
    do_not: tuple[str, ...]


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
class MutationMeasurement:
    """How many changes of this program, made at random, were noticed.

    Attributes:
        date: When it was measured, year-month-day.
        command: With what.
        drawn: How many changes were made.
        equivalent: How many of them have no effect.
        claims: How many another verdict, or a check that stopped the report, has shown first.
        tests: How many a test has shown first.
        nothing: How many nothing has shown, of those with an effect.
        interval: 95 % interval of the share that is noticed among those with an effect.
    """

    date: str
    command: str
    drawn: int
    equivalent: int
    claims: int
    tests: int
    nothing: int
    interval: tuple[float, float]

    @property
    def noticed(self) -> int:
        """How many were noticed."""
        return self.claims + self.tests


@dataclass(frozen=True)
class Robustness:
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
    """What the report was made from; nothing in it depends on the time or the machine of the build.

    ``build_time`` is the processor time it took when that was last measured.
    """

    version: str
    commit: str
    date: str
    libraries: tuple[tuple[str, str], ...]
    build_time: BuildTime | None = None


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
class Observation:
    """A sentence on the physical twin, or a few: Markdown, with what it rests on and where that is computed.

    ``title`` may be empty; ``evidence`` holds one check each, all of which hold, and is never empty.
    """

    id: str
    title: str
    text: str
    evidence: tuple[str, ...]
    source: str


@dataclass(frozen=True)
class TwinSection:
    """A section of the chapter on the twin: observations and figures in their order."""

    id: str
    title: str
    items: tuple[Observation | Figure, ...]


@dataclass(frozen=True)
class TwinChapter:
    """What play does in the real trimmer: beside the thesis's chapters, and not about one of them."""

    title: str
    sections: tuple[TwinSection, ...]

    @property
    def observations(self) -> tuple[Observation, ...]:
        """All observations in their order."""
        return tuple(
            item for section in self.sections for item in section.items if isinstance(item, Observation)
        )

    @property
    def figures(self) -> tuple[Figure, ...]:
        """All figures in their order."""
        return tuple(item for section in self.sections for item in section.items if isinstance(item, Figure))


@dataclass(frozen=True)
class Document:
    """The whole report, or a part of it: ``omitted`` are the chapters that a partial report leaves out.

    ``further_statements`` is how many statements were found by a second reading, ``solution`` the steps from
    the equations to numbers, ``step_of`` the id of the step that each claim rests on.
    """

    title: str
    opening: Opening | None
    chapters: tuple[Chapter, ...]
    statements_in_thesis: int
    derivation: tuple[DerivationStep, ...]
    figures: tuple[Figure, ...]
    nomenclature: tuple[NomenclatureRow, ...]
    parameters: tuple[ParameterRow, ...]
    provenance: Provenance
    text_copy: TextCopy
    programs: tuple[Program, ...] = ()
    describing_functions: tuple[DerivationStep, ...] = ()
    solution: tuple[DerivationStep, ...] = ()
    step_of: Mapping[str, str] = field(default_factory=dict)
    explorable: Explorable | None = None
    spread: tuple[Follows, ...] = ()
    answers: tuple[Answer, ...] = ()
    corrected: tuple[CorrectedResult, ...] = ()
    robustness: Robustness | None = None
    mutation: MutationMeasurement | None = None
    sections: tuple[Section, ...] = ()
    omitted: tuple[Chapter, ...] = ()
    further_statements: int = 0
    twin: TwinChapter | None = None

    @property
    def steps(self) -> tuple[DerivationStep, ...]:
        """All steps of the derivation, in their order."""
        return (*self.derivation, *self.describing_functions, *self.solution)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings, in thesis order."""
        return tuple(finding for chapter in self.chapters for finding in chapter.findings)

    @property
    def drawings(self) -> tuple[Figure, ...]:
        """All figures: first screen, claims, the twin, how far it holds, and the explorable."""
        first = (self.opening.figure,) if self.opening else ()
        last = (self.robustness.figure,) if self.robustness else ()
        still = (self.explorable.still,) if self.explorable else ()
        return (*first, *self.figures, *(self.twin.figures if self.twin else ()), *last, *still)
