"""Lines for who waits: what is being done and what time is left, on standard error and in a file."""

import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import final

from report.design.quantities import place_words
from trimmer.deadline import NEVER, Deadline
from trimmer.design.design import Stage
from trimmer.files import FileWriteError
from trimmer.progress import is_silenced

OFTEN = 5.0  # Time after which the same step is told of again where there is no terminal, s


def minutes(seconds: float) -> str:
    """Return a time as minutes and seconds, such as ``2:05``."""
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


@final
@dataclass
class ProgressLines:
    """Tells each step on standard error, unless that is silenced, and in a log.

    Raises:
        FileWriteError: if the log cannot be written.
    """

    log: Path | None = None  # The log, which is begun anew; none if not given
    deadline: Deadline = NEVER  # What time is left is told until then
    _begun: dict[tuple[Stage, tuple[str, ...]], float] = field(default_factory=dict)
    _last: float = 0.0

    def __post_init__(self) -> None:
        if self.log is not None:
            self.log.unlink(missing_ok=True)
            self._write("trimmer design: what was done, and the time that was left")

    def __call__(self, stage: Stage, over: tuple[str, ...], done: int, count: int) -> None:
        """Tell how much of a step is done; one that ends without having begun was kept, or left out."""
        now = time.perf_counter()
        words = " and ".join(map(place_words, over))
        name = f"{stage.value}{f' over the {words}' if over else ''}"
        if done == count <= 1:
            begun = self._begun.pop((stage, over), None)
            took = "kept" if begun is None else f"{now - begun:.1f} s"
            self.say(f"{name}: {took if count else 'left out'}", after_bar=True)
            return
        self._begun.setdefault((stage, over), now)
        if sys.stderr.isatty() and not is_silenced():
            share = f" {done}/{count}" if count > 1 else ""
            print(f"\r\033[K{name} ...{share}{self._left()}", end="", file=sys.stderr, flush=True)
        elif count > 1 and now > self._last + OFTEN:
            self._last = now
            self.say(f"{name} ... {done} of {count}{self._left()}")

    def say(self, text: str, *, after_bar: bool = False) -> None:
        """Tell something else."""
        self._write(text + ("" if text.endswith(")") else self._left()))
        if not is_silenced():
            clear = "\r\033[K" if after_bar and sys.stderr.isatty() else ""
            print(f"{clear}{text}", file=sys.stderr, flush=True)

    def _left(self) -> str:
        return "" if self.deadline is NEVER else f" ({minutes(self.deadline.left)} left)"

    def _write(self, text: str) -> None:
        if self.log is None:
            return
        try:
            self.log.parent.mkdir(parents=True, exist_ok=True)
            with self.log.open("a", encoding="utf-8") as file:
                file.write(f"{text}\n")
        except OSError as error:
            reason = f"{error.strerror or error}; name another place"
            raise FileWriteError(f"{self.log} cannot be written: {reason}") from error
