"""The contact problem of dry friction, beside SciPy's linear programming and least squares."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog, lsq_linear

from trimmer.arrays import Reals
from trimmer.hybrid.dry_friction import (
    admissible_split,
    closure,
    complementary_forces,
    elementary_vectors,
    independent,
    margins,
)

RING = np.array([[1.0, -1.0, 0.0], [0.0, 1.0, -1.0], [1.0, 0.0, -1.0]])
"""Three bodies; the third velocity is the sum of the other two."""
SEEDS = st.integers(0, 10**9)


def contacts(seed: int) -> tuple[np.random.Generator, Reals, Reals]:
    """Return up to eight contacts between up to five bodies and the ground, and their limits."""
    random = np.random.default_rng(seed)
    bodies = int(random.integers(1, 6))
    count = int(random.integers(1, 9))
    directions = np.zeros((count, bodies + 1))
    for row in directions:
        row[random.choice(bodies + 1, 2, replace=False)] = 1.0, -1.0
    limits = 10.0 ** random.uniform(-2.0, 2.0, count)
    return random, directions[:, 1:], limits


def range_of_forces(
    directions: Reals, limits: Reals, forces: Reals, contact: int
) -> tuple[float, float] | None:
    """Return the least and the greatest force of a contact among all admissible splits."""
    ends = []
    for sign in (1.0, -1.0):
        cost = np.zeros(len(limits))
        cost[contact] = sign
        found = linprog(
            cost,
            A_eq=directions.T,
            b_eq=directions.T @ forces,
            bounds=list(zip(-limits, limits, strict=True)),
        )
        if found.status != 0:
            return None
        ends.append(float(found.x[contact]))
    return ends[0], ends[1]


@given(st.integers(0, 2**32 - 1))
def test_independent_rows_are_those_that_raise_the_rank_one_after_the_other(seed: int) -> None:
    random = np.random.default_rng(seed)
    rows = random.integers(-2, 3, (8, 3)) @ random.integers(-1, 2, (3, 5)).astype(float)
    ranks = [0, *(int(np.linalg.matrix_rank(rows[:count])) for count in range(1, 9))]
    scaled = rows * 10.0 ** random.uniform(-5, 5, (8, 1))
    assert independent(scaled).tolist() == np.flatnonzero(np.diff(ranks)).tolist()


def test_a_ring_can_hold_what_two_of_three_can_hold_each() -> None:
    found = {tuple(np.round(row, 12) + 0.0) for row in elementary_vectors(RING)}
    assert found == {(1.0, 0.0, 1.0), (0.0, 1.0, 1.0), (1.0, -1.0, 0.0)}


def test_independent_contacts_hold_each_for_itself() -> None:
    assert (elementary_vectors(RING[:2]) == np.eye(2)).all()


def test_contacts_that_repeat_each_other_hold_together() -> None:
    vectors = elementary_vectors(np.array([[1.0, -1.0], [-2.0, 2.0], [1.0, 0.0]]))
    assert vectors == pytest.approx(np.array([[0.5, -1.0, 0.0], [0.0, 0.0, 1.0]]), abs=1e-12)


@settings(deadline=None, max_examples=40)
@given(SEEDS)
def test_a_split_is_found_whenever_there_is_one(seed: int) -> None:
    random, directions, limits = contacts(seed)
    forces = random.normal(size=len(limits)) * limits * 10.0 ** random.uniform(-1.0, 1.0, len(limits))
    margin = float(margins(elementary_vectors(directions), limits, forces).min())
    possible = range_of_forces(directions, limits, forces, 0) is not None
    if abs(margin) > 1e-6:  # SciPy's tolerance
        assert (margin > 0) == possible
        split = admissible_split(directions, limits, forces)
        assert (split is not None) == possible
        if split is not None:
            assert (abs(split) <= limits).all()
            assert directions.T @ split == pytest.approx(directions.T @ forces, abs=1e-9 * abs(forces).max())


@settings(deadline=None, max_examples=20)
@given(SEEDS)
def test_the_margin_is_that_of_the_limits(seed: int) -> None:
    random, directions, limits = contacts(seed)
    forces = random.uniform(-1.0, 1.0, len(limits)) * limits
    share = 1.0 - float(margins(elementary_vectors(directions), limits, forces).min())
    assert range_of_forces(directions, (share + 1e-6) * limits, forces, 0) is not None
    assert range_of_forces(directions, share * (1.0 - 1e-4) * limits, forces, 0) is None


@settings(deadline=None, max_examples=40)
@given(SEEDS)
def test_accelerations_are_those_of_the_complementarity_problem(seed: int) -> None:
    random, directions, limits = contacts(seed)
    masses = 10.0 ** random.uniform(-3.0, 0.0, directions.shape[1])
    given_accelerations = random.normal(size=directions.shape[1]) * 100.0
    influence, drift = (directions / masses) @ directions.T, directions @ given_accelerations
    forces, accelerations = complementary_forces(influence, drift, -limits, limits)
    size = abs(drift) + abs(influence) @ abs(forces)
    assert (abs(drift - influence @ forces - accelerations) <= 1e-11 * size).all()
    assert (abs(forces) <= limits * (1 + 1e-15)).all()
    at_end = np.isclose(forces, np.sign(accelerations) * limits, rtol=1e-12)
    assert at_end[accelerations != 0].all()
    root = (directions / np.sqrt(masses)).T
    peer = lsq_linear(
        root, np.sqrt(masses) * given_accelerations, (-limits, limits), method="bvls", max_iter=2000
    )
    if peer.status > 0:
        assert drift - influence @ peer.x == pytest.approx(accelerations, abs=1e-6 * size.max())


def test_a_force_at_its_limit_may_only_go_back() -> None:
    """The second contact is at its upper limit; that the first one is not, lets it take the rate over."""
    influence = RING[[0, 2]] @ RING[[0, 2]].T
    drift = influence @ np.array([1.0, 3.0])
    lower, upper = np.array([-np.inf, -np.inf]), np.array([np.inf, 0.0])
    forces, rates = complementary_forces(influence, drift, lower, upper)
    assert forces == pytest.approx([2.5, 0.0])
    assert rates == pytest.approx([0.0, 4.5])


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_forces_that_cannot_balance_go_to_their_bounds(sign: float) -> None:
    """Two frictions at one place whose ends move differently, which no force changes: so one slides."""
    bounds = np.array([-3.0, -3.0]), np.array([3.0, 3.0])
    with np.errstate(invalid="raise"):
        forces, rates = complementary_forces(np.ones((2, 2)), sign * np.array([0.9, 0.7]), *bounds)
    slides = abs(rates) > 1e-12
    assert slides.sum() == 1
    assert (forces[slides] == 3.0 * np.sign(rates[slides])).all()
    assert rates == pytest.approx(sign * np.array([0.9, 0.7]) - forces.sum(), abs=1e-12)


def test_no_problem_of_a_dozen_frictions_takes_long() -> None:
    random = np.random.default_rng(3)
    directions = np.array([np.eye(6)[a] - np.eye(6)[b] for a in range(6) for b in range(a)])[:12, 1:]
    vectors = elementary_vectors(directions)
    limits = 10.0 ** random.uniform(-2.0, 2.0, 12)
    assert vectors.shape[0] <= 2**5
    forces, rates = complementary_forces(directions @ directions.T, directions @ np.ones(5), -limits, limits)
    assert (abs(forces) <= limits).all()
    assert rates.shape == (12,)


def test_what_follows_from_held_contacts_is_held() -> None:
    assert closure(RING, np.array([True, False, True])).tolist() == [True, True, True]
    assert closure(RING, np.array([False, False, True])).tolist() == [False, False, True]
    assert closure(RING, np.array([False, False, False])).tolist() == [False, False, False]
