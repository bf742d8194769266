"""Work that goes on in a second process, so that a build uses two cores."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.connection import Connection
from typing import TypeVar

Result = TypeVar("Result")


class BackgroundError(RuntimeError):
    """The second process ended without handing over its result."""


def start(jobs: Sequence[Callable[[], Result]]) -> Iterator[Result]:
    """Start the jobs, one after the other in a forked process, and return their results in order.

    A forked process sees everything that was computed before; only the results are sent back. Where processes
    cannot be forked (Windows) the jobs run here, each when its result is asked for.

    Raises:
        BackgroundError: when a result is asked for, if the process has died.
        Exception: when a result is asked for, whatever its job raised.
    """
    if "fork" not in multiprocessing.get_all_start_methods():
        return (job() for job in jobs)
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_work, args=(jobs, sender), daemon=True)
    process.start()
    sender.close()
    return _received(receiver, len(jobs))


def _work(jobs: Sequence[Callable[[], Result]], sender: Connection) -> None:
    for job in jobs:
        try:
            sender.send((job(), None))
        except Exception as error:
            sender.send((None, error))
            return


def _received(receiver: Connection, count: int) -> Iterator[Result]:
    for _ in range(count):
        try:
            result, error = receiver.recv()
        except EOFError as end:
            raise BackgroundError(
                "the second process of the build ended early, perhaps for want of memory"
            ) from end
        if error is not None:
            raise error
        yield result
