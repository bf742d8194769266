"""Lines for who waits: each step of a design as it begins, on a terminal with a count of what is done."""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass, field
from typing import final

from report.design.quantities import place_words
from trimmer.design.design import Stage
from trimmer.progress import is_silenced

KEPT = 0.05
"""Time below which a step was not computed but kept, s."""


@final
@dataclass
class ProgressLines:
    """Tells each step on standard error, unless that is silenced."""

    _begun: dict[tuple[Stage, tuple[str, ...]], float] = field(default_factory=dict)

    def __call__(self, stage: Stage, over: tuple[str, ...], done: int, count: int) -> None:
        """Tell how much of a step is done."""
        if is_silenced():
            return
        begun = self._begun.setdefault((stage, over), time.perf_counter())
        if done == count:
            del self._begun[stage, over]
        name = f"{stage.value}{f' over the {_words(over)}' if over else ''}"
        if sys.stderr.isatty():
            share = f" {done}/{count}" if count > 1 else ""
            print(
                f"\r\033[K{name} ...{share}", end="\n" if done == count else "", file=sys.stderr, flush=True
            )
        elif done == count:
            seconds = time.perf_counter() - begun
            print(f"{name}: {f'{seconds:.1f} s' if seconds > KEPT else 'kept'}", file=sys.stderr, flush=True)

    def say(self, text: str) -> None:
        """Tell something else."""
        if not is_silenced():
            print(text, file=sys.stderr, flush=True)


def _words(over: tuple[str, ...]) -> str:
    return " and ".join(map(place_words, over))
