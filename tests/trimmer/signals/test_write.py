from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from trimmer.files import FileWriteError
from trimmer.signals import Signal, SignalError, read_signal, write_signal

VALUES = arrays(np.float64, st.integers(2, 40), elements=st.floats(-1e300, 1e300))


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One file for all examples: each writes it anew."""
    return tmp_path_factory.mktemp("written") / "signal.csv"


@given(VALUES, st.integers(1, 10**15 - 1), st.integers(-12, 6))
def test_values_and_rate_come_back_to_the_last_bit(path: Path, values, digits: int, exponent: int) -> None:
    """For any values, and any sample rate of up to 15 digits."""
    signal = Signal(values, float(f"{digits}e{exponent}"), "q2-q4", "m")
    write_signal(path, signal)
    back = read_signal(path)
    np.testing.assert_array_equal(back.values, signal.values)
    assert back.sample_rate == signal.sample_rate
    assert (back.name, back.unit, back.start) == ("q2-q4", "m", 0.0)


@given(VALUES, st.floats(1e-3, 1e9), st.floats(-1.0, 1.0))
def test_any_rate_and_start_come_back_nearly(path: Path, values, rate: float, start: float) -> None:
    signal = Signal(values, rate, start=start)
    write_signal(path, signal)
    back = read_signal(path)
    assert back.start == start
    rounding = 4.0 * np.spacing(np.abs(signal.times).max()) * rate / (values.size - 1)
    assert back.sample_rate == pytest.approx(rate, rel=rounding + 1e-15)


def test_several_signals_share_the_times(path: Path) -> None:
    first, second = Signal([1.0, 2.0], 4.0, "pin", "m"), Signal([3.0, 4.0], 4.0, 'a "b", c')
    write_signal(path, first, second)
    assert path.read_bytes() == b'time [s],pin [m],"a ""b"", c"\n0.0,1.0,3.0\n0.25,2.0,4.0\n'
    assert read_signal(path, column='a "b", c').values.tolist() == [3.0, 4.0]


@pytest.mark.parametrize(
    ("others", "message"),
    [
        ([Signal(np.zeros(2), 2.0, "b")], "same number of samples, sample rate and start"),
        ([Signal(np.zeros(3), 1.0, "b")], "same number of samples"),
        ([Signal(np.zeros(2), 1.0, "b", start=1.0)], "same number of samples"),
        ([Signal(np.zeros(2), 1.0, "A")], "two signals are named 'a'"),
        ([Signal(np.zeros(2), 1.0, "Time")], "cannot be named 'Time' in a file"),
    ],
)
def test_signals_that_do_not_fit_into_one_file_are_refused(path: Path, others, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        write_signal(path, Signal(np.zeros(2), 1.0, "a"), *others)


def test_times_that_rounding_would_make_equal_are_refused(path: Path) -> None:
    with pytest.raises(SignalError, match=r"samples at 1e\+06 Hz cannot be told apart at 1e\+09 s"):
        write_signal(path, Signal(np.zeros(3), 1e6, start=1e9))


def test_a_file_that_cannot_be_written_leaves_the_old_one(tmp_path: Path) -> None:
    with pytest.raises(FileWriteError):
        write_signal(tmp_path, Signal(np.zeros(2), 1.0))
    assert list(tmp_path.iterdir()) == []
