"""What is done of a design is kept, whole, and an interrupted map goes on where it was."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

import pytest

from trimmer import SerialRunner
from trimmer.design import DesignFile, DesignMap, DesignSettings
from trimmer.design.parameter_studies.keeping import Keeper
from trimmer.design.parameter_studies.kept_map import design_map
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.design.varied_places import varied_places
from trimmer.examples import example_text

FEW = DesignSettings(cells=4, cell_periods=60, grid=1)


@dataclass
class InMemory:
    """A store that forgets nothing while the test runs."""

    held: dict[tuple[str, str], Any] = field(default_factory=dict)

    def load(self, stage: str, key: str) -> Any | None:
        return self.held.get((stage, key))

    def keep(self, stage: str, key: str, result: object) -> None:
        self.held[stage, key] = result


@dataclass
class Counting:
    """Does the cells one by one, counts them, and is interrupted after some."""

    most: int = 1000
    done: int = 0

    def results(self, work: Any, cells: Iterable[Any]) -> Iterator[Any]:
        for result in map(work, cells):
            if self.done == self.most:
                raise KeyboardInterrupt
            self.done += 1
            yield result


@pytest.fixture(scope="module")
def file() -> DesignFile:
    return design_file_of_text(example_text("den-hartog"), "den-hartog.toml")


def made(file: DesignFile, runner: Any, keeper: Keeper) -> DesignMap:
    first, second = varied_places(file.mechanism, None)
    return design_map(file.mechanism, first, second, FEW, runner, keeper, lambda done, count: None)


def test_an_interrupted_map_goes_on_with_the_rows_that_are_left(file: DesignFile) -> None:
    keeper = Keeper(InMemory())
    with pytest.raises(KeyboardInterrupt):
        made(file, Counting(most=10), keeper)
    again = Counting()
    resumed = made(file, again, keeper)
    assert again.done == 8  # of four rows of four, two were whole
    alone = made(file, SerialRunner(), Keeper())
    assert resumed.result.cells == alone.result.cells


def test_a_map_is_whole_even_if_what_was_kept_is_cleared_meanwhile(file: DesignFile) -> None:
    @dataclass
    class Clearing(Counting):
        def results(self, work: Any, cells: Iterable[Any]) -> Iterator[Any]:
            store.held.clear()
            return super().results(work, cells)

    store = InMemory()
    keeper = Keeper(store)
    with pytest.raises(KeyboardInterrupt):
        made(file, Counting(most=10), keeper)
    resumed = made(file, Clearing(), keeper)
    assert resumed.result.cells == made(file, SerialRunner(), Keeper()).result.cells
    assert made(file, SerialRunner(), keeper).result.cells == resumed.result.cells


def test_a_kept_map_is_not_computed_again(file: DesignFile) -> None:
    keeper, runner = Keeper(InMemory()), Counting()
    first = made(file, runner, keeper)
    assert runner.done == 16
    assert made(file, runner, keeper).result.cells == first.result.cells
    assert runner.done == 16
