"""Progress bars and times of the stages of a build."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TypeVar, final

from tqdm import tqdm

Item = TypeVar("Item")
Result = TypeVar("Result")
BAR = "{desc:<9}{percentage:3.0f}% |{bar:30}| {n_fmt}/{total_fmt} {elapsed}"


@final
@dataclass
class Progress:
    """Runs the stages of a build one after the other and keeps their times, s."""

    times: list[tuple[str, float]] = field(default_factory=list)

    def run(self, name: str, items: Sequence[Item], work: Callable[[Item], Result]) -> tuple[Result, ...]:
        """Do the work for each item, behind a progress bar, and return the results in order."""
        started = time.perf_counter()
        # disable=None: bars on a terminal only; a log gets one line for each stage.
        results = tuple(work(item) for item in tqdm(items, desc=name, bar_format=BAR, disable=None))
        self.times.append((name, time.perf_counter() - started))
        if not sys.stderr.isatty():
            print(f"{name:<9}{len(results)}/{len(items)} done", file=sys.stderr)
        return results

    def log(self) -> str:
        """Return one line for each stage and one for the sum."""
        rows = [*self.times, ("sum", sum(seconds for _, seconds in self.times))]
        return "".join(f"{name:<9}{seconds:7.2f} s\n" for name, seconds in rows)
