"""Links inside the report: each has to lead somewhere."""

from __future__ import annotations

import re
from collections.abc import Iterable

from report.document.document import Document
from report.document.robustness import SurvivalRow

_INTERNAL_LINK = re.compile(r"\]\(#([^)\s]+)\)")
_IDENTIFIER = re.compile(r"(?<=[{ ])#([^\s}#]+)(?=[^{}\n]*\}\s*$)", re.MULTILINE)


class BrokenLinkError(ValueError):
    """The report links to a place that it does not have, or has the same place twice."""


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
        **{claim: "a research question" for answer in document.answers for claim in answer.claims},
        **{figure.id: "a figure" for figure in document.figures},
        **{claim: "the graph of a slip" for edge in document.spread for claim in (edge.claim, edge.source)},
        **{result.claim: f"the corrected result “{result.quantity}”" for result in document.corrected},
        **{row.claim: "how far it holds" for row in _survivals(document)},
    }
    for claim in sorted(set(named) - {finding.id for finding in document.findings}):
        raise BrokenLinkError(f"{named[claim]} names the claim {claim}, which the report does not have")


def _survivals(document: Document) -> tuple[SurvivalRow, ...]:
    return document.robustness.survivals if document.robustness else ()


def check_links(markdown: str, elsewhere: Iterable[str] = ()) -> None:
    """Check that places have names of their own and that each link leads to one.

    Args:
        markdown: the text of the report.
        elsewhere: identifiers of the places that the report has outside of this text.

    Raises:
        BrokenLinkError: listing the names that stand twice, or the links that lead nowhere.
    """
    identifiers = [*_IDENTIFIER.findall(markdown), *elsewhere]
    twice = sorted({identifier for identifier in identifiers if identifiers.count(identifier) > 1})
    if twice:
        raise BrokenLinkError(
            f"the report has these identifiers twice, rename one of each: {', '.join(twice)}"
        )
    broken = sorted(set(_INTERNAL_LINK.findall(markdown)) - set(identifiers))
    if broken:
        raise BrokenLinkError(
            f"the report links to places it does not have: {', '.join(broken)}; "
            "correct the link or add the claim, step or figure"
        )
