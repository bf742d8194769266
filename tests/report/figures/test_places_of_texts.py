"""Titles fit, and texts stand beside curves: those that are like others are slow."""

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from report.pages.drawing.letters import panels_of
from report.pages.drawing.style import style
from tests.report.figures import conftest

STEP = 2.0  # Distance of the points of a curve that are looked for under a text, in pixels
QUICK = ("fig-1.1", "fig-2.9", "fig-2.14", "fig-3.4", "fig-3.8", "fig-5.8", "fig-5.15", "twin-map-friction")
MARGIN = np.array([1.0, 2.0])
"""What a curve may reach into the box of a text, across and up, in pixels; it is larger than the letters."""


@pytest.mark.parametrize(
    "figure_id",
    [pytest.param(each, marks=[] if each in QUICK else pytest.mark.slow) for each in conftest.FIGURES],
)
def test_titles_fit_and_texts_stand_beside_curves(figure_id, drawn):
    drawing = drawn(figure_id)
    with style():
        canvas = FigureCanvasAgg(drawing)
        drawing.draw_without_rendering()
        titles = [(axes, extent(left_title(axes), canvas)) for axes in panels_of(drawing)]
        texts = [(axes, text) for axes in drawing.axes if axes.axison for text in axes.texts]
        boxes = [(axes, text.get_text(), extent(text, canvas)) for axes, text in texts if text.get_text()]
    for position, (_, box) in enumerate(titles):
        assert box.x1 <= drawing.bbox.x1
        assert not any(box.overlaps(other) for _, other in titles[:position] if other.width)
    for axes, text, box in boxes:
        assert axes.bbox.x0 - 1 <= box.x0 and box.x1 <= drawing.bbox.x1, text
        assert not any(runs_through(line, box, axes.bbox) for line in axes.lines if line.get_clip_on()), text


def left_title(axes):
    """The text that stands at the left above axes."""
    texts = [each for each in axes.get_children() if isinstance(each, Text)]
    return next(each for each in texts if each.get_text() == axes.get_title(loc="left"))


def extent(text, canvas):
    """The box of a text alone, without the arrow of an annotation."""
    return Text.get_window_extent(text, canvas.get_renderer())


def runs_through(line, box, view):
    """Say whether a curve, as far as it is seen, runs through the inside of a box."""
    points = line.get_transform().transform(np.array(line.get_data(orig=False), float).T)
    points = points[np.isfinite(points).all(axis=1)]
    counts = np.clip(np.hypot(*np.diff(points, axis=0).T) / STEP, 1, 2000).astype(int)
    places = np.arange(counts.sum()) - np.repeat(counts.cumsum() - counts, counts)
    shares = (places / np.repeat(np.maximum(counts - 1, 1), counts))[:, None]
    dense = (1 - shares) * np.repeat(points[:-1], counts, axis=0) + shares * np.repeat(
        points[1:], counts, axis=0
    )
    points = np.concatenate([points, dense])
    seen = np.all((points >= view.min) & (points <= view.max), axis=1)
    inside = np.all(np.abs(points - (box.min + box.max) / 2) < box.size / 2 - MARGIN, axis=1)
    return bool((seen & inside).any())
