"""Where a claim stands in the thesis, in words."""

from __future__ import annotations

from report.judging.finding import Finding
from report.pages.escaping import Markdown
from report.rendering.outline import Group


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
