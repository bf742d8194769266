"""Lines, cells and headings of a CSV file, piece by piece, from lines written by hand."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from trimmer.signals import csv_table
from trimmer.signals.cells import is_missing, is_numeric, is_text, numbers_in, shown
from trimmer.signals.csv_layout import CsvLayout, DecimalSign, Delimiter, delimiter_of, ends_with_delimiter
from trimmer.signals.csv_table import NumberedLines, read_table
from trimmer.signals.text_file import SignalFileError

ANY = CsvLayout()
POINT, COMMA = DecimalSign.POINT, DecimalSign.COMMA


def lines(
    *texts: str, delimiter: Delimiter | None = Delimiter.SEMICOLON, closing: bool = False
) -> NumberedLines:
    return NumberedLines(Path("a.csv"), range(11, 11 + len(texts)), texts, delimiter, closing)


def test_lines_are_split_at_the_delimiter_and_a_closing_one_makes_no_cell() -> None:
    assert lines("1;2", "1,2").cells(0) == ["1", "2"]
    assert lines("1;2", "1,2").cells(1) == ["1,2"]
    assert lines("1;2", delimiter=None).cells(0) == ["1;2"]
    assert lines('1;"2;3"').cells(0) == ["1", "2;3"]
    assert lines('1,"2,3"', delimiter=None).cells(0) == ["1", "2,3"]
    closed = lines("1;2;", "1;", "", ";", "1;2; ", "1;2", '"1";', closing=True)
    assert [closed.cells(place) for place in range(7)] == [
        ["1", "2"],
        ["1"],
        [""],
        [""],
        ["1", "2"],
        ["1", "2"],
        ["1"],
    ]
    assert lines("1;").cells(0) == ["1", ""]
    with pytest.raises(SignalFileError, match=r"^a\.csv, line 12: quotation marks"):
        lines("1", '1;"2').cells(1)
    part = closed[1:3]
    assert (len(part), list(part.numbers), part.closing, part.delimiter) == (
        2,
        [12, 13],
        True,
        closed.delimiter,
    )


def test_comments_and_empty_lines_keep_the_numbers_of_the_others(file) -> None:
    table = read_table(file("# made\n\na;b\n1;2\n# between\n\n3;4\n\n\n"), ANY)
    assert (table.headings, table.width, list(table.lines)) == (("a", "b"), 2, [4, 6, 7])
    assert [table.column(place) for place in (0, 1)] == [["1", "", "3"], ["2", "", "4"]]
    plain = read_table(file("\na;b\n1;2\n3;4\n\n"), ANY)
    assert list(plain.lines) == [3, 4]
    with pytest.raises(
        SignalFileError, match=r"csv, line 4: 1 cell separated by semicolon, where line 2 has 2: '3'"
    ):
        read_table(file("#\n1;2\n#\n3\n"), ANY).column(0)
    with pytest.raises(
        SignalFileError, match=r"line 2: 3 cells separated by comma, where line 1 has 2: '3,4,5'"
    ):
        read_table(file("1,2\n3,4,5\n"), ANY).column(1)
    with pytest.raises(SignalFileError, match=r"line 3: 2 cells without a delimiter, where line 1 has 1"):
        read_table(file('1\n2\n"a","b"\n'), ANY).column(0)


@pytest.mark.parametrize(
    ("texts", "data"),
    [
        (("serial;1234", "Time;Way", "0;1"), 2),
        (("serial;1234", "rate;50", "", "Time;Way", "0;1", "1;2"), 4),
        (("serial;1234", "Time;", "0;1"), 2),
        (("serial;1234", "Time;Way", "", "0;1"), 3),
        (("serial;1234", "Time;Way", "late;1"), None),  # no more numbers than before
        (("serial;1234", "", "0;1"), None),  # a blank line is no heading
        (("serial;1234", "state;5", "0;1"), None),  # nor is one with a number
        (("serial;1234;x", "state;5;6", "0;1;2"), None),
        (("serial;1234", "Time;Way"), None),
        (("1;2", "Time;Way", "0;1;2"), None),  # no text beside the number
        (("serial;1234", *(98 * [""]), "Time;Way", "0;1"), 100),
        (("serial;1234", *(99 * [""]), "Time;Way", "0;1"), None),
    ],
)
def test_data_below_a_heading_below_a_number(texts: tuple[str, ...], data: int | None) -> None:
    assert csv_table._after_heading(lines(*texts), 0) == data
    before = lines("title;x", *texts)
    assert csv_table._after_heading(before, 1) == (None if data is None else data + 1)


@pytest.mark.parametrize(
    ("texts", "names"),
    [
        ((), ()),
        (("", "  "), ()),
        (("a;b", ""), ("a", "b")),
        (("title", "a;  b  c "), ("a", "b c")),
        (("x;y", "m;s"), ("x [m]", "y [s]")),
        (("x;y", "", "m;(s)"), ("x [m]", "y (s)")),
        (("m;s", "x;y"), ("x", "y")),
        (("m;s",), ("m", "s")),
        (("title", "m;s"), ("m", "s")),
    ],
)
def test_headings_are_the_last_line_and_units_below_names(
    texts: tuple[str, ...], names: tuple[str, ...]
) -> None:
    assert csv_table._headings(lines(*texts), 2) == names


def test_a_heading_of_another_width_is_named_with_its_line() -> None:
    with pytest.raises(SignalFileError, match=r"^a\.csv, line 12: 3 cells in the heading, but 2 in the data"):
        csv_table._headings(lines("a;b", "a;b;c", ""), 2)


def test_missing_values_before_the_first_number_are_data(file) -> None:
    table = read_table(file("a;b\n;\n-;nan\n;\n1;2\n"), ANY)
    assert (table.headings, list(table.lines)) == (("-", "nan"), [5])
    table = read_table(file("a;b\nnan;-\n-;nan\n1;2\n"), ANY)
    assert (table.headings, list(table.lines)) == (("a", "b"), [2, 3, 4])
    assert list(read_table(file("a;b\nnan;\n1;2\n"), ANY).lines) == [2, 3]
    table = read_table(file("nan;-\n1;2\n"), ANY)
    assert (table.headings, list(table.lines)) == ((), [1, 2])
    table = read_table(file("a;nan\n1;2\n"), ANY)
    assert (table.headings, list(table.lines)) == (("a", "nan"), [2])


@pytest.mark.parametrize(
    ("texts", "layout", "delimiter"),
    [
        (["1\t2;3,4"], ANY, Delimiter.TAB),
        (["1,5;2,5"], ANY, Delimiter.SEMICOLON),
        (["a;b", "1,2"], ANY, Delimiter.COMMA),
        (["1,2"], CsvLayout(decimal=COMMA), None),
        (["1,2"], CsvLayout(decimal=POINT), Delimiter.COMMA),
        (["1;2"], CsvLayout(Delimiter.COMMA), Delimiter.COMMA),
        (["a;b", "", "# c\td"], ANY, Delimiter.SEMICOLON),
        (["1.5"], ANY, None),
        (["\t1\t"], ANY, None),
        ([*(100 * ["1"]), "1;2"], ANY, None),
        ([*(99 * ["1"]), "1;2"], ANY, Delimiter.SEMICOLON),
    ],
)
def test_the_delimiter_is_found_in_lines_of_numbers(texts, layout, delimiter) -> None:
    assert delimiter_of(texts, layout) is delimiter


@pytest.mark.parametrize(
    ("texts", "closing"),
    [
        (["a;b;", "1;2;", "3;4; "], True),
        (["a;b", "1;2;"], True),
        (["1;2;", "3;4"], False),
        (["a;b;c", "1;2;", "3;4;"], False),  # the last column has a name
        (["a;b;c;d", "1;2;"], True),
        (["a;b", "1;2"], False),
        (["1;;", "2;3;"], True),
        (["1;2;;", "2;3;"], True),
    ],
)
def test_a_delimiter_at_the_end_of_each_line_of_numbers(texts: list[str], closing: bool) -> None:
    assert ends_with_delimiter(texts, Delimiter.SEMICOLON) is closing
    assert ends_with_delimiter(texts, None) is False


def test_kinds_of_cells() -> None:
    kinds = {
        "1": "n",
        " -.5e3 ": "n",
        "+,5": "n",
        "1 000": "n",
        "1'000": "n",
        "1|2": "n",
        "": "m",
        " N/A": "m",
    }
    kinds |= {
        "-": "m",
        "?": "m",
        "None": "m",
        "inf": "i",
        " -INFINITY ": "i",
        "∞": "i",
        "a": "t",
        "e5": "t",
        "1a": "t",
    }
    for cell, kind in kinds.items():
        assert (is_numeric(cell), is_missing(cell), is_text(cell)) == (kind == "n", kind == "m", kind == "t")


def test_long_cells_are_shortened_in_messages() -> None:
    assert (shown("a" * 38), shown("a" * 39)) == (f"'{38 * 'a'}'", f"'{36 * 'a'}...")
    assert len(shown("a" * 100)) == 40


@pytest.mark.parametrize(
    ("cells", "decimal", "numbers"),
    [
        (["1.5", " -2e3 "], None, [1.5, -2000.0]),
        (["1,5", "-2"], None, [1.5, -2.0]),
        (["1,5", "-2"], COMMA, [1.5, -2.0]),
        (["1,5", "", "nan"], None, [1.5, math.nan, math.nan]),
        (["1.5", "?"], POINT, [1.5, math.nan]),
        (["n/a", "NA"], None, [math.nan, math.nan]),
        (["5"], None, [5.0]),
    ],
)
def test_columns_of_numbers(cells, decimal, numbers) -> None:
    np.testing.assert_array_equal(numbers_in(cells, [3, 7, 9][: len(cells)], decimal, "f"), numbers)


@pytest.mark.parametrize(
    ("cells", "decimal", "message"),
    [
        (["1.5", "2,5"], None, "f, line 7: decimals have a point in line 3 and a comma in line 7"),
        (["1,5", "2.5", "3.5"], None, "f, line 7: decimals have a point in line 7 and a comma in line 3"),
        (["1", "1.000,5"], None, "f, line 7: '1.000,5' has a point and a comma"),
        (["1,5", "2"], POINT, "f, line 3: '1,5' is no number with a decimal point"),
        (["1", "2.5"], COMMA, "f, line 7: '2.5' is no number with a decimal comma"),
        (["1", "2", "1 2"], None, "f, line 9: '1 2' is several numbers"),
        (["1", "a b"], None, "f, line 7: 'a b' is not a number; put # before"),
        (["1", "12 a"], None, "f, line 7: '12 a' is not a number"),
        (["1", "-inf"], None, "f, line 7: '-inf' is not finite"),
        (["1", " inf "], None, "f, line 7: ' inf ' is not finite"),
        (["1", " 1 2 "], None, "f, line 7: ' 1 2 ' is several numbers"),
        (["1", " a "], None, "f, line 7: ' a ' is not a number"),
        (["1", " 2.5 "], COMMA, "f, line 7: ' 2.5 ' is no number with a decimal comma"),
        (["", "1e999"], None, "f, line 7: '1e999' is too large"),
        (["1", "1e999"], None, "f, line 7: '1e999' is too large"),
    ],
)
def test_cells_that_are_no_numbers_are_named_with_their_line(cells, decimal, message: str) -> None:
    with pytest.raises(SignalFileError) as raised:
        numbers_in(cells, [3, 7, 9][: len(cells)], decimal, "f")
    assert str(raised.value).startswith(message)
