import numpy as np
import pytest

from tests.trimmer.signals.reading import message_for
from trimmer.signals import MissingValues, read_signal


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


def test_too_many_missing_values_are_not_interpolated(file) -> None:
    rows = ["1", "", "2", *(8 * ["3"])]
    read_signal(file("\n".join(rows[:2] + rows[3:])), sample_rate=1, missing=MissingValues.INTERPOLATE)
    rows[9] = ""
    error = message_for(file("\n".join(rows)), sample_rate=1, missing=MissingValues.INTERPOLATE)
    assert (
        error
        == ", line 2: the first of 2 missing values, more than 10 % of the samples, too many to interpolate"
    )


def test_a_column_without_any_value_is_reported(file) -> None:
    error = message_for(file("a,b\n1,\n2,\n"), sample_rate=1, column="b")
    assert error == ": every value of the column is missing"


def test_values_cut_at_the_beginning_move_the_start(file) -> None:
    path = file("t,y\n1.0,nan\n1.5,2\n2.0,3\n")
    signal = read_signal(path, missing=MissingValues.INTERPOLATE)
    assert (signal.start, signal.sample_rate, signal.values.tolist()) == (1.5, 2.0, [2.0, 3.0])
