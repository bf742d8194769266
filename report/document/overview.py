"""What the first pages of a report say."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Self, final

from report.document.extra import ExtraChapter
from report.pages.figure import Figure


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
    """The first screen: what was found, what matters most, what a designer does (Markdown)."""

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


@final
@dataclass(frozen=True)
class Overview(ExtraChapter):
    """The first screen, the research questions with their answers, and corrected predictions."""

    opening: Opening | None = None
    answers: tuple[Answer, ...] = ()
    corrected: tuple[CorrectedResult, ...] = ()

    @property
    def figures(self) -> tuple[Figure, ...]:
        """That of the first screen."""
        return (self.opening.figure,) if self.opening else ()

    @property
    def named(self) -> Mapping[str, str]:
        """Claims that answers and corrected predictions are about."""
        answered = {claim: "a research question" for answer in self.answers for claim in answer.claims}
        return answered | {each.claim: f"the corrected result “{each.quantity}”" for each in self.corrected}

    def part(self, kept: Collection[str]) -> Self:
        """Return the corrected predictions of some claims; the rest is about the whole report."""
        corrected = tuple(each for each in self.corrected if each.claim in kept)
        return replace(self, opening=None, answers=(), corrected=corrected)
