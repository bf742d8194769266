"""Tasks are done once, in several processes, and again when keys change; results, errors, an early end."""

import multiprocessing
import os
import signal
import time
from functools import partial
from pathlib import Path

import pytest

from report.building.background import BackgroundError, run
from report.building.progress import Progress
from report.building.tasks import BuildTask, done
from report.cache.stage_store import StageStore


def square(number: int) -> tuple[int, int]:
    return number**2, os.getpid()


def fail() -> None:
    raise ArithmeticError("on purpose")


def tasks(key: str, *numbers: int) -> list[BuildTask]:
    return [BuildTask(f"square-{number}", "square", key, partial(square, number)) for number in numbers]


def test_results_come_by_name_from_other_processes(tmp_path: Path) -> None:
    results = done(tasks("a", 1, 2, 3, 4), StageStore(tmp_path), Progress())
    assert {name: value for name, (value, _) in results.items()} == {f"square-{n}": n**2 for n in range(1, 5)}
    assert os.getpid() not in {process for _, process in results.values()}


def test_what_is_kept_is_not_done_again(tmp_path: Path) -> None:
    store = StageStore(tmp_path)
    done(tasks("a", 1, 2), store, Progress())
    again = [BuildTask(f"square-{number}", "square", "a", fail) for number in (1, 2)]
    assert done(again, store, Progress())["square-2"][0] == 4
    changed = [*again[:1], BuildTask("square-2", "square", "b", partial(square, 5))]
    assert done(changed, store, Progress())["square-2"][0] == 25


def test_a_failure_is_raised_and_nothing_of_the_run_is_kept(tmp_path: Path) -> None:
    store = StageStore(tmp_path)
    with pytest.raises(ArithmeticError, match="on purpose"):
        done([*tasks("a", 1), BuildTask("wrong", "square", "a", fail)], store, Progress())
    assert store.load("square-1", "a") is None


def test_the_log_has_the_time_of_each_task(tmp_path: Path) -> None:
    progress = Progress()
    mixed = [*tasks("a", 1, 2, 3), BuildTask("other", "print", "a", partial(square, 7))]
    done(mixed, StageStore(tmp_path), progress)
    assert [name for name, _ in progress.times] == ["tasks"]
    assert {(stage, name) for stage, name, _ in progress.tasks} == {
        *(("square", f"square-{number}") for number in (1, 2, 3)),
        ("print", "other"),
    }
    assert all(name in progress.log() for name in ("sum", "square-3", "other"))


needs_forks = pytest.mark.skipif(
    "fork" not in multiprocessing.get_all_start_methods(), reason="the work is done in this process"
)


def test_every_result_comes_with_its_place():
    found = {done.index: done.result for done in run([partial(pow, 2, n) for n in range(5)])}
    assert found == {0: 1, 1: 2, 2: 4, 3: 8, 4: 16}
    assert list(run([])) == []


@needs_forks
def test_the_work_is_done_in_another_process():
    assert [done.result for done in run([os.getpid])] != [os.getpid()]


@needs_forks
@pytest.mark.skipif(os.cpu_count() == 1, reason="one core, one process")
def test_no_process_waits_for_the_job_of_another():
    """Results larger than a pipe's buffer once made a process wait until all jobs of the other were done."""
    results = run([partial(time.sleep, 2), *[partial(bytes, 1_000_000)] * 4])
    assert [len(next(results).result) for _ in range(4)] == [1_000_000] * 4
    results.close()


def test_an_error_is_raised():
    with pytest.raises(ArithmeticError, match="on purpose"):
        list(run([partial(pow, 2, 3), fail, partial(pow, 2, 4)]))


@needs_forks
def test_an_early_end_is_reported():
    with pytest.raises(BackgroundError, match="ended early"):
        list(run([partial(signal.raise_signal, signal.SIGKILL)]))


def test_the_time_of_a_job_is_returned():
    (done,) = run([partial(time.sleep, 0.05)])
    assert done.seconds >= 0.05
