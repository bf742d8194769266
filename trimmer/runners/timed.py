"""The work of cells, as much of it as is begun before an instant."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Generic

from trimmer.deadline import Deadline
from trimmer.runners.runner import Cell, Result, Runner


def _nobody(done: int, count: int) -> None:
    """Tell nobody."""


def nothing(cell: object) -> None:
    """Return nothing, for cells whose result may be missing."""


@dataclass(frozen=True)
class TimedRunner:
    """Does cells with another runner until an instant; each that was begun is finished."""

    runner: Runner  # Who does them
    deadline: Deadline  # The instant
    # The result of a cell that is not done; None leaves it out. It can be pickled.
    instead: Callable[..., object] = nothing
    told: Callable[[int, int], None] = _nobody  # Is told how many cells of how many have come back

    def results(self, work: Callable[[Cell], Result], cells: Iterable[Cell]) -> Iterator[Result]:
        """Yield the results of the cells as they come."""
        wanted = list(cells)
        timed = _Timed(work, self.deadline, self.instead)
        for done, result in enumerate(self.runner.results(timed, wanted), start=1):
            self.told(done, len(wanted))
            if result is not None:
                yield result


@dataclass(frozen=True)
class _Timed(Generic[Cell, Result]):
    work: Callable[[Cell], Result]
    deadline: Deadline
    instead: Callable[..., object]

    def __call__(self, cell: Cell) -> Result:
        return self.instead(cell) if self.deadline.passed else self.work(cell)  # type: ignore[return-value]
