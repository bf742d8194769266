"""The lines of code behind a step: of each function that it names, the file, the place and the text."""

import inspect
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from derivations.step import NarrativeStep
from report.cache.source_closure import ROOT
from report.pages.figure import CodeLines


@dataclass(frozen=True)
class StepWithLines:
    """A step as it is kept: with the lines of its functions in place of the functions."""

    step: NarrativeStep  # The step, without functions
    lines: tuple[CodeLines, ...]  # Those of its functions, in their order


def with_lines(derived: Callable[..., Iterable[NarrativeStep]], *arguments: Any) -> tuple[StepWithLines, ...]:
    """Return the steps that a function derives, with the lines of their functions."""
    steps = derived(*arguments)
    return tuple(StepWithLines(replace(each, code=()), tuple(map(code_lines, each.code))) for each in steps)


def code_lines(function: Callable[..., Any]) -> CodeLines:
    """Return where a function or class of this project stands, and its text.

    Raises:
        ValueError: if it is not defined in this project.
    """
    plain = inspect.unwrap(function)
    path = Path(inspect.getsourcefile(plain) or "").resolve()
    if not path.is_relative_to(ROOT.resolve()):
        raise ValueError(f"{plain} is no code of this project; name a function of it in the step")
    lines, first = inspect.getsourcelines(plain)
    text = "".join(lines).rstrip()
    name = plain.__qualname__
    return CodeLines(path.relative_to(ROOT.resolve()).as_posix(), name, first, first + len(lines) - 1, text)
