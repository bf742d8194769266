"""Chapters beside those of the thesis, finished and frozen: first pages, twin, robustness, explorable."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Self, final

from report.document.advice import Advice
from report.pages.derivation import DerivationStep
from report.pages.explorable import Panel, Slider
from report.pages.figure import Figure


@dataclass(frozen=True)
class ExtraChapter:
    """What is finished of an extra chapter; each has a template of its own."""

    @property
    def figures(self) -> tuple[Figure, ...]:
        """Its figures."""
        return ()

    @property
    def observations(self) -> tuple[Observation, ...]:
        """Its observations."""
        return ()

    @property
    def named(self) -> Mapping[str, str]:
        """Ids of the claims that it names, and where it does, in words."""
        return MappingProxyType({})

    def part(self, kept: Collection[str]) -> Self | None:
        """Return what stays of it in a report with some claims only, by their ids; None if nothing does."""
        return None


@dataclass(frozen=True)
class Highlight:
    """A finding that matters most: where it stands (ids of claims or places), and what to do.

    ``sentence`` and ``action`` are Markdown.
    """

    places: tuple[str, ...]
    sentence: str
    action: str


@dataclass(frozen=True)
class Opening:
    """The first screen: what was found, what matters most (Markdown), and what a designer is advised."""

    sentences: str
    highlights: tuple[Highlight, ...]
    figure: Figure
    advice: tuple[Advice, ...] = ()


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
class Root:
    """A slip from which others grow, or those that stand alone, which need no words.

    ``title`` is plain text with TeX mathematics, ``words`` Markdown; ``claims`` are ids, the root's first.
    """

    title: str
    words: str
    claims: tuple[str, ...]

    @property
    def size(self) -> int:
        """How many claims it has."""
        return len(self.claims)


@dataclass(frozen=True)
class Matter:
    """What the thesis got right of a matter, what not (Markdown), and ids of claims behind each."""

    title: str
    right: str
    kept: tuple[str, ...]
    wrong: str
    slips: tuple[str, ...]


@final
@dataclass(frozen=True)
class Overview(ExtraChapter):
    """The first screen, what changes a conclusion, the research questions, what is right and what not."""

    opening: Opening | None = None  # The first screen
    answers: tuple[Answer, ...] = ()  # To the research questions
    corrected: tuple[CorrectedResult, ...] = ()  # Corrected predictions
    roots: tuple[Root, ...] = ()  # What changes a conclusion, by the slip it grows from
    matters: tuple[Matter, ...] = ()  # What is right beside what is not
    short: tuple[DerivationStep, ...] = ()  # The thesis's loop, derived in short

    @property
    def figures(self) -> tuple[Figure, ...]:
        """That of the first screen, and those of the short derivation."""
        pictures = tuple(step.picture for step in self.short if step.picture)
        return ((self.opening.figure,) if self.opening else ()) + pictures

    @property
    def named(self) -> Mapping[str, str]:
        """Claims that roots, answers and corrected predictions are about."""
        rooted = {claim: f"the root “{root.title}”" for root in self.roots for claim in root.claims}
        answered = {claim: "a research question" for answer in self.answers for claim in answer.claims}
        sides = {claim: each.title for each in self.matters for claim in (*each.kept, *each.slips)}
        return (
            rooted
            | answered
            | {claim: f"what is right of “{title}”, and what not" for claim, title in sides.items()}
            | {each.claim: f"the corrected result “{each.quantity}”" for each in self.corrected}
        )

    def part(self, kept: Collection[str]) -> Self:
        """Return the corrected predictions of some claims; the rest is about the whole report."""
        corrected = tuple(each for each in self.corrected if each.claim in kept)
        return replace(self, opening=None, roots=(), answers=(), corrected=corrected, matters=(), short=())


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
class SectionedChapter(ExtraChapter):
    """A chapter of observations and figures in sections."""

    title: str
    sections: tuple[TwinSection, ...]

    @property
    def items(self) -> tuple[Observation | Figure, ...]:
        """All observations and figures, in their order in the report."""
        return tuple(item for section in self.sections for item in section.items)

    @property
    def observations(self) -> tuple[Observation, ...]:
        """All observations in their order."""
        return tuple(item for item in self.items if isinstance(item, Observation))

    @property
    def figures(self) -> tuple[Figure, ...]:
        """All figures in their order."""
        return tuple(item for item in self.items if isinstance(item, Figure))


@final
@dataclass(frozen=True)
class FutureWork(SectionedChapter):
    """An answer to each question of section 6.4, in their order: a section with its figure and its limits."""


@final
@dataclass(frozen=True)
class TwinChapter(SectionedChapter):
    """What play does in the real trimmer: beside the thesis's chapters, and not about one of them.

    Attributes:
        title: Of the chapter.
        sections: What stands in the chapter itself.
        advice: What was found for each line of advice.
        loop: The exact limit cycles of the thesis's loop.
        questions: One observation for each research question of the thesis, in their order.
    """

    advice: TwinSection
    loop: TwinSection
    questions: TwinSection

    @property
    def items(self) -> tuple[Observation | Figure, ...]:
        """All observations and figures, in their order in the report."""
        sections = (self.advice, self.questions, *self.sections, self.loop)
        return tuple(item for section in sections for item in section.items)


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


@dataclass(frozen=True)
class Explorable(ExtraChapter):
    """What a reader can move: the formulas as a script, sliders, panels, and a picture for print."""

    formulas: str
    sliders: tuple[Slider, ...]
    panels: tuple[Panel, ...]
    still: Figure

    @property
    def figures(self) -> tuple[Figure, ...]:
        """The picture for print."""
        return (self.still,)
