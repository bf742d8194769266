"""A CSV file as headings and columns of cells, each cell with its line."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from trimmer.messages import shown_value
from trimmer.showing.shown import counted
from trimmer.signals.cells import is_numeric, is_text
from trimmer.signals.csv_layout import (
    COMMENT,
    CsvLayout,
    Delimiter,
    delimiter_of,
    ends_with_delimiter,
    is_comment,
)
from trimmer.signals.quantity import in_brackets, is_unit
from trimmer.signals.text_file import SignalFileError, read_lines

_LONGEST_PREAMBLE = 100


@dataclass(frozen=True)
class NumberedLines:
    """Lines of a file, which are split into cells when a column is read.

    A file of a million lines held as cells takes far longer.
    """

    path: Path  # The file
    numbers: Sequence[int]  # Number of each line, from 1
    texts: Sequence[str]  # The lines
    delimiter: Delimiter | None  # Sign between cells; None if a line is one cell
    closing: bool  # Whether the delimiter ends each line too, which makes no further cell

    def __getitem__(self, places: slice) -> NumberedLines:
        """Return the lines of a slice."""
        return replace(self, numbers=self.numbers[places], texts=self.texts[places])

    def __len__(self) -> int:
        return len(self.texts)

    def cells(self, place: int) -> list[str]:
        """Split a line into cells; ``place`` counts from 0."""
        text = self.texts[place]
        if '"' in text:
            cells = self._quoted(place)
        else:
            cells = text.split(self.delimiter.value) if self.delimiter else [text]
        if self.closing and len(cells) > 1 and not cells[-1].strip():
            cells.pop()
        return cells

    def _quoted(self, place: int) -> list[str]:
        delimiter = self.delimiter or Delimiter.COMMA
        try:
            return next(csv.reader([self.texts[place]], delimiter=delimiter.value, strict=True))
        except csv.Error as error:
            raise SignalFileError(
                f"{self.path}, line {self.numbers[place]}: quotation marks are not in pairs around cells "
                f"({error})"
            ) from error


@dataclass(frozen=True)
class CsvTable:
    """A CSV file as headings and lines of cells."""

    path: Path  # The file
    # Heading of each column, empty text for one without; the tuple is empty if the file has no heading
    headings: tuple[str, ...]
    width: int  # Number of columns
    data: NumberedLines  # Lines of data, at least one

    @property
    def lines(self) -> Sequence[int]:
        """Number of each line of data."""
        return self.data.numbers

    def column(self, index: int) -> list[str]:
        """Return the cells of a column; ``index`` counts from 0. An empty line is a row of empty cells."""
        column = []
        for place in range(len(self.data)):
            cells = self.data.cells(place)
            if len(cells) != self.width:
                cells = self._empty(place, cells)
            column.append(cells[index])
        return column

    def _empty(self, place: int, cells: Sequence[str]) -> list[str]:
        if not self.data.texts[place].strip():
            return [""] * self.width
        delimiter = self.data.delimiter
        separated = f"separated by {delimiter.word}" if delimiter else "without a delimiter"
        raise SignalFileError(
            f"{self.path}, line {self.lines[place]}: {counted(len(cells), 'cell')} {separated}, where line "
            f"{self.lines[0]} has {self.width}: {shown_value(self.data.texts[place])}"
        )


def read_table(path: Path, layout: CsvLayout) -> CsvTable:
    """Read a CSV file.

    Lines that begin with ``#`` are skipped, and so are empty lines before the data and after them.
    Elsewhere an empty line is a row of missing values. The heading is the last line before the first that
    holds a number; or the last two, if the last holds units alone. Other lines may come before it, with a
    number beside a text, as of a device's serial number.
    """
    lines = _numbered(path, layout)
    begin = _first_number(lines, 0)
    while begin is not None and (later := _after_heading(lines, begin)) is not None:
        begin = later
    if begin is None:
        raise SignalFileError(f"{path}: holds no number; a column of samples is needed")
    width = len(lines.cells(begin))
    while begin > 0 and _is_all_missing(lines.cells(begin - 1)):
        begin -= 1
    return CsvTable(path, _headings(lines[:begin], width), width, lines[begin:])


def _first_number(lines: NumberedLines, begin: int) -> int | None:
    places = range(begin, len(lines))
    return next((place for place in places if any(map(is_numeric, lines.cells(place)))), None)


def _after_heading(lines: NumberedLines, begin: int) -> int | None:
    """Find the data below a heading, if a line with a number is one before it, such as ``serial;1234``.

    It is if it holds a text too, and fewer numbers than the first line with numbers below a line of texts.
    """
    if not any(map(is_text, lines.cells(begin))):
        return None
    for place in range(begin, min(begin + _LONGEST_PREAMBLE, len(lines))):
        cells = lines.cells(place)
        if not any(map(is_numeric, cells)) and any(map(is_text, cells)):
            data = _first_number(lines, place)
            if data is not None and _numbers(lines, data) > _numbers(lines, begin):
                return data
    return None


def _numbers(lines: NumberedLines, place: int) -> int:
    return sum(map(is_numeric, lines.cells(place)))


def _numbered(path: Path, layout: CsvLayout) -> NumberedLines:
    numbers: Sequence[int]
    texts = read_lines(path)
    numbers = range(1, len(texts) + 1)
    if any(map(is_comment, texts)):
        numbers = [number for number, text in zip(numbers, texts, strict=True) if not is_comment(text)]
        texts = [text for text in texts if not is_comment(text)]
    while texts and not texts[-1].strip():
        texts.pop()
    delimiter = delimiter_of(texts, layout)
    closing = ends_with_delimiter(texts, delimiter)
    return NumberedLines(path, numbers[: len(texts)], texts, delimiter, closing)


def _is_all_missing(cells: Sequence[str]) -> bool:
    """Return whether a line before the first number is data: signs for missing values, not blank."""
    return any(cell.strip() for cell in cells) and not any(map(is_text, cells))


def _headings(lines: NumberedLines, width: int) -> tuple[str, ...]:
    filled = [place for place in range(len(lines)) if lines.texts[place].strip()]
    if not filled:
        return ()
    last = lines.cells(filled[-1])
    if len(last) != width:
        raise SignalFileError(
            f"{lines.path}, line {lines.numbers[filled[-1]]}: {counted(len(last), 'cell')} in the heading, "
            f"but {width} in the data after it; put {COMMENT} before it if it is no heading, or say what the "
            "delimiter and the decimal sign are"
        )
    names, before = last, lines.cells(filled[-2]) if len(filled) > 1 else []
    if all(map(is_unit, last)) and len(before) == width:
        names = [f"{name} {in_brackets(unit)}" for name, unit in zip(before, last, strict=True)]
    return tuple(" ".join(name.split()) for name in names)
