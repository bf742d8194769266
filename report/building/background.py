"""Work that goes on in other processes, so that a build uses all cores."""

import multiprocessing
import os
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any, Generic, TypeVar, final

from trimmer import TrimmerError

Result = TypeVar("Result")
_JOBS: ContextVar[Sequence[Callable[[], Any]]] = ContextVar("jobs of this process")
"""They come to a process by the fork, since most of them cannot be pickled."""


class BackgroundError(TrimmerError, RuntimeError):
    """A process ended without handing over its result."""


@final
@dataclass(frozen=True)
class Done(Generic[Result]):
    """A job's result, with the job's place in the sequence and the time that it took, s."""

    index: int
    result: Result
    seconds: float


def run(jobs: Sequence[Callable[[], Result]]) -> Iterator[Done[Result]]:
    """Do the jobs in as many forked processes as there are cores; yield their results as they come.

    A process takes the next job when it has done its last, so jobs should come in order of length, the
    longest first. A forked process sees everything that was computed before; only the results are sent back.
    Where processes cannot be forked (Windows) the jobs run here, one after the other.

    Raises:
        BackgroundError: if a process has died.
        Exception: whatever a job raised.
    """
    if not jobs:
        return
    if "fork" not in multiprocessing.get_all_start_methods():
        yield from (_done(jobs, index) for index in range(len(jobs)))
        return
    context = multiprocessing.get_context("fork")
    pool = ProcessPoolExecutor(min(_cores(), len(jobs)), context, _inherit, (jobs,))
    try:
        for finished in as_completed([pool.submit(_inherited, index) for index in range(len(jobs))]):
            yield finished.result()
    except BrokenProcessPool as end:
        raise BackgroundError("a process of the build ended early, perhaps for want of memory") from end
    finally:
        pool.shutdown(wait=False, cancel_futures=True)


@contextmanager
def begun(job: Callable[[], Result]) -> Iterator[Callable[[], Result]]:
    """Begin a job in a forked process; yield what waits for its result.

    The job and its result can be pickled. Where processes cannot be forked it is done when it is asked for.
    """
    if "fork" not in multiprocessing.get_all_start_methods():
        yield job
        return
    with ProcessPoolExecutor(1, multiprocessing.get_context("fork")) as pool:
        yield pool.submit(job).result


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _done(jobs: Sequence[Callable[[], Result]], index: int) -> Done[Result]:
    started = time.perf_counter()
    return Done(index, jobs[index](), time.perf_counter() - started)


def _inherit(jobs: Sequence[Callable[[], Any]]) -> None:
    _JOBS.set(jobs)


def _inherited(index: int) -> Done[Any]:
    return _done(_JOBS.get(), index)
