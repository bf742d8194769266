from __future__ import annotations

import numpy as np
import pytest
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure

from tests.trimmer.maps.machines import impact_oscillator
from trimmer.drawing.cells import edges
from trimmer.drawing.mechanisms.kinds import categories, category
from trimmer.maps.cells import CellMotion, CellResult
from trimmer.maps.inputs import MapInputs, Settings
from trimmer.maps.measures import Measures
from trimmer.maps.result import MotionMap
from trimmer.response.response import MotionKind

KINDS = [(MotionKind.PERIODIC, 1), (MotionKind.PERIODIC, 2), (MotionKind.CHAOTIC, 0)]
MEASURES = Measures({"x": 1.0}, {"mass": 1.0}, {}, 1.0, 1.0, 1.0)


def drawn_map(values=((1.0, 1.1, 1.4), (8.0, 10.0))) -> MotionMap:
    inputs = MapInputs(
        impact_oscillator(), ("frequency", "stops.wall.gap")[: len(values)], values, Settings()
    )
    kinds = [KINDS[number % 3] for number in range(inputs.count)]
    cells = [
        CellResult(number, (CellMotion(kind, count, measures=MEASURES),))
        for number, (kind, count) in enumerate(kinds)
    ]
    return MotionMap(inputs, tuple(cells))


def legend(axes) -> dict[str, object]:
    found = axes.get_legend()
    return dict(zip([text.get_text() for text in found.get_texts()], found.legend_handles, strict=True))


def test_the_legend_names_the_kinds_that_occur_in_plain_words() -> None:
    axes = Figure().add_subplot()
    drawn_map().plot(axes)
    assert list(legend(axes)) == ["period 1", "period 2", "chaotic over 300 drive periods"]


def colour_at(axes, place: tuple[float, float]) -> str:
    """The colour of the area in which a place lies."""
    (found,) = (each for each in axes.patches if each.get_fill() and each.get_path().contains_point(place))
    return to_hex(found.get_facecolor())


def test_each_cell_has_the_colour_of_its_kind() -> None:
    axes = Figure().add_subplot()
    drawn_map().plot(axes)
    named = {name: to_hex(patch.get_facecolor()) for name, patch in legend(axes).items()}
    for second in (8.0, 10.0):
        for first, name in ((1.0, "period 1"), (1.1, "period 2"), (1.4, "chaotic over 300 drive periods")):
            assert colour_at(axes, (first, second)) == named[name]


def test_cells_reach_half_way_to_the_next_value() -> None:
    np.testing.assert_allclose(edges(np.array([1.0, 1.1, 1.4])), [0.95, 1.05, 1.25, 1.55])
    axes = Figure().add_subplot()
    drawn_map().plot(axes)
    assert colour_at(axes, (1.249, 8.9)) != colour_at(axes, (1.251, 8.9))
    assert [*axes.get_xlim(), *axes.get_ylim()] == pytest.approx([0.95, 1.55, 7.0, 11.0])


def test_values_that_fall_are_drawn_where_they_are() -> None:
    axes = Figure().add_subplot()
    drawn_map(values=((1.4, 1.1, 1.0), (8.0, 10.0))).plot(axes)
    named = {name: to_hex(patch.get_facecolor()) for name, patch in legend(axes).items()}
    assert colour_at(axes, (1.4, 8.0)) == named["period 1"]
    assert colour_at(axes, (1.0, 8.0)) == named["chaotic over 300 drive periods"]


def test_axes_have_units_and_readable_numbers() -> None:
    figure = Figure()
    axes = figure.add_subplot()
    drawn_map(values=((1.0, 1.1), (20e-6, 40e-6))).plot(axes)
    figure.canvas.draw()
    assert axes.get_ylabel() == "stops.wall.gap, µm"
    assert "20" in [text.get_text() for text in axes.get_yticklabels()]
    assert axes.get_xlabel() == "frequency, Hz"


def test_curves_are_drawn_over_the_map_and_named_once() -> None:
    axes = Figure().add_subplot()
    curve = np.array([[1.0, 8.0], [1.2, 9.0], [9.0, 9.0]])
    drawn_map().plot(axes, curves=[("fold", curve), ("grazing", curve + 0.1), ("fold", curve + 0.2)])
    assert list(legend(axes))[-2:] == ["fold", "grazing"]
    assert len(axes.lines) == 6  # each with a light border
    assert axes.get_xlim()[1] < 2


def test_a_map_over_one_place_is_a_stroke() -> None:
    axes = Figure().add_subplot()
    drawn_map(values=((1.0, 1.1, 1.4),)).plot(axes)
    assert axes.get_ylabel().startswith("x, peak to peak, ")
    assert list(legend(axes)) == ["period 1", "period 2", "chaotic over 300 drive periods"]


@pytest.mark.parametrize(("count", "name"), [(1, "period 1"), (6, "period 6"), (24, "period 7 or more")])
def test_periods_are_categories(count: int, name: str) -> None:
    assert category(CellMotion(MotionKind.PERIODIC, count)).name == name


def test_colours_differ_in_lightness_or_hue_for_readers_without_red_or_green() -> None:
    # Protanopia after Viénot, Brettel and Mollon (1999), in linear light: no two are alike.
    see = np.array([[0.11238, 0.88762, 0.0], [0.11238, 0.88762, 0.0], [0.00401, -0.00401, 1.0]])
    linear = [see @ np.array(to_rgb(each.colour)) ** 2.2 for each in categories()]
    seen = [np.clip(colour, 0, 1) ** (1 / 2.2) for colour in linear]
    assert min(abs(one - other).max() for at, one in enumerate(seen) for other in seen[:at]) > 0.1


def test_a_grey_print_tells_kinds_apart() -> None:
    def grey(colour: str) -> float:
        return float(np.array(to_rgb(colour)) @ [0.299, 0.587, 0.114])

    kinds = categories()
    for at, one in enumerate(kinds):
        for other in kinds[:at]:
            assert one.hatch != other.hatch or abs(grey(one.colour) - grey(other.colour)) > 0.1
