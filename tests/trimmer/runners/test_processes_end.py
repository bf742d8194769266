"""Processes end when nobody waits for them, even beside one that was ended from outside."""

import multiprocessing
import os
import threading
import time

from trimmer.runners import ProcessRunner


def slow(number: int) -> int:
    time.sleep(0.02)
    return number


def test_results_that_nobody_wants_end_beside_a_killed_process() -> None:
    results = ProcessRunner(2, chunk=1).results(slow, range(10_000))
    next(results)
    os.kill(multiprocessing.active_children()[0].pid or 0, 9)
    closing = threading.Thread(target=results.close, daemon=True)
    closing.start()
    closing.join(20)
    assert not closing.is_alive()
