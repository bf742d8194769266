"""The stages that make the report's content: derive, solve, judge, draw and assemble."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from types import ModuleType
from typing import Any

from report import background
from report.assemble import assemble
from report.claim import Entry, Finding, judge
from report.claims.all_claims import SECTIONS, require_known_once
from report.document import Document
from report.evidence import Evidence, derive, solve
from report.figures.all_figures import DRAWINGS
from report.inventory import read_inventory
from report.progress import Progress


def make_document(progress: Progress) -> Document:
    """Derive, solve, judge and draw everything that the report shows.

    A second process judges every other section and draws, while this one judges the rest.

    Raises:
        ClaimIdError: if a claim is not in the inventory or stands twice.
        ContradictionError: if two independent derivations disagree.
    """
    inventory = read_inventory()
    (derived,) = progress.run("derive", [derive], lambda work: work())
    (evidence,) = progress.run("solve", [derived], solve)
    elsewhere = SECTIONS[1::2]
    jobs: list[Callable[[], Any]] = [
        *(partial(_judged, section, evidence, inventory) for section in elsewhere),
        *(partial(drawing.finished, evidence) for drawing in DRAWINGS),
    ]
    second: Iterator[Any] = background.start(jobs)  # findings of each section, then the figures
    by_section = progress.run(
        "judge", SECTIONS[::2], lambda section: _judged(section, evidence, inventory)
    ) + progress.run("judge", elsewhere, lambda _: next(second))
    findings = _in_order(by_section, inventory)
    figures = progress.run("draw", DRAWINGS, lambda _: next(second))
    (document,) = progress.run(
        "assemble", [evidence], lambda known: assemble(known, findings, figures, inventory)
    )
    return document


def _judged(section: ModuleType, evidence: Evidence, inventory: Mapping[str, Entry]) -> tuple[Finding, ...]:
    claims = section.claims(evidence)
    require_known_once((claim.id for claim in claims), inventory)
    return tuple(judge(claim, inventory[claim.id]) for claim in claims)


def _in_order(
    by_section: tuple[tuple[Finding, ...], ...], inventory: Mapping[str, Entry]
) -> tuple[Finding, ...]:
    findings = [finding for section in by_section for finding in section]
    require_known_once((finding.id for finding in findings), inventory)
    place = {claim_id: index for index, claim_id in enumerate(inventory)}
    return tuple(sorted(findings, key=lambda finding: place[finding.id]))
