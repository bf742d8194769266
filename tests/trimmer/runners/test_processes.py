import os

import pytest

from trimmer.errors import WorkerError
from trimmer.runners import ClusterRunner, ProcessRunner


def leave(number: int) -> int:
    os._exit(1)


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
