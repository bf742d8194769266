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
    """A function to generate, whose arguments are the parameters of a mechanism."""

    name: str  # Name of the function
    documentation: str  # Its docstring, one line
    entries: Entries  # Derived entries that it returns: a row, or rows of a matrix
    # A function before it in the module; if this one is that with another symbol in the place of one, it
    # calls it
    sibling: NumericFunction | None = None

    @property
    def symbols(self) -> set[sympy.Basic]:
        """The symbols that occur."""
        return sympy.Tuple(*self.entries).free_symbols


def function_source(function: NumericFunction, arguments: Mapping[sympy.Expr, str]) -> str:
    """Return the source of a function.

    Args:
        function: What it returns.
        arguments: Name of the argument for each symbol, in their order.
    """
    plain = {symbol: sympy.Symbol(name) for symbol, name in arguments.items()}
    nested = isinstance(function.entries[0], tuple)
    flat = [entry for row in function.entries for entry in row] if nested else list(function.entries)
    listed = ", ".join(f"{name}: float" for name in arguments.values())
    lines = [
        f"def {function.name}(",
        *_wrapped(f"{listed},", "    "),
        f") -> {'Matrix' if nested else 'Row'}:",
        f'    """{function.documentation}"""',
    ]
    if (taken := _taken(function)) is not None and function.sibling is not None:
        given = ", ".join(arguments[taken.get(symbol, symbol)] for symbol in arguments)
        return "\n".join((*lines, *_wrapped(f"return {function.sibling.name}({given})", "    "), ""))
    shared, reduced = sympy.cse([entry.xreplace(plain) for entry in flat], order="none")
    lines += [f"    {name} = {pycode(value)}" for name, value in shared]
    returned = _returned(reduced, len(function.entries[0]) if nested else None)
    return "\n".join((*lines, "    return (", *returned, "    )\n"))


def _taken(function: NumericFunction) -> dict[sympy.Basic, sympy.Basic] | None:
    """Return the symbol of the sibling and the one in its place here; None if more than that differs."""
    if (sibling := function.sibling) is None:
        return None
    taken = dict(zip(sibling.symbols - function.symbols, function.symbols - sibling.symbols, strict=False))
    same = sympy.Tuple(*sibling.entries).xreplace(taken) == sympy.Tuple(*function.entries)
    return taken if same and len(taken) == 1 else None


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
