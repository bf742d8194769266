"""Progress bars and times of the stages of a build."""

import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TypeVar, final

from tqdm import tqdm

from trimmer.progress import is_silenced

Item = TypeVar("Item")
Result = TypeVar("Result")
BAR = "{desc:<9}{percentage:3.0f}% |{bar:30}| {n_fmt}/{total_fmt} {elapsed}"


@final
@dataclass
class Progress:
    """Runs the stages of a build and keeps their times, s, and those of the tasks done side by side."""

    times: list[tuple[str, float]] = field(default_factory=list)
    tasks: list[tuple[str, str, float]] = field(default_factory=list)

    def run(self, name: str, items: Sequence[Item], work: Callable[[Item], Result]) -> tuple[Result, ...]:
        """Do the work for each item, behind a progress bar, and return the results in order."""
        return tuple(self.follow(name, len(items), (work(item) for item in items)))

    def follow(self, name: str, count: int, results: Iterable[Result]) -> Iterator[Result]:
        """Yield the results as they come, behind a progress bar; there will be ``count`` of them."""
        started = time.perf_counter()
        # disable=None: bars on a terminal only; a log gets one line for each stage.
        hidden = True if is_silenced() else None
        yield from tqdm(results, desc=name, total=count, bar_format=BAR, disable=hidden)
        self.times.append((name, time.perf_counter() - started))
        if not sys.stderr.isatty() and not is_silenced():
            print(f"{name:<9}{count}/{count} done", file=sys.stderr)

    def add(self, stage: str, task: str, seconds: float) -> None:
        """Keep the time of a task that was done beside others."""
        self.tasks.append((stage, task, seconds))

    def log(self) -> str:
        """Return one line for each stage, one for the sum, and one for each task, the longest first."""
        rows = [*self.times, ("sum", sum(seconds for _, seconds in self.times))]
        tasks = sorted(self.tasks, key=lambda task: -task[2])
        return "".join(f"{name:<9}{seconds:7.2f} s\n" for name, seconds in rows) + "".join(
            f"  {stage:<9}{seconds:7.2f} s  {task}\n" for stage, task, seconds in tasks
        )
