"""Ask the package, and the second ways, for the digits of the problems.

``python -m benchmarks.problems.ask [NAME ...]`` prints each digit with what both find; it ends with 1
where one is further off than the file says.
"""

import contextlib
import importlib
import io
import json
import math
import os
import shlex
import sys
from argparse import ArgumentParser
from collections.abc import Iterator, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from benchmarks.problems.read import Digit, Problem, problems

FILE = "machine.toml"


def ours(problem: Problem) -> dict[str, float]:
    """Return the digits as the package finds them, by its commands or the problem's Python."""
    if problem.python:
        found = names_of(problem)["found"]
        return {each.name: float(found[each.name]) for each in problem.digits}
    with TemporaryDirectory() as folder:
        write_files(problem, Path(folder))
        told = {name: _told(line, Path(folder)) for name, line in problem.asks.items()}
    return {each.name: followed(told, each) for each in problem.digits}


def names_of(problem: Problem) -> dict[str, Any]:
    """Run the Python of a problem; return what it names."""
    space: dict[str, Any] = {}
    exec(compile(problem.python, f"{problem.name}.toml", "exec"), space)
    return space


def one(problem: Problem, digit: Digit) -> float:
    """Return one digit as the package finds it, by the command that it needs alone."""
    if problem.python:
        return ours(problem)[digit.name]
    with TemporaryDirectory() as folder:
        write_files(problem, Path(folder))
        return followed({digit.ours[0]: _told(problem.asks[str(digit.ours[0])], Path(folder))}, digit)


def write_files(problem: Problem, folder: Path) -> None:
    """Write the machine of a problem, and what it reads."""
    for name, content in {FILE: problem.machine, **problem.files}.items():
        (folder / name).write_text(content, encoding="utf-8")


def _told(line: str, folder: Path) -> Any:
    """Return what a command prints as JSON; FILE in it stands for the machine."""
    from trimmer.command_line.main import main

    words = [str(folder / FILE) if word == "FILE" else word for word in shlex.split(line)]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        code = main([*words, "--json", "--quiet"])
    if code:
        raise RuntimeError(f"trimmer {line} ended with {code}")
    return json.loads(printed.getvalue())


def followed(told: Any, digit: Digit) -> float:
    """Return the number to which the keys of a digit lead.

    A key of a list is a number, or a ``kind``: of the entries of that kind the one whose ``value`` is nearest
    to the digit. Behind the number may stand ``modulus`` of a complex one, ``half``, ``minus``, or ``turns``,
    which makes rad/s of Hz; of a list ``count``.
    """
    for key in digit.ours:
        told = _step(told, key, digit.value)
    return float(told)


def _step(told: Any, key: str | int, near: float) -> Any:
    if isinstance(told, dict) or isinstance(key, int):
        return told[key]
    if isinstance(told, list) and key not in {"modulus", "count"}:
        found = [each["value"] for each in told if each["kind"] == key]
        return min(found, key=lambda value: min(abs(value - near), abs(math.tau * value - near)))
    changed = {
        "modulus": lambda: abs(complex(*told)),
        "half": lambda: 0.5 * told,
        "minus": lambda: -told,
        "turns": lambda: math.tau * told,
        "count": lambda: len(told),
    }
    return changed[str(key)]()


def second(problem: Problem) -> dict[str, float]:
    """Return the digits that the second way finds; it imports nothing of the package."""
    module, _, function = problem.second_way.partition(".")
    found: Mapping[str, Any] = getattr(
        importlib.import_module(f"benchmarks.problems.second_ways.{module}"), function
    )()
    return {name: float(value) for name, value in found.items()}


def compared(problem: Problem, found: Mapping[str, float]) -> dict[str, float]:
    """Return how far what was found is from each digit, relative."""
    return {each.name: abs(found[each.name] / each.value - 1.0) for each in problem.digits}


def held(problem: Problem, found: Mapping[str, Mapping[str, float]]) -> Iterator[tuple[bool, str]]:
    """Yield of each digit whether a way is further off than the file says, and a line on all ways."""
    off = {name: compared(problem, values) for name, values in found.items()}
    for each in problem.digits:
        late = any(not errors[each.name] <= each.agreement for errors in off.values())
        told = "  ".join(
            f"{name} {found[name][each.name]!r} ({errors[each.name]:.0e})" for name, errors in off.items()
        )
        head = f"  {each.name}: {each.printed} {each.unit}, to {each.agreement:.0e}"
        yield late, f"{head}; {told}{'  OFF' if late else ''}"


def main() -> int:
    """Print the table of what both ways find; return 1 where one is too far off."""
    parser = ArgumentParser(prog="python -m benchmarks.problems.ask", description=__doc__)
    parser.add_argument("names", nargs="*", help="names of problems (default: all)")
    parser.add_argument("--only", choices=("ours", "second"), help="ask in one way alone")
    arguments = parser.parse_args()
    wrong = 0
    for problem in problems():
        if arguments.names and problem.name not in arguments.names:
            continue
        ways = {"ours": ours, "second": second}
        found = {name: way(problem) for name, way in ways.items() if arguments.only in (None, name)}
        print(problem.name)
        for late, line in held(problem, found):
            wrong += late
            print(line, flush=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    sys.exit(main())
