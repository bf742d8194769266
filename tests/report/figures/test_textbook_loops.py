"""The drawn intersections lie on both curves, and what is shaded is what is encircled."""

import numpy as np
import pytest

from report.chapters.chapter_2.figures import textbook_loops
from report.numbers.textbook_loops import backlash_loop, relay_loop
from tests.report.figures.lines import curve


def distance(points, point):
    """Distance from a point to a chain of straight lines."""
    steps = np.diff(points)
    share = np.clip(((point - points[:-1]) * steps.conj()).real / np.abs(steps) ** 2, 0, 1)
    return np.abs(points[:-1] + share * steps - point).min()


@pytest.fixture(scope="module")
def two():
    return textbook_loops.two_limit_cycles.draw(None).axes


def test_the_relay_s_limit_cycle_lies_on_all_four_curves():
    plane, equations = textbook_loops.one_limit_cycle.draw(None).axes
    (cycle,) = relay_loop().limit_cycles()
    (marked,) = (each for each in plane.lines if each.get_marker() == "o")
    point = complex(marked.get_xdata()[0], marked.get_ydata()[0])
    assert distance(curve(plane, r"$G(j\omega)$"), point) < 1e-4
    assert distance(curve(plane, "$-1/N(A)$"), point) < 1e-4
    for contour in equations.collections:
        vertices = np.concatenate([path.vertices for path in contour.get_paths()])
        assert np.abs(vertices - (cycle.omega, cycle.amplitude)).sum(axis=1).min() < 1e-2


@pytest.mark.parametrize("index", [0, 1])
def test_operating_points_are_shaded_as_the_rule_says(two, index):
    axes = two[index]
    (shade,) = axes.patches
    marked = {each.get_marker(): each for each in axes.lines if each.get_marker() in "^ov"}
    larger, smaller = (
        shade.get_path().contains_point((marked[marker].get_xdata()[0], marked[marker].get_ydata()[0]))
        for marker in "^v"
    )
    assert (larger, smaller) == ((True, False), (False, True))[index]
    middle = complex(marked["o"].get_xdata()[0], marked["o"].get_ydata()[0])
    assert distance(curve(axes, r"$G(j\omega)$"), middle) < 1e-3
    assert distance(curve(axes, "$-1/N(A)$"), middle) < 1e-3
    words = {text.get_text() for text in axes.texts}
    assert {"$L_1$, unstable", "$L_2$, stable"} & words == {("$L_1$, unstable", "$L_2$, stable")[index]}


def test_arrows_point_to_a_rising_parameter(two):
    axes, loop = two[0], backlash_loop()
    inverse = curve(axes, "$-1/N(A)$")
    assert abs(inverse[0]) > abs(inverse[-1])  # small amplitudes are far away
    rising = loop.inverse_element(np.array([0.7, 0.8]))
    for arrow in (text for text in axes.texts if not text.get_text()):
        start, end = complex(*arrow.xyann), complex(*arrow.xy)
        if distance(inverse, start) < 1e-9:
            assert ((end - start) * np.conj(rising[1] - rising[0])).real > 0


def test_the_simulated_amplitudes_leave_the_first_and_reach_the_second(two):
    history = two[2]
    first, second = backlash_loop().limit_cycles()
    ends = {each.get_label(): each.get_ydata()[-1] for each in history.lines if len(each.get_ydata()) > 2}
    assert ends["started at 0.9 $A_1$"] == pytest.approx(0, abs=1e-6)
    assert ends["started at 1.1 $A_1$"] == pytest.approx(second.amplitude, rel=0.01)
    assert ends["started at 10 $A_1$"] == pytest.approx(second.amplitude, rel=0.01)
    levels = sorted(each.get_ydata()[0] for each in history.lines if len(each.get_ydata()) == 2)
    assert levels == pytest.approx([first.amplitude, second.amplitude])
