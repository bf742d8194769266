"""The work of cells, done in several processes of this computer."""

import multiprocessing
import multiprocessing.context
import os
import signal
import threading
import warnings
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import chain, islice
from multiprocessing.connection import Connection
from multiprocessing.connection import wait as wait_for
from multiprocessing.context import SpawnContext, SpawnProcess
from typing import Any

from tqdm import TMonitor

from trimmer.arguments import whole_number
from trimmer.errors import WorkerError
from trimmer.runners.chunks import handed_back
from trimmer.runners.runner import CHUNK, Cell, Result

_SAFE = "PYTHONSAFEPATH"
MOST_OF_A_CORE = 4  # Processes for each core that may be asked for


@dataclass(frozen=True)
class ProcessRunner:
    """A runner that does cells in several processes of this computer.

    Attributes:
        processes: How many at most; by default as many as there are cores for this process. There are never
            more than chunks.
        chunk: Cells that go to a process at once.

    Raises:
        ValueError: if one is not a whole number from 1 on, or processes are more than ``most_processes``.
    """

    processes: int | None = None
    chunk: int = CHUNK

    def __post_init__(self) -> None:
        if self.processes is not None:
            whole_number("processes", self.processes, 1)
            if self.processes > most_processes():
                raise ValueError(f"processes must be at most {most_processes()} here, not {self.processes}")
        whole_number("chunk", self.chunk, 1)

    @property
    def count(self) -> int:
        """How many processes there are at most."""
        return self.processes or cores()

    def results(self, work: Callable[[Cell], Result], cells: Iterable[Cell]) -> Iterator[Result]:
        """Yield the results of the cells as they come.

        Raises:
            WorkerError: if a process ended at once, or none can be begun.
        """
        remaining = iter(cells)
        first = list(islice(remaining, self.count * self.chunk))
        if not first:
            return
        count = min(self.count, -(-len(first) // self.chunk))
        context = _context()
        # A pipe, as the lock of an event would be lost with a process that is ended from outside.
        ended, end = context.Pipe(duplex=False)
        with _beginning():  # its locks begin a process too
            pool = ProcessPoolExecutor(count, context, _begin, (work, ended))

        def submit(chunk: list[Cell]) -> Future[list[Result]]:
            with _beginning():
                return pool.submit(_done, chunk)

        whole = False
        try:
            yield from handed_back(submit, chain(first, remaining), self.chunk, lambda: count)
            whole = True
        except BrokenProcessPool as error:
            raise WorkerError(
                "a process that did the work of cells was ended from outside, perhaps as memory ran out: "
                "go on with fewer processes"
            ) from error
        finally:
            if not whole:
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
    return multiprocessing.get_context("fork") if copies else _Spawning()


@contextmanager
def _away_from_here() -> Iterator[None]:
    """Let processes that begin meanwhile find no modules among the user's files in the current folder."""
    before = os.environ.get(_SAFE)
    os.environ[_SAFE] = before or "1"
    try:
        yield
    finally:
        if before is None:
            del os.environ[_SAFE]


@contextmanager
def _beginning() -> Iterator[None]:
    """Tell in a sentence that the system lets no process begin."""
    try:
        with _away_from_here():
            yield
    except OSError as error:
        raise WorkerError(
            f"no other processes can be begun here ({error.strerror or error}): do the work in this one "
            "(--jobs 1)"
        ) from error


class _Process(SpawnProcess):
    @staticmethod
    def _Popen(process_obj: Any) -> Any:
        with _away_from_here():
            return SpawnProcess._Popen(process_obj)


class _Spawning(SpawnContext):
    Process = _Process


def most_processes() -> int:
    """Return how many processes may be asked for: more only wait for each other, and each takes memory."""
    return max(MOST_OF_A_CORE * cores(), 32)


def cores() -> int:
    """Return on how many cores this process may run."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class _Worker:
    """What a process does with its cells; set once, as the process begins."""

    work: Callable[[Any], Any]


def _begin(work: Callable[[Any], Any], ended: Connection) -> None:
    """Prepare a process: it leaves interrupts to the one that began it, and ends with it or when told."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    warnings.simplefilter("ignore", RuntimeWarning)  # a result says itself what became of it
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
