"""Cells of a CSV file as numbers; text is never evaluated."""

import math
import re
from collections.abc import Sequence

import numpy as np

from trimmer.arrays import Reals
from trimmer.messages import shown_value
from trimmer.signals.csv_layout import COMMENT, DecimalSign
from trimmer.signals.signal import LARGEST_VALUE
from trimmer.signals.text_file import SignalFileError

MISSING = frozenset(
    {"", "-", "--", "?", "n/a", "#n/a", "na", "nan", "+nan", "-nan", "nan(ind)", "-nan(ind)", "null", "none"}
)
"""Cells that mean a missing value, whatever their capitals."""

_INFINITE = frozenset({"inf", "+inf", "-inf", "infinity", "+infinity", "-infinity", "∞", "-∞"})
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?", flags=re.ASCII)
_NUMERIC = re.compile(r"[+-]?[.,]?[0-9][0-9.,'eE+|\s-]*", flags=re.ASCII)
_PLAIN = re.compile(r"[0-9.eE+\s-]+", flags=re.ASCII)


def is_missing(cell: str) -> bool:
    """Return whether a cell means a missing value: it is empty or one of ``MISSING``."""
    return cell.strip().casefold() in MISSING


def is_numeric(cell: str) -> bool:
    """Return whether a cell is a number, or digits that were meant as one or several."""
    return _NUMERIC.fullmatch(cell.strip()) is not None


def is_text(cell: str) -> bool:
    """Return whether a cell is neither a number nor a missing or infinite value, as in a heading."""
    return not (is_numeric(cell) or is_missing(cell) or cell.strip().casefold() in _INFINITE)


def numbers_in(cells: Sequence[str], lines: Sequence[int], decimal: DecimalSign | None, place: str) -> Reals:
    """Read a column of numbers, (cells,); NaN where missing. Lines count from 1."""
    plain = _plain_numbers(cells, decimal)
    if plain is not None:
        return plain
    sign = decimal or _decimal_sign(cells, lines, place)
    numbers = np.empty(len(cells))
    for index, (cell, line) in enumerate(zip(cells, lines, strict=True)):
        text = _with_point(cell.strip(), sign)
        if _NUMBER.fullmatch(text):
            numbers[index] = float(text)
        elif is_missing(cell):
            numbers[index] = math.nan
        else:
            raise SignalFileError(f"{place}, line {line}: {_reason(cell, sign)}")
        if abs(numbers[index]) > LARGEST_VALUE:
            raise SignalFileError(f"{place}, line {line}: {shown_value(cell)} is too large for a number")
    return numbers


def _plain_numbers(cells: Sequence[str], decimal: DecimalSign | None) -> Reals | None:
    """Read a column at once, several times faster; None if it holds anything but numbers that can be used."""
    text = "\n".join(cells)
    if decimal is not DecimalSign.POINT and "," in text and "." not in text:
        text = text.replace(",", ".")
    elif decimal is DecimalSign.COMMA and "." in text:
        return None
    if not _PLAIN.fullmatch(text):
        return None
    try:
        numbers = np.array(list(map(float, text.split("\n"))))
    except ValueError:
        return None
    return numbers if (np.abs(numbers) <= LARGEST_VALUE).all() else None


def _with_point(text: str, sign: DecimalSign) -> str:
    """Write a number with a decimal point; empty for one that has a point in place of a comma."""
    if sign is DecimalSign.POINT:
        return text
    return "" if "." in text else text.replace(",", ".")


def _decimal_sign(cells: Sequence[str], lines: Sequence[int], place: str) -> DecimalSign:
    first: dict[DecimalSign, int] = {}
    for cell, line in zip(cells, lines, strict=True):
        signs = [sign for sign in DecimalSign if sign.value in cell]
        if len(signs) == 2 and is_numeric(cell):
            raise SignalFileError(
                f"{place}, line {line}: {shown_value(cell)} has a point and a comma; choose the delimiter "
                "that fits, and write thousands without a sign"
            )
        for sign in signs:
            first.setdefault(sign, line)
    if len(first) == 2:
        point, comma = first[DecimalSign.POINT], first[DecimalSign.COMMA]
        raise SignalFileError(
            f"{place}, line {max(point, comma)}: decimals have a point in line {point} and a comma in line "
            f"{comma}; write them with one sign, and thousands without"
        )
    return next(iter(first), DecimalSign.POINT)


def _reason(cell: str, sign: DecimalSign) -> str:
    text, given = cell.strip(), shown_value(cell)
    if text.casefold() in _INFINITE:
        return f"{given} is not finite; was the sensor overloaded? Leave the cell empty if it is missing"
    if ("," if sign is DecimalSign.POINT else ".") in text:
        return f"{given} is no number with a decimal {sign.word}"
    parts = re.split(r"[\s|]+", text)
    if len(parts) > 1 and all(map(is_numeric, parts)):
        return (
            f"{given} is several numbers; separate columns by comma, semicolon or tab, "
            "and write thousands without spaces"
        )
    return f"{given} is not a number; put {COMMENT} before lines that are neither heading nor data"
