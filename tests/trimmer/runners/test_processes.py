import os
import time
from collections.abc import Iterator

import pytest

from trimmer import SerialRunner
from trimmer.errors import WorkerError
from trimmer.runners import ClusterRunner, ProcessRunner
from trimmer.runners.chunks import AHEAD
from trimmer.runners.runner import CHUNK


def square(number: int) -> int:
    return number * number


def fail(number: int) -> int:
    raise ArithmeticError(f"no {number}")


def leave(number: int) -> int:
    os._exit(1)


def slow(number: int) -> int:
    time.sleep(0.01)
    return number


@pytest.mark.parametrize("runner", [SerialRunner(), ProcessRunner(1), ProcessRunner(2)])
def test_each_cell_is_done_once(runner) -> None:
    assert sorted(runner.results(square, range(50))) == [number * number for number in range(50)]


def test_no_cells_give_no_results() -> None:
    assert list(ProcessRunner(2).results(square, [])) == []


def test_cells_are_taken_as_they_are_needed() -> None:
    taken = []

    def cells() -> Iterator[int]:
        for number in range(10_000):
            taken.append(number)
            yield number

    results = ProcessRunner(1).results(slow, cells())
    next(results)
    assert len(taken) <= (AHEAD + 1) * CHUNK
    results.close()


def test_an_error_of_the_work_comes_through() -> None:
    with pytest.raises(ArithmeticError, match="no 0"):
        list(ProcessRunner(1).results(fail, [0]))


def test_a_process_that_is_ended_is_told_in_a_sentence() -> None:
    with pytest.raises(WorkerError, match="fewer processes"):
        list(ProcessRunner(1).results(leave, [0]))


def test_processes_are_as_many_as_asked_or_as_cores() -> None:
    assert ProcessRunner(3).count == 3
    assert ProcessRunner().count == len(os.sched_getaffinity(0))


@pytest.mark.parametrize(
    ("runner", "wrong"),
    [
        (ProcessRunner, {"processes": 0}),
        (ProcessRunner, {"processes": -1}),
        (ProcessRunner, {"chunk": 0}),
        (ClusterRunner, {"address": "tcp://127.0.0.1:1", "chunk": 0}),
        (ClusterRunner, {"address": "tcp://127.0.0.1:1", "chunk": -1}),
        (ClusterRunner, {"address": "tcp://127.0.0.1:1", "patience": 0}),
    ],
)
def test_counts_of_runners_are_whole_numbers_from_1_on(runner, wrong: dict[str, int | str]) -> None:
    with pytest.raises(ValueError, match=f"{list(wrong)[-1]} must be a whole number from 1 on"):
        runner(**wrong)
