"""Pictures of branches, and of curves on which special points lie."""

from __future__ import annotations

import numpy as np
import pytest

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.blank import new_axes
from trimmer.drawing.look import BLACK
from trimmer.drawing.mechanisms.branch import branch_figure

FOLD = 8.566394 / (2 * np.pi)
"""Published of pyHarm's example, see ``machines.impact_oscillator``; Hz."""


def test_a_branch_is_drawn_with_its_stability() -> None:
    branch = results.branch()
    axes = branch.plot(new_axes())
    solid = [each for each in axes.lines if each.get_label() == "stable, period 1"]
    dashed = [each for each in axes.lines if each.get_label() == "unstable, period 1"]
    places = np.array([(point.value, point.outputs["x"].peak_to_peak) for point in branch.points])
    stable = np.array([point.stable for point in branch.points])
    for lines, wanted in ((solid, stable), (dashed, ~stable)):
        drawn = {tuple(place) for line in lines for place in line.get_xydata()}
        assert {tuple(place) for place in places[wanted]} <= drawn
        assert len(drawn) <= wanted.sum() + len(lines)  # each stretch begins at the end of the one before
    assert {line.get_linestyle() for line in solid} == {"-"}
    assert {line.get_linestyle() for line in dashed} == {"--"}
    assert axes.get_xlabel() == "frequency, Hz"


def test_special_points_are_marked_and_named() -> None:
    axes = results.branch().plot(new_axes())
    (fold,) = (each for each in axes.lines if each.get_label() == "fold")
    assert fold.get_xdata() == pytest.approx(FOLD, rel=1e-5)
    assert (fold.get_color(), fold.get_marker()) == (BLACK, "v")


def test_each_output_has_a_panel() -> None:
    (panel,) = branch_figure(results.branch()).axes
    assert panel.get_ylabel().startswith("x, peak to peak")


def test_an_output_that_is_not_there_is_refused() -> None:
    with pytest.raises(trimmer.MechanismError, match="no output is called 'y'; there are x"):
        results.branch().plot(new_axes(), output="y")


def test_curves_alone_have_the_units_of_their_numbers() -> None:
    axes = results.locus().plot(new_axes())
    _, curve = axes.lines
    np.testing.assert_array_equal(curve.get_xydata(), results.locus().values)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("frequency, Hz", "stops.wall.gap, µm")


def test_curves_over_a_map_keep_its_limits_and_its_legend() -> None:
    axes = results.motion_map().plot(new_axes())
    limits = axes.get_xlim(), axes.get_ylim()
    results.curves().plot(axes)
    assert (axes.get_xlim(), axes.get_ylim()) == limits
    assert [text.get_text() for text in axes.get_legend().get_texts()][-1] == "fold"
    assert axes.get_xlabel() == "frequency, Hz"
    assert len(axes.get_legend().get_texts()) > 1
