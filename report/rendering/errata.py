"""The errata of the sheet that is laid into the thesis, the gravest first; also as CSV."""

import csv
import io
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from report.document.document import Document
from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.shown import Shown, Words
from report.judging.verdict import Certainty, Severity, Verdict
from report.pages.escaping import plain
from report.rendering.outline import grouped
from report.rendering.summary import short_reference

_STATEMENT = re.compile(r"(?:\$[^$]*\$|(?!; |\. [A-Z])[^$])*")
"""Words up to the first semicolon or the end of the first sentence, outside of mathematics."""
_LONG = 45  # Corrections longer than this are not said twice
_VERY_LONG = 120  # Answers longer than this give their first statement only; the card has the rest


HEADINGS = {
    Severity.CONCLUSION: "Changes a conclusion",
    Severity.RESULT: "Wrong number or formula",
    Severity.SLIP: "Slip without effect",
    Severity.NONE: "Not graded",
}
COLUMNS = (
    "severity",
    "certainty",
    "claim",
    "place",
    "part",
    "first_line",
    "last_line",
    "printed",
    "should_be",
)
"""Columns of the CSV."""


@dataclass(frozen=True)
class Erratum:
    """One line of the sheet: the claim's id, the place in the thesis, which part of it, and both forms.

    ``item`` is the printed thing, ``lines`` the first and the last of its passage in the text that was read.
    """

    claim: str
    place: str
    part: str
    printed: Shown
    should_be: Shown
    item: str
    severity: Severity
    certainty: Certainty | None
    lines: tuple[int, int] | None


@dataclass(frozen=True)
class Errata:
    """Errata of one severity, in thesis order."""

    severity: Severity
    errata: tuple[Erratum, ...]


def errata(document: Document) -> tuple[Erratum, ...]:
    """Return an erratum for each printed thing that is wrong: the gravest first, and then in thesis order.

    What several parts judge, of one claim or of several, is there once, with the gravest that was found.
    """
    found = (
        erratum
        for chapter in document.chapters
        for group in grouped(chapter, document.sections)
        for finding in group.findings
        for erratum in _errata_of(finding)
    )
    once: dict[str, Erratum] = {}
    for erratum in sorted(found, key=lambda each: each.severity.rank):
        once.setdefault(erratum.item or f"{erratum.claim}, {erratum.part}", erratum)
    return tuple(_said_once(once.values()))


def by_severity(found: Iterable[Erratum]) -> tuple[Errata, ...]:
    """Part errata by how much they matter, the gravest first; a severity without errata is left out."""
    listed = tuple(found)
    groups = (
        Errata(severity, tuple(each for each in listed if each.severity is severity)) for severity in Severity
    )
    return tuple(group for group in groups if group.errata)


def to_csv(document: Document) -> str:
    """Return the errata as CSV with ``COLUMNS``; formulas are TeX, words Markdown."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for each in errata(document):
        first, last = each.lines or ("", "")
        certainty = each.certainty.value if each.certainty else ""
        sides = (str(each.printed), str(each.should_be))
        writer.writerow(
            [each.severity.value, certainty, each.claim, each.place, each.part, first, last, *sides]
        )
    return text.getvalue()


def _said_once(errata: Iterable[Erratum]) -> Iterator[Erratum]:
    """Refer to the first of several errata with the same long correction."""
    said: dict[str, Erratum] = {}
    for erratum in errata:
        correction = str(erratum.should_be)
        first = said.setdefault(correction, erratum)
        if len(correction) <= _LONG or first is erratum:
            yield erratum
        else:
            yield replace(erratum, should_be=Words(f"as at [{plain(first.place)}](#{first.claim})"))


def _errata_of(finding: Finding) -> tuple[Erratum, ...]:
    wrong = [part for part in finding.parts if part.verdict is Verdict.ERRATUM]
    return tuple(
        Erratum(
            finding.id,
            short_reference(finding),
            _part(finding, part, index),
            part.printed,
            _correction(part.derived),
            part.item,
            part.severity,
            part.certainty,
            finding.lines,
        )
        for index, part in enumerate(wrong)
    )


def _part(finding: Finding, part: JudgedPart, index: int) -> str:
    """Name the part; a statement has no number in the thesis, so its first part gets its title as well.

    What is printed in words says itself which statement it is.
    """
    if finding.kind is not Kind.STATEMENT or index or isinstance(part.printed, Words):
        return part.label
    return f"{finding.title}: {part.label}" if part.label else finding.title


def _correction(derived: Shown) -> Shown:
    """Leave out the "No" of an answer, which on the sheet all are, and what follows a very long statement."""
    if not isinstance(derived, Words):
        return derived
    answer = derived.text.removeprefix("No: ")
    statement = _STATEMENT.match(answer)
    return Words(statement[0] if statement and len(answer) > _VERY_LONG else answer)
