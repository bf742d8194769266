from __future__ import annotations

import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from trimmer.signals.signal import Signal, SignalError, split_heading


def test_times_and_duration_count_from_the_start() -> None:
    signal = Signal(np.arange(4.0), 8.0, start=-0.5)
    assert signal.times.tolist() == [-0.5, -0.375, -0.25, -0.125]
    assert signal.duration == 0.5


def test_values_are_a_copy_that_cannot_be_changed() -> None:
    given_values = np.zeros(3)
    signal = Signal(given_values, 1.0)
    given_values[0] = 1.0
    assert signal.values[0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        signal.values[0] = 1.0


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ([], "at least one"),
        ([[1.0, 2.0]], "one dimension"),
        (["1", "2"], "real numbers"),
        ([1j], "real numbers"),
        ([True], "real numbers"),
        ([[1.0], [1.0, 2.0]], "one dimension"),
        ([0.0, np.nan, 1.0, np.inf], r"2 of 4 samples are not finite, the first is sample 2 \(nan\)"),
        ([1e301], "above 1e\\+300 cannot be computed with"),
    ],
)
def test_values_that_are_no_signal_are_refused(values, message: str) -> None:
    with pytest.raises(SignalError, match=message):
        Signal(values, 1.0)


@pytest.mark.parametrize("rate", [0.0, -1.0, np.nan, np.inf, True])
def test_a_sample_rate_must_be_positive_and_finite(rate) -> None:
    with pytest.raises(SignalError, match="sample rate must be a positive number of hertz"):
        Signal(np.zeros(2), rate)


def test_a_start_must_be_finite() -> None:
    with pytest.raises(SignalError, match="start is nan"):
        Signal(np.zeros(2), 1.0, start=np.nan)


@pytest.mark.parametrize(
    ("heading", "name", "unit"),
    [
        ("q2-q4", "q2-q4", ""),
        ("q2-q4 [m]", "q2-q4", "m"),
        ("q2-q4(m)", "q2-q4", "m"),
        ("  Zeit \n  (ms) ", "Zeit", "ms"),
        ("f(x) [m/s]", "f(x)", "m/s"),
        ("x []", "x", ""),
        ("[m]", "[m]", ""),
        ("a [m] b", "a [m] b", ""),
        ("a\x93b", "a\N{REPLACEMENT CHARACTER}b", ""),
        ("", "", ""),
    ],
)
def test_a_heading_is_a_name_and_a_unit(heading: str, name: str, unit: str) -> None:
    assert split_heading(heading) == (name, unit)


@given(st.text())
def test_any_heading_gives_a_name_that_a_signal_can_have(heading: str) -> None:
    name, unit = split_heading(heading)
    if name:
        signal = Signal(np.zeros(1), 1.0, name, unit)
        assert split_heading(signal.heading) == (name, unit)


@pytest.mark.parametrize(
    ("name", "unit"),
    [("", "m"), ("a\nb", ""), (" a", ""), ("a [m]", ""), ("a", "m]"), ("a", " "), ("\x00", "")],
)
def test_a_name_that_would_not_read_back_is_refused(name: str, unit: str) -> None:
    with pytest.raises(SignalError, match="cannot have the name"):
        Signal(np.zeros(1), 1.0, name, unit)


def test_a_signal_that_was_pickled_is_the_same_and_cannot_be_changed_either() -> None:
    signal = Signal([1.0, -2.0, 3.0], 50.0, "stroke", "m", start=0.25, notes=("a note",), converted=2)
    back = pickle.loads(pickle.dumps(signal))
    assert back.values.tolist() == [1.0, -2.0, 3.0]
    assert not back.values.flags.writeable
    for name in ("sample_rate", "name", "unit", "start", "notes", "converted", "full_scale", "trusted"):
        assert getattr(back, name) == getattr(signal, name)
