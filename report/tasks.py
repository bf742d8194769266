"""Tasks of a build: what is kept from the last one is taken, the rest is done in two processes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from report import background
from report.progress import Progress
from report.stage_store import StageStore


@dataclass(frozen=True)
class Task:
    """Work whose result is kept.

    Attributes:
        name: Unique; the result is kept in a file of this name.
        stage: Stage of the build that it belongs to, for the log.
        key: Digest of everything that the result depends on.
        work: Does it; the result can be pickled and is not None.
    """

    name: str
    stage: str
    key: str
    work: Callable[[], Any]


def done(tasks: Sequence[Task], store: StageStore, progress: Progress) -> dict[str, Any]:
    """Return the result of each task by its name.

    Tasks whose results are not kept under their key are done, every other one in a second process, and
    their results kept.
    """
    results = {task.name: store.load(task.name, task.key) for task in tasks}
    missing = [task for task in tasks if results[task.name] is None]
    here, there = missing[::2], missing[1::2]
    elsewhere = background.start([task.work for task in there])
    for task, result in zip(here, _by_stage(here, progress, lambda task: task.work()), strict=True):
        results[task.name] = result
    for task, result in zip(there, _by_stage(there, progress, lambda _: next(elsewhere)), strict=True):
        results[task.name] = result
    for task in missing:
        store.keep(task.name, task.key, results[task.name])
    return results


def _by_stage(tasks: Sequence[Task], progress: Progress, work: Callable[[Task], Any]) -> list[Any]:
    """Do tasks in their order, the neighbours of one stage behind one progress bar."""
    results: list[Any] = []
    while len(results) < len(tasks):
        stage = tasks[len(results)].stage
        group = [task for task in tasks[len(results) :] if task.stage == stage]
        results += progress.run(stage, group, work)
    return results
