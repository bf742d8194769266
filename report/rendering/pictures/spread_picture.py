"""How a slip spreads as a picture: a line for each statement, below what it follows from."""

import textwrap
from dataclasses import dataclass
from typing import Final
from xml.sax.saxutils import escape

from markupsafe import Markup

from report.document.document import Document
from report.judging.finding import Finding
from report.judging.spread import Follows
from report.judging.verdict import Grade, grade
from report.pages.html import html_templates
from report.rendering.summary import COLOURS, GRADES, SYMBOLS, capitalised, reference

NAME: Final = "spread"  # Name of the picture among the drawings of the report
WIDTH, INDENT, GAP = 400, 24, 10
FIRST_LINE, NEXT_LINE, BELOW = 16, 15, 8
LINE, LINES_OF_TITLE = 52, 3  # Characters in a line of a title, and lines of it


@dataclass(frozen=True)
class PlacedStatement:
    """A statement in the picture."""

    finding: Finding  # What was found about it
    depth: int  # How many statements it follows from, one after the other
    row: int  # Its line, from 0
    top: float  # Upper edge of its box
    how: str  # How it follows from the one before; empty for the first
    above: tuple[int, ...]  # Lines of the statements that it follows from

    @property
    def title(self) -> tuple[str, ...]:
        """The title in lines."""
        return tuple(textwrap.wrap(capitalised(self.finding.title), LINE)[:LINES_OF_TITLE])

    @property
    def height(self) -> float:
        """Height of its box."""
        return FIRST_LINE + NEXT_LINE * len(self.title) + BELOW

    @property
    def left(self) -> float:
        """Left edge of its box."""
        return INDENT * self.depth + 1

    def line(self, number: int) -> float:
        """Return the height of a line of text in its box."""
        return self.top + FIRST_LINE + NEXT_LINE * number

    @property
    def grade(self) -> Grade:
        """Grade of the finding."""
        return grade(self.finding)

    @property
    def holds(self) -> bool:
        """Whether the statement is right although it follows from a wrong one: there the slip stops."""
        return self.grade is Grade.REPRODUCED


def spread(document: Document) -> tuple[PlacedStatement, ...]:
    """Return the statements of the graph, each below what it follows from."""
    findings = {finding.id: finding for finding in document.findings}
    edges = document.spread
    followers = {edge.claim for edge in edges}
    places: dict[str, PlacedStatement] = {}
    for root in dict.fromkeys(edge.source for edge in edges if edge.source not in followers):
        _add(places, root, "", edges, findings)
    return tuple(places.values())


def _add(
    places: dict[str, PlacedStatement],
    claim: str,
    how: str,
    edges: tuple[Follows, ...],
    findings: dict[str, Finding],
) -> None:
    """Add a statement once all that it follows from is there, then what follows from it."""
    sources = [edge.source for edge in edges if edge.claim == claim]
    if claim in places or any(source not in places for source in sources):
        return
    above = tuple(places[source] for source in sources)
    depth = 1 + max((place.depth for place in above), default=-1)
    rows = tuple(place.row for place in above)
    top = max((place.top + place.height + GAP for place in places.values()), default=2.0)
    places[claim] = PlacedStatement(findings[claim], depth, len(places), top, how, rows)
    for edge in edges:
        if edge.source == claim:
            _add(places, edge.claim, edge.how, edges, findings)


def spread_picture(document: Document) -> str:
    """Return the graph as SVG; the text in it stays text, and words repeat what colour says."""
    places = spread(document)
    return (
        html_templates()
        .get_template("spread.svg.j2")
        .render(
            **{"name": NAME, "places": places, "description": description(document), "width": WIDTH},
            **{"height": places[-1].top + places[-1].height + 2, "reference": reference},
            **{"colours": COLOURS, "symbols": SYMBOLS, "grades": GRADES, "text": svg_text},
        )
    )


def description(document: Document) -> str:
    """Return the graph in words, for a reader who does not see the picture."""
    places = spread(document)
    said = (
        f"{reference(place.finding)}, {GRADES[place.grade]}"
        + (
            f", follows from {' and '.join(reference(places[row].finding) for row in place.above)}"
            if place.above
            else ""
        )
        for place in places
    )
    return "; ".join(said) + "."


def svg_text(text: str) -> Markup:
    """Return text for a drawing, in which quotation marks stay as they are."""
    return Markup(escape(text))
