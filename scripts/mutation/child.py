"""Work in a process of its own, with limits, forked from one that has loaded libraries and tests."""

import ctypes
import multiprocessing
import os
import resource
import signal
import sys
import traceback
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import Any

from scripts.mutation.collected import TREE, forget

LIBRARIES = (
    *(
        "numpy",
        "scipy.linalg",
        "scipy.optimize",
        "scipy.signal",
        "scipy.integrate",
        "scipy.special",
        "mpmath",
        "sympy",
    ),
    *("numba", "control", "matplotlib.figure", "hypothesis", "coverage"),
)
MEMORY = 8 * 2**30
"""Most memory of a process, bytes: an endless loop that fills a list ends here."""
PATIENCE = 8.0
"""How many times the limit of processor time may pass on the clock: other work may be going on."""


class End(Enum):
    """How a process ended."""

    DONE = "done"
    RAISED = "raised"
    TIMEOUT = "timeout"
    DIED = "died"


@dataclass(frozen=True)
class Ended:
    """What a process handed over: its value, or the last lines of what it printed; processor time, s."""

    end: End
    value: Any
    printed: str
    seconds: float


@dataclass(frozen=True)
class Place:
    """Where a process works."""

    root: Path  # Folder of the project's copy
    numba: Path  # Folder of Numba's machine code
    printed: Path  # File that gets what the process prints
    # Whether it is the copy whose project and tests the server has loaded, and they are to be used
    loaded: bool = False


def context() -> multiprocessing.context.ForkServerContext:
    """Return what begins processes; the server that they are forked from has loaded libraries and tests."""
    os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", PYTHONHASHSEED="0", MPLBACKEND="agg")
    server = multiprocessing.get_context("forkserver")
    server.set_forkserver_preload([*LIBRARIES, "scripts.mutation.collected"])
    return server


def load(root: Path, numba: Path) -> None:
    """Let the server load the project and the tests of a copy, before it begins its first process."""
    os.environ.update({TREE: str(root), "NUMBA_CACHE_DIR": str(numba)})


def run(work: Callable[..., Any], arguments: tuple[Any, ...], place: Place, limit: float) -> Ended:
    """Call a function in a process of its own; end it when it has used its processor time, s.

    Args:
        work: A function of a module; its result can be pickled.
        arguments: Its arguments.
        place: Where it works.
        limit: Processor time, s; on the clock ``PATIENCE`` times that.
    """
    server = context()
    here, there = server.Pipe(duplex=False)
    process = server.Process(target=_main, args=(there, work, arguments, place, limit))
    process.start()
    there.close()
    received: tuple[str, Any, float] | None = None
    out_of_time = not here.poll(PATIENCE * limit)
    with suppress(EOFError):
        received = None if out_of_time else here.recv()
    _end_group(process)
    last = place.printed.read_text("utf-8", "replace")[-4000:] if place.printed.exists() else ""
    if received is not None:
        return Ended(End(received[0]), received[1], last, received[2])
    by_limit = out_of_time or process.exitcode in (-signal.SIGXCPU, -signal.SIGKILL)
    return Ended(End.TIMEOUT if by_limit else End.DIED, process.exitcode, last, limit)


def _end_group(process: Any) -> None:
    """End the process and those that it has begun."""
    process.join(2.0)
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except (ProcessLookupError, PermissionError):
        if process.is_alive():
            process.kill()
    process.join()


def _main(
    there: Any, work: Callable[..., Any], arguments: tuple[Any, ...], place: Place, limit: float
) -> None:
    os.setpgid(0, 0)
    _end_with_parent()
    resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 5))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    output = os.open(place.printed, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    os.dup2(output, 1)
    os.dup2(output, 2)
    _move(place)
    try:
        answer: tuple[str, Any] = (End.DONE.value, work(*arguments))
    except BaseException as error:
        traceback.print_exc()
        answer = (End.RAISED.value, f"{type(error).__name__}: {error}"[:500])
    sys.stdout.flush()
    sys.stderr.flush()
    there.send((*answer, _used()))
    there.close()


def _end_with_parent() -> None:
    """End this process when the one that it was forked from ends, where Linux does that."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG


def _move(place: Place) -> None:
    """Work in the copy from now on, with its modules."""
    os.chdir(place.root)
    paths: Mapping[str, str] = {
        "PYTHONPATH": str(place.root),
        "NUMBA_CACHE_DIR": str(place.numba),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    os.environ.update(paths)
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(place.root))
    if not place.loaded:
        forget()
    if "numba" in sys.modules:  # It has read the environment already.
        sys.modules["numba"].core.config.CACHE_DIR = str(place.numba)


def _used() -> float:
    return sum(
        used.ru_utime + used.ru_stime
        for used in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    )
