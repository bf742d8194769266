"""Tasks of a build: what is kept from the last one is taken, the rest is done in several processes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from report.building import background
from report.building.progress import Progress
from report.cache.stage_store import StageStore


@dataclass(frozen=True)
class BuildTask:
    """Work whose result is kept."""

    name: str  # Unique; the result is kept in a file of this name
    stage: str  # Stage of the build that it belongs to, for the log
    key: str  # Digest of everything that the result depends on
    work: Callable[[], Any]  # Does it; the result can be pickled and is not None


def done(tasks: Sequence[BuildTask], store: StageStore, progress: Progress) -> dict[str, Any]:
    """Return the result of each task by its name.

    Tasks whose results are not kept under their key are done, in several processes, and their results kept
    when all are there.
    """
    results = {task.name: store.load(task.name, task.key) for task in tasks}
    missing = [task for task in tasks if results[task.name] is None]
    for finished in progress.follow("tasks", len(missing), background.run([task.work for task in missing])):
        task = missing[finished.index]
        results[task.name] = finished.result
        progress.add(task.stage, task.name, finished.seconds)
    for task in missing:
        store.keep(task.name, task.key, results[task.name])
    return results
