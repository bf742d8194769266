"""What results inherit to show themselves.

A dataclass that inherits from these says ``repr=False``, so that it keeps their ``repr``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import fields
from enum import Enum
from html import escape
from numbers import Complex, Integral, Real
from typing import TYPE_CHECKING

from trimmer.choices import Choice
from trimmer.showing.table import Table, to_frame

if TYPE_CHECKING:
    import pandas

LONGEST = 160  # Most characters of what is told


class Shown:
    """A result that shows itself in one line, and as a paragraph in a notebook."""

    __slots__ = ()

    def _told(self) -> str:
        """Return what is to be said of the result, in a few words."""
        raise NotImplementedError

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {_short(self._told())}>"

    def _repr_html_(self) -> str:
        return sentence(type(self).__name__, _short(self._told()))


class ShownFields:
    """A small result that is its fields; they are a table in a notebook. Its ``repr`` is the dataclass's."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        content = [(each.name, getattr(self, each.name)) for each in fields(self) if each.repr]  # type: ignore[arg-type]
        return of_fields(type(self).__name__, content)


class Tabular(Shown):
    """A result that is a table too."""

    __slots__ = ()

    def _table(self) -> Table:
        """Return the table."""
        raise NotImplementedError

    def to_dataframe(self) -> pandas.DataFrame:
        """Return the table as a data frame of pandas, with the units in ``attrs["units"]``.

        Columns have the names of the keys in the JSON of the command line, where that has them.

        Raises:
            MissingPackageError: if pandas is not installed.
        """
        return to_frame(self._table())

    def _repr_html_(self) -> str:
        return of_table(type(self).__name__, _short(self._told()), self._table())


def _short(told: str) -> str:
    line = " ".join(told.split())
    return line if len(line) <= LONGEST else f"{line[: LONGEST - 1].rstrip()}…"


def counted(count: int | str, noun: str) -> str:
    """Return a number with what it counts: ``1 orbit``, ``2 orbits``, ``2 bodies``, ``2 guesses``."""
    if str(count) == "1":
        return f"1 {noun}"
    plural = f"{noun}es" if noun.endswith(("ch", "s")) else f"{noun}s"
    plural = f"{noun[:-1]}ies" if noun.endswith("y") and noun[-2] not in "aeiou" else plural
    return f"{count} {plural}"


MOST_ROWS = 20  # Rows that are shown


def sentence(name: str, told: str) -> str:
    """Return a paragraph: the name of a class, and what is told of the result."""
    return f"<p><strong>{escape(name)}</strong>: {escape(told)}</p>"


def of_table(name: str, told: str, table: Table) -> str:
    """Return what is told of a result, and its table, cut off after ``MOST_ROWS`` rows."""
    heads = "".join(_head(column.name, column.unit) for column in table.columns)
    rows = "".join(_row(values) for values in table.rows(MOST_ROWS))
    left = len(table.items) - MOST_ROWS
    more = f"<p>… and {left} more rows</p>" if left > 0 else ""
    shown = (
        f"<table><caption>{escape(table.title)}</caption><thead><tr>{heads}</tr></thead>"
        f"<tbody>{rows}</tbody></table>{more}"
    )
    return sentence(name, told) + (shown if table.items else "")


def of_fields(name: str, content: Iterable[tuple[str, object]]) -> str:
    """Return names and values as a table with a row for each."""
    row = '<tr><th scope="row">{}</th><td>{}</td></tr>'
    rows = "".join(row.format(escape(key), escape(as_text(value))) for key, value in content)
    return f"<table><caption>{escape(name)}</caption><tbody>{rows}</tbody></table>"


def _head(name: str, unit: str) -> str:
    return f'<th scope="col">{escape(f"{name}, {unit}" if unit else name)}</th>'


def _row(values: tuple[object, ...]) -> str:
    return f"<tr>{''.join(f'<td>{escape(as_text(value))}</td>' for value in values)}</tr>"


def as_text(value: object) -> str:
    """Write a value for a reader: numbers with six digits, yes and no, nothing where there is none."""
    if value is None:
        return ""
    if isinstance(value, Enum):
        return value.word if isinstance(value, Choice) else str(value.value)
    if type(value).__name__ in ("bool", "bool_"):
        return "yes" if value else "no"
    if isinstance(value, Integral):
        return str(value)
    if isinstance(value, Real):
        number = float(value)
        return "" if math.isnan(number) else f"{number:.6g}"
    if isinstance(value, Complex):
        pair = complex(value)
        return f"{pair.real:.6g} {'−' if pair.imag < 0 else '+'} {abs(pair.imag):.6g}j"
    return str(value)
