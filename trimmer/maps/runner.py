"""Who does the work of the cells: this process, several on this computer, or what has the same interface.

A cluster can take their place: it needs the one method of ``Runner``. Work and cells are pickled, and a
result depends on its cell alone, so the order and the place in which cells are done never matter.
"""

from __future__ import annotations

import multiprocessing
import multiprocessing.context
import os
import signal
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from itertools import islice
from multiprocessing.connection import Connection
from multiprocessing.connection import wait as wait_for
from typing import Any, Protocol, TypeVar

from tqdm import TMonitor

from trimmer.arguments import whole_number
from trimmer.errors import WorkerError

Cell = TypeVar("Cell")
Result = TypeVar("Result")

CHUNK = 8
"""Cells that go to a process at once: a tenth of a second of work, against a thousandth for the way there."""
AHEAD = 3
"""Chunks per process that are under way, so that no process waits and memory does not grow with the cells."""


class Runner(Protocol):
    """Does the work of cells, here or elsewhere."""

    def results(self, work: Callable[[Cell], Result], cells: Iterable[Cell]) -> Iterator[Result]:
        """Yield the results of the cells as they come, in any order.

        Args:
            work: What is done with a cell; it can be pickled.
            cells: The cells; they can be pickled. They are taken as they are needed.
        """
        ...


@dataclass(frozen=True)
class SerialRunner:
    """Does one cell after the other in this process."""

    def results(self, work: Callable[[Cell], Result], cells: Iterable[Cell]) -> Iterator[Result]:
        """Yield the results of the cells in their order."""
        return map(work, cells)


@dataclass(frozen=True)
class ProcessRunner:
    """Does the cells in several processes of this computer.

    Attributes:
        processes: How many; by default as many as there are cores for this process.
        chunk: Cells that go to a process at once.

    Raises:
        ValueError: if one is not a whole number from 1 on.
    """

    processes: int | None = None
    chunk: int = CHUNK

    def __post_init__(self) -> None:
        if self.processes is not None:
            whole_number("processes", self.processes, 1)
        whole_number("chunk", self.chunk, 1)

    @property
    def count(self) -> int:
        """How many processes there are."""
        return self.processes or cores()

    def results(self, work: Callable[[Cell], Result], cells: Iterable[Cell]) -> Iterator[Result]:
        """Yield the results of the cells as they come.

        Raises:
            WorkerError: if a process ended at once.
        """
        remaining, count, context = iter(cells), self.count, _context()
        # A pipe, as the lock of an event would be lost with a process that is ended from outside.
        ended, end = context.Pipe(duplex=False)
        pool = ProcessPoolExecutor(count, context, _begin, (work, ended))
        pending: set[Future[list[Result]]] = set()
        try:
            while True:
                while len(pending) < AHEAD * count and (chunk := list(islice(remaining, self.chunk))):
                    pending.add(pool.submit(_done, chunk))
                if not pending:
                    return
                finished, pending = wait(pending, return_when=FIRST_COMPLETED)
                for future in finished:
                    yield from future.result()
        except BrokenProcessPool as error:
            raise WorkerError(
                "a process that did the work of cells was ended from outside, perhaps as memory ran out: "
                "go on with fewer processes"
            ) from error
        finally:
            if pending:
                # Nobody waits for what is under way, after an interrupt for example.
                end.send_bytes(b"end")
            pool.shutdown(wait=True, cancel_futures=True)
            ended.close()
            end.close()


def _context() -> multiprocessing.context.BaseContext:
    """Return how processes begin: as copies of this one, which takes no time, unless it has other threads.

    A lock that another thread holds would never be released in a copy. The thread of progress bars holds none
    that the work needs.
    """
    others = [
        thread
        for thread in threading.enumerate()
        if thread is not threading.main_thread() and not isinstance(thread, TMonitor)
    ]
    copies = "fork" in multiprocessing.get_all_start_methods() and not others
    return multiprocessing.get_context("fork" if copies else "spawn")


def cores() -> int:
    """Return on how many cores this process may run."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class _Worker:
    """What a process does with its cells; set once, as the process begins."""

    work: Callable[[Any], Any]


def _begin(work: Callable[[Any], Any], ended: Connection) -> None:
    """Prepare a process: it leaves interrupts to the one that began it, and ends with it or when told."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    threading.Thread(target=_end_when, args=(ended,), daemon=True).start()
    _Worker.work = staticmethod(work)


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _end_when(ended: Connection) -> None:
    wait_for([ended])  # it stays readable, for all
    os._exit(0)


def _done(chunk: list[Any]) -> list[Any]:
    return [_Worker.work(cell) for cell in chunk]
