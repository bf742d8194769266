"""The second process of a build: order, errors, and its early end."""

import multiprocessing
import os
from functools import partial

import pytest

from report.background import BackgroundError, start

FORKS = "fork" in multiprocessing.get_all_start_methods()


def fail():
    raise ValueError("no such thing")


def test_results_come_in_order():
    assert list(start([partial(pow, 2, n) for n in range(5)])) == [1, 2, 4, 8, 16]


@pytest.mark.skipif(not FORKS, reason="processes cannot be forked here, so the work is done in this one")
def test_the_work_is_done_in_another_process():
    assert list(start([os.getpid])) != [os.getpid()]


def test_an_error_is_raised_where_its_result_is_asked_for():
    results = start([partial(pow, 2, 3), fail, partial(pow, 2, 4)])
    assert next(results) == 8
    with pytest.raises(ValueError, match="no such thing"):
        next(results)


@pytest.mark.skipif(not FORKS, reason="processes cannot be forked here, so none can die")
def test_an_early_end_is_reported():
    with pytest.raises(BackgroundError, match="ended early"):
        next(start([partial(os._exit, 1)]))
