"""The first event within a step, in plain Python, on tables made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.motion.hand_made_tables import COUNT, constant
from tests.trimmer.uncompiled import uncompile
from trimmer.motion import first_event as first_event_module
from trimmer.motion import kernel, sampling
from trimmer.motion.first_event import DEEPEST, NOWHERE, ROUNDING
from trimmer.motion.tables import Tables
from trimmer.motion.taylor import bernstein_from_taylor


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, kernel, first_event_module, sampling)


def first(tables: Tables, *known: int, at_start: bool = True, recent: int = -1, x: float = 0.0):
    work = kernel._work(tables)
    work.state[:] = x, 1.0
    work.known_zeros[:] = 0
    work.known_zeros[: len(known)] = known
    return (*first_event_module.first_event(tables, work, 0, at_start, recent), work.touch.tolist())


def test_the_first_event_and_what_touches_before_it() -> None:
    tables = constant((0.9, -1.0), (0.3, -1.0), (0.2, 1.0))
    fired, fraction, jumped, touch = first(tables)
    assert (fired, jumped, touch) == (1, False, [NOWHERE] * 3)
    assert fraction == pytest.approx(0.3, rel=1e-14)
    touching = constant((0.09 + 1e-16, -0.6, 1.0), (0.2, 1.0))
    fired, fraction, _, touch = first(touching)
    assert (fired, fraction) == (-1, NOWHERE)
    assert touch == [pytest.approx(0.3, abs=1e-3), NOWHERE]
    # Further away than rounding of the value: 64 * 2^-53 of 0.09.
    assert first(constant((0.09 + 2e-15, -0.6, 1.0)))[3] == [NOWHERE]


@pytest.mark.parametrize("at_start", [True, False])
def test_what_is_negative_at_once(at_start: bool) -> None:
    tables = constant((-0.1, 1.0), (-0.2,), (-0.3,))
    assert first(tables, at_start=at_start)[:3] == (0, 0.0, at_start)
    assert first(tables, at_start=at_start, recent=2)[:3] == (2, 0.0, at_start)
    # What is known to vanish counts at the start alone.
    found = first(constant((-0.1, 1.0)), 1, at_start=at_start)
    assert found[0] == (-1 if at_start else 0)


def test_what_falls_from_a_known_zero_or_stays_there() -> None:
    assert first(constant((0.0, -0.5, 1.0)), 1)[:3] == (0, 0.0, False)
    # What is known outweighs a value that is positive all over the step.
    assert first(constant((0.1, -0.05)), 1)[:3] == (0, 0.0, False)
    fired, fraction, jumped, _ = first(constant((1e-18, 0.5, -1.0)), 1)
    assert (fired, jumped, fraction) == (0, False, pytest.approx(0.5, rel=1e-14))
    staying = constant((-1e-17, 1e-17))
    staying.sizes[:, 0, 1, 0] = 1.0
    assert first(staying)[0] == -1
    assert first(constant((0.0,)))[0] == -1


def test_leading_zeros() -> None:
    sizes = np.full(COUNT, 4.0)
    sizes[1] = 20.0
    small = 3.9 * ROUNDING

    def zeros(known: int, *leading: float) -> tuple[int, list[float]]:
        taylor = np.ones(COUNT)
        taylor[: len(leading)] = leading
        return first_event_module._leading_zeros(taylor, sizes, known), taylor[: len(leading)].tolist()

    assert zeros(0, small, 1.0) == (1, [0.0, 1.0])
    assert zeros(0, -1.1 * small) == (0, [-1.1 * small])
    assert zeros(0, -small, 4.9 * small, 1.1 * small) == (2, [0.0, 0.0, 1.1 * small])
    assert zeros(2, 0.5, 0.5, 0.5) == (2, [0.0, 0.0, 0.5])
    assert zeros(0, *[0.0] * COUNT)[0] == COUNT


def test_halves_of_a_polynomial() -> None:
    # s^2 on [0, 1] is 0, 0, 1; on the halves it is 0, 0, 1/4 and 1/4, 1/2, 1.
    left, right = np.full(4, 9.0), np.full(4, 9.0)
    first_event_module.halve(np.array([0.0, 0.0, 1.0, 7.0]), 3, left, right)
    assert left.tolist() == [0.0, 0.0, 0.25, 9.0]
    assert right.tolist() == [0.25, 0.5, 1.0, 9.0]


@pytest.mark.parametrize("zero", [0.31, 0.4999, 0.5, 0.74])
def test_a_zero_is_polished_within_its_interval(zero: float) -> None:
    # (zero - s) (1 + s^2) on [0.3, 0.75]; a first guess of no use does not matter.
    taylor = np.array([zero, -1.0, zero, -1.0])
    values = np.array([zero - 0.3, 0.1, -0.1, zero - 0.75])
    for bernstein in (values, np.array([1.0, 1.0, 1.0, 1.0]), np.array([1e9, -1e-9, -1.0, -1.0])):
        found = first_event_module.polished(bernstein, taylor, 4, 0.3, 0.45)
        assert found == pytest.approx(zero, rel=4e-16)


def test_the_guess_of_a_straight_line_is_its_zero() -> None:
    # Bernstein coefficients of 2 - 5 s of degree 4 on [0, 1]: their polygon is the line.
    taylor, bernstein = np.array([2.0, -5.0, 0.0, 0.0, 0.0]), np.array([2.0, 0.75, -0.5, -1.75, -3.0])
    assert first_event_module.polished(bernstein, taylor, 5, 0.0, 1.0) == pytest.approx(0.4, rel=1e-16)
    # With a polynomial that is zero everywhere the guess itself comes back.
    assert first_event_module.polished(bernstein, 0 * taylor, 5, 0.0, 1.0) == pytest.approx(0.4, rel=1e-15)
    assert first_event_module.polished(bernstein, 0 * taylor, 5, 0.3, 0.2) == pytest.approx(0.38, rel=1e-15)


def test_touches_count_before_the_zero_alone() -> None:
    def search(polynomial: np.ndarray) -> tuple[float, float]:
        taylor = np.zeros(COUNT)
        taylor[: len(polynomial)] = polynomial
        bernstein = taylor @ bernstein_from_taylor()[0]
        return first_event_module.first_root(
            bernstein, taylor, COUNT, 1e-13, np.empty((DEEPEST + 3, COUNT + 2))
        )

    # ((s - 3/10)^2 + 1e-15) (3/4 - s) touches at 3/10 and falls at 3/4.
    touching = np.polymul([1.0, -0.6, 0.09 + 1e-15], [-1.0, 0.75])[::-1]
    root, touch = search(touching)
    assert root == pytest.approx(0.75, rel=1e-12)
    assert touch == pytest.approx(0.3, abs=2e-3)
    late = np.polymul([1.0, -1.4, 0.49 + 1e-15], [-1.0, 0.25])[::-1]
    assert search(late) == (pytest.approx(0.25, rel=1e-12), NOWHERE)
    assert search(np.array([0.0, 0.0, 1.0]) + 1e-20)[0] == NOWHERE
