"""Block diagrams: every arrow ends at a block, a junction or outside, and the names are the text's."""

import numpy as np
import pytest
from matplotlib.patches import Circle, Rectangle

from report.chapters.chapter_2.figures import block_diagrams

DIAGRAMS = {
    block_diagrams.linear_system: {"$G(s)$", "$u(t)$", "$y(t)$"},
    block_diagrams.feedback_system: {"$G(s)$", "$N(s)$", "$U(s)$", "$Y(s)$", "$+$", "$-$"},
    block_diagrams.loop_without_reference: {
        r"$N(A,\omega)$",
        r"$G(j\omega)$",
        "$r(t) = 0$",
        "$e$",
        "$u$",
        "$y$",
        "$-$",
    },
    block_diagrams.describing_function_block: {r"$N(A,\omega)$", r"$A\,\sin\omega t$"},
    block_diagrams.parallel_nonlinearities: {
        "$G_m(s)$",
        "$G_g(s)$",
        r"$G_m(s)\,G_g(s)$",
        "$N_f$",
        "$N_r$",
        "$1/G_g(s)$",
        "$v$",
        "$x$",
    },
}


def on_edge(patch, x, y):
    if isinstance(patch, Circle):
        return np.isclose(np.hypot(x - patch.center[0], y - patch.center[1]), patch.radius)
    (left, bottom), width, height = patch.get_xy(), patch.get_width(), patch.get_height()
    beside = np.isclose(x, [left, left + width]).any() and bottom <= y <= bottom + height
    above = np.isclose(y, [bottom, bottom + height]).any() and left <= x <= left + width
    return beside or above


def heads(axes):
    return [text.xy for text in axes.texts if getattr(text, "arrow_patch", None)]


@pytest.mark.parametrize("figure", DIAGRAMS, ids=lambda figure: figure.id)
def test_names_of_the_text_are_there(figure):
    (axes,) = figure.draw(None).axes
    assert {text.get_text() for text in axes.texts} >= DIAGRAMS[figure]


@pytest.mark.parametrize("figure", DIAGRAMS, ids=lambda figure: figure.id)
def test_arrows_end_at_something_or_leave(figure):
    (axes,) = figure.draw(None).axes
    shapes = [patch for patch in axes.patches if isinstance(patch, (Circle, Rectangle))]
    width = axes.get_xlim()[1]
    for x, y in heads(axes):
        assert x > width - 0.35 or any(on_edge(shape, x, y) for shape in shapes), (x, y)


def test_each_block_of_the_parallel_configuration_has_one_input():
    (axes,) = block_diagrams.parallel_nonlinearities.draw(None).axes
    for block in (patch for patch in axes.patches if isinstance(patch, Rectangle)):
        assert sum(bool(on_edge(block, x, y)) for x, y in heads(axes)) == 1


def test_both_feedbacks_are_subtracted():
    (axes,) = block_diagrams.parallel_nonlinearities.draw(None).axes
    junctions = [patch for patch in axes.patches if isinstance(patch, Circle)]
    entering = sum(any(bool(on_edge(each, x, y)) for each in junctions) for x, y in heads(axes))
    assert entering == 4
    assert [text.get_text() for text in axes.texts].count("$-$") == 4
