"""What the first pages of a report say."""

from __future__ import annotations

from dataclasses import dataclass

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
