"""Layout of a CSV file: delimiter and decimal sign, given or found out."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice

from trimmer.choices import Choice


class Delimiter(Choice):
    """What stands between two columns."""

    COMMA = ","
    SEMICOLON = ";"
    TAB = "\t"


class DecimalSign(Choice):
    """What stands before the decimals of a number."""

    POINT = "."
    COMMA = ","


@dataclass(frozen=True)
class CsvLayout:
    """What is known about the layout of a CSV file; None where its content decides.

    Either may also be given by its word, such as ``comma``.

    Attributes:
        delimiter: What stands between two columns. Found out: the first of tab, semicolon and comma that
            occurs in a line that begins with a number. Where decimals have a comma, a comma is no delimiter.
        decimal: What stands before decimals. Found out from the numbers of each column.

    Raises:
        ChoiceError: if one is given and is none of those there are.
    """

    delimiter: Delimiter | None = None
    decimal: DecimalSign | None = None

    def __post_init__(self) -> None:
        if self.delimiter is not None:
            object.__setattr__(self, "delimiter", Delimiter.chosen(self.delimiter, "delimiter"))
        if self.decimal is not None:
            object.__setattr__(self, "decimal", DecimalSign.chosen(self.decimal, "decimal"))


COMMENT = "#"
"""A line that begins with this sign is skipped."""

_SNIFFED_LINES = 100
_BEGINS_WITH_NUMBER = re.compile(r'\s*"?[+-]?[.,]?[0-9]')


def is_comment(line: str) -> bool:
    """Return whether a line is a comment: it begins with ``COMMENT``, spaces apart."""
    return COMMENT in line and line.lstrip().startswith(COMMENT)


def delimiter_of(lines: Sequence[str], layout: CsvLayout) -> Delimiter | None:
    """Find the sign between columns of lines without comments; None if there is one column only."""
    if layout.delimiter is not None:
        return layout.delimiter
    sample = _sample(lines)
    for delimiter in (Delimiter.TAB, Delimiter.SEMICOLON, Delimiter.COMMA):
        if delimiter.value == "," and layout.decimal is DecimalSign.COMMA:
            continue
        if any(delimiter.value in line.strip() for line in sample):
            return delimiter
    return None


def ends_with_delimiter(lines: Sequence[str], delimiter: Delimiter | None) -> bool:
    """Return whether the delimiter ends each line of numbers, instead of standing between columns only.

    A last column that is empty throughout looks alike, unless the heading has a name for it.
    """
    if delimiter is None:
        return False
    sign = delimiter.value
    numbers = [line.strip(" ") for line in _sample(lines)]
    most = max(line.count(sign) for line in numbers)
    return all(line.endswith(sign) for line in numbers) and not any(
        line.count(sign) == most and not line.strip(" ").endswith(sign) for line in _filled(lines)
    )


def _sample(lines: Sequence[str]) -> list[str]:
    """Take some lines with numbers, or whatever lines there are: headings may hold any sign."""
    numbers = list(islice(filter(_BEGINS_WITH_NUMBER.match, lines), _SNIFFED_LINES))
    return numbers or _filled(lines)


def _filled(lines: Sequence[str]) -> list[str]:
    """Take some lines from the beginning that are neither empty nor comments."""
    filled = (line for line in lines if line.strip() and not is_comment(line))
    return list(islice(filled, _SNIFFED_LINES))
