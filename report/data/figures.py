"""Figures to draw: what draws each, and what stands beside it in ``figures.toml``."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, final

import matplotlib.figure

from report.judging.text import RecordError, one_line
from report.pages.drawing.drawn import drawn
from report.pages.drawing.style import style
from report.pages.figure import Figure

Draw = Callable[[Any], matplotlib.figure.Figure]

PATH = Path(__file__).with_name("figures.toml")


@final
@dataclass(frozen=True)
class FigureWords:
    """Title, caption (Markdown) and alternative text of a figure."""

    title: str
    caption: str
    alternative_text: str


@cache
def figure_words() -> Mapping[str, FigureWords]:
    """Read the words of all figures, by id."""
    figures = tomllib.loads(PATH.read_text(encoding="utf-8")).items()
    return {name: FigureWords(**{key: one_line(each) for key, each in of.items()}) for name, of in figures}


@final
@dataclass(frozen=True)
class FigureRecord:
    """A figure before it is drawn: its claim's id, or a place of its own in the report, and what draws it."""

    id: str
    draw: Draw = field(repr=False)

    @property
    def words(self) -> FigureWords:
        """What stands beside it.

        Raises:
            RecordError: if nothing does.
        """
        if self.id not in figure_words():
            raise RecordError(f"{PATH.name} has no [{self.id!r}]: add title, caption and alternative_text")
        return figure_words()[self.id]

    def finished(self, known: Any) -> Figure:
        """Draw the figure; it is then an SVG with its words."""
        words = self.words
        return drawn(self.id, words.title, words.caption, words.alternative_text, lambda: self.draw(known))


def figure(figure_id: str) -> Callable[[Draw], FigureRecord]:
    """Make a figure, in the report's look, of what draws it."""
    return lambda draw: FigureRecord(figure_id, style()(draw))
