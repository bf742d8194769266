"""What the page says that tells what was read, by what, and how the report is made again."""

from __future__ import annotations

from report.document.document import Document
from report.judging.claim import Kind
from report.rendering.selection import chapter_name


def figures_judged(document: Document) -> int:
    """Return how many figures are judged; no drawing of the thesis was seen."""
    return sum(finding.kind is Kind.FIGURE for finding in document.findings)


def command(document: Document) -> str:
    """Return the command that makes the report, or this part of it, again."""
    if not document.omitted:
        return "trimmer report"
    names = (chapter_name(chapter.number) for chapter in document.chapters)
    return f"trimmer report --only {' '.join(names)}"


def build_time(document: Document) -> str:
    """Say what processor time the report took from nothing; empty where that is not known.

    It is a measured figure of the data: the time of each build would make each report another file.
    """
    taken = document.provenance.build_time
    if taken is None:
        return ""
    return f"{taken.seconds:.0f} s of processor time from nothing, measured with version {taken.version}"
