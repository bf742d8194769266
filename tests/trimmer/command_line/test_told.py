"""What commands tell in the same way of all results: tables, sums of motions, numbers, notes."""

from __future__ import annotations

from types import SimpleNamespace as Made

import numpy as np
import pytest

from trimmer.command_line import json_values, motion_summary
from trimmer.command_line.signals import fit_text, recording_text
from trimmer.command_line.table import table


def test_columns_are_as_wide_as_their_widest_cell() -> None:
    assert table(("a", "bcd"), [("long", "x"), ("", "y")]) == ["  a     bcd", "  long  x", "        y"]
    assert table(("a",), []) == ["  none"]


def test_numbers_that_json_lacks_are_null() -> None:
    assert [json_values.finite(value) for value in (2.0, np.inf, np.nan)] == [2.0, None, None]
    assert json_values.pair(2 - 3j) == (2.0, -3.0)


def test_a_motion_is_summed_up() -> None:
    lines = motion_summary.summary_lines(0.25, "done", [("b", "x"), ("a", "y"), ("b", "x")])
    assert lines[0] == "Motion of 0.25 s: done"
    assert lines[1:3] == ["  a: 1 x y", "  b: 2 x x"]
    assert len(motion_summary.summary_lines(0.25, "done", [])) == 3
    assert "no event" in motion_summary.summary_lines(0.25, "done", [])[1]
    times = motion_summary.last_times(0.5)
    assert (times.size, times[0], times[-1]) == (20_001, pytest.approx(0.45), 0.5)
    np.testing.assert_allclose(np.diff(times), 0.05 / 20_000)
    assert motion_summary.amplitudes({"a": np.array([1.0, -3.0, 0.0])}) == {"a": 2.0}


def test_ends_of_intervals_are_shares_of_the_number() -> None:
    def number(value: float, lower: float | None, upper: float | None) -> Made:
        return Made(value=value, lower=lower, upper=upper, lowest=1.0, highest=9.0)

    assert fit_text._percent(number(4.0, 3.0, 6.0)) == "-25 % to +50 %"
    assert fit_text._percent(number(-4.0, -6.0, -3.0)) == "-25 % to +50 %"
    assert fit_text._percent(number(0.0, -1.0, 1.0)) == ""
    assert fit_text._ends(number(4.0, 3.0, 6.0)) == ("3 to 6", "-25 % to +50 %")
    assert fit_text._ends(number(4.0, None, 6.0)) == ("open to 6", "")


def test_what_was_assumed_is_told_once() -> None:
    signal = Made(notes=("a", "b"), unit="")
    told = recording_text.notes_of(Made(full_scale_is_one=True), signal, ["b", "c"])
    assert told == ["a", "b", recording_text.NO_SCALE, "c"]
    signal.unit = "m"
    assert recording_text.notes_of(Made(full_scale_is_one=True), signal, []) == ["a", "b"]
    signal.unit = ""
    assert recording_text.notes_of(Made(full_scale_is_one=False), signal, []) == ["a", "b"]
    lines = recording_text.wrapped("word " * 60, "1 ", "22 ")
    assert lines[0].startswith("1 word") and lines[1].startswith("22 word")
    assert max(map(len, lines)) <= 110
    long = "x" * 120
    assert recording_text.wrapped(f"a {long}", "", "  ") == ["a", f"  {long}"]
    assert recording_text.wrapped("word " * 21 + "a-bcdefghijkl", "", "")[1] == "a-bcdefghijkl"
