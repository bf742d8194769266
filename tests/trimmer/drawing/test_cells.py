"""Cells of a map as areas, their hatching, and the colours of kinds of motion and of basins."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from tests.trimmer import results
from trimmer.drawing.cells import draw_cells, edges
from trimmer.drawing.mechanisms import motion_map
from trimmer.drawing.mechanisms.kinds import HATCHES, LONGER, categories, category, legend_of
from trimmer.maps.cells import CellMotion
from trimmer.response.response import MotionKind


@pytest.mark.parametrize(("value", "half"), [(3.0, 1.5), (-3.0, 1.5), (0.0, 0.5)])
def test_a_single_value_has_room_around_it(value: float, half: float) -> None:
    np.testing.assert_allclose(edges(np.array([value])), [value - half, value + half])


def test_neighbours_of_one_colour_are_one_area() -> None:
    axes = Figure().add_subplot()
    first, second = np.array([3.0, 1.0, 2.0, 5.0]), np.array([20.0, 10.0])
    numbers = np.array([[4, 7, 7, 4], [7, 7, 4, 4]])
    draw_cells(axes, first, second, numbers, {7: "#ff0000", 4: "#00ff00"}, {4: "//"})
    filled, hatched, plain = axes.patches
    assert [to_hex(each.get_facecolor()) for each in (plain, filled)] == ["#ff0000", "#00ff00"]
    assert (hatched.get_fill(), hatched.get_hatch(), hatched.get_linewidth()) == (False, "//", 0)
    assert (plain.get_hatch(), filled.get_hatch()) == (None, None)
    np.testing.assert_array_equal(hatched.get_path().vertices, filled.get_path().vertices)
    # Columns are 1, 2, 3, 5, rows 10, 20: below red, green, red, green; above red, red, green, green.
    rectangles = plain.get_path().vertices.reshape(-1, 5, 2)
    found = [[*each.min(axis=0), *each.max(axis=0)] for each in rectangles]
    assert found == [[0.5, 5, 1.5, 15], [2.5, 5, 4.0, 15], [0.5, 15, 2.5, 25]]
    corners = [(0.5, 5), (1.5, 5), (1.5, 15), (0.5, 15), (0.5, 5)]
    np.testing.assert_array_equal(rectangles[0], corners)
    rectangles = filled.get_path().vertices.reshape(-1, 5, 2)
    found = [[*each.min(axis=0), *each.max(axis=0)] for each in rectangles]
    assert found == [[1.5, 5, 2.5, 15], [4.0, 5, 6.0, 15], [2.5, 15, 6.0, 25]]
    assert (axes.get_xlim(), axes.get_ylim()) == ((0.5, 6.0), (5.0, 25.0))


def test_kinds_have_their_own_colours() -> None:
    # Okabe and Ito's: sky blue for period 1, blue for 2, ..., purple for more than six; greys for others.
    found = {each.name: each.colour for each in categories()}
    assert list(found)[:7] == [*(f"period {count}" for count in range(1, 7)), "period 7 or more"]
    assert (found["period 1"], found["period 6"], found[LONGER]) == ("#56B4E9", "#D55E00", "#CC79A7")
    for count, name in ((1, "period 1"), (6, "period 6"), (7, LONGER)):
        each = category(CellMotion(MotionKind.PERIODIC, count))
        assert (each.name, each.colour, each.hatch) == (name, found[name], HATCHES.get(name, ""))
    chaotic = category(CellMotion(MotionKind.CHAOTIC, 0))
    assert (chaotic.name, chaotic.colour) == ("chaotic", "#222222")


def test_patches_of_a_legend_are_hatched_densely() -> None:
    shown = {each.get_label(): each for each in legend_of(categories(), 120)}
    assert shown["period 3"].get_hatch() == "////"
    assert shown["not settled within 120 drive periods"].get_hatch() == "||||"
    assert not shown["period 1"].get_hatch()
    assert to_hex(shown["period 1"].get_facecolor()) == "#56b4e9"


def test_motions_of_a_basin_have_colours_in_turn() -> None:
    repeats, chaos = CellMotion(MotionKind.PERIODIC, 1), CellMotion(MotionKind.CHAOTIC, 0)
    motions = (repeats, chaos, *(8 * [repeats]))
    basin = SimpleNamespace(motions=motions, names=[f"motion {number}" for number in range(10)])
    found = [motion_map._of_basin(basin, number) for number in range(10)]
    assert [each.name for each in found] == basin.names
    assert found[1] == replace(category(chaos), name="motion 1")
    in_turn = [each for number, each in enumerate(found) if number != 1]
    colours, hatches = motion_map.BASIN_COLOURS, motion_map.BASIN_HATCHES
    assert [each.colour for each in in_turn] == [*colours, *colours[:2]]
    assert [each.hatch for each in in_turn] == [*hatches, *hatches[:2]]


def test_a_basin_is_drawn_with_the_names_of_its_motions() -> None:
    basin = results.basin()
    axes = basin.plot(Figure().add_subplot())
    assert [text.get_text() for text in axes.get_legend().get_texts()] == list(basin.names)
    shown = {to_hex(each.get_facecolor()) for each in axes.patches if each.get_fill()}
    expected = {motion_map._of_basin(basin, number).colour.lower() for number in np.unique(basin.number)}
    assert shown == expected
    assert axes.get_xlabel().startswith("start.mass.displacement")
    assert axes.get_ylabel().startswith("start.mass.velocity")
