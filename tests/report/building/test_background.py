"""The other processes of a build: results, errors, and their early end."""

import multiprocessing
import os
import signal
import time
from functools import partial

import pytest

from report.building.background import BackgroundError, run

FORKS = "fork" in multiprocessing.get_all_start_methods()
needs_forks = pytest.mark.skipif(
    not FORKS, reason="processes cannot be forked here, so the work is done in this one"
)


def fail():
    raise ValueError("no such thing")


def test_every_result_comes_with_its_place():
    assert sorted((done.index, done.result) for done in run([partial(pow, 2, n) for n in range(5)])) == [
        (0, 1),
        (1, 2),
        (2, 4),
        (3, 8),
        (4, 16),
    ]


def test_no_jobs_have_no_results():
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
    with pytest.raises(ValueError, match="no such thing"):
        list(run([partial(pow, 2, 3), fail, partial(pow, 2, 4)]))


@needs_forks
def test_an_early_end_is_reported():
    with pytest.raises(BackgroundError, match="ended early"):
        list(run([partial(signal.raise_signal, signal.SIGKILL)]))


def test_the_time_of_a_job_is_returned():
    (done,) = run([partial(time.sleep, 0.05)])
    assert done.seconds >= 0.05
