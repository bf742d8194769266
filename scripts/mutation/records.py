"""Outcomes, a line each in a file that only grows, so that an interrupted run goes on where it was."""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from enum import Enum
from pathlib import Path
from typing import Any

from scripts.mutation.mutants import Mutant
from scripts.mutation.operators import Kind


class Noticed(Enum):
    """By what a change is noticed."""

    CLAIMS = "claims"
    TESTS = "tests"
    NOTHING = "nothing"


@dataclass(frozen=True)
class Outcome:
    """What became of a mutant.

    Attributes:
        tests: The test that failed, empty if none did, None if none was asked.
        claims: The claim or check that differed, likewise.
        text: A claim that shows something else though its verdict is the same; empty if none does.
        files: How many test files may notice it.
        every: All tests that failed, where all were asked.
        seconds: Processor time, s.
    """

    tests: str | None = None
    claims: str | None = None
    text: str = ""
    files: int = 0
    every: tuple[str, ...] = ()
    seconds: float = 0.0

    @property
    def noticed(self) -> Noticed:
        """By what; by claims if both noticed it."""
        if self.claims:
            return Noticed.CLAIMS
        return Noticed.TESTS if self.tests else Noticed.NOTHING


@dataclass(frozen=True)
class Records:
    """The file of the outcomes."""

    path: Path

    def add(self, mutant: Mutant, outcome: Outcome) -> None:
        """Write an outcome; a later one of the same mutant counts instead of it."""
        row = {"key": mutant.key, "mutant": {**asdict(mutant), "kind": mutant.kind.value}, **asdict(outcome)}
        self.path.parent.mkdir(parents=True, exist_ok=True)
        cut = self.path.exists() and not self.path.read_bytes().endswith(b"\n")
        with self.path.open("a", encoding="utf-8") as lines:
            lines.write("\n" * cut + json.dumps(row) + "\n")

    def read(self) -> dict[str, tuple[Mutant, Outcome]]:
        """Return each mutant with its last outcome, by its key."""
        return {row.pop("key"): _read(row) for row in self._rows()}

    def _rows(self) -> Iterator[dict[str, Any]]:
        for line in self.path.read_text("utf-8").splitlines() if self.path.exists() else ():
            try:
                yield json.loads(line)
            except ValueError:  # The line that an interruption has cut off.
                continue


def _read(row: dict[str, Any]) -> tuple[Mutant, Outcome]:
    fields = row.pop("mutant")
    pairs = {name: tuple(fields[name]) for name in ("lines", "span")}
    row["every"] = tuple(row.get("every", ()))
    return Mutant(**{**fields, **pairs, "kind": Kind(fields["kind"])}), Outcome(**row)
