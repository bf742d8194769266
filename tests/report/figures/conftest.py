"""Figures, each drawn once for each test process."""

from functools import cache

import pytest

from report.building.collect import collect
from report.data.figures import FigureRecord
from report.data.statements import read_inventory
from report.explorable import make
from report.future_work.chapter import SECTIONS
from report.judging.figure import recorded
from report.pages.drawing.letters import letter_panels
from report.twin.figures.bridge import bridge_in_slot
from report.twin.figures.design import design_limits
from report.twin.figures.loop import loop_branches
from report.twin.figures.maps import branches_over_gap, friction_map, speed_map
from report.twin.figures.motion import motions, spectra

MAPS = friction_map, speed_map, bridge_in_slot
TWIN = (*MAPS, motions, spectra, branches_over_gap, loop_branches, design_limits)
"""Figures of the chapter on the twin, which belong to no claim."""
FUTURE = tuple(each for section in SECTIONS for each in section.items if isinstance(each, FigureRecord))
"""Figures of the answers to section 6.4."""
STILL = recorded("explorable-still", dict)(make.picture)
FIGURES = {figure.id: figure for figure in (*collect(read_inventory()).figures, *TWIN, *FUTURE)}
DRAWN = FIGURES | {STILL.id: STILL}


@pytest.fixture(scope="session")
def drawn(evidence):
    """Return a function that draws a figure by its id, with the letters of its panels."""

    def draw(figure_id):
        figure = DRAWN[figure_id].draw(evidence)
        letter_panels(figure)
        return figure

    return cache(draw)
