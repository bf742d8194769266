"""The findings of a chapter by section, in thesis order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from report.data.sections import Section
from report.document.thesis import Chapter
from report.judging.claim import Kind
from report.judging.finding import Finding

_KINDS = tuple(Kind)


@dataclass(frozen=True)
class Group:
    """Findings that stand in one section; ``heading`` is empty for what belongs to the chapter as a whole."""

    number: str
    heading: str
    findings: tuple[Finding, ...]


def grouped(chapter: Chapter, sections: Sequence[Section]) -> tuple[Group, ...]:
    """Return the findings of a chapter by section, equations first; figures go to the section they are in."""
    section_of = {figure: section.number for section in sections for figure in section.figures}
    headings = {section.number: f"{section.number} {section.title}" for section in sections}
    findings: dict[str, list[Finding]] = {}
    for finding in chapter.findings:
        findings.setdefault(section_of.get(finding.id, finding.section), []).append(finding)
    return tuple(
        Group(
            number,
            "" if number == chapter.number else headings.get(number, f"Section {number}"),
            tuple(sorted(findings[number], key=lambda finding: _KINDS.index(finding.kind))),
        )
        for number in sorted(findings, key=_in_numeric_order)
    )


def _in_numeric_order(number: str) -> list[tuple[int, str]]:
    return [(int(part), "") if part.isdigit() else (0, part) for part in number.split(".")]
