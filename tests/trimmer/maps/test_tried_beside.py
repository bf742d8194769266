"""Orbits of cells that are tried in the cells beside, with motions made by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.trimmer.maps.machines import impact_oscillator
from tests.trimmer.maps.test_cells_by_hand import CHAOS, FAILED, INPUTS, ORBIT, OTHER, PERIODIC, periodic
from trimmer.errors import WrongTypeError
from trimmer.maps import coexistence
from trimmer.maps.cells import (
    CellResult,
)
from trimmer.maps.coexistence import (
    Coexistence,
    _around,
    _candidates,
    _is_carried_on,
    _new,
    coexisting_motions,
)
from trimmer.maps.inputs import MapInputs, Settings
from trimmer.maps.result import MotionMap


@pytest.mark.parametrize(
    ("number", "around"),
    [(0, [1, 4, 5]), (5, [0, 1, 2, 4, 6, 8, 9, 10]), (11, [6, 7, 10]), (3, [2, 6, 7]), (8, [4, 5, 9])],
)
def test_eight_cells_are_around_a_cell_or_fewer_at_the_edge(number: int, around: list[int]) -> None:
    assert list(_around(number, (3, 4))) == around


def test_an_orbit_is_tried_beside_its_cell_unless_one_there_looks_like_it() -> None:
    near = periodic((1.05, 2e-5))
    assert _is_carried_on(ORBIT, near)
    assert not _is_carried_on(ORBIT, OTHER)
    assert not _is_carried_on(ORBIT, CHAOS)
    assert not _is_carried_on(ORBIT, replace(CHAOS, states=ORBIT.states))
    assert not _is_carried_on(periodic((1.0, 0.0), (1.0, 0.0)), ORBIT)
    motions = [(ORBIT,), (near, CHAOS), (OTHER,), (FAILED,), (CHAOS,), (ORBIT,)]
    result = MotionMap(INPUTS, tuple(CellResult(number, each) for number, each in enumerate(motions)))
    cells = list(_candidates(result, motions, {0: (ORBIT,), 1: (near, CHAOS)}))
    # From cell 0: to 3 and 4, not to 1; from cell 1: to 2, and to 3 and 4 what looks like the first one.
    assert [(cell.number, cell.orbits) for cell in cells] == [
        (2, (near.states,)),
        (3, (ORBIT.states,)),
        (4, (ORBIT.states,)),
    ]
    assert cells[1].values == (1.0, 10.0)
    assert list(_candidates(result, motions, {})) == []
    assert _new((ORBIT, CHAOS), (OTHER, CHAOS, ORBIT, FAILED)) == (OTHER,)


class Answering:
    """A runner that answers each cell with the orbits that it is given, and counts what it was asked."""

    def __init__(self) -> None:
        self.rounds = list[list[int]]()

    def results(self, work: object, cells: object) -> list[CellResult]:
        taken = list(cells)  # type: ignore[call-overload]
        self.rounds.append([cell.number for cell in taken])
        return [
            CellResult(cell.number, tuple(periodic(*states) for states in cell.orbits))
            for cell in reversed(taken)
        ]


def test_orbits_go_from_cell_to_cell_until_none_is_new() -> None:
    values = ((1.0, 1.1, 1.2, 1.3),)
    inputs = MapInputs(impact_oscillator(), ("frequency",), values, Settings())
    motions = [(ORBIT,), (OTHER,), (OTHER,), (OTHER,)]
    result = MotionMap(inputs, tuple(CellResult(number, each) for number, each in enumerate(motions)))
    runner = Answering()
    found = coexisting_motions(result, runner=runner, quiet=True)
    # First both go over the border; then the first goes on to the right.
    assert runner.rounds == [[0, 1], [2], [3]]
    assert (found.tried, found.rounds, found.complete) == (4, 3, True)
    assert found.several == ((0, 0), (0, 1), (0, 2), (0, 3))
    assert found.result.cells[3].motions == (OTHER, ORBIT)
    assert "4 of 4 cells" in str(found)
    assert "from 1 start each" in found.searched
    assert "until no cell had a new one" in found.searched
    rows = list(found._table().rows())
    assert [row[:4] for row in rows[:3]] == [
        (1.0, 1, PERIODIC, 1),
        (1.0, 2, PERIODIC, 1),
        (1.1, 1, PERIODIC, 1),
    ]
    assert [row[4] for row in rows[:3]] == [0.25, 0.25, 1.25]
    short = coexisting_motions(result, most_rounds=2, runner=Answering(), quiet=True)
    assert (short.tried, short.rounds, short.complete) == (3, 2, False)
    assert "the search ended before it was done" in short.searched


def test_nothing_is_tried_where_all_motions_are_carried_on() -> None:
    inputs = MapInputs(impact_oscillator(), ("frequency",), ((1.0, 1.1),), Settings(starts=2))
    result = MotionMap(inputs, (CellResult(0, (ORBIT,)), CellResult(1, (ORBIT,))))
    found = coexisting_motions(result, runner=Answering(), quiet=True)
    assert (found.tried, found.rounds, found.complete, found.several) == (0, 0, True, ())
    assert "from 2 starts each" in found.searched
    assert isinstance(found, Coexistence)


def test_a_search_without_rounds_or_a_map_is_refused() -> None:
    result = MotionMap(INPUTS, tuple(CellResult(number, (ORBIT,)) for number in range(6)))
    with pytest.raises(ValueError, match="most_rounds"):
        coexisting_motions(result, most_rounds=0, runner=Answering(), quiet=True)
    with pytest.raises(WrongTypeError, match="result"):
        coexisting_motions(INPUTS, runner=Answering(), quiet=True)  # type: ignore[arg-type]


@pytest.mark.parametrize("quiet", [None, True, False])
def test_a_progress_bar_shows_each_round_unless_it_shall_not(
    monkeypatch: pytest.MonkeyPatch, quiet: bool | None
) -> None:
    shown = []

    def bar(results: object, name: str, **settings: object) -> object:
        shown.append((name, settings))
        return results

    monkeypatch.setattr(coexistence, "progress_bar", bar)
    inputs = MapInputs(impact_oscillator(), ("frequency",), ((1.0, 1.1),), Settings())
    result = MotionMap(inputs, (CellResult(0, (ORBIT,)), CellResult(1, (OTHER,))))
    coexisting_motions(result, runner=Answering(), **({} if quiet is None else {"quiet": quiet}))  # type: ignore[arg-type]
    assert shown == [("round 1", {"quiet": bool(quiet), "total": 2})]
