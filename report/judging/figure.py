"""Figures to draw: what draws each, and what stands beside it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, final

import matplotlib.figure

from report.judging.text import RecordError, one_line
from report.pages.drawing.drawn import drawn
from report.pages.drawing.style import style
from report.pages.figure import Figure

Draw = Callable[[Any], matplotlib.figure.Figure]


@final
@dataclass(frozen=True)
class FigureWords:
    """Title, caption (Markdown) and alternative text of a figure."""

    title: str
    caption: str
    alternative_text: str


@final
@dataclass(frozen=True)
class FigureRecord:
    """A figure before it is drawn.

    Attributes:
        id: Its claim's id, or a place of its own in the report.
        draw: Draws it of what was solved.
        told: Gives its words.
    """

    id: str
    draw: Draw = field(repr=False)
    told: Callable[[], FigureWords] = field(repr=False)

    @property
    def words(self) -> FigureWords:
        """What stands beside it."""
        return self.told()

    def finished(self, known: Any) -> Figure:
        """Draw the figure; it is then an SVG with its words."""
        words = self.words
        return drawn(self.id, words.title, words.caption, words.alternative_text, lambda: self._made(known))

    def _made(self, known: Any) -> matplotlib.figure.Figure:
        made = self.draw(known)
        if made is None:
            raise RecordError(f"figure {self.id}: what draws it returns nothing; return a matplotlib Figure")
        return made


def recorded(figure_id: str, told: Callable[[], FigureWords]) -> Callable[[Draw], FigureRecord]:
    """Make a figure, in the report's look, of what draws it and of what gives its words."""
    return lambda draw: FigureRecord(figure_id, style()(draw), told)


def figure(
    figure_id: str, *, title: str, caption: str, alternative_text: str
) -> Callable[[Draw], FigureRecord]:
    """Make a figure of what draws it, with its words: plain text, the caption Markdown."""
    words = FigureWords(one_line(title), one_line(caption), one_line(alternative_text))
    return recorded(figure_id, lambda: words)
