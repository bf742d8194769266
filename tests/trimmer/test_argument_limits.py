"""Checks of arguments at their limits: the largest, the smallest, and what looks like a number."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from trimmer import arguments, messages
from trimmer.displacement import Body, Displacement
from trimmer.errors import WrongTypeError


def test_numbers_pass_as_floats() -> None:
    for value in (3, 3.0, np.float32(3.0), np.array(3.0), np.int64(3)):
        assert arguments.real_number("x", value) == 3.0
        assert type(arguments.real_number("x", value)) is float
    assert arguments.real_number("x", 10**400) == math.inf
    assert math.isnan(arguments.real_number("x", math.nan))
    for wrong in (True, np.True_, "3", 3j, np.array([3.0]), None):
        with pytest.raises(WrongTypeError, match=r"x must be a real number \(m\)"):
            arguments.real_number("x", wrong, "m")


def test_limits_of_numbers() -> None:
    assert arguments.finite_number("x", -2.5) == -2.5
    assert arguments.positive_number("x", 5e-324) == 5e-324
    for check in (arguments.finite_number, arguments.positive_number):
        assert (check("x", np.float32(0.5)), type(check("x", 3))) == (0.5, float)
    for check, wrongs in (
        (arguments.finite_number, (math.inf, -math.inf, math.nan)),
        (arguments.positive_number, (0.0, -1.0, math.inf, math.nan)),
    ):
        for wrong in wrongs:
            with pytest.raises(ValueError, match="x must be"):
                check("x", wrong)


def test_limits_of_whole_numbers() -> None:
    assert arguments.whole_number("n", np.int8(-3)) == -3
    assert type(arguments.whole_number("n", np.int8(3), 3)) is int
    assert arguments.whole_number("n", 2, 2) == 2
    assert arguments.whole_number("n", 2**62) == 2**62
    with pytest.raises(ValueError, match="at most"):
        arguments.whole_number("n", 2**62 + 1)
    with pytest.raises(ValueError, match="from 2 on"):
        arguments.whole_number("n", 1, 2)
    for wrong in (True, 2.0, "2", None):
        with pytest.raises(WrongTypeError, match="whole number"):
            arguments.whole_number("n", wrong)


def test_sequences_truth_and_paths() -> None:
    assert arguments.require_instances("x", iter([1, 2]), int, "a number") == (1, 2)
    with pytest.raises(WrongTypeError, match=r"x\[1\] must be a number"):
        arguments.require_instances("x", [1, "2"], int, "a number")
    for wrong in ("12", b"12", 3):
        with pytest.raises(WrongTypeError, match="sequence"):
            arguments.require_instances("x", wrong, int, "a number")
    assert arguments.truth_value("x", np.array(True)) is True
    assert arguments.truth_value("x", np.False_) is False
    for wrong in (1, "yes", np.array([True])):
        with pytest.raises(WrongTypeError):
            arguments.truth_value("x", wrong)
    assert arguments.file_path("x", "a") == arguments.file_path("x", Path("a")) == Path("a")
    with pytest.raises(WrongTypeError):
        arguments.file_path("x", 3)


def test_arrays_of_numbers() -> None:
    assert arguments.real_array("x", [1, 2]).tolist() == [1.0, 2.0]
    assert arguments.real_array("x", np.array([3], np.uint8)).dtype == float
    assert arguments.real_array("x", []).shape == (0,)
    assert arguments.real_values("x", [math.inf])[0] == math.inf
    with pytest.raises(ValueError, match="but holds -inf"):
        arguments.real_array("x", [1.0, -math.inf, math.nan])
    for wrong in ([True], ["1"], [1j], [[1, 2], [3]], None):
        with pytest.raises(WrongTypeError):
            arguments.real_array("x", wrong)


def test_values_stay_short() -> None:
    assert arguments.shown("x" * 198) == repr("x" * 198)
    assert arguments.shown("x" * 199) == repr("x" * 199)[:200] + " ..."
    assert arguments.shown(int) == "the class int; give an instance of it"
    assert messages.shown_value("x" * 38) == repr("x" * 38)
    assert messages.shown_value("x" * 39) == repr("x" * 39)[:37] + "..."
    assert "thousands" in messages.shown_value(10**5000)


def test_near_words() -> None:
    assert messages.near_words("long", ["longer words", "x"]) == ("longer words",)
    assert messages.near_words("long", ["longer words", "longest words"]) == ()
    assert messages.near_words("lo", ["longer words", "x"]) == ()
    assert messages.near_words("GAP", ["gap", "Gap", "gas"]) == ("gap", "Gap")
    assert messages.near_words("pag", ["gap", "pages"]) == ("gap",)
    assert messages.near_words("x" * 101, ["x" * 101]) == ()
    assert messages.near_words("x" * 100, ["x" * 100]) == ("x" * 100,)
    assert messages.near_words("--", ["++", "+-"]) == ()
    assert messages.listed(["a"]) == "a"
    assert messages.listed(["a", "b", "c"], "or") == "a, b or c"


def test_rows_of_displacements() -> None:
    assert [body.index for body in Body] == [0, 1, 2, 3]
    assert Displacement("q1").row == (1.0, 0.0, 0.0, 0.0)
    assert Displacement("q3", "q1").row == (-1.0, 0.0, 1.0, 0.0)
    assert Displacement("q4", "q3").label == "q4-q3"
    assert Displacement.parse("q4-q3") == Displacement(Body.GUARD, Body.HOUSING)
