"""Which column of a file is read, and what is done where values are missing."""

import numpy as np
import pytest

from tests.trimmer.signals.reading import message_for
from trimmer.signals import MissingValues, read_signal

THREE = "time [s],pin [m],pin,q2-q4 [m]\n0.0,1,2,3\n0.1,1,2,4\n"


@pytest.mark.parametrize("choice", [4, "4", "q2-q4", "q2-q4 [m]", "Q2-Q4", " q2-q4 "])
def test_a_column_is_chosen_by_name_or_number(file, choice) -> None:
    signal = read_signal(file(THREE), column=choice)
    assert signal.values.tolist() == [3.0, 4.0]
    assert (signal.name, signal.unit) == ("q2-q4", "m")


def test_a_name_of_digits_comes_before_a_number(file) -> None:
    path = file("time,b,2 [m]\n0,7,8\n1,7,9\n")
    assert read_signal(path, column="2").values.tolist() == [8.0, 9.0]
    assert read_signal(path, column=2).values.tolist() == [7.0, 7.0]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, ": there are 4 columns: 1 'time [s]', 2 'pin [m]', 3 'pin', 4 'q2-q4 [m]'; choose one by name"),
        ({"column": "q2-q3"}, ": no column is named 'q2-q3'; did you mean 'q2-q4'?"),
        ({"column": "velocity"}, ": no column is named 'velocity'; there are 4 columns: 1 'time [s]'"),
        ({"column": "pin"}, ": columns 2 and 3 are named 'pin'; choose by number"),
        ({"column": 5}, ": there is no column 5; there are 4 columns"),
        ({"column": "0"}, ": there is no column 0; there are 4 columns"),
        ({"column": -1}, ": there is no column -1"),
        ({"column": ""}, ": no column is named ''"),
        ({"column": 1, "time_column": 1}, ": the signal and the time stamps cannot both be 1 'time [s]'"),
        ({"column": "time"}, ": the signal and the time stamps cannot both be 1 'time [s]'"),
        ({"column": 4, "time_column": "clock"}, ": no column is named 'clock'"),
    ],
)
def test_a_column_that_is_not_there_is_reported_with_those_that_are(file, options, message: str) -> None:
    assert message_for(file(THREE), **options).startswith(message)


def test_several_columns_of_time_stamps_are_reported(file) -> None:
    path = file("t,time,y\n0,0,1\n1,1,2\n")
    assert message_for(path) == ": 1 't' and 2 'time' may both be time stamps; choose one (--time)"
    assert read_signal(path, time_column="t", column="y").values.tolist() == [1.0, 2.0]


def test_the_only_column_is_named(file) -> None:
    told = message_for(file("y\n1\n2\n"), column=5, sample_rate=1)
    assert told == ": there is no column 5; the only one is 1 'y'"
    told = message_for(file("1\n2\n"), column=2, sample_rate=1)
    assert told == ": there is no column 2; the only one is column 1"
    told = message_for(file("1;2\n2;3\n"), sample_rate=1)
    assert told.startswith(": there are 2 columns: column 1, column 2; choose one")


def test_time_stamps_alone_are_reported(file) -> None:
    assert "holds time stamps alone" in message_for(file("t\n0\n1\n"))


@pytest.mark.parametrize("marker", ["", " ", "nan", "NaN", "N/A", "-", "null"])
def test_missing_values_are_refused_or_interpolated(file, marker: str) -> None:
    rows = [f"{k}.0" for k in range(30)]
    rows[0] = rows[7] = rows[8] = rows[29] = marker
    path = file("\n".join(["y", *rows, ""]))
    assert message_for(path, sample_rate=1).startswith(", line ")
    signal = read_signal(path, sample_rate=1, missing=MissingValues.INTERPOLATE)
    assert (signal.name, signal.interpolated) == ("y", 2)
    assert signal.values == pytest.approx(np.arange(1.0, 29.0), rel=1e-15)


def test_the_first_missing_value_and_their_number_are_reported(file) -> None:
    error = message_for(file("t,y\n0,1\n1,\n2,nan\n\n4,5\n"))
    assert error.startswith(", line 3: the first of 3 missing values; remove lines")
    assert "--missing interpolate" in error
    assert message_for(file("y\n1\n\n2\n"), sample_rate=1).startswith(", line 3: a value is missing")


def test_a_column_without_any_value_is_reported(file) -> None:
    error = message_for(file("a,b\n1,\n2,\n"), sample_rate=1, column="b")
    assert error == ": every value of the column is missing"


def test_values_cut_at_the_beginning_move_the_start(file) -> None:
    path = file("t,y\n1.0,nan\n1.5,2\n2.0,3\n")
    signal = read_signal(path, missing=MissingValues.INTERPOLATE)
    assert (signal.start, signal.sample_rate, signal.values.tolist()) == (1.5, 2.0, [2.0, 3.0])
