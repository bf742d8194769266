"""Columns of numbers in a file of text, with their names in the first line (CSV)."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import TYPE_CHECKING

from trimmer.errors import TrimmerError
from trimmer.toml_files import read_text

if TYPE_CHECKING:
    from trimmer.arrays import Reals


class TableError(TrimmerError, ValueError):
    """A file that is no table of numbers; the message says where, and why."""


def columns_of(path: Path) -> dict[str, Reals]:
    """Return the columns of a file by their names, all of one length, (rows,).

    They are separated by commas, or by semicolons or tabs where the first line holds no comma. Empty
    lines and those that begin with # are passed over.
    """
    import numpy as np

    text = read_text(path, TableError, "write names of columns in the first line, numbers below")
    lines = [
        (number, line)
        for number, line in enumerate(text.splitlines(), 1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    head = lines[0][1] if lines else ""
    separator = next((each for each in ",;\t" if each in head), ",")
    rows = csv.reader((line for _, line in lines), delimiter=separator, skipinitialspace=True)
    table = [[cell.strip() for cell in row] for row in rows]
    names = table[0] if table else []
    if "" in names or len(set(names)) < len(names) or not names:
        raise TableError(f"{path}: line {lines[0][0] if lines else 1}: give each column a name of its own")
    numbers = [
        [_number(path, line, cell) for cell in _complete(path, line, row, len(names))]
        for (line, _), row in zip(lines[1:], table[1:], strict=True)
    ]
    if not numbers:
        raise TableError(f"{path}: holds no line of numbers below the names of its columns")
    return dict(zip(names, np.array(numbers, dtype=np.float64).T, strict=True))


def _complete(path: Path, line: int, row: list[str], count: int) -> list[str]:
    if len(row) != count:
        raise TableError(f"{path}: line {line}: holds {len(row)} cells where {count} columns are named")
    return row


def _number(path: Path, line: int, cell: str) -> float:
    import numpy as np

    try:
        number = float(cell)
    except ValueError:
        number = float("nan")
    if not np.isfinite(number):
        raise TableError(f"{path}: line {line}: {cell!r} is no finite number")
    return number
