"""Laws of all runners, and a real cluster here: a scheduler and workers, each a process of its own."""

from __future__ import annotations

import math
import operator
import os
import signal
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from trimmer import Mechanism, SerialRunner, motion_map
from trimmer.command_line.main import main
from trimmer.errors import WorkerError
from trimmer.runners import ClusterRunner, ProcessRunner
from trimmer.runners.chunks import AHEAD

if TYPE_CHECKING:
    from distributed import LocalCluster

pytestmark = pytest.mark.skipif(find_spec("distributed") is None, reason="needs the package distributed")


@pytest.fixture(scope="module")
def cluster(request, tmp_path_factory) -> Iterator[LocalCluster]:
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=getattr(request, "param", 1),
        threads_per_worker=1,
        processes=True,
        dashboard_address=":0",
        silence_logs=50,
        local_directory=str(tmp_path_factory.mktemp("workers")),
    ) as made:
        yield made


def worker_ids(cluster: LocalCluster) -> list[int]:
    from distributed import Client

    with Client(cluster, set_as_default=False) as client:
        return list(client.run(os.getpid).values())


@pytest.fixture(params=[SerialRunner, ProcessRunner, ClusterRunner])
def runner(request):
    """Each kind of runner, in small chunks where it has any."""
    if request.param is SerialRunner:
        return SerialRunner()
    first = 2 if request.param is ProcessRunner else request.getfixturevalue("cluster").scheduler_address
    return request.param(first, chunk=2)


@pytest.mark.parametrize("cells", [[*range(50), 3, 3], []])
def test_each_cell_is_done_once(runner, cells: list[int]) -> None:
    assert sorted(runner.results(operator.neg, cells)) == sorted(-number for number in cells)


def test_cells_are_taken_as_they_are_needed(runner) -> None:
    taken = []

    def cells() -> Iterator[int]:
        for number in range(10_000):
            taken.append(number)
            yield number

    results = runner.results(operator.neg, cells())
    next(results)
    del results  # which ends it
    assert len(taken) <= 2 * (AHEAD * getattr(runner, "count", 1) + 1)


def test_an_error_of_the_work_comes_through(runner) -> None:
    with pytest.raises(ValueError, match=r"math domain error|nonnegative"):
        list(runner.results(math.sqrt, [-1.0]))


@pytest.mark.slow
@pytest.mark.parametrize("cluster", [2], indirect=True)
def test_a_worker_that_is_killed_on_the_way_changes_no_digit(cluster, project_folder: Path) -> None:
    mechanism = Mechanism.from_toml(project_folder / "examples" / "oscillator-stop.toml")
    values = {"frequency": [0.9 + 0.002 * number for number in range(48)]}
    alone = motion_map(mechanism, values, runner=SerialRunner(), most_periods=60, quiet=True)
    killed = worker_ids(cluster)[0]

    class Killing(ClusterRunner):
        def results(self, work, cells):
            for count, result in enumerate(super().results(work, cells)):
                if count == 3:
                    os.kill(killed, signal.SIGKILL)
                yield result

    runner = Killing(cluster.scheduler_address, chunk=1)
    shared = motion_map(mechanism, values, runner=runner, most_periods=60, quiet=True)
    assert repr(shared.cells) == repr(alone.cells)
    assert killed not in worker_ids(cluster)


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "nowhere://x"])
def test_a_scheduler_that_is_not_there_is_told_in_a_sentence(address: str) -> None:
    with pytest.raises(WorkerError, match=f"no Dask scheduler answers at {address}: begin one"):
        list(ClusterRunner(address, patience=1).results(operator.neg, [1]))


def test_a_scheduler_without_workers_is_told_in_a_sentence() -> None:
    from distributed import LocalCluster

    with LocalCluster(n_workers=0, dashboard_address=":0", silence_logs=50) as empty:
        runner = ClusterRunner(empty.scheduler_address, patience=1)
        with pytest.raises(WorkerError, match="has no worker: begin one"):
            list(runner.results(operator.neg, [1]))


def put_first(folder: str) -> None:
    sys.path.insert(0, folder)


def test_a_worker_with_other_versions_is_refused(cluster, tmp_path: Path) -> None:
    (tmp_path / "numpy-0.1.dist-info").mkdir()
    (tmp_path / "numpy-0.1.dist-info" / "METADATA").write_text("Name: numpy\nVersion: 0.1\n", "utf-8")
    from distributed import Client

    with Client(cluster, set_as_default=False) as client:
        client.run(put_first, str(tmp_path))
        try:
            with pytest.raises(WorkerError, match=r"has numpy 0\.1, and this computer .*: install the same"):
                list(ClusterRunner(cluster.scheduler_address).results(operator.neg, [1]))
        finally:
            client.run(sys_path_without, str(tmp_path))


def sys_path_without(folder: str) -> None:
    sys.path.remove(folder)


def test_the_command_line_takes_a_cluster(cluster, project_folder: Path, capsys) -> None:
    words = ["map", str(project_folder / "examples" / "oscillator-stop.toml"), "--vary", "frequency=0.9:1:3"]
    assert main([*words, "--json", "--scheduler", cluster.scheduler_address]) == 0
    shared = capsys.readouterr().out
    assert main([*words, "--json"]) == 0
    assert capsys.readouterr().out == shared


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--scheduler", "tcp://127.0.0.1:1", "--jobs", "2"], "leave one of them out"),
        (["--scheduler", " "], "give the address of a Dask scheduler"),
    ],
)
def test_options_that_contradict_are_refused(project_folder: Path, capsys, words, told: str) -> None:
    file = str(project_folder / "examples" / "oscillator-stop.toml")
    assert main(["map", file, "--vary", "frequency=0.9:1:3", *words]) == 2
    assert told in capsys.readouterr().err
