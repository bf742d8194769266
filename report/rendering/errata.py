"""The errata of the sheet that is laid into the thesis."""

from __future__ import annotations

from dataclasses import dataclass

from report.claim import Finding, JudgedPart, Kind, Shown, Verdict, Words
from report.document import Document
from report.rendering.outline import grouped
from report.rendering.summary import short_reference


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
        erratum
        for chapter in document.chapters
        for group in grouped(chapter, document.sections)
        for finding in group.findings
        for erratum in _errata_of(finding)
    )


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
    """Name the part; a statement has no number in the thesis, so its first part gets its title as well."""
    if finding.kind is not Kind.STATEMENT or index:
        return part.label
    return f"{finding.title}: {part.label}" if part.label else finding.title


def _correction(derived: Shown) -> Shown:
    """Leave out the "No" of an answer: on the sheet, all answers are."""
    if isinstance(derived, Words):
        return Words(derived.text.removeprefix("No: "))
    return derived
