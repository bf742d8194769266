"""The stages that make the report's content: derive, solve, judge, draw and assemble."""

from __future__ import annotations

from report.assemble import assemble
from report.claim import judge
from report.claims.all_claims import all_claims
from report.document import Document
from report.evidence import derive, solve
from report.figures.all_figures import DRAWINGS
from report.inventory import read_inventory
from report.progress import Progress


def make_document(progress: Progress) -> Document:
    """Derive, solve, judge and draw everything that the report shows.

    Raises:
        ClaimIdError: if a claim is not in the inventory or stands twice.
        ContradictionError: if two independent derivations disagree.
    """
    inventory = read_inventory()
    (derived,) = progress.run("derive", [derive], lambda work: work())
    (evidence,) = progress.run("solve", [derived], solve)
    (claims,) = progress.run("claim", [evidence], lambda known: all_claims(known, inventory))
    findings = progress.run("judge", claims, lambda claim: judge(claim, inventory[claim.id]))
    figures = progress.run("draw", DRAWINGS, lambda drawing: drawing.finished(evidence))
    (document,) = progress.run(
        "assemble", [evidence], lambda known: assemble(known, findings, figures, inventory)
    )
    return document
