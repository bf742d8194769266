"""All drawings of the report as SVG, by the names under which its text asks for them."""

from report.document.document import Document
from report.rendering.pictures import spread_picture


def drawings(document: Document) -> dict[str, str]:
    """Return the drawings: a slip's way, all figures, and pictures of steps."""
    pictures = (step.picture for step in document.steps if step.picture)
    graph = {spread_picture.NAME: spread_picture.spread_picture(document)} if document.spread else {}
    figures = {figure.id: figure.svg for figure in (*document.drawings, *pictures)}
    return {**graph, **figures}
