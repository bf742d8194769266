"""Figures of the thesis's report, whose words stand in ``figures.toml``."""

import tomllib
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path

from report.judging.figure import Draw, FigureRecord, FigureWords, recorded
from report.judging.text import RecordError, one_line

PATH = Path(__file__).with_name("figures.toml")


@cache
def figure_words() -> Mapping[str, FigureWords]:
    """Read the words of all figures, by id."""
    figures = tomllib.loads(PATH.read_text(encoding="utf-8")).items()
    return {name: FigureWords(**{key: one_line(each) for key, each in of.items()}) for name, of in figures}


def figure(figure_id: str) -> Callable[[Draw], FigureRecord]:
    """Make a figure, in the report's look, of what draws it; its words are read when they are asked for."""
    return recorded(figure_id, lambda: _words(figure_id))


def _words(figure_id: str) -> FigureWords:
    if figure_id not in figure_words():
        raise RecordError(f"{PATH.name} has no [{figure_id!r}]: add title, caption and alternative_text")
    return figure_words()[figure_id]
