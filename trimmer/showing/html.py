"""HTML of results for notebooks: plain tables without colours or scripts, right on light and dark pages."""

import math
from collections.abc import Iterable
from enum import Enum
from html import escape
from numbers import Complex, Integral, Real

from trimmer.choices import Choice
from trimmer.showing.table import Table

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
