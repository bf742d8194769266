"""How processes and workers are begun, told to end and asked, with stand-ins for all of them."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import CancelledError, Future
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from types import SimpleNamespace as Made
from typing import Any

import pytest
from tqdm import TMonitor

from trimmer.errors import WorkerError
from trimmer.runners import cluster, processes, record_file
from trimmer.runners.chunks import AHEAD
from trimmer.runners.runner import SerialRunner


def double(cell: int) -> int:
    return 2 * cell


def broken(cell: int) -> int:
    raise BrokenProcessPool


class Pool:
    """Does chunks at once, and keeps what it was made and asked with."""

    def __init__(self, *made: Any) -> None:
        self.made, self.chunks, self.ended = made, [], {}

    def submit(self, work: Callable[..., list[int]], *given: Any) -> Future[list[int]]:
        self.chunks.append(given[-1])
        done: Future[list[int]] = Future()
        try:
            done.set_result(work(*given))
        except BaseException as error:
            done.set_exception(error)
        return done

    def shutdown(self, **how: bool) -> None:
        self.ended = how


class End:
    """An end of a pipe."""

    def __init__(self) -> None:
        self.sent, self.closed = [], False

    def send_bytes(self, content: bytes) -> None:
        self.sent.append(content)

    def close(self) -> None:
        self.closed = True


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> Made:
    """The pool and the pipe that a runner works with; its processes are this one."""
    found = Made(pools=[], pipe=(End(), End()), duplex=None)

    def pipe(duplex: bool) -> tuple[End, End]:
        found.duplex = duplex
        return found.pipe

    def pool(*given: Any) -> Pool:
        found.pools.append(Pool(*given))
        processes._Worker.work = staticmethod(given[-1][0])
        return found.pools[-1]

    found.context = Made(Pipe=pipe)
    monkeypatch.setattr(processes._Worker, "work", None, raising=False)
    monkeypatch.setattr(processes, "_context", lambda: found.context)
    monkeypatch.setattr(processes, "ProcessPoolExecutor", pool)
    return found


def test_one_process_does_its_cells_in_their_order() -> None:
    assert list(SerialRunner().results(double, iter([3, 1, 2]))) == [6, 2, 4]


def test_processes_that_are_done_are_waited_for(made: Made) -> None:
    assert sorted(processes.ProcessRunner(3, 2).results(double, range(5))) == [0, 2, 4, 6, 8]
    (pool,), (ended, end) = made.pools, made.pipe
    assert pool.made == (3, made.context, processes._begin, (double, ended))
    assert pool.chunks == [[0, 1], [2, 3], [4]]
    assert pool.ended == {"wait": True, "cancel_futures": True}
    assert (ended.sent, end.sent, ended.closed, end.closed, made.duplex) == ([], [], True, True, False)


def test_there_are_no_more_processes_than_chunks_nor_than_the_computer_bears(made: Made) -> None:
    assert sorted(processes.ProcessRunner(9, 8).results(double, range(10))) == list(range(0, 20, 2))
    assert list(processes.ProcessRunner(9, 8).results(double, [])) == []
    assert [pool.made[0] for pool in made.pools] == [2]
    with pytest.raises(ValueError, match=f"processes must be at most {processes.most_processes()} here"):
        processes.ProcessRunner(processes.most_processes() + 1)


def test_a_system_that_lets_no_process_begin_is_told(made: Made, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise OSError(30, "Read-only file system")

    monkeypatch.setattr(processes, "ProcessPoolExecutor", fail)
    with pytest.raises(WorkerError, match=r"no other processes .* \(Read-only file system\): do .*--jobs 1"):
        list(processes.ProcessRunner(2).results(double, [1]))


def test_processes_whose_results_nobody_wants_are_told_to_end(made: Made) -> None:
    results = processes.ProcessRunner(2, 1).results(double, range(100))
    next(results)
    results.close()
    (pool,), (ended, end) = made.pools, made.pipe
    assert len(pool.chunks) == 2 * AHEAD
    assert (ended.sent, end.sent, ended.closed, end.closed) == ([], [b"end"], True, True)
    assert pool.ended == {"wait": True, "cancel_futures": True}


def test_processes_of_which_one_is_gone_are_told_to_end(made: Made) -> None:
    with pytest.raises(WorkerError, match="go on with fewer processes"):
        list(processes.ProcessRunner(1).results(broken, [1]))
    assert made.pipe[1].sent == [b"end"]


def test_a_process_leaves_interrupts_and_watches_for_its_end(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[Any] = []

    class Thread:
        def __init__(self, **how: Any) -> None:
            self.how = how

        def start(self) -> None:
            told.append(self.how)

    monkeypatch.setattr(signal, "signal", lambda *given: told.append(given))
    monkeypatch.setattr(threading, "Thread", Thread)
    monkeypatch.setattr(processes._Worker, "work", None, raising=False)
    end: Any = "end"
    processes._begin(double, end)
    assert told == [
        (signal.SIGINT, signal.SIG_IGN),
        {"target": processes._end_with_parent, "daemon": True},
        {"target": processes._end_when, "args": (end,), "daemon": True},
    ]
    assert processes._done([3]) == [6]


def test_a_process_ends_with_its_parent_or_when_it_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[Any] = []
    monkeypatch.setattr(os, "_exit", lambda code: told.append(code))
    monkeypatch.setattr(multiprocessing, "parent_process", lambda: None)
    processes._end_with_parent()
    assert told == []
    parent = Made(join=lambda: told.append("joined"))
    monkeypatch.setattr(multiprocessing, "parent_process", lambda: parent)
    processes._end_with_parent()
    assert told == ["joined", 1]
    monkeypatch.setattr(processes, "wait_for", lambda ends: told.append(ends))
    end: Any = "end"
    processes._end_when(end)
    assert told[2:] == [["end"], 0]


def test_how_processes_begin(monkeypatch: pytest.MonkeyPatch) -> None:
    main, bars = threading.main_thread(), object.__new__(TMonitor)
    methods = ["spawn", "fork"]
    monkeypatch.setattr(multiprocessing, "get_all_start_methods", lambda: methods)
    for threads, method in (([main], "fork"), ([main, bars], "fork"), ([main, object()], "spawn")):
        monkeypatch.setattr(threading, "enumerate", lambda threads=threads: threads)
        assert processes._context().get_start_method() == method
    monkeypatch.setattr(threading, "enumerate", lambda: [main])
    methods.remove("fork")
    assert processes._context().get_start_method() == "spawn"


def test_cores_are_those_of_the_process_or_of_the_computer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        os, "sched_getaffinity", lambda process: {4, 6, 7} if process == 0 else {}, raising=False
    )
    monkeypatch.setattr(os, "cpu_count", lambda: 5)
    assert processes.cores() == 3
    monkeypatch.delattr(os, "sched_getaffinity")
    assert processes.cores() == 5
    monkeypatch.setattr(os, "cpu_count", lambda: None)
    assert processes.cores() == 1


class Client:
    """Stands for a client of Dask."""

    def __init__(self, threads: dict[str, int]) -> None:
        self.threads, self.pool, self.closed, self.asked = threads, Pool(), False, {}

    def get_executor(self, **how: bool) -> Pool:
        self.asked = how
        return self.pool

    def nthreads(self) -> dict[str, int]:
        return self.threads

    def close(self) -> None:
        self.closed = True


@pytest.mark.parametrize(("threads", "count"), [({"a": 2, "b": 1}, 3), ({}, 1)])
def test_chunks_are_sent_for_each_thread_of_a_cluster(
    monkeypatch: pytest.MonkeyPatch, threads: dict[str, int], count: int
) -> None:
    pytest.importorskip("distributed")
    client = Client(threads)
    monkeypatch.setattr(cluster.ClusterRunner, "_client", lambda self: client)
    results = cluster.ClusterRunner("tcp://127.0.0.1:1", 2).results(double, range(100))
    assert next(results) % 2 == 0
    assert len(client.pool.chunks) == AHEAD * count
    assert client.pool.chunks[0] == [0, 1]
    results.close()
    assert (client.asked, client.pool.ended, client.closed) == ({"pure": False}, {"wait": False}, True)


def test_what_goes_wrong_with_a_cluster_is_told() -> None:
    distributed = pytest.importorskip("distributed")
    from distributed.comm import CommClosedError

    lacking = ModuleNotFoundError("no module", name="numba")
    killed = distributed.KilledWorker.__new__(distributed.KilledWorker)
    for error, told in (
        (killed, "workers of tcp:x ended again and again"),
        (CancelledError(), "the Dask scheduler at tcp:x has left"),
        (CommClosedError(), "the Dask scheduler at tcp:x has left"),
        (lacking, "a worker of tcp:x lacks the module numba"),
    ):
        with pytest.raises(WorkerError, match=told), cluster._in_a_sentence("tcp:x"):
            raise error


def test_a_client_is_closed_if_no_worker_comes(monkeypatch: pytest.MonkeyPatch) -> None:
    distributed = pytest.importorskip("distributed")
    asked: list[Any] = []

    async def reach(address: str, patience: float) -> None:
        asked.append((address, patience))

    def connect(address: str, **how: Any) -> Client:
        asked.append((address, how))
        return client

    def wait(count: int, timeout: float) -> None:
        asked.append((count, timeout))
        if not client.threads:
            raise TimeoutError

    client = Client({"a": 1})
    client.wait_for_workers = wait  # type: ignore[attr-defined]
    monkeypatch.setattr(cluster, "_reach", reach)
    monkeypatch.setattr(distributed, "Client", connect)
    runner = cluster.ClusterRunner("tcp:x", patience=7)
    found: Any = runner._client()
    assert (found, client.closed) == (client, False)
    assert asked == [("tcp:x", 7), ("tcp:x", {"timeout": 7, "set_as_default": False}), (1, 7)]
    client.threads = {}
    with pytest.raises(WorkerError, match="tcp:x has no worker"):
        runner._client()
    assert client.closed


def test_a_scheduler_that_does_not_answer_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("distributed")
    for error in (OSError("no"), TimeoutError(), ValueError("no")):

        async def reach(address: str, patience: float, error: Exception = error) -> None:
            raise error

        monkeypatch.setattr(cluster, "_reach", reach)
        with pytest.raises(WorkerError, match=r"^no Dask scheduler answers at tcp:x: begin one"):
            cluster.ClusterRunner("tcp:x")._client()
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(WorkerError, match=r"^a cluster needs the package distributed"):
        cluster.ClusterRunner("tcp:x")._client()


def test_lines_are_on_the_disk_at_the_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    synced: list[str] = []
    path = tmp_path / "a.map"
    monkeypatch.setattr(os, "fsync", lambda number: synced.append(path.read_text("utf-8")))
    assert list(record_file.appended(path, [1, 2], lambda number: {"a": number})) == [1, 2]
    assert synced == ['{"a": 1}\n{"a": 2}\n']
    with pytest.raises(ValueError, match="not JSON compliant"):
        record_file.as_line({"a": float("nan")})
