"""The distance of lines made by hand, and its derivatives where a neighbour is missing or unlike."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from tests.trimmer.fitting.known import measured
from trimmer.fitting.misfit import Fitted, Misfit
from trimmer.fitting.model import GOES_ON, ModelMotion

RNG = np.random.default_rng(11)
LINES = RNG.normal(size=(4, 2)) + 1j * RNG.normal(size=(4, 2))
FACTORS = np.array([[[0.5 + row, 0.0], [0.3 - 0.2j, 0.7]] for row in range(4)])
ORDERS = np.arange(1, 5)[:, None]


class Motions:
    """A model whose lines are a known function of the coordinates; it keeps how long it may settle."""

    def __init__(self, lines: Callable[[np.ndarray], np.ndarray | None], neutral: bool = False) -> None:
        self.lines, self.neutral = lines, neutral
        self.settlings: list[int] = []

    def settled(self, coordinates: np.ndarray) -> ModelMotion | None:
        return self.continued(coordinates, None, -1)

    def continued(self, coordinates: np.ndarray, near: Any, settling: int) -> ModelMotion | None:
        self.settlings.append(settling)
        lines = self.lines(coordinates)
        orbit: Any = SimpleNamespace(neutral=self.neutral)
        return None if lines is None else ModelMotion(coordinates, orbit, lines)


def misfit(lines: Callable[[np.ndarray], np.ndarray | None], neutral: bool = False) -> Misfit:
    model: Any = Motions(lines, neutral)
    return Misfit(measured(LINES, FACTORS), model)


def at(wrong: Misfit, *coordinates: float) -> Fitted:
    found = wrong.settled(np.array(coordinates))
    assert found is not None
    return found


def distance(lines: np.ndarray, angle: float, sign: float = 1.0) -> float:
    """Return the sum of the squares with the noise's inverse covariance, without whitening."""
    apart = lines * np.exp(1j * angle * ORDERS) - sign * LINES
    inverses = np.linalg.inv(FACTORS @ FACTORS.conj().transpose(0, 2, 1))
    return float(np.einsum("pi,pij,pj->", apart.conj(), inverses, apart).real)


def test_lines_that_are_shifted_in_time_agree() -> None:
    found = at(misfit(lambda at: LINES * np.exp(-1j * 0.7 * ORDERS)), 0.0)
    assert found.angle % (2 * np.pi) == pytest.approx(0.7, abs=1e-9)
    np.testing.assert_allclose(found.lines, LINES, rtol=1e-9)
    assert found.chi_square < 1e-16
    np.testing.assert_array_equal(found.coordinates, [0.0])


def test_the_residual_is_whitened_and_least_over_the_shift() -> None:
    other = LINES + 0.2 * RNG.normal(size=LINES.shape)
    wrong = misfit(lambda at: other * np.exp(-1j * 2.1 * ORDERS))
    found = at(wrong, 0.0)
    assert wrong.size == found.residual.size == 16
    best = minimize_scalar(lambda angle: distance(other, angle), bounds=(-0.5, 0.5), method="bounded").fun
    assert found.chi_square == pytest.approx(best, rel=1e-6)
    solved = np.linalg.solve(FACTORS, (found.lines - LINES)[..., None])[..., 0].ravel()
    np.testing.assert_allclose(found.residual, [*solved.real, *solved.imag], rtol=1e-10)


def test_the_opposite_sign_is_tried_with_its_own_shift() -> None:
    other = 0.9 * LINES
    wrong = misfit(lambda at: other)
    grid = np.linspace(0, 2 * np.pi, 721)
    start = grid[np.argmin([distance(other, angle, -1.0) for angle in grid])]
    best = minimize_scalar(
        lambda angle: distance(other, angle, -1.0), bounds=(start - 0.02, start + 0.02), method="bounded"
    )
    assert wrong.opposite(at(wrong, 0.0)) == pytest.approx(best.fun, rel=1e-6)
    turned = misfit(lambda at: -LINES)
    assert turned.opposite(at(turned, 0.0)) < 1e-16


def test_the_derivative_is_that_of_the_residual() -> None:
    first, second = RNG.normal(size=(2, 4, 2))

    def lines(at: np.ndarray) -> np.ndarray:
        return np.asarray(LINES + 0.1 + at[0] * first + np.sin(at[1]) * 1j * second)

    wrong = misfit(lines)
    found = at(wrong, 0.2, -0.3)
    slope = wrong.jacobian(found)
    for place, step in enumerate(np.eye(2) * 1e-3):
        one, two = (
            (
                at(wrong, *(found.coordinates + k * step)).residual
                - at(wrong, *(found.coordinates - k * step)).residual
            )
            / (2e-3 * k)
            for k in (1, 2)
        )
        np.testing.assert_allclose(slope[:, place], (4 * one - two) / 3, rtol=1e-5, atol=1e-7)
    only = wrong.jacobian(found, np.array([False, True]))
    np.testing.assert_array_equal(only, slope * [0.0, 1.0])


def scaled(size: Callable[[float], float | None], neutral: bool = False) -> tuple[Misfit, Fitted]:
    """Return the misfit of one real line whose size is a function of one coordinate, and its start."""

    def lines(at: np.ndarray) -> np.ndarray | None:
        found = size(float(at[0]))
        return None if found is None else np.array([[found + 0j]])

    model: Any = Motions(lines, neutral)
    wrong = Misfit(measured(np.array([[1.0 + 0j]])), model)
    return wrong, at(wrong, 0.0)


def test_where_one_neighbour_is_missing_the_other_side_counts() -> None:
    for sign in (1.0, -1.0):
        wrong, start = scaled(lambda x, sign=sign: 3.0 + 2.0 * x if sign * x <= 0 else None)  # type: ignore[misc]
        column, rough = wrong._difference(start, 0, 1e-3)
        np.testing.assert_allclose(column, [2.0, 0.0], atol=1e-12)
        assert rough == 0.0
        np.testing.assert_allclose(wrong.jacobian(start), [[2.0], [0.0]], atol=1e-9)


def test_where_both_neighbours_are_missing_nothing_is_known() -> None:
    wrong, start = scaled(lambda x: 3.0 if x == 0 else None)
    column, rough = wrong._difference(start, 0, 1e-3)
    np.testing.assert_array_equal(column, [0.0, 0.0])
    assert rough == 0.0
    np.testing.assert_array_equal(wrong.jacobian(start), [[0.0], [0.0]])


def test_sides_that_differ_are_rough() -> None:
    wrong, start = scaled(lambda x: 3.0 + (4.0 * x if x > 0 else 2.0 * x))
    column, rough = wrong._difference(start, 0, 1e-3)
    np.testing.assert_allclose(column, [3.0, 0.0], atol=1e-12)
    assert rough == pytest.approx(2.0 / 3.0)
    still, start = scaled(lambda x: 3.0)
    assert still._difference(start, 0, 1e-3)[1] == 0.0


def test_a_kink_nearby_is_avoided_by_a_smaller_difference() -> None:
    wrong, start = scaled(lambda x: 3.0 + 2.0 * x + 9.0 * max(x - 5e-6, 0.0))
    np.testing.assert_allclose(wrong.jacobian(start), [[2.0], [0.0]], atol=1e-6)
    # But not where the smaller difference is the rougher one.
    wrong, start = scaled(lambda x: 3.0 + x + 2.0 * min(max(x, 0.0), 1e-6))
    np.testing.assert_allclose(wrong.jacobian(start), [[1.1], [0.0]], atol=1e-6)
    smooth, start = scaled(lambda x: 3.0 + x)
    smooth.jacobian(start)
    assert len(smooth.model.settlings) == 1 + 2  # type: ignore[attr-defined]


@pytest.mark.parametrize(("neutral", "settling"), [(False, 0), (True, GOES_ON)])
def test_neighbours_settle_only_where_friction_leaves_a_place_free(neutral: bool, settling: int) -> None:
    wrong, start = scaled(lambda x: 3.0 + x, neutral)
    wrong.jacobian(start)
    assert wrong.model.settlings[1:] == [settling, settling]  # type: ignore[attr-defined]


def test_without_a_motion_there_is_no_distance() -> None:
    wrong, start = scaled(lambda x: None if x > 1 else 3.0)
    assert wrong.settled(np.array([2.0])) is None
    assert wrong.continued(np.array([2.0]), start) is None
    found = wrong.continued(np.array([0.5]), start)
    assert found is not None
    assert found.chi_square == pytest.approx(4.0)
    assert wrong.model.settlings[-1] == GOES_ON  # type: ignore[attr-defined]
