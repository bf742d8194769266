"""What a map makes of its cells, with motions made by hand."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer.contact.advance import Ending
from trimmer.contact.flow import ExactFlow
from trimmer.errors import UnsupportedMotionError
from trimmer.json_data import parsed_json, typed
from trimmer.maps import cells as cell_work
from trimmer.maps.basin import Basin
from trimmer.maps.cells import (
    Cell,
    CellMotion,
    CellResult,
    CellWork,
    _add,
    _described,
    _motion,
    _starts,
    alike,
    described,
    same_motion,
    start_scales,
)
from trimmer.maps.inputs import MapInputs, Settings
from trimmer.maps.measures import Measures
from trimmer.maps.result import MotionMap
from trimmer.maps.settle import Settled
from trimmer.mechanism import Mechanism, Pin, Play, Stop
from trimmer.response.response import MotionKind

PERIODIC, CHAOTIC, UNDECIDED = MotionKind.PERIODIC, MotionKind.CHAOTIC, MotionKind.UNDECIDED
INPUTS = MapInputs(
    impact_oscillator(),
    ("frequency", "stops.wall.gap"),
    ((1.0, 1.1, 1.2), (8.0, 10.0)),
    Settings(starts=3, seed=5),
)


def measures(number: float) -> Measures:
    return Measures(
        {"x": 10.0 + number}, {"mass": 20.0 + number}, {}, 30.0 + number, 40.0 + number, 50.0 + number
    )


def periodic(*states: Sequence[float], starts: int = 1, number: float = 0.0) -> CellMotion:
    return CellMotion(
        PERIODIC,
        len(states),
        24,
        0.25 + number,
        states=tuple(map(tuple, states)),
        measures=measures(number),
        starts=starts,
    )


ORBIT = periodic((1.0, 2e-5))
OTHER = periodic((-1.0, 2e-5), number=1.0)
CHAOS = CellMotion(CHAOTIC, periods=300, lyapunov=0.5, states=((0.3, 0.4),), measures=measures(2.0))
FAILED = CellMotion(UNDECIDED, failure="it was too fast")


def made() -> MotionMap:
    """A map of six cells, of which the second has three motions and the last one failed."""
    motions = [
        (ORBIT,),
        (OTHER, ORBIT, CHAOS),
        (CHAOS,),
        (ORBIT,),
        (periodic((1.0, 0.0), (2.0, 1.0), number=3.0),),
        (FAILED,),
    ]
    return MotionMap(INPUTS, tuple(CellResult(number, each) for number, each in enumerate(motions)))


def test_cells_run_along_the_first_place() -> None:
    assert INPUTS.count == 6
    assert [INPUTS.cell_values(number) for number in (0, 2, 3, 5)] == [
        (1.0, 8.0),
        (1.2, 8.0),
        (1.0, 10.0),
        (1.2, 10.0),
    ]
    one = MapInputs(INPUTS.mechanism, ("frequency",), ((1.0, 1.1),), Settings())
    assert (one.count, one.cell_values(1)) == (2, (1.1,))


def test_arrays_are_of_the_first_motions_row_by_row() -> None:
    found = made()
    nan = math.nan
    assert found.shape == (2, 3)
    assert found.kind.tolist() == [[PERIODIC, PERIODIC, CHAOTIC], [PERIODIC, PERIODIC, UNDECIDED]]
    assert found.period_count.tolist() == [[1, 1, 0], [1, 2, 0]]
    assert found.periods.tolist() == [[24, 24, 300], [24, 24, 0]]
    assert found.motion_count.tolist() == [[1, 3, 1], [1, 1, 1]]
    for array, first in (
        (found.stroke, 10.0),
        (found.peak_to_peak["x"], 10.0),
        (found.rms_acceleration["mass"], 20.0),
        (found.events, 30.0),
        (found.impacts, 40.0),
        (found.impact_speed, 50.0),
    ):
        np.testing.assert_array_equal(array, first + np.array([[0.0, 1.0, 2.0], [0.0, 3.0, nan]]))
    np.testing.assert_array_equal(found.lyapunov, [[nan, nan, 0.5], [nan, nan, nan]])
    np.testing.assert_array_equal(found.largest_multiplier, [[0.25, 1.25, nan], [0.25, 3.25, nan]])
    assert found.failures == {(1, 2): "it was too fast"}
    assert found.units == ("Hz", "m")
    assert [values.tolist() for values in found.values] == [[1.0, 1.1, 1.2], [8.0, 10.0]]


def test_the_table_of_a_map_has_a_row_for_each_cell() -> None:
    found = made()
    table = found._table()
    rows = list(table.rows())
    assert [row[:2] for row in rows] == [(b, a) for a in (8.0, 10.0) for b in (1.0, 1.1, 1.2)]
    assert rows[1][2:] == (
        PERIODIC,
        1,
        24,
        3,
        1.25,
        pytest.approx(math.nan, nan_ok=True),
        31.0,
        41.0,
        51.0,
        11.0,
        21.0,
    )
    assert table.units["outputs.x.peak_to_peak"] == "m"
    assert [column.name for column in table.columns[-2:]] == [
        "outputs.x.peak_to_peak",
        "bodies.mass.rms_acceleration",
    ]
    assert "3 x 2 cells over frequency and stops.wall.gap: 3 period 1" in str(found)


def test_what_was_searched_counts_starts_and_several_motions() -> None:
    told = made().searched
    assert told.startswith("6 cells, each from rest and from 2 random states (seed 5), for at most 300 drive")
    assert "; 1 of them have several motions" in told
    twice = MapInputs(INPUTS.mechanism, INPUTS.places, INPUTS.values, Settings(starts=2))
    cells = [CellResult(0, (ORBIT, OTHER)), *made().cells[1:]]
    told = MotionMap(twice, tuple(cells)).searched
    assert "each from rest and from 1 random states (seed 0)" in told
    assert "; 2 of them have several motions" in told
    alone = MapInputs(INPUTS.mechanism, INPUTS.places, INPUTS.values, Settings(12))
    assert MotionMap(alone, made().cells).searched == (
        "6 cells, each from rest, for at most 12 drive periods; other motions were not looked for"
    )
    begun = Mechanism.from_toml_text(INPUTS.mechanism.to_toml()).with_value("start.mass.velocity", 1.0)
    own = MapInputs(begun, INPUTS.places, INPUTS.values, Settings())
    assert "each from the mechanism's own start" in MotionMap(own, made().cells).searched


def test_motions_are_the_same_by_their_orbits_or_their_kind() -> None:
    assert same_motion(ORBIT, periodic((1.0 + 1e-9, 2e-5)))
    assert not same_motion(ORBIT, OTHER)
    assert not same_motion(ORBIT, periodic((1.0, 2e-5), (2.0, 0.0)))
    assert not same_motion(ORBIT, CHAOS)
    assert same_motion(CHAOS, CellMotion(CHAOTIC))
    assert not same_motion(FAILED, CellMotion(UNDECIDED))
    assert same_motion(FAILED, CellMotion(UNDECIDED, failure="it was too fast"))
    assert [described(each) for each in (ORBIT, CHAOS, FAILED)][2] == "failed"
    # Differences count relative to the larger size of each state.
    assert alike(ORBIT, periodic((1.11, 2e-5)), 0.1)
    assert not alike(ORBIT, periodic((1.12, 2e-5)), 0.1)
    assert alike(periodic((1.11, 2e-5)), ORBIT, 0.1)
    assert not alike(ORBIT, periodic((1.0, 2.3e-5)), 0.1)
    # Twice the same orbit is none of one period, and one that begins a period later is the same.
    assert not alike(ORBIT, periodic((1.0, 2e-5), (1.0, 2e-5)))
    assert alike(periodic((1.0, 2e-5), (3.0, 0.0)), periodic((3.0, 0.0), (1.0, 2e-5)))


def test_motions_that_are_there_already_are_counted() -> None:
    motions: list[CellMotion] = []
    for each in (ORBIT, CHAOS, periodic((1.0, 2e-5), starts=4), OTHER, CHAOS):
        _add(motions, each)
    assert [motion.starts for motion in motions] == [5, 2, 1]
    assert [motion.kind for motion in motions] == [PERIODIC, CHAOTIC, PERIODIC]
    assert motions[0].largest_multiplier == 0.25


def with_parts(**parts: object) -> ExactFlow:
    return ExactFlow(replace(linear_oscillator(), **parts))  # type: ignore[arg-type]


def test_random_starts_go_as_far_as_the_largest_amplitude_or_gap() -> None:
    omega = 7.5
    assert start_scales(with_parts()) == pytest.approx([1e-3, 1e-3 * omega], rel=1e-12)
    pins = {"pin": Pin("ground", amplitude=-0.2)}
    plays = {"play": Play(("ground", "mass"), 10.0, gap=0.3)}
    stops = {"stop": Stop(("ground", "mass"), 10.0, gap=-0.5)}
    for parts, length in (
        ({"pins": pins}, 0.2),
        ({"pins": pins, "plays": plays}, 0.3),
        ({"pins": pins, "plays": plays, "stops": stops}, 0.5),
    ):
        assert start_scales(with_parts(**parts)) == pytest.approx([length, length * omega], rel=1e-12)


def test_starts_are_rest_and_states_within_the_scales() -> None:
    flow = with_parts()
    rest, *others = _starts(flow, Cell(7, (1.0,)), Settings(starts=4, seed=2))
    assert rest.state.tolist() == [0.0, 0.0]
    assert len(others) == 3
    states = np.array([each.state for each in others]) / start_scales(flow)
    assert abs(states).max() <= 1.0
    assert (states < 0.0).any() and (states > 0.0).any()
    again = _starts(flow, Cell(7, (1.0,)), Settings(starts=2, seed=2))
    assert again[1].state.tolist() == others[0].state.tolist()
    beside = _starts(flow, Cell(8, (1.0,)), Settings(starts=2, seed=2))
    assert beside[1].state.tolist() != others[0].state.tolist()
    assert _starts(flow, Cell(7, (1.0,), (((0.0, 0.0),),)), Settings(starts=4)) == []


def test_random_starts_have_springs_as_short_as_can_be() -> None:
    # The spring of a play with a damper relaxes by itself, and its stretch is a state.
    flow = with_parts(plays={"play": Play(("ground", "mass"), 10.0, damping=2.0, gap=0.3)})
    for start in _starts(flow, Cell(7, (1.0,)), Settings(starts=6, seed=2))[1:]:
        again = flow.at(start.state, stretched=False)
        assert again.state.tolist() == start.state.tolist()
        assert again.statuses == start.statuses


def test_an_error_is_told_by_the_motion() -> None:
    def fails(error: Exception) -> CellMotion:
        def found() -> Settled:
            raise error

        return _motion(None, found)  # type: ignore[arg-type]

    assert fails(UnsupportedMotionError("it leans")).failure == "it leans"
    assert fails(ZeroDivisionError()).failure == "ZeroDivisionError"
    assert fails(np.linalg.LinAlgError("singular")).kind is UNDECIDED
    with pytest.raises(KeyError):
        fails(KeyError())


def test_a_motion_that_ends_before_its_time_has_no_measures() -> None:
    early = Settled(UNDECIDED, 17, None, ending=Ending.STEP_LIMIT)  # type: ignore[arg-type]
    found = _described(None, early)  # type: ignore[arg-type]
    assert (found.kind, found.periods, found.failure) == (UNDECIDED, 17, Ending.STEP_LIMIT.value)
    assert found.measures is None
    stopped = SimpleNamespace(course=lambda end, periods: SimpleNamespace(ending=Ending.STEP_LIMIT))
    later = _described(stopped, Settled(CHAOTIC, 300, None, lyapunov=0.1))  # type: ignore[arg-type]
    assert (later.kind, later.periods, later.failure) == (CHAOTIC, 300, Ending.STEP_LIMIT.value)


def test_a_motion_comes_back_from_its_data() -> None:
    for motion in (ORBIT, CHAOS, FAILED):
        data = motion.as_data()
        assert typed(CellMotion, parsed_json(json.dumps(data))) == motion
        assert isinstance(data["kind"], str)


def test_a_cell_begins_with_the_orbits_of_others(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = []

    def near(flow: ExactFlow, states: np.ndarray, settings: Settings) -> Settled:
        seen.append(states.tolist())
        return Settled(UNDECIDED, len(states), None, ending=Ending.STEP_LIMIT)  # type: ignore[arg-type]

    monkeypatch.setattr(cell_work, "_near", near)
    work = CellWork(linear_oscillator(), ("frequency",), Settings(starts=3))
    orbits = (((1.0, 2.0),), ((3.0, 4.0), (5.0, 6.0)))
    result = work(Cell(4, (1.0,), orbits))
    assert seen == [[[1.0, 2.0]], [[3.0, 4.0], [5.0, 6.0]]]
    assert result.number == 4
    assert [motion.starts for motion in result.motions] == [2]


def test_a_basin_tells_shares_and_a_row_for_each_start() -> None:
    numbers = np.array([[0, 1, 2], [0, 0, 2]])
    found = Basin(made(), (ORBIT, OTHER, FAILED), numbers)
    assert found.shares == pytest.approx((0.5, 1.0 / 6.0, 1.0 / 3.0), rel=1e-15)
    assert found.names == ("1: period 1", "2: period 1", "3: failed")
    rows = list(found._table().rows())
    assert rows[2] == (1.2, 8.0, 3, UNDECIDED, 0)
    assert rows[3] == (1.0, 10.0, 1, PERIODIC, 1)
    assert "3: failed, 33%" in str(found)
