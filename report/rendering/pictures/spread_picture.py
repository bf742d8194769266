"""How a slip spreads as a picture: a line for each statement, below what it follows from."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final
from xml.sax.saxutils import escape

from report.document.document import Document
from report.judging.finding import Finding
from report.judging.spread import Follows
from report.judging.verdict import Grade, grade
from report.rendering.pictures.verdict_picture import COLOURS
from report.rendering.summary import GRADES, SYMBOLS, capitalised, reference

NAME: Final = "spread"
"""Name of the picture among the drawings of the report."""
WIDTH, INDENT, EDGE, GAP = 400, 24, 11, 10
FIRST_LINE, NEXT_LINE, BELOW = 16, 15, 8
LINE, LINES_OF_TITLE = 52, 3
"""Characters in a line of a title, and lines of it."""


@dataclass(frozen=True)
class PlacedStatement:
    """A statement in the picture.

    Attributes:
        finding: What was found about it.
        depth: How many statements it follows from, one after the other.
        row: Its line, from 0.
        top: Upper edge of its box.
        how: How it follows from the one before; empty for the first.
        above: Lines of the statements that it follows from.
    """

    finding: Finding
    depth: int
    row: int
    top: float
    how: str
    above: tuple[int, ...]

    @property
    def title(self) -> tuple[str, ...]:
        """The title in lines."""
        return tuple(textwrap.wrap(capitalised(self.finding.title), LINE)[:LINES_OF_TITLE])

    @property
    def height(self) -> float:
        """Height of its box."""
        return FIRST_LINE + NEXT_LINE * len(self.title) + BELOW

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
    height = places[-1].top + places[-1].height + 2
    return "".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" class="spread" role="img" '
            f'viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" '
            f'font-family="Libertinus Serif" font-size="12" '
            f'aria-labelledby="{NAME}-title {NAME}-description">',
            f'<title id="{NAME}-title">How a slip spreads</title>',
            f'<desc id="{NAME}-description">{escape(description(document))}</desc>',
            *(_line(place, places[row]) for place in places for row in place.above),
            *(text for place in places for text in _box(place)),
            "</svg>",
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


def _left(place: PlacedStatement) -> float:
    return INDENT * place.depth + 1


def _line(place: PlacedStatement, above: PlacedStatement) -> str:
    start, end = _left(above) + EDGE, _left(place)
    level = place.top + place.height / 2
    return (
        f'<path class="edge" d="M{start},{above.top + above.height}V{level}H{end - 1}m-6,-4l6,4l-6,4" '
        f'fill="none" stroke="#888888" stroke-width="1.2"/>'
    )


def _box(place: PlacedStatement) -> Iterator[str]:
    left, top, colour = _left(place), place.top, COLOURS[place.grade]
    width = WIDTH - left - 2
    yield (
        f'<rect class="{place.grade.value}" x="{left}" y="{top}" width="{width}" '
        f'height="{place.height}" rx="3" '
        f'fill="none" stroke="{colour}" stroke-width="1.2"/>'
        f'<text x="{left + 8}" y="{top + FIRST_LINE}"><tspan font-weight="bold" class="black">'
        f"{escape(reference(place.finding))}</tspan>"
        f'<tspan dx="10" class="{place.grade.value}" fill="{colour}" '
        f'font-family="DejaVu Sans Mono" font-size="10">{SYMBOLS[place.grade]}</tspan> '
        f'<tspan class="{place.grade.value}" fill="{colour}">{_outcome(place)}</tspan></text>'
    )
    for number, line in enumerate(place.title, start=1):
        yield (
            f'<text x="{left + 8}" y="{top + FIRST_LINE + NEXT_LINE * number}" font-size="11" class="black">'
            f"{escape(line)}</text>"
        )


def _outcome(place: PlacedStatement) -> str:
    if not place.above:
        return "the slip is made"
    return "holds: the slip stops" if place.holds else GRADES[place.grade]
