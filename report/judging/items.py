"""The printed things that are judged: one may be judged by parts of several claims, and counts once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import final

from report.judging.finding import Finding, JudgedPart
from report.judging.verdict import Severity, Verdict


@final
@dataclass(frozen=True)
class Item:
    """A printed thing, in the chapter of the first claim on it, with the gravest that was found of it."""

    name: str
    chapter: str
    verdict: Verdict
    severity: Severity


def items(findings: Iterable[Finding]) -> tuple[Item, ...]:
    """Return the printed things that the findings judge, in the order in which they come first."""
    chapters: dict[str, str] = {}
    judged: dict[str, list[JudgedPart]] = {}
    for finding in findings:
        for part in finding.parts:
            chapters.setdefault(part.item, finding.section.split(".")[0])
            judged.setdefault(part.item, []).append(part)
    return tuple(
        Item(
            name,
            chapters[name],
            max((part.verdict for part in parts), key=lambda verdict: verdict.rank),
            min((part.severity for part in parts), key=lambda severity: severity.rank),
        )
        for name, parts in judged.items()
    )
