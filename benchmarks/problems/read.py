"""The problems as data: a TOML file each, checked as it is read."""

import math
import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parent
KINDS = frozenset({"play", "stop", "friction", "impact", "control"})
NEEDED = {"title", "kinds", "statement", "second_way", "digits"}
KEYS = NEEDED | {"source", "ways", "machine", "asks", "python", "files"}
LEAST_WAYS = 2
COARSEST = 1e-5  # A digit is confirmed to this at least, relative


class ProblemError(ValueError):
    """A problem's file says something that cannot be used."""


@dataclass(frozen=True)
class Digit:
    """A number that a problem asks for."""

    name: str  # What it is; unique in the problem
    value: float  # In the unit
    unit: str  # SI, or empty for a pure number
    agreement: float  # Relative difference within which all ways agree
    ways: tuple[str, ...]  # How it was found, two independent ways at least, in words
    # Keys that lead to it in what the package tells; empty if the problem's Python makes it
    ours: tuple[str | int, ...]

    @property
    def printed(self) -> str:
        """Return the digits that are confirmed, no more."""
        return f"{self.value:.{min(15, max(2, math.floor(-math.log10(self.agreement))))}g}"


@dataclass(frozen=True)
class Problem:
    """A problem: statement in words and equations, how two ways find it, and its digits."""

    name: str
    title: str
    kinds: tuple[str, ...]
    statement: str
    source: str
    machine: str
    files: dict[str, str]
    asks: dict[str, str]
    python: str
    second_way: str
    digits: tuple[Digit, ...]


@cache
def problems() -> tuple[Problem, ...]:
    """Return all problems, by name.

    Raises:
        ProblemError: for a file that cannot be used; names it, the key, and what to do.
    """
    return tuple(read(path) for path in sorted(FOLDER.glob("*.toml")))


def read(path: Path) -> Problem:
    """Return the problem of a file; errors as of ``problems``."""
    data = tomllib.loads(path.read_text(encoding="utf-8"))
    if unknown := sorted(set(data) - KEYS):
        raise ProblemError(f"{path.name}: unknown key {unknown[0]!r}; known are {', '.join(sorted(KEYS))}")
    if missing := sorted(NEEDED - set(data)):
        raise ProblemError(f"{path.name}: {missing[0]!r} is missing; add it")
    if wrong := sorted(set(data["kinds"]) - KINDS):
        raise ProblemError(f"{path.name}: kinds has {wrong[0]!r}; known are {', '.join(sorted(KINDS))}")
    if "python" not in data and not {"machine", "asks"} <= set(data):
        raise ProblemError(f"{path.name}: give machine and asks, or python, so that the package can be asked")
    digits = tuple(_digit(path.name, entry, data) for entry in data["digits"])
    names = [each.name for each in digits]
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise ProblemError(f"{path.name}: digit {twice!r} is there twice; give each a name of its own")
    return Problem(
        path.stem,
        data["title"],
        tuple(data["kinds"]),
        data["statement"].strip(),
        data.get("source", "made for this collection"),
        data.get("machine", ""),
        data.get("files", {}),
        data.get("asks", {}),
        data.get("python", ""),
        data["second_way"],
        digits,
    )


def _digit(file: str, entry: dict[str, Any], data: dict[str, Any]) -> Digit:
    name = entry.get("name", "?")
    wrong = set(entry) ^ {"name", "value", "unit", "agreement"} ^ ({"ways", "ours"} & set(entry))
    if wrong:
        raise ProblemError(f"{file}: digit {name!r} lacks or has {min(wrong)!r}; give value, unit, agreement")
    ways = tuple(entry.get("ways", data.get("ways", ())))
    if len(ways) < LEAST_WAYS:
        raise ProblemError(f"{file}: digit {name!r} has {len(ways)} ways; two independent ones are needed")
    value, agreement = float(entry["value"]), float(entry["agreement"])
    if not (math.isfinite(value) and value != 0.0 and 0.0 < agreement <= COARSEST):
        raise ProblemError(
            f"{file}: digit {name!r} is {value} to {agreement}; give a number that is not 0, confirmed to"
            f" {COARSEST:g} relative or better"
        )
    return Digit(name, value, entry["unit"], agreement, ways, tuple(entry.get("ours", ())))
