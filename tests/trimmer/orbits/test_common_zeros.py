"""Newton's method for the common zeros of two functions of two durations, with functions that are given."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.orbits import unequal_switches
from trimmer.orbits.unequal_switches import _solved

EQUATION = SimpleNamespace(tangents=lambda durations: durations)
STARTS = np.array([[0.0, 0.0]])


def solved(monkeypatch: pytest.MonkeyPatch, functions, starts=STARTS) -> list:
    """Logarithms at zeros of functions of logarithms."""

    def switching(equation, long, short):
        return np.stack(functions(np.log(long), np.log(short)), axis=-1)

    monkeypatch.setattr(unequal_switches, "_switching", switching)
    return _solved(EQUATION, np.asarray(starts)).tolist()


def test_a_common_zero_is_found_from_each_start(monkeypatch: pytest.MonkeyPatch) -> None:
    def functions(u, v):
        return np.sin(u - 0.5) + 0.2 * (v + 0.2), np.exp(v + 0.2) - 1.0 + 0.1 * (u - 0.5)

    starts = [[0.0, 0.0], [0.9, -0.6], [0.5, -0.2]]
    assert solved(monkeypatch, functions, starts) == [pytest.approx([0.5, -0.2], abs=1e-9)] * 3


@pytest.mark.parametrize("zero", [(0.5, -0.2), (-0.2, 0.5), (0.6, 0.6 - 2e-4), (0.9, -0.95)])
def test_either_duration_may_be_the_longer_one(monkeypatch: pytest.MonkeyPatch, zero: tuple) -> None:
    found = solved(monkeypatch, lambda u, v: (u - zero[0], v - zero[1]))
    assert found == [pytest.approx(zero, abs=1e-9)]


@pytest.mark.parametrize("zero", [(0.6, 0.6 - 5e-5), (0.6, 0.6), (1.1, 0.5), (0.5, -1.1)])
def test_equal_durations_and_far_ones_are_left_out(monkeypatch: pytest.MonkeyPatch, zero: tuple) -> None:
    assert solved(monkeypatch, lambda u, v: (u - zero[0], v - zero[1])) == []


def test_a_zero_of_one_function_alone_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    assert solved(monkeypatch, lambda u, v: (u - 0.5, v * v + 0.1)) == []
    assert solved(monkeypatch, lambda u, v: (u * u + 0.1, v - 0.5)) == []
    assert solved(monkeypatch, lambda u, v: (u - 0.5, np.full_like(v, np.nan))) == []


def test_slopes_that_are_singular_leave_the_values_as_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both functions depend on the sum alone, which is zero at the start."""
    start = [[0.3, -0.3]]
    assert solved(monkeypatch, lambda u, v: (u + v, u + v), start) == [pytest.approx([0.3, -0.3])]
    # No step is longer than 0.3: eight of them lead no farther than the farthest.
    assert solved(monkeypatch, lambda u, v: (u + v - 9.0, u + v - 9.0), start) == []
