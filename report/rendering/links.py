"""Claims that a report names outside of its chapters: each has to be there."""

from __future__ import annotations

from report.document.document import Document
from report.pages.links import BrokenLinkError


def check_claims(document: Document) -> None:
    """Check that every claim is there that the document names outside of its chapters.

    Raises:
        BrokenLinkError: naming who names which claim, if one is not there.
    """
    steps = document.steps
    named = {
        **{
            claim: f"step {step.id} of the derivation"
            for step in steps
            for claim in step.claims + step.others
        },
        **{figure.id: "a figure" for figure in document.figures},
        **{claim: "the graph of a slip" for edge in document.spread for claim in (edge.claim, edge.source)},
        **{claim: words for extra in document.extras.values() for claim, words in extra.named.items()},
    }
    for claim in sorted(set(named) - {finding.id for finding in document.findings}):
        raise BrokenLinkError(f"{named[claim]} names the claim {claim}, which the report does not have")
