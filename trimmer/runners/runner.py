"""Who does the work of cells: this process, several on this computer, a cluster, or what has the same method.

Work and cells are pickled, and a result depends on its cell alone, so the order and the place in which cells
are done never matter.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Protocol, TypeVar

Cell = TypeVar("Cell")
Result = TypeVar("Result")

CHUNK = 8
"""Cells that go to a process at once: a tenth of a second of work, against a thousandth for the way there."""


class Runner(Protocol):
    """What does the work of cells, here or elsewhere."""

    def results(self, work: Callable[[Cell], Result], cells: Iterable[Cell]) -> Iterator[Result]:
        """Yield the results of the cells as they come, in any order.

        Args:
            work: What is done with a cell; it can be pickled.
            cells: The cells; they can be pickled. They are taken as they are needed.
        """
        ...


@dataclass(frozen=True)
class SerialRunner:
    """A runner that does one cell after the other in this process."""

    def results(self, work: Callable[[Cell], Result], cells: Iterable[Cell]) -> Iterator[Result]:
        """Yield the results of the cells in their order."""
        return map(work, cells)
