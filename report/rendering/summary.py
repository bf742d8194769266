"""What the summary counts, how a claim is named in words, and how the report is made again."""

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from report.document.document import Document
from report.document.thesis import Chapter
from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.items import Item, items
from report.judging.verdict import Certainty, Grade, Verdict, grade
from report.rendering.selection import chapter_name

SYMBOLS = {
    Grade.CONCLUSION: "✗",
    Grade.RESULT: "≠",
    Grade.SLIP: "≈",
    Grade.COPY: "¶",
    Grade.NOT_CHECKABLE: "?",
    Grade.REPRODUCED: "✓",
}
GRADES = {
    Grade.CONCLUSION: "changes a conclusion",
    Grade.RESULT: "wrong result",
    Grade.SLIP: "slip",
    Grade.COPY: "possibly the copy",
    Grade.NOT_CHECKABLE: "not checkable",
    Grade.REPRODUCED: "reproduced",
}
IN_PART = {
    Grade.CONCLUSION: "part changes a conclusion",
    Grade.RESULT: "part is a wrong result",
    Grade.SLIP: "part is a slip",
    Grade.COPY: "part is possibly the copy",
}
"""Of a card that has parts that are right."""
COLOURS = {
    Grade.CONCLUSION: "#a3231f",
    Grade.RESULT: "#8a4b08",
    Grade.SLIP: "#5f5c00",
    Grade.COPY: "#6a4a8c",
    Grade.NOT_CHECKABLE: "#55585e",
    Grade.REPRODUCED: "#17663a",
}
CERTAINTIES = {
    Certainty.PROVEN: "proven",
    Certainty.COMPUTED: "computed twice",
    Certainty.READING: "depends on a reading",
}
_KIND_NAMES = {
    Kind.EQUATION: "Equation",
    Kind.FIGURE: "Figure",
    Kind.TABLE: "Table",
    Kind.LISTING: "Listing",
    Kind.STATEMENT: "Statement",
}
_ABBREVIATIONS = {Kind.EQUATION: "Eq.", Kind.FIGURE: "Fig.", Kind.TABLE: "Table", Kind.LISTING: "Listing"}
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
    """Number of printed things of one chapter, or of all (``chapter`` is None), with one grade."""

    chapter: Chapter | None
    grade: Grade
    number: int


@dataclass(frozen=True)
class CountRow:
    """One line of the summary's table."""

    chapter: Chapter | None
    counts: tuple[Count, ...]
    total: int

    @property
    def reproduced(self) -> int:
        """How many follow as printed."""
        return self.number(Grade.REPRODUCED)

    def number(self, grade: Grade) -> int:
        """Return how many have a grade."""
        return sum(count.number for count in self.counts if count.grade is grade)


def count_table(document: Document) -> tuple[CountRow, ...]:
    """Count printed things by chapter and grade; the last row counts all chapters together.

    One that several claims judge counts in the chapter of the first.
    """
    judged = items(document.findings)
    rows = [
        _count_row(chapter, [item for item in judged if item.chapter == chapter.number])
        for chapter in document.chapters
    ]
    return (*rows, _count_row(None, judged))


def not_to_cite(chapter: Chapter) -> tuple[tuple[Finding, ...], ...]:
    """Return what has a wrong result or changes a conclusion, by the place that a reader knows."""
    found: dict[str, tuple[Finding, ...]] = {}
    for finding in chapter.findings:
        if grade(finding) in (Grade.CONCLUSION, Grade.RESULT):
            found[short_reference(finding)] = (*found.get(short_reference(finding), ()), finding)
    return tuple(found.values())


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


def partly(finding: Finding) -> bool:
    """Return whether a card that says what is wrong has parts that are right."""
    return finding.verdict.is_wrong and any(part.verdict is Verdict.REPRODUCED for part in finding.parts)


def figures_judged(document: Document) -> int:
    """Return how many figures are judged; no drawing of the thesis was seen."""
    return sum(finding.kind is Kind.FIGURE for finding in document.findings)


def command(document: Document) -> str:
    """Return the command that makes the report, or this part of it, again."""
    if not document.omitted:
        return document.subject.command
    names = (chapter_name(chapter.number) for chapter in document.chapters)
    return f"{document.subject.command} --only {' '.join(names)}"


def build_time(document: Document) -> str:
    """Say what processor time the report took from nothing; empty where that is not known.

    It is a measured figure of the data: the time of each build would make each report another file.
    """
    taken = document.provenance.build_time
    if taken is None:
        return ""
    return f"{taken.seconds:.0f} s of processor time from nothing, measured with version {taken.version}"


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
    return _said_once([(part.label, "" if part.decided_by else part.slip) for part in parts])


def copy_faults(parts: tuple[JudgedPart, ...]) -> tuple[tuple[str, str], ...]:
    """Return (parts, what the copy may have lost, and what decides it), in order; as ``slips``."""
    return _said_once(
        [(part.label, f"{part.slip}; {part.decided_by}" if part.decided_by else "") for part in parts]
    )


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


def _count_row(chapter: Chapter | None, judged: Sequence[Item]) -> CountRow:
    numbers = Counter(grade(item) for item in judged)
    counts = tuple(Count(chapter, each, numbers[each]) for each in Grade)
    return CountRow(chapter, counts, len(judged))
