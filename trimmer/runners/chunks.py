"""Chunks of cells on their way to those who do them, and back."""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from itertools import islice

from trimmer.runners.runner import Cell, Result

AHEAD = 3
"""Chunks under way for each who does them, so that none waits and memory does not grow with the cells."""


def handed_back(
    submit: Callable[[list[Cell]], Future[list[Result]]],
    cells: Iterable[Cell],
    chunk: int,
    count: Callable[[], int],
) -> Iterator[Result]:
    """Yield the results of cells as they come; ``count`` chunks are done at once at present."""
    remaining = iter(cells)
    pending: set[Future[list[Result]]] = set()
    while True:
        most = AHEAD * count()
        while len(pending) < most and (next_cells := list(islice(remaining, chunk))):
            pending.add(submit(next_cells))
        if not pending:
            return
        finished, pending = wait(pending, return_when=FIRST_COMPLETED)
        for future in finished:
            yield from future.result()
