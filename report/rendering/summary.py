"""What the summary counts, and how a claim is named in words."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass

from report.claim import Finding, Impact, JudgedPart, Kind, Verdict
from report.document import Chapter, Document

SYMBOLS = {
    Verdict.REPRODUCED: "✓",
    Verdict.COPY: "¶",
    Verdict.EXPLAINED: "≈",
    Verdict.NOT_CHECKABLE: "?",
    Verdict.ERRATUM: "✗",
}
MEANINGS = {
    Verdict.REPRODUCED: "follows from the thesis's own model, to every printed digit",
    Verdict.COPY: "differs by what a page read by machine explains; the page decides",
    Verdict.EXPLAINED: "does not follow, but comes out when a named slip made earlier is repeated",
    Verdict.NOT_CHECKABLE: "needs something the thesis does not give; the finding says what",
    Verdict.ERRATUM: "is wrong in this place; the right form or value stands beside it",
}
REACHES = {
    Impact.NONE: "",
    Impact.NOTATION: "notation only",
    Impact.LOCAL: "stays in this place",
    Impact.DOWNSTREAM: "reaches later results",
}
_KIND_NAMES = {
    Kind.EQUATION: "Equation",
    Kind.FIGURE: "Figure",
    Kind.TABLE: "Table",
    Kind.LISTING: "Listing",
    Kind.STATEMENT: "Statement",
}
_ABBREVIATIONS = {
    Kind.EQUATION: "Eq.",
    Kind.FIGURE: "Fig.",
    Kind.TABLE: "Table",
    Kind.LISTING: "Listing",
}
_KINDS_IN_WORDS = {
    Kind.EQUATION: ("equation", "equations"),
    Kind.FIGURE: ("figure", "figures"),
    Kind.TABLE: ("table", "tables"),
    Kind.LISTING: ("listing", "listings"),
    Kind.STATEMENT: ("statement in its text", "statements in its text"),
}
_MOST_LABELS = 3


@dataclass(frozen=True)
class Count:
    """Number of claims of one chapter, or of all (``chapter`` is None), with one verdict."""

    chapter: Chapter | None
    verdict: Verdict
    number: int


@dataclass(frozen=True)
class CountRow:
    """One line of the summary's table."""

    chapter: Chapter | None
    counts: tuple[Count, ...]
    total: int


def count_table(document: Document) -> tuple[CountRow, ...]:
    """Count claims by chapter and verdict; the last row counts all chapters together."""
    rows = [_count_row(chapter, chapter.findings) for chapter in document.chapters]
    return (*rows, _count_row(None, document.findings))


def reference(finding: Finding) -> str:
    """Name the place of a claim as a reader would: ``Equation 2.8``, ``Statement in section 5.1.2``."""
    name = _KIND_NAMES[finding.kind]
    if finding.kind is Kind.STATEMENT:
        return f"{name} in section {finding.section}"
    return f"{name} {finding.id.partition('-')[2]}"


def short_reference(finding: Finding) -> str:
    """Name the place of a claim where there is little room: ``Eq. 2.8``, ``Sec. 5.1.2``."""
    if finding.kind is Kind.STATEMENT:
        return f"Sec. {finding.section}"
    return f"{_ABBREVIATIONS[finding.kind]} {finding.id.partition('-')[2]}"


def kinds_in_words(document: Document) -> str:
    """Say how many findings there are of each kind: ``92 equations, 54 figures and 1 table``."""
    numbers = Counter(finding.kind for finding in document.findings)
    said = [f"{numbers[kind]} {_KINDS_IN_WORDS[kind][numbers[kind] > 1]}" for kind in Kind if numbers[kind]]
    return " and ".join(filter(None, (", ".join(said[:-1]), *said[-1:])))


def capitalised(text: str) -> str:
    """Begin with a capital, where the text begins with a small letter and not with a symbol."""
    return text[:1].upper() + text[1:] if re.match("[a-z]{2}", text) else text


def sentence(text: str) -> str:
    """End with a full stop; the first letter stays, because it may be a symbol."""
    return text.rstrip(". ") + "."


def methods(parts: tuple[JudgedPart, ...]) -> tuple[tuple[str, str], ...]:
    """Return (parts, method) for each distinct method, in order; parts is empty if all parts share it."""
    return _said_once([(part.label, part.method) for part in parts])


def slips(parts: tuple[JudgedPart, ...]) -> tuple[tuple[str, str], ...]:
    """Return (parts, slip) for each distinct slip, in order; parts is empty if all parts share it."""
    return _said_once([(part.label, part.slip) for part in parts])


def _said_once(said: list[tuple[str, str]]) -> tuple[tuple[str, str], ...]:
    labels_of: dict[str, list[str]] = {}
    for label, text in said:
        if text:
            labels_of.setdefault(text, []).append(label)
    return tuple((_named(labels, len(said)), text) for text, labels in labels_of.items())


def _named(labels: list[str], parts: int) -> str:
    if len(labels) == parts:
        return ""
    return ", ".join(labels) if len(labels) <= _MOST_LABELS else f"{len(labels)} parts"


def _count_row(chapter: Chapter | None, findings: tuple[Finding, ...]) -> CountRow:
    numbers = Counter(finding.verdict for finding in findings)
    counts = tuple(Count(chapter, verdict, numbers[verdict]) for verdict in Verdict)
    return CountRow(chapter, counts, len(findings))
