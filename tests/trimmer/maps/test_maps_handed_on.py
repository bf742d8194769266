"""What maps hand on to runners, files and progress bars, with stand-ins for all of these."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from tests.trimmer.maps.machines import impact_oscillator
from tests.trimmer.maps.test_cells_by_hand import ORBIT, OTHER
from trimmer.errors import MapError
from trimmer.maps import coexistence, motion_map, special_curves, special_work
from trimmer.maps.cells import Cell, CellResult
from trimmer.maps.coexistence import coexisting_motions
from trimmer.maps.inputs import MapInputs, Settings
from trimmer.maps.result import MotionMap

VALUES = {"frequency": [1.0, 1.1, 1.2], "stops.wall.gap": [8.0, 10.0]}


class Answering:
    """A runner that keeps what it is asked, and is interrupted after some cells if it shall be."""

    def __init__(self, most: int = 99) -> None:
        self.most, self.works, self.cells = most, list[Any](), list[Cell]()

    def results(self, work: Any, cells: Iterable[Cell]) -> Iterator[CellResult]:
        self.works.append(work)
        for done, cell in enumerate(cells):
            if done == self.most:
                raise KeyboardInterrupt
            self.cells.append(cell)
            yield CellResult(cell.number, (ORBIT,))


class Bar:
    """Stands in for a progress bar."""

    def __init__(self) -> None:
        self.begun, self.updates = list[tuple[Any, ...]](), 0

    def __call__(self, results: Any = None, description: str = "", **settings: Any) -> Any:
        self.begun.append((description, settings))
        return self if results is None else results

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *_: object) -> None:
        self.begun.append("end")  # type: ignore[arg-type]

    def update(self) -> None:
        self.updates += 1


@pytest.fixture
def bar(monkeypatch: pytest.MonkeyPatch) -> Bar:
    found = Bar()
    for module in (motion_map, coexistence, special_work):
        monkeypatch.setattr(module, "progress_bar", found)
    return found


def test_a_map_is_done_cell_by_cell_with_its_settings_behind_a_bar(bar: Bar) -> None:
    runner = Answering()
    found = motion_map.motion_map(impact_oscillator(), VALUES, runner=runner)  # type: ignore[arg-type]
    assert [cell.number for cell in runner.cells] == [0, 1, 2, 3, 4, 5]
    assert runner.cells[4].values == (1.1, 10.0)
    assert (runner.works[0].places, runner.works[0].settings) == (tuple(VALUES), Settings(300, 1, 0))
    assert bar.begun == [("cells", {"quiet": False, "total": 6, "initial": 0}), "end"]
    assert bar.updates == 6
    assert [cell.number for cell in found.cells] == [0, 1, 2, 3, 4, 5]
    others = motion_map.motion_map(
        impact_oscillator(),
        VALUES,
        most_periods=12,
        starts=3,
        seed=5,
        runner=runner,  # type: ignore[arg-type]
        quiet=True,
    )
    assert others.inputs.settings == runner.works[1].settings == Settings(12, 3, 5)
    assert bar.begun[2][1]["quiet"]
    for name, least in (("most_periods", 2), ("starts", 1), ("seed", 0)):
        motion_map.motion_map(impact_oscillator(), VALUES, runner=runner, **{name: least})  # type: ignore[arg-type]
        with pytest.raises(ValueError, match=name):
            motion_map.motion_map(impact_oscillator(), VALUES, runner=runner, **{name: least - 1})  # type: ignore[arg-type]


class Files:
    """Stands in for the file of a map."""

    def __init__(self, *done: int) -> None:
        self.done, self.asked = done, list[Any]()

    def begin(self, path: Path, inputs: MapInputs, *, overwrite: bool) -> None:
        self.asked.append(("begin", path, inputs.count, overwrite))

    def resumed(self, path: Path, inputs: MapInputs) -> list[CellResult]:
        self.asked.append(("resumed", path, inputs.count))
        return [CellResult(number, (OTHER,)) for number in self.done]

    def append(self, path: Path, results: Iterator[CellResult]) -> Iterator[CellResult]:
        self.asked.append(("append", path))
        return results


def test_only_cells_that_are_left_are_done_and_kept(monkeypatch: pytest.MonkeyPatch, bar: Bar) -> None:
    files, runner, path = Files(1, 4), Answering(), Path("map.jsonl")
    monkeypatch.setattr(motion_map, "checkpoint", files)
    found = motion_map.motion_map(impact_oscillator(), VALUES, runner=runner, file="map.jsonl", resume=True)  # type: ignore[arg-type]
    assert files.asked == [("resumed", path, 6), ("append", path)]
    assert [cell.number for cell in runner.cells] == [0, 2, 3, 5]
    assert [cell.motions[0] is OTHER for cell in found.cells] == [False, True, False, False, True, False]
    assert bar.begun[0] == ("cells", {"quiet": False, "total": 6, "initial": 2})
    assert bar.updates == 4
    files.asked.clear()
    for overwrite in (False, True):
        motion_map.motion_map(impact_oscillator(), VALUES, runner=runner, file=path, overwrite=overwrite)  # type: ignore[arg-type]
    begun = [[("begin", path, 6, overwrite), ("append", path)] for overwrite in (False, True)]
    assert files.asked == [*begun[0], *begun[1]]
    # Of a whole file nothing is left.
    files.done, bar.begun = (0, 1, 2, 3, 4, 5), []
    whole = motion_map.motion_map(impact_oscillator(), VALUES, file=path, resume=True)
    assert [cell.motions[0] for cell in whole.cells] == [OTHER] * 6
    assert bar.begun == []
    interrupted: Any = Answering(1)
    files.done = (1, 4)
    with pytest.raises(motion_map.MapInterruptedError, match=r"after 3 of 6 cells, which map\.jsonl holds"):
        motion_map.motion_map(impact_oscillator(), VALUES, runner=interrupted, file=path, resume=True)


def test_resume_and_overwrite_are_of_a_file() -> None:
    for name in ("resume", "overwrite"):
        with pytest.raises(MapError, match=f"^{name} is of a file"):
            motion_map.motion_map(impact_oscillator(), VALUES, runner=Answering(), **{name: True})  # type: ignore[arg-type]


@pytest.mark.parametrize(("count", "several"), [(12, False), (13, True)])
def test_many_cells_are_done_by_several_processes(
    monkeypatch: pytest.MonkeyPatch, bar: Bar, count: int, several: bool
) -> None:
    asked = []

    def made(name: str) -> Any:
        return lambda **settings: asked.append((name, settings)) or Answering()

    for module in (motion_map, coexistence):
        monkeypatch.setattr(module, "ProcessRunner", made("processes"))
        monkeypatch.setattr(module, "SerialRunner", made("this one"))
    values = [1.0 + 0.01 * number for number in range(count)]
    motion_map.motion_map(impact_oscillator(), {"frequency": values})
    name = "processes" if several else "this one"
    assert asked == [(name, {})]
    inputs = MapInputs(impact_oscillator(), ("frequency",), (tuple(values),), Settings())
    motions = [(ORBIT if number % 2 else OTHER,) for number in range(count)]
    coexisting_motions(
        MotionMap(inputs, tuple(CellResult(*each) for each in enumerate(motions))), most_rounds=1
    )
    assert asked[1:] == [(name, {})]


def test_curves_are_looked_for_by_processes_one_piece_at_a_time(
    monkeypatch: pytest.MonkeyPatch, bar: Bar
) -> None:
    asked: list[Any] = []
    runner = SimpleNamespace(
        results=lambda work, pieces: ((at, work.work.given(piece)) for at, piece in pieces)
    )
    monkeypatch.setattr(special_curves, "ProcessRunner", lambda **settings: asked.append(settings) or runner)

    def line_work(*given: Any) -> Any:
        asked.append(given)
        return SimpleNamespace(given=lambda second: special_work.Line(second, ()))

    def add(search: Any, line: Any, most: int) -> None:
        asked.append((search.runner is runner, search.work.place, search.quiet, line.second, most))

    monkeypatch.setattr(special_curves, "LineWork", line_work)
    monkeypatch.setattr(special_curves._Search, "add", add)
    inputs = MapInputs(impact_oscillator(), tuple(VALUES), ((1.2, 1.0), (8.0, 12.0)), Settings())
    result = MotionMap(inputs, tuple(CellResult(number, (ORBIT,)) for number in range(4)))
    for settings, lines, most, quiet in (
        ({}, 3, 8, False),
        ({"lines": 1, "most_curves": 1, "quiet": True}, 1, 1, True),
    ):
        asked.clear()
        bar.begun.clear()
        special_curves.special_curves(result, **settings)  # type: ignore[arg-type]
        assert asked[0] == {"chunk": 1}
        assert asked[1][:2] == (inputs.mechanism, tuple(VALUES))
        assert asked[1][2].both == ((1.0, 1.2), (8.0, 12.0))
        seconds = [8.0 + 4.0 * (line + 0.5) / lines for line in range(lines)]
        assert asked[2:] == [
            (True, "stops.wall.gap", quiet, pytest.approx(second, rel=1e-14), most * number)
            for number, second in enumerate(seconds, start=1)
        ]
        assert bar.begun == [("branches", {"quiet": quiet, "total": lines})]
    for name in ("lines", "most_curves"):
        with pytest.raises(ValueError, match=name):
            special_curves.special_curves(result, **{name: 0})  # type: ignore[arg-type]
