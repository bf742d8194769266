"""Maps and basins are areas in colours that readers tell apart, and curves lie over them."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex, to_rgb
from matplotlib.patches import Patch

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.pictures import legend, new_axes
from tests.trimmer.maps.machines import impact_oscillator
from trimmer.maps.cell_motion import CellMotion
from trimmer.maps.cells import CellResult
from trimmer.maps.inputs import MapInputs, Settings
from trimmer.maps.measures import CellMeasures

KIND = trimmer.MotionKind
MEASURES = CellMeasures({"x": 1.0}, {"mass": 1.0}, {}, 1.0, 1.0, 1.0)
THREE = ((KIND.PERIODIC, 1), (KIND.PERIODIC, 2), (KIND.CHAOTIC, 0))
NAMES = ("period 1", "period 2", "chaotic over 300 drive periods")
ALL = (
    *((KIND.PERIODIC, count) for count in range(1, 8)),
    *((kind, 0) for kind in KIND if kind is not KIND.PERIODIC),
)
"""All kinds of motion; what has a period of 7 or more is one kind."""


def drawn_map(values=((1.0, 1.1, 1.4), (8.0, 10.0)), kinds=THREE, machine=None) -> trimmer.MotionMap:
    """A map whose cells have the kinds in turn."""
    inputs = MapInputs(
        machine or impact_oscillator(), ("frequency", "stops.wall.gap")[: len(values)], values, Settings()
    )
    motions = [CellMotion(*kinds[number % len(kinds)], measures=MEASURES) for number in range(inputs.count)]
    return trimmer.MotionMap(
        inputs, tuple(CellResult(number, (motion,)) for number, motion in enumerate(motions))
    )


def patches(axes: Axes) -> dict[str, Patch]:
    return dict(zip(legend(axes), axes.get_legend().legend_handles, strict=True))


def colour_at(axes: Axes, place: tuple[float, float]) -> str:
    """The colour of the area in which a place lies."""
    (found,) = (each for each in axes.patches if each.get_fill() and each.get_path().contains_point(place))
    return to_hex(found.get_facecolor())


@pytest.mark.parametrize("first", [(1.0, 1.1, 1.4), (1.4, 1.1, 1.0), (1.1, 1.4, 1.0)], ids=str)
def test_each_cell_has_the_colour_that_the_legend_names(first: tuple[float, ...]) -> None:
    axes = drawn_map((first, (10.0, 8.0))).plot(new_axes())
    named = {name: to_hex(patch.get_facecolor()) for name, patch in patches(axes).items()}
    assert tuple(named) == NAMES
    for place, name in zip(first, NAMES, strict=True):
        assert {colour_at(axes, (place, second)) for second in (8.0, 10.0)} == {named[name]}
    assert [*axes.get_xlim(), *axes.get_ylim()] == pytest.approx([0.95, 1.55, 7.0, 11.0])


@pytest.mark.parametrize(("value", "ends"), [(3.0, (1.5, 4.5)), (0.0, (-0.5, 0.5))])
def test_a_single_value_has_room_around_it(value: float, ends: tuple[float, float]) -> None:
    axes = drawn_map(((1.0, 1.1), (value,))).plot(new_axes())
    assert axes.get_ylim() == ends


def test_all_kinds_are_told_apart_without_colours_and_by_readers_without_red_or_green() -> None:
    """A grey print, and protanopia after Viénot, Brettel and Mollon (1999), in linear light."""
    frequencies = tuple(1.0 + 0.1 * number for number in range(len(ALL)))
    axes = drawn_map((frequencies, (8.0,)), ALL).plot(new_axes())
    kinds = list(patches(axes).values())
    assert "period 7 or more" in legend(axes)
    assert len(kinds) == len(ALL)
    see = np.array([[0.11238, 0.88762, 0.0], [0.11238, 0.88762, 0.0], [0.00401, -0.00401, 1.0]])
    colours = [np.array(to_rgb(each.get_facecolor())) for each in kinds]
    seen = [np.clip(see @ colour**2.2, 0, 1) ** (1 / 2.2) for colour in colours]
    greys = [colour @ [0.299, 0.587, 0.114] for colour in colours]
    for at, one in enumerate(kinds):
        for other in range(at):
            assert abs(seen[at] - seen[other]).max() > 0.1
            assert one.get_hatch() != kinds[other].get_hatch() or abs(greys[at] - greys[other]) > 0.1
    hatched = {each.get_hatch() for each in axes.patches if not each.get_fill()}
    assert {2 * each for each in hatched} == {each.get_hatch() for each in kinds if each.get_hatch()}


def test_a_map_over_one_place_without_an_output_tells_impacts() -> None:
    bare = drawn_map(((1.0, 1.1, 1.4),), machine=replace(impact_oscillator(), outputs={}))
    axes = bare.plot(new_axes())
    np.testing.assert_allclose(axes.collections[0].get_offsets()[:, 1], bare.impacts[0])
    assert axes.get_ylabel() == "impacts per drive period"


def test_curves_are_drawn_over_a_map_and_named_once() -> None:
    curve = np.array([[1.0, 8.0], [1.2, 9.0], [9.0, 9.0]])
    given = [("fold", curve), ("grazing", curve + 0.1), ("fold", curve + 0.2)]
    axes = drawn_map().plot(new_axes(), curves=given)
    assert legend(axes)[-2:] == ["fold", "grazing"]
    under, over = axes.lines[::2], axes.lines[1::2]  # each with a light border
    assert [line.get_linestyle() for line in over] == ["-", "--", "-"]
    for one, other, (_, places) in zip(under, over, given, strict=True):
        np.testing.assert_array_equal(one.get_xydata(), places)
        np.testing.assert_array_equal(other.get_xydata(), places)
    assert axes.get_xlim() == pytest.approx((0.95, 1.55))


def test_curves_over_what_is_drawn_keep_its_limits_names_and_legend() -> None:
    axes = results.motion_map().plot(new_axes())
    before = (axes.get_xlim(), axes.get_ylim(), axes.get_xlabel(), legend(axes))
    results.curves().plot(axes)
    assert (axes.get_xlim(), axes.get_ylim(), axes.get_xlabel(), legend(axes)[:-1]) == before
    assert legend(axes)[-1] == "fold"
    plain = new_axes()
    plain.plot([0.0, 1.0], [0.0, 1.0])
    results.locus().plot(plain)
    assert (legend(plain), plain.get_xlabel()) == (["fold"], "")


def test_motions_of_a_basin_have_colours_in_turn_but_for_those_that_do_not_repeat() -> None:
    kinds = [THREE[0], THREE[2], *(8 * [THREE[0]])]
    values = (tuple(range(1, 11)), (8.0, 9.0))
    result = drawn_map(values, kinds)
    motions = tuple(cell.motions[0] for cell in result.cells[:10])
    basin = trimmer.maps.Basin(result, motions, np.tile(np.arange(10), (2, 1)))
    shown = list(patches(basin.plot(new_axes())).values())
    colours = [to_hex(each.get_facecolor()) for each in shown]
    looks = [(colour, each.get_hatch()) for colour, each in zip(colours, shown, strict=True)]
    chaos = to_hex(patches(drawn_map().plot(new_axes()))[NAMES[2]].get_facecolor())
    assert colours[1] == chaos
    in_turn = looks[:1] + looks[2:]
    assert len(set(in_turn)) == 7 and in_turn[7:] == in_turn[:2]
