"""How balanced harmonics are asked for, packed for the solver, judged and told, in parts."""

from __future__ import annotations

import math
from types import SimpleNamespace

import control
import numpy as np
import pytest
import scipy.optimize

from trimmer import Relay, WrongTypeError, limit_cycles, multi_harmonic_balance
from trimmer.errors import OrbitNotFoundError
from trimmer.orbits import multi_harmonic_balance as module
from trimmer.orbits.multi_harmonic_balance import BalancedHarmonics, solutions

PLANT = control.ss(control.tf([1.0], [1.0, 3.0, 2.0, 0.0]))
RELAY = Relay(1.5)
(CYCLE,) = limit_cycles(PLANT, RELAY)


def test_orders_are_checked_and_handed_on(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list = []
    monkeypatch.setattr(module, "solutions", lambda *given: asked.append(given) or iter("ab"))
    assert multi_harmonic_balance(PLANT, RELAY, CYCLE) == ("a", "b")
    system, element, guess, orders = asked[0]
    assert (system, element, guess) == (PLANT, RELAY, (CYCLE.amplitude, CYCLE.omega))
    assert list(orders) == [1, 3, 5, 7, 9]
    for given in ((3,), (1, 9), [1, 3, 5]):
        multi_harmonic_balance(PLANT, RELAY, CYCLE, given)
        assert list(asked[-1][3]) == list(given)
    for wrong in ((), (0,), (-1, 1), (1, 2), (3, 1), (1, 1)):
        with pytest.raises(ValueError, match="orders must be odd, positive and rising"):
            multi_harmonic_balance(PLANT, RELAY, CYCLE, wrong)
    with pytest.raises(ValueError, match=r"orders\[1\]"):
        multi_harmonic_balance(PLANT, RELAY, CYCLE, (1, 3.5))
    with pytest.raises(WrongTypeError, match="cycle must be"):
        multi_harmonic_balance(PLANT, RELAY, (1.0, 2.0))


def test_each_solution_begins_at_the_one_before(monkeypatch: pytest.MonkeyPatch) -> None:
    begun: list = []

    def solve(system, element, order, harmonics, omega):
        begun.append((order, harmonics.tolist(), omega))
        found = np.arange(1, len(harmonics) + 1) * (1 + 2j)
        return SimpleNamespace(harmonics=found, omega=omega + 0.5)

    monkeypatch.setattr(module, "_solve", solve)
    assert len(list(solutions(PLANT, RELAY, (2.0, 3.0), (1, 3, 7)))) == 3
    assert begun == [
        (1, [2.0], 3.0),
        (3, [1 + 2j, 0.0], 3.5),
        (7, [1 + 2j, 2 + 4j, 0.0, 0.0], 4.0),
    ]


def without_solver(monkeypatch: pytest.MonkeyPatch) -> list:
    """Take the first guess for the solution; return where the solver begins."""
    begun: list = []

    def root(function, start, **options):
        begun.append(start.tolist())
        return SimpleNamespace(x=start)

    monkeypatch.setattr(scipy.optimize, "root", root)
    return begun


def test_what_is_solved_already_is_given_back(monkeypatch: pytest.MonkeyPatch) -> None:
    *_, exact = multi_harmonic_balance(PLANT, RELAY, CYCLE, (1, 3, 5))
    begun = without_solver(monkeypatch)
    found = module._solve(PLANT, RELAY, 5, exact.harmonics, exact.omega)
    first = exact.harmonics[0].real
    parts = [part / first for each in exact.harmonics[1:] for part in (each.real, each.imag)]
    assert begun == [[1.0, 1.0, *map(pytest.approx, parts)]]
    assert min(map(abs, parts)) > 1e-6
    np.testing.assert_allclose(found.harmonics, exact.harmonics, rtol=1e-14)
    assert (found.order, found.omega) == (5, exact.omega)
    assert found.amplitude == pytest.approx(exact.amplitude, rel=1e-14)
    assert found.residual <= 1e-9


def test_too_small_a_harmonic_is_no_solution_either(monkeypatch: pytest.MonkeyPatch) -> None:
    without_solver(monkeypatch)
    for share in (0.9, 1.1):
        with pytest.raises(OrbitNotFoundError, match="no solution with harmonics up to 1 lies near"):
            module._solve(PLANT, RELAY, 1, np.array([share * CYCLE.amplitude + 0j]), CYCLE.omega)


def test_the_table_has_a_row_for_each_harmonic() -> None:
    found = BalancedHarmonics(5, 3.0, 8.0 * math.pi, np.array([3.0, -2j, 0.5 + 0.5j]), 0.0)
    assert found.frequency == pytest.approx(4.0)
    table = found._table()
    rows = list(table.rows())
    assert [row[0] for row in rows] == [1, 3, 5]
    np.testing.assert_allclose(
        np.array([row[1:] for row in rows], float),
        [[4.0, 3.0, 0.0], [12.0, 2.0, -math.pi / 2], [20.0, math.sqrt(0.5), math.pi / 4]],
    )
