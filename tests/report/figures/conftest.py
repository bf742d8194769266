"""Figures, each drawn once for each test process."""

from functools import cache

import pytest

from report.collect import collect
from report.drawing.letters import letter_panels
from report.inventory import read_inventory

FIGURES = {figure.id: figure for figure in collect(read_inventory()).figures}


@pytest.fixture(scope="session")
def drawn(evidence):
    """Return a function that draws a figure by its id, with the letters of its panels."""

    def draw(figure_id):
        figure = FIGURES[figure_id].draw(evidence)
        letter_panels(figure)
        return figure

    return cache(draw)


@pytest.fixture(scope="session")
def drawn_axes(drawn):
    """Return a function that draws a figure by its id, and returns its axes."""
    return lambda figure_id: drawn(figure_id).axes
