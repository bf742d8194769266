"""Python source of derived expressions: functions of plain numbers, with common subexpressions shared."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import sympy
from sympy.printing.pycode import pycode

LINE_LENGTH = 110
Entries = tuple[sympy.Expr, ...] | tuple[tuple[sympy.Expr, ...], ...]


@dataclass(frozen=True)
class NumericFunction:
    """A function to generate, whose arguments are the parameters of a mechanism.

    Attributes:
        name: Name of the function.
        documentation: Its docstring, one line.
        entries: Derived entries that it returns: a row, or rows of a matrix.
    """

    name: str
    documentation: str
    entries: Entries


def function_source(function: NumericFunction, arguments: Mapping[sympy.Expr, str]) -> str:
    """Return the source of a function.

    Args:
        function: What it returns.
        arguments: Name of the argument for each symbol, in their order.
    """
    plain = {symbol: sympy.Symbol(name) for symbol, name in arguments.items()}
    nested = isinstance(function.entries[0], tuple)
    flat = [entry for row in function.entries for entry in row] if nested else list(function.entries)
    shared, reduced = sympy.cse([entry.xreplace(plain) for entry in flat], order="none")
    listed = ", ".join(f"{name}: float" for name in arguments.values())
    lines = [
        f"def {function.name}(",
        *_wrapped(f"{listed},", "    "),
        f") -> {'Matrix' if nested else 'Row'}:",
        f'    """{function.documentation}"""',
        *(f"    {name} = {pycode(value)}" for name, value in shared),
        "    return (",
        *(_returned(reduced, len(function.entries[0]) if nested else None)),
        "    )\n",
    ]
    return "\n".join(lines)


def _returned(entries: list[sympy.Expr], row_length: int | None) -> Iterator[str]:
    code = [pycode(entry) for entry in entries]
    if row_length is None:
        for entry in code:
            yield from _wrapped(f"{entry},", "        ")
        return
    for start in range(0, len(code), row_length):
        row = code[start : start + row_length]
        line = f"        ({', '.join(row)}{',' if row_length == 1 else ''}),"
        if len(line) <= LINE_LENGTH:
            yield line
            continue
        yield "        ("
        for entry in row:
            yield from _wrapped(f"{entry},", "            ")
        yield "        ),"


def _wrapped(code: str, indent: str) -> list[str]:
    """Break code that stands between parentheses at its spaces."""
    return textwrap.wrap(
        code, LINE_LENGTH, initial_indent=indent, subsequent_indent=indent, break_long_words=False
    )
