"""All drawings of the report as SVG, by the names under which its text asks for them."""

from __future__ import annotations

from report.document import Document
from report.rendering import spread_picture
from report.rendering.verdict_picture import NAME, verdict_picture


def drawings(document: Document) -> dict[str, str]:
    """Return the drawings: counts of verdicts, a slip's way, figures, pictures of steps."""
    pictures = (step.picture for step in document.steps if step.picture)
    stills = (document.explorable.still,) if document.explorable else ()
    figures = (*document.figures, *pictures, *stills)
    graph = {spread_picture.NAME: spread_picture.spread_picture(document)} if document.spread else {}
    return {NAME: verdict_picture(document), **graph, **{figure.id: figure.svg for figure in figures}}
