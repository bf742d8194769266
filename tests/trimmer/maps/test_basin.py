"""Basins: which motion each start leads to."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from tests.trimmer.maps.machines import impact_oscillator
from trimmer import SerialRunner, basin
from trimmer.contact.flow import MechanismFlow
from trimmer.errors import MapError, MechanismError, WrongTypeError

SERIAL = SerialRunner()
SLICE = {"mass.displacement": np.linspace(-25, 12, 5), "mass.velocity": np.linspace(-100, 100, 5)}


@pytest.fixture(scope="module")
def found():
    return basin(impact_oscillator(), SLICE, runner=SERIAL)


def test_two_motions_share_the_plane(found) -> None:
    assert len(found.motions) == 2
    assert sum(found.shares) == pytest.approx(1)
    strokes = [motion.measures.peak_to_peak["x"] for motion in found.motions]
    # The motion without contact is linear.
    assert min(strokes) == pytest.approx(200 / abs(40 - 7.5**2 + 0.1j * np.sqrt(40) * 7.5), rel=1e-9)


@pytest.mark.parametrize("cell", [(0, 0), (2, 3), (4, 1)])
def test_each_cell_is_where_its_start_leads_to(found, cell) -> None:
    row, column = cell
    start = SLICE["mass.displacement"][column], SLICE["mass.velocity"][row]
    flow = MechanismFlow(impact_oscillator())
    end = flow.strobe(flow.rest({"mass": start}), 400).states[-1]
    reached = np.array(found.motions[found.number[cell]].states[0])
    np.testing.assert_allclose(end, reached, atol=1e-6 * abs(reached).max())


def test_each_start_has_a_row(found) -> None:
    frame = found.to_dataframe()
    assert frame["motion"].tolist() == (found.number.ravel() + 1).tolist()
    assert frame["period_count"].tolist() == [1] * 25
    assert frame.iloc[7, :2].tolist() == [SLICE["mass.displacement"][2], SLICE["mass.velocity"][1]]
    shares = np.bincount(found.number.ravel()) / 25
    assert found.shares == pytest.approx(shares, rel=1e-12)
    assert found.names == ("1: period 1", "2: period 1")
    assert f"1: period 1, {shares[0]:.0%}" in repr(found)


def test_places_may_be_written_as_in_the_file(found) -> None:
    longer = {f"start.{place}": values for place, values in SLICE.items()}
    np.testing.assert_array_equal(basin(impact_oscillator(), longer, runner=SERIAL).number, found.number)


def test_the_drawing_numbers_the_motions_from_one(found) -> None:
    axes = Figure().add_subplot()
    found.plot(axes)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["1: period 1", "2: period 1"]


@pytest.mark.parametrize("place", ["mass.mass", "stops.wall.gap", "mass"])
def test_what_is_no_initial_value_is_refused(place: str) -> None:
    with pytest.raises(MapError, match="no initial value"):
        basin(impact_oscillator(), {place: [1.0]})


@pytest.mark.parametrize("values", [3, [1.0], {3: [1.0]}])
def test_a_wrong_type_is_named(values: object) -> None:
    with pytest.raises(WrongTypeError, match="must be"):
        basin(impact_oscillator(), values)  # type: ignore[arg-type]


def test_a_body_that_is_not_there_is_named() -> None:
    with pytest.raises(MechanismError, match=r"did you mean start\.mass\.velocity"):
        basin(impact_oscillator(), {"mas.velocity": [1.0]})


def test_a_slice_over_one_value_is_not_drawn() -> None:
    found = basin(impact_oscillator(), {"mass.velocity": [0.0, 50.0]}, runner=SERIAL)
    with pytest.raises(MapError, match="vary two"):
        found.plot(Figure().add_subplot())
