"""Equations whose rank is to be found: their solutions against the linear algebra of SciPy."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import null_space

from trimmer.mechanism.elimination import solutions


@given(st.integers(0, 2**32 - 1))
def test_solutions_are_all_there_are_and_the_first_unknowns_are_free(seed: int) -> None:
    random = np.random.default_rng(seed)
    rows, unknowns, rank = (int(each) for each in random.integers(1, 7, 3))
    equations = random.integers(-3, 4, (rows, rank)) @ random.integers(-2, 3, (rank, unknowns)).astype(float)
    right = equations @ random.integers(-5, 6, unknowns)
    found = solutions(equations * 10.0 ** random.uniform(-6, 6, (rows, 1)), np.zeros(rows))
    directions = found.directions
    assert directions.shape == null_space(equations).shape
    assert abs(equations @ directions).max(initial=0.0) <= 1e-11 * max(1.0, abs(directions).max(initial=0.0))
    assert (directions[found.free] == np.eye(len(found.free))).all()
    for number, free in enumerate(found.free):
        # It depends on those behind it alone, so that no earlier unknown could lead in its place.
        assert (directions[:free, number] == 0.0).all()
    particular = solutions(equations, right)
    assert particular.consistent
    assert equations @ particular.particular == pytest.approx(right, abs=1e-9)
    assert (particular.particular[particular.free] == 0.0).all()


def test_what_contradicts_itself_has_no_solution_and_what_is_soft_still_holds() -> None:
    assert not solutions(np.array([[1.0, -1.0], [-2.0, 2.0]]), np.array([1.0, 0.0])).consistent
    chain = np.array([[1e9, -1e9, 0.0], [-1e9, 2e9, -1e9], [0.0, -1e9, 1e9]])
    assert (solutions(chain, np.zeros(3)).directions == 1.0).all()
    chain[2, 2] += 10.0
    assert not len(solutions(chain, np.zeros(3)).free)
