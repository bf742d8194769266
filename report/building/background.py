"""Work that goes on in other processes, so that a build uses all cores."""

from __future__ import annotations

import multiprocessing
import os
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from typing import Any, Generic, TypeVar, final

Result = TypeVar("Result")


class BackgroundError(RuntimeError):
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
    if "fork" not in multiprocessing.get_all_start_methods():
        yield from (_done(jobs, index) for index in range(len(jobs)))
        return
    context = multiprocessing.get_context("fork")
    taken = context.Value("i", 0)
    receivers, processes = [], []
    for _ in range(min(_cores(), len(jobs))):
        receiver, sender = context.Pipe(duplex=False)
        process = context.Process(target=_work, args=(jobs, taken, sender), daemon=True)
        process.start()
        sender.close()
        receivers.append(receiver)
        processes.append(process)
    try:
        yield from _received(receivers)
    finally:
        for process in processes:
            process.terminate()
            process.join()


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _done(jobs: Sequence[Callable[[], Result]], index: int) -> Done[Result]:
    started = time.perf_counter()
    return Done(index, jobs[index](), time.perf_counter() - started)


def _work(jobs: Sequence[Callable[[], Result]], taken: Any, sender: Connection) -> None:
    while True:
        with taken.get_lock():
            index = taken.value
            taken.value += 1
        if index >= len(jobs):
            sender.send((None, None))
            return
        try:
            sender.send((_done(jobs, index), None))
        except Exception as error:
            sender.send((None, error))
            return


def _received(receivers: list[Connection]) -> Iterator[Done[Any]]:
    working = list(receivers)
    while working:
        for receiver in wait(working):
            assert isinstance(receiver, Connection)
            try:
                done, error = receiver.recv()
            except EOFError as end:
                raise BackgroundError(
                    "a process of the build ended early, perhaps for want of memory"
                ) from end
            if error is not None:
                raise error
            if done is None:
                working.remove(receiver)
            else:
                yield done
