"""The contact problem of dry friction on small systems whose answers are on paper."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.motion.frictions.dry_friction import (
    _least_distance,
    _rank,
    _step_to_balance,
    _with_zero_acceleration,
    admissible_split,
    always_at_limit,
    closure,
    complementary_forces,
    elementary_vectors,
    margins,
)

TWICE = np.array([[1.0], [2.0]])
"""Two frictions on one body; the end of the second one moves twice as fast."""


def test_elementary_vectors_in_order() -> None:
    assert elementary_vectors(TWICE).tolist() == [pytest.approx([0.5, 1.0])]
    assert elementary_vectors(-TWICE[::-1]).tolist() == [pytest.approx([1.0, 0.5])]
    assert elementary_vectors(np.array([[3.0, 4.0], [0.0, 2.0]])).tolist() == [[1.0, 0.0], [0.0, 1.0]]
    # Two bodies on a table that rub on each other as well; supports are (0, 1), (0, 2), (1, 2).
    found = elementary_vectors(np.array([[4.0, 0.0], [0.0, 5.0], [1.0, -1.0]]))
    assert found.tolist() == [
        pytest.approx([0.8, 1.0, 0.0], rel=1e-12),
        pytest.approx([1.0, 0.0, 0.25], rel=1e-12),
        pytest.approx([0.0, 1.0, -0.2], rel=1e-12),
    ]
    assert (found[0, 2], found[1, 1], found[2, 0]) == (0.0, 0.0, 0.0)
    # Contacts that repeat each other say nothing about others.
    repeated = elementary_vectors(np.array([[1.0, 0, 0], [-2.0, 0, 0], [0, 3.0, 0], [0, 0, 1.0]]))
    assert repeated.tolist() == [
        pytest.approx([0.5, -1.0, 0.0, 0.0]),
        pytest.approx([0.0, 0.0, 1.0, 0.0]),
        pytest.approx([0.0, 0.0, 0.0, 1.0]),
    ]
    # Of three bodies on a line, each on the next and on the ground, none is left out.
    line = np.array([[1.0, 0, 0], [1.0, -1.0, 0], [0, 1.0, -1.0], [0, 0, 1.0]])
    pairs = [tuple(np.flatnonzero(row)) for row in elementary_vectors(line)]
    assert pairs == [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]


def test_closure_with_lengths_and_signs() -> None:
    directions = np.array([[4.0, 0.0], [0.0, -5.0], [1e-6, -1e-6], [0.0, 3.0]])
    held = np.array([False, True, False, False])
    assert closure(directions, held).tolist() == [False, True, False, True]
    held[2] = True
    assert closure(directions, held).tolist() == [True] * 4


def test_margins_and_limits() -> None:
    vectors, limits = np.array([[1.0, 0.5], [0.0, -1.0]]), np.array([3.0, 8.0])
    # The bounds are 7 and 8, the products 4 and -6, and with other signs the same.
    for sign in (1.0, -1.0):
        forces = sign * np.array([1.0, 6.0])
        assert margins(vectors, limits, forces) == pytest.approx([3 / 7, 1 / 4], rel=1e-14)
        assert always_at_limit(vectors, limits, forces).tolist() == [0, 0]
        assert always_at_limit(vectors, limits, forces, 0.25).tolist() == [0, sign]
        assert always_at_limit(vectors, limits, forces, 0.43).tolist() == [sign, sign]
    touching = np.array([-3.0, -8.0])
    assert always_at_limit(vectors, limits, touching).tolist() == [-1, -1]
    assert always_at_limit(vectors, limits, touching).dtype == np.int64


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_split_with_the_least_squares_relative_to_the_limits(sign: float) -> None:
    # On one body the forces f and g count as f + 2 g, at most 1 + 2 * 4 N.
    limits = np.array([1.0, 4.0])

    def split(resultant: float) -> np.ndarray | None:
        return admissible_split(TWICE, limits, sign * np.array([resultant, 0.0]))

    # The forces relative to the limits are as 1 to 8.
    assert split(6.5) == pytest.approx(sign * np.array([0.1, 3.2]), rel=1e-13)
    assert split(65 / 8) == pytest.approx(sign * np.array([1 / 8, 4.0]), rel=1e-12)
    # Beyond, the second one is at its limit and the first one takes the rest.
    assert split(8.5) == pytest.approx(sign * np.array([0.5, 4.0]), rel=1e-12)
    assert split(9.0) == pytest.approx(sign * limits, rel=1e-12)
    assert split(9.01) is None
    assert (abs(split(9.0)) <= limits).all()
    # What does not depend on others keeps its force.
    apart = admissible_split(np.eye(2), limits, sign * np.array([0.7, -3.0]))
    assert apart == pytest.approx(sign * np.array([0.7, -3.0]), rel=1e-14)
    assert admissible_split(np.eye(2), limits, sign * np.array([1.1, -3.0])) is None


def test_the_shortest_vector_that_meets_conditions() -> None:
    assert _least_distance(np.array([[1.0, 0.0, 2.0]])) == pytest.approx([2.0, 0.0])
    assert _least_distance(np.array([[3.0, 4.0, 10.0], [1.0, 0.0, -9.0]])) == pytest.approx([1.2, 1.6])
    assert _least_distance(np.array([[1.0, 0.0, 2.0], [0.0, -1.0, 3.0]])) == pytest.approx([2.0, -3.0])
    assert _least_distance(np.array([[1.0, 0.0, -2.0]])) == pytest.approx([0.0, 0.0])
    assert _least_distance(np.array([[0.0, 0.0], [1.0, 5.0]])) == pytest.approx([5.0])
    assert _least_distance(np.array([[1.0, 1.0], [-1.0, 1.0]])) is None


def test_accelerations_with_unequal_masses_and_bounds() -> None:
    # 2 kg under 6 m/s^2 hold with 12 N, of which 5 N are there; 1/9 kg hold.
    influence, drift = np.diag([0.5, 9.0]), np.array([6.0, -18.0])
    forces, rates = complementary_forces(influence, drift, np.array([-1.0, -3.0]), np.array([5.0, 3.0]))
    assert forces == pytest.approx([5.0, -2.0], rel=1e-14)
    assert rates.tolist() == pytest.approx([3.5, 0.0], rel=1e-14)
    assert rates[1] == 0.0
    forces, rates = complementary_forces(influence, -drift, np.array([-1.0, -3.0]), np.array([5.0, 1.0]))
    assert forces == pytest.approx([-1.0, 1.0], rel=1e-14)
    assert rates == pytest.approx([-5.5, 9.0], rel=1e-14)
    # Where zero is no force that is allowed, the nearest bound is where it begins.
    forces, rates = complementary_forces(influence, 0 * drift, np.array([2.0, -9.0]), np.array([5.0, -1.0]))
    assert forces == pytest.approx([2.0, -1.0], rel=1e-14)
    assert rates == pytest.approx([-1.0, 9.0], rel=1e-14)


def test_accelerations_below_the_noise_are_zero() -> None:
    influence, bounds = np.diag([4.0, 4.0]), (np.full(2, -np.inf), np.zeros(2))
    drift = np.array([1e-5, 3e-5])
    assert complementary_forces(influence, drift, *bounds)[1].tolist() == pytest.approx(drift.tolist())
    rates = complementary_forces(influence, drift, *bounds, np.array([2e-5, 2e-5]))[1]
    assert rates.tolist() == pytest.approx([0.0, 3e-5], rel=1e-14)
    assert rates[0] == 0.0


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_acceleration_is_zero_by_the_terms_that_it_is_made_of(sign: float) -> None:
    # 1 m/s^2 and a bit more, less what 1 N does to 1 kg: the terms add up to 2 m/s^2.
    bounds = np.array([-1.0]), np.array([1.0])
    for excess, counts in ((1.5e-12, False), (2.5e-12, True)):
        forces, rates = complementary_forces(np.eye(1), sign * np.array([1.0 + excess]), *bounds)
        assert forces.tolist() == [sign]
        assert rates.tolist() == [pytest.approx(sign * excess, rel=1e-3, abs=0.0) if counts else 0.0]


def test_forces_that_meet_a_bound_on_their_way_stay_there() -> None:
    # Balance is at (3, 1); the first one meets 2 first, and then the second one balances alone.
    influence, drift = np.array([[2.0, 1.0], [1.0, 2.0]]), np.array([7.0, 5.0])
    bounds, both = (np.array([-9.0, -9.0]), np.array([2.0, 9.0])), np.array([True, True])
    given = np.array([0.0, 0.0])
    forces, between = _with_zero_acceleration(influence, drift, bounds, given, both)
    assert forces == pytest.approx([2.0, 1.5], rel=1e-14)
    assert between.tolist() == [False, True]
    assert (given == 0.0).all() and both.all()
    forces, between = _with_zero_acceleration(influence, -drift, (-bounds[1], bounds[1]), given, both)
    assert forces == pytest.approx([-2.0, -1.5], rel=1e-14)
    # What is not between its bounds is left alone.
    alone = np.array([False, True])
    forces, between = _with_zero_acceleration(influence, drift, bounds, np.array([0.5, 0.0]), alone)
    assert forces == pytest.approx([0.5, 2.25], rel=1e-14)
    assert between.tolist() == [False, True]
    forces, between = _with_zero_acceleration(influence, drift, bounds, given, np.array([False, False]))
    assert forces.tolist() == [0.0, 0.0]


def test_forces_that_cannot_balance_go_to_their_bounds() -> None:
    # Both ends move differently by 0.2 m/s^2, which no force changes; so the forces part until one stops.
    same, both, given = np.ones((2, 2)), np.array([True, True]), np.array([0.25, 0.5])
    bounds = np.array([-3.0, -3.0]), np.array([3.0, 3.0])
    forces, between = _with_zero_acceleration(same, np.array([0.9, 0.7]), bounds, given, both)
    # The one that has not met its bound balances alone.
    assert (forces.tolist(), between.tolist()) == (pytest.approx([3.0, 0.7 - 3.0]), [False, True])
    # It would need -3.9 N, and stops at its own bound.
    forces, between = _with_zero_acceleration(same, np.array([-0.9, -0.7]), bounds, given, both)
    assert (forces.tolist(), between.tolist()) == ([-3.0, 3.0], [False, False])


def test_steps_to_balance() -> None:
    step, ends = _step_to_balance(np.diag([2.0, 5.0]), np.array([4.0, 5.0]), np.array([1.0, 3.0]))
    assert (step.tolist(), ends) == (pytest.approx([1.0, -2.0]), True)
    same = np.ones((2, 2))
    step, ends = _step_to_balance(same, np.array([4.0, 4.0]), np.array([0.5, 0.0]))
    assert (step.tolist(), ends) == (pytest.approx([1.75, 1.75]), True)
    step, ends = _step_to_balance(same, np.array([-4.0, -4.0]), np.array([-0.5, 0.0]))
    assert (step.tolist(), ends) == (pytest.approx([-1.75, -1.75]), True)
    # What they touch moves differently: no forces balance.
    step, ends = _step_to_balance(same, np.array([3.0, 1.0]), np.array([0.5, 0.0]))
    assert (step.tolist(), ends) == (pytest.approx([1.0, -1.0]), False)
    # A small difference is none of rounding.
    assert _step_to_balance(same, np.array([1e7, 1e7 + 1.0]), np.zeros(2))[1]
    assert _step_to_balance(same, np.array([1.0, 1.0 + 1e-8]), np.zeros(2))[1]
    assert not _step_to_balance(same, np.array([1.0, 1.0 + 1e-5]), np.zeros(2))[1]
    directions = np.array([[1.0, 0.0], [1.0, 0.0], [0.6, 0.8]])
    step, ends = _step_to_balance(directions @ directions.T, np.array([3.0, 1.0, 7.0]), np.zeros(3))
    assert (step.tolist(), ends) == (pytest.approx([1.0, -1.0, 0.0]), False)
    assert step[2] == 0.0
    third = np.array([[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    step, ends = _step_to_balance(third, np.array([3.0, 1.0, 7.0]), np.zeros(3))
    assert (step.tolist(), ends) == (pytest.approx([1.0, -1.0, 0.0]), False)
    assert step[2] == 0.0


def test_the_number_of_independent_directions() -> None:
    assert _rank(np.array([3.0, 1e-9, 1e-11])) == 2
    assert _rank(np.array([1e-11, 1e-12, 1e-22])) == 2
    assert _rank(np.array([])) == 0
    assert _rank(np.zeros(2)) == 0
    assert elementary_vectors(math.sqrt(3) * np.eye(3)).tolist() == np.eye(3).tolist()
