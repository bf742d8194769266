"""The findings of a chapter by section, in thesis order, and where each stands, in words."""

from collections.abc import Sequence
from dataclasses import dataclass

from report.data.statements import ThesisSection
from report.document.thesis import Chapter
from report.judging.claim import Kind
from report.judging.finding import Finding
from report.pages.escaping import Markdown

_KINDS = tuple(Kind)


@dataclass(frozen=True)
class Group:
    """Findings that stand in one section; ``heading`` is empty for what belongs to the chapter as a whole."""

    number: str
    heading: str
    findings: tuple[Finding, ...]


def grouped(chapter: Chapter, sections: Sequence[ThesisSection]) -> tuple[Group, ...]:
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


def place(finding: Finding, group: Group) -> Markdown:
    r"""Say as Markdown where a claim stands: ``section\ 5.2.1, paragraph\ 4, lines\ 7–9 of the copy``."""
    section = rf"{'section' if group.heading else 'chapter'}\ {group.number}"
    paragraph = rf"paragraph\ {finding.paragraph}" if finding.paragraph is not None else ""
    return Markdown(", ".join(filter(None, (section, paragraph, _lines(finding)))))


def _lines(finding: Finding) -> str:
    if finding.lines is None:
        return ""
    first, last = finding.lines
    return rf"line\ {first} of the copy" if first == last else rf"lines\ {first}–{last} of the copy"
