"""Preambles, headings, units, delimiters and cells of files as loggers write them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.trimmer.signals.reading import message_for
from trimmer.signals import CsvLayout, DecimalSign, read_signal
from trimmer.signals.cells import numbers_in
from trimmer.signals.text_file import SignalFileError

FIRST = {"column": 1, "sample_rate": 1.0}


@pytest.mark.parametrize(
    ("content", "heading", "values"),
    [
        ("serial;1234\nTime;Way\n0;1\n1;2\n", "Way", [1.0, 2.0]),
        ("serial;1234\nrate;50\n\nTime;Way\n0;1\n1;2\n", "Way", [1.0, 2.0]),
        ("title;x\nserial;1234\nTime;Way\n\n0;1\n1;2\n", "Way", [1.0, 2.0]),
        ("serial;1234\n" + 98 * "\n" + "Time;Way\n0;1\n1;2\n", "Way", [1.0, 2.0]),
        ("title\nTime;  Way  of it \n0;1\n1;2\n", "Way of it", [1.0, 2.0]),
        ("Time;Way\n\ns;(mm)\n0;1\n1;2\n", "Way [mm]", [1.0, 2.0]),
        ("mm;s\nTime;Way\n0;1\n1;2\n", "Way", [1.0, 2.0]),
        ("title\nt;m\n0;1\n1;2\n", "m", [1.0, 2.0]),
        ("# made\n\nt;Way\n0;1\n# between\n1;2\n\n\n", "Way", [1.0, 2.0]),
        ('"t","Way"\n"0","1"\n1,"2"\n', "Way", [1.0, 2.0]),
        ("t\tWay;x\n0\t1,5\n1\t2,5\n", "Way;x", [1.5, 2.5]),
        ("t;Way;\n0;1;\n1;2; \n", "Way", [1.0, 2.0]),
        ("t;Way\n0;1;\n1;2;\n", "Way", [1.0, 2.0]),
        ('time,Way\n"0,0","1,5"\n"1,0",2\n', "Way", [1.5, 2.0]),
        ("Way, and time\nWay, t\n1.5, 0\n2, 1\n", "Way", [1.5, 2.0]),
    ],
)
def test_headings_and_data_are_told_apart(file, content: str, heading: str, values: list[float]) -> None:
    signal = read_signal(file(content))
    assert (signal.heading, signal.values.tolist(), signal.sample_rate) == (heading, values, 1.0)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("serial;1234\nTime;Way\nlate;1\n", ", line 1: 'serial' is not a number"),
        ("serial;1234\nstate;5\n0;1\n", ", line 1: 'serial' is not a number"),
        ("serial;1234\n" + 99 * "\n" + "Time;Way\n0;1\n", ", line 1: 'serial' is not a number"),
        ("1;2\nTime;Way\n0;1\n", ", line 2: 'Time' is not a number"),
        ("1234\nTime;Way\n0;1\n", ", line 2: 2 cells separated by semicolon, where line 1 has 1: 'Time;Way'"),
        ("a;b\na;b;c\n\n1;2\n", ", line 2: 3 cells in the heading, but 2 in the data"),
        ("#\n1;2\n#\n3\n", ", line 4: 1 cell separated by semicolon, where line 2 has 2: '3'"),
        ('1\n2\n"a","b"\n', ", line 3: 2 cells without a delimiter, where line 1 has 1"),
        ("a;b;c\n1;2;\n3;4\n", ", line 3: 2 cells separated by semicolon, where line 2 has 3"),
        ("1;\n2;3;\n", ", line 2: 2 cells separated by semicolon, where line 1 has 1: '2;3;'"),
        ('1\n1;"2\n', ", line 2: quotation marks are not in pairs"),
        ("\n\x7f\n", ", line 2: byte 0x7f does not occur"),
    ],
)
def test_what_is_no_table_is_told_with_its_line(file, content: str, message: str) -> None:
    assert message_for(file(content), **FIRST).startswith(message)


@pytest.mark.parametrize(
    ("content", "count"),
    [
        ("a;b\n-;nan\n1;2\n2;3\n", 2),
        ("a;b\nnan;-\n-;nan\n1;2\n2;3\n", 2),
        ("nan;-\n1;2\n2;3\n", 2),
        ("a;nan\n1;2\n2;3\n", 2),
    ],
)
def test_missing_values_before_the_first_number_are_data(file, content: str, count: int) -> None:
    signal = read_signal(file(content), missing="interpolate", **FIRST)
    assert signal.values.size == count


@pytest.mark.parametrize(
    ("rows", "interpolated", "values"),
    [
        (["", *map(str, range(10)), "10", "", "14", "nan"], 1, [*range(11), 12.0, 14.0]),
        (["1", *(7 * ["2"]), "?", "2"], 1, [1.0, *(9 * [2.0])]),
    ],
)
def test_a_tenth_of_missing_values_is_interpolated(file, rows, interpolated: int, values) -> None:
    path = file("y\n" + "\n".join(rows) + "\n")
    signal = read_signal(path, missing="interpolate", sample_rate=1.0)
    assert (signal.values.tolist(), signal.interpolated) == (values, interpolated)
    fewer = file("y\n" + "\n".join([*rows[:2], *rows[3:]]).replace("?", "") + "\n")
    if rows[0]:
        assert "more than 10 %" in message_for(fewer, missing="interpolate", sample_rate=1.0)


@pytest.mark.parametrize(
    ("cells", "decimal", "numbers"),
    [
        (["1.5", " -2e3 "], None, [1.5, -2000.0]),
        (["1,5", "-2"], None, [1.5, -2.0]),
        (["1,5", "+,5"], "comma", [1.5, 0.5]),
        (["5."], "point", [5.0]),
        (["1e300", "-9.999999999999999e299"], None, [1e300, -9.999999999999999e299]),
    ],
)
def test_cells_are_numbers_with_either_sign(file, cells, decimal, numbers) -> None:
    path = file("\n".join(f"{cell};0" for cell in cells))
    layout = CsvLayout("semicolon", decimal)
    assert read_signal(path, layout=layout, **FIRST).values.tolist() == numbers


@pytest.mark.parametrize(
    ("cells", "decimal", "message"),
    [
        (["1,5", "2.5", "3.5"], None, "line 2: decimals have a point in line 2 and a comma in line 1"),
        (["1", "1.000,5"], None, "line 2: '1.000,5' has a point and a comma"),
        (["1,5", "2"], "point", "line 1: '1,5' is no number with a decimal point"),
        (["1", " 2.5 "], "comma", "line 2: ' 2.5 ' is no number with a decimal comma"),
        (["1", " 1 2 "], None, "line 2: ' 1 2 ' is several numbers"),
        (["1", "1'000"], None, 'line 2: "1\'000" is not a number'),
        (["1", "12 a"], None, "line 2: '12 a' is not a number"),
        (["1", " inf "], None, "line 2: ' inf ' is not finite"),
        (["1", "∞"], None, "line 2: '∞' is not finite"),
        (["nan", "1e999"], None, "line 2: '1e999' is too large"),
        (["-1e301", "1e301"], None, "line 1: '-1e301' is too large"),
        (["1", "a" * 38], None, f"line 2: '{38 * 'a'}' is not"),
        (["1", "a" * 39], None, f"line 2: '{36 * 'a'}... is not"),
    ],
)
def test_cells_that_are_no_numbers_are_named(file, cells, decimal, message: str) -> None:
    path = file("\n".join(f"{cell};0" for cell in cells))
    assert message_for(path, layout=CsvLayout("semicolon", decimal), **FIRST).startswith(f", {message}")


@pytest.mark.parametrize(
    ("content", "hinted"),
    [
        ("1,-2\n+3,4\n", True),
        ("1,2\n3,4.5\n", False),
        (99 * "1,2\n" + "1.5,2\n", False),
        (100 * "1,2\n" + "1.5,2\n", True),
    ],
)
def test_a_comma_is_suspected_only_among_whole_numbers(file, content: str, hinted: bool) -> None:
    assert ("--decimal comma" in message_for(file(content), sample_rate=1.0)) is hinted


@pytest.mark.parametrize(
    ("unit", "step"),
    [
        ("", 1.0),
        ("s", 1.0),
        ("sec", 1.0),
        ("ms", 1e-3),
        ("us", 1e-6),
        ("µs", 1e-6),
        ("μs", 1e-6),
        ("ns", 1e-9),
    ],
)
def test_units_of_time(file, unit: str, step: float) -> None:
    path = file("\n".join([f"t [{unit}];y", *(f"{k};{k}" for k in range(9))]))
    assert read_signal(path).sample_rate == pytest.approx(1 / step, rel=1e-14)
    assert math.isclose(read_signal(path).times[-1], 8 * step)


def test_an_unknown_unit_of_time_is_reported(file) -> None:
    assert "time stamps in 'min' are not known; known units: s" in message_for(file("t [min],y\n0,1\n1,2\n"))


def test_without_rate_and_time_stamps_it_says_what_to_give(file) -> None:
    error = message_for(file("y\n1\n2\n"))
    assert error == ": no sample rate; give it (--rate), or name the column of time stamps (--time)"


def test_a_file_without_heading_can_have_its_time_stamps_numbered(file) -> None:
    signal = read_signal(file("0.0;1\n0.5;2\n"), time_column=1)
    assert (signal.sample_rate, signal.name, signal.values.tolist()) == (2.0, "column 2", [1.0, 2.0])


@given(
    st.lists(
        st.one_of(st.floats().map(repr), st.integers().map(str), st.text("0123456789.,+-eE _\t", max_size=6)),
        min_size=1,
    ),
    st.sampled_from([None, *DecimalSign]),
)
def test_reading_a_column_at_once_changes_nothing(cells: list[str], decimal) -> None:
    """The fast way through a clean column gives what the slow way gives cell by cell."""

    def outcome(column: list[str]) -> list[float] | str:
        try:
            return numbers_in(column, list(range(1, len(column) + 1)), decimal, "file").tolist()
        except SignalFileError as error:
            return str(error)

    together = outcome(cells)
    with_a_missing_value = outcome([*cells, "nan"])  # is not clean, so it takes the slow way
    if isinstance(together, list):
        assert isinstance(with_a_missing_value, list)
        np.testing.assert_array_equal(together, with_a_missing_value[:-1])
    else:
        assert together == with_a_missing_value
