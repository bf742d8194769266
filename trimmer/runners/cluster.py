"""The work of cells, done on a Dask cluster (``pip install trimmer[cluster]``)."""

from __future__ import annotations

import asyncio
import platform
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import CancelledError, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

from trimmer.arguments import require_instance, whole_number
from trimmer.errors import WorkerError
from trimmer.runners.chunks import handed_back
from trimmer.runners.runner import CHUNK, Cell, Result

if TYPE_CHECKING:
    from distributed import Client

PATIENCE = 20  # Seconds to wait for the scheduler, and then for its first worker

_LIBRARIES = ("trimmer", "numpy", "scipy", "numba")
_ONE_AT_A_TIME = threading.Lock()


@dataclass(frozen=True)
class ClusterRunner:
    """A runner that does cells on a Dask cluster.

    The workers need the same Python and the same libraries; that is checked with each chunk. Results are then
    those of this computer, to the last digit if its linear algebra runs on one thread as that of Dask's
    workers does (``OPENBLAS_NUM_THREADS=1``); else the last digit may differ. What a worker had not handed
    back when it ended is done by another one. A worker does one chunk after the other however many threads it
    has: begin it with ``--nthreads 1``.

    Attributes:
        address: Where the scheduler listens, such as ``tcp://127.0.0.1:8786``.
        chunk: Cells that go to a worker at once.
        patience: Seconds to wait for the scheduler, and then for its first worker.

    Raises:
        WrongTypeError: if the address is no text.
        ValueError: if another is not a whole number from 1 on.
    """

    address: str
    chunk: int = CHUNK
    patience: int = PATIENCE

    def __post_init__(self) -> None:
        require_instance("address", self.address, str, "the address of a scheduler")
        whole_number("chunk", self.chunk, 1)
        whole_number("patience", self.patience, 1)

    def check(self) -> None:
        """Check that the cluster can be reached, before any work is done.

        Raises:
            WorkerError: if Dask is not installed, the scheduler does not answer, or it has no worker.
        """
        self._client().close()

    def results(self, work: Callable[[Cell], Result], cells: Iterable[Cell]) -> Iterator[Result]:
        """Yield the results of the cells as they come.

        Raises:
            WorkerError: if Dask is not installed, the scheduler does not answer or leaves, it has no worker,
                a worker has other versions, or workers ended again and again over the same cells.
        """
        client = self._client()
        # Cells may be equal, and yet each is done; so results are not looked up by their arguments.
        pool = client.get_executor(pure=False)
        submit = partial(pool.submit, _done, work, _programs())
        try:
            with _in_a_sentence(self.address):
                yield from handed_back(
                    submit, cells, self.chunk, lambda: max(sum(client.nthreads().values()), 1)
                )
        finally:
            pool.shutdown(wait=False)  # takes back what nobody waits for, after an interrupt for example
            client.close()

    def _client(self) -> Client:
        try:
            from distributed import Client
        except ImportError as error:
            raise WorkerError(
                "a cluster needs the package distributed: pip install 'trimmer[cluster]'"
            ) from error
        # A client that finds nobody stays behind half made, and Dask may wait for ever as it is cleared away.
        try:
            with ThreadPoolExecutor(1) as thread:
                thread.submit(asyncio.run, _reach(self.address, self.patience)).result()
        except (OSError, TimeoutError, ValueError) as error:
            raise WorkerError(
                f"no Dask scheduler answers at {self.address}: begin one with 'dask scheduler', and give the "
                "address that it prints"
            ) from error
        client = Client(self.address, timeout=self.patience, set_as_default=False)
        try:
            client.wait_for_workers(1, timeout=self.patience)
        except TimeoutError as error:
            client.close()
            raise WorkerError(
                f"the Dask scheduler at {self.address} has no worker: begin one with 'dask worker "
                f"{self.address} --nthreads 1'"
            ) from error
        return client


async def _reach(address: str, patience: float) -> None:
    """Connect with a scheduler, and leave it again."""
    from distributed.comm import connect

    comm = await connect(address, timeout=patience)
    await comm.close()


@contextmanager
def _in_a_sentence(address: str) -> Iterator[None]:
    """Tell what goes wrong with a cluster as a ``WorkerError``."""
    from distributed import KilledWorker
    from distributed.comm import CommClosedError

    try:
        yield
    except KilledWorker as error:
        raise WorkerError(
            f"workers of {address} ended again and again over the same cells, perhaps as memory ran out: "
            "give them more, or fewer workers to a computer"
        ) from error
    except (CancelledError, CommClosedError) as error:
        raise WorkerError(
            f"the Dask scheduler at {address} has left: begin it again, and go on (--resume where there is a "
            "file)"
        ) from error
    except ModuleNotFoundError as error:
        raise WorkerError(
            f"a worker of {address} lacks the module {error.name}: install there what is installed here"
        ) from error


def _programs() -> tuple[tuple[str, str], ...]:
    """Return what the digits of a result depend on."""
    return (("Python", platform.python_version()), *((name, version(name)) for name in _LIBRARIES))


def _done(work: Callable[[Any], Any], programs: tuple[tuple[str, str], ...], cells: list[Any]) -> list[Any]:
    """Do the cells of a chunk, on a worker."""
    for (name, wanted), (_, present) in zip(programs, _programs(), strict=True):
        if wanted != present:
            raise WorkerError(
                f"a worker at {platform.node()} has {name} {present}, and this computer {wanted}: install "
                "the same, or digits may differ"
            )
    with _ONE_AT_A_TIME:
        return [work(cell) for cell in cells]
