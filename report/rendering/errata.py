"""The errata of the sheet that is laid into the thesis."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from report.claim import Finding, JudgedPart, Kind, Shown, Verdict, Words
from report.document import Document
from report.rendering.escaping import plain
from report.rendering.outline import grouped
from report.rendering.summary import short_reference

_STATEMENT = re.compile(r"(?:\$[^$]*\$|(?!; |\. [A-Z])[^$])*")
"""Words up to the first semicolon or the end of the first sentence, outside of mathematics."""
_LONG = 45
"""Corrections longer than this are not said twice."""
_VERY_LONG = 120
"""Answers longer than this give their first statement only; the card has the rest."""


@dataclass(frozen=True)
class Erratum:
    """One line of the sheet: the claim's id, the place in the thesis, which part of it, and both forms."""

    claim: str
    place: str
    part: str
    printed: Shown
    should_be: Shown


def errata(document: Document) -> tuple[Erratum, ...]:
    """Return one erratum for each wrong part of each claim, in thesis order."""
    return tuple(
        _said_once(
            erratum
            for chapter in document.chapters
            for group in grouped(chapter, document.sections)
            for finding in group.findings
            for erratum in _errata_of(finding)
        )
    )


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
