"""Prose with numbers filled in, written as it is read.

A number stands as ``[[ name | f2 ]]``, so that the braces of TeX mean nothing here. Line breaks and the
indent of a text block count as one space.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any

import sympy
from jinja2 import Environment, StrictUndefined, Template, TemplateError, Undefined, meta, nodes

from report.judging.comparisons.printed import power, power_of
from trimmer.errors import TrimmerError

SPACE = re.compile(r"[ \n]+")
"""Spaces that may be one; not a no-break space."""
MOST_PLACES = 12
CALCULATING = (nodes.BinExpr, nodes.UnaryExpr, nodes.Call)


class RecordError(TrimmerError, ValueError):
    """A record of a claim or a figure cannot be used; the message says which one, and what to do."""


class TextError(RecordError):
    """A text lacks a number that it asks for, is given one it does not ask for, or is malformed."""


def filled(prose: str, **numbers: object) -> str:
    """Return prose as one line, with numbers in place of ``[[ name | filter ]]``.

    Args:
        prose: pandoc Markdown with TeX mathematics between dollar signs.
        numbers: by the names that the prose uses. Filters: ``f2`` two decimals, ``signed2`` the same with its
            sign, ``e2``, ``g2`` and ``g`` as Python's formats, ``percent1`` a share in per cent, ``power2``
            digits times a power of ten, ``power`` the same of printed digits, ``latex`` an expression.

    Raises:
        TextError: naming what the prose asks for and is not given, or is given and does not ask for.
    """
    try:
        template, asked = _compiled(SPACE.sub(" ", prose.strip(" \n")))
        if asked != numbers.keys():
            raise TextError(_mismatch(asked, frozenset(numbers)))
        return template if isinstance(template, str) else template.render(numbers)
    except TextError:
        raise
    except (TemplateError, TypeError, ValueError) as error:
        raise TextError(f"the text {prose.strip()[:60]!r} cannot be filled in: {error}") from error


def _mismatch(asked: frozenset[str], given: frozenset[str]) -> str:
    lacking, unused = ", ".join(sorted(asked - given)), ", ".join(sorted(given - asked))
    parts = (
        f"asks for {lacking}, not given" if lacking else "",
        f"is given {unused}, not used" if unused else "",
    )
    return "the text " + "; ".join(part for part in parts if part)


@cache
def _compiled(prose: str) -> tuple[Template | str, frozenset[str]]:
    """Return the template of a prose (itself if it asks for no number), and the names it asks for."""
    if "[[" not in prose:
        return prose, frozenset()
    parsed = _environment().parse(prose)
    if any(parsed.find(kind) for kind in CALCULATING):
        raise TextError(f"the text {prose[:60]!r} calculates; give it the number under a name")
    asked = frozenset(meta.find_undeclared_variables(parsed))
    environment = _environment()
    return Template.from_code(environment, environment.compile(parsed), dict(environment.globals)), asked


@cache
def _environment() -> Environment:
    environment = Environment(
        variable_start_string="[[",
        variable_end_string="]]",
        block_start_string="[%",
        block_end_string="%]",
        comment_start_string="[#",
        comment_end_string="#]",
        undefined=StrictUndefined,
        autoescape=False,
    )
    environment.globals.clear()
    environment.filters.clear()
    environment.filters |= {"g": _formatted("g"), "latex": sympy.latex, "power": power}
    for places in range(MOST_PLACES + 1):
        environment.filters |= {
            f"f{places}": _formatted(f".{places}f"),
            f"signed{places}": _formatted(f"+.{places}f"),
            f"e{places}": _formatted(f".{places}e"),
            f"g{places}": _formatted(f".{places}g"),
            f"percent{places}": _formatted(f".{places}%"),
            f"power{places}": _power(places),
        }
    return environment


def _formatted(specification: str) -> Callable[[Any], str]:
    def write(value: Any) -> str:
        # The word of a missing attribute says which one it is; its format does not.
        return str(value) if isinstance(value, Undefined) else format(value, specification)

    return write


def _power(places: int) -> Callable[[float], str]:
    return lambda value: power_of(value, places)
