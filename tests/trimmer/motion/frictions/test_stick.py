"""What is held at zero is zero to the last digit: projections written out by hand."""

from __future__ import annotations

import numpy as np

from trimmer.motion.frictions.stick import _with_equal_rows, projection

MASSES = np.array([0.035, 0.003, 0.005])


def along_forces(held: np.ndarray) -> np.ndarray:
    """Return what frictions do to velocities: each works against its own rate."""
    return -(held / MASSES).T


def test_a_body_on_the_ground_has_no_velocity() -> None:
    held = np.array([[0.0, 1.0, 0.0]])
    assert projection(held, along_forces(held)).tolist() == np.diag([1.0, 0.0, 1.0]).tolist()
    # Held by its acceleration by another one: the first entry takes the state to 2 x + 3 y = 0.
    moved = projection(np.array([[2.0, 3.0]]), np.array([[-4.0], [0.0]]))
    np.testing.assert_allclose(moved, [[0.0, -1.5], [0.0, 1.0]], rtol=1e-14)
    assert moved[0, 0] == moved[1, 0] == 0.0


def test_bodies_that_are_held_together_have_one_velocity() -> None:
    held = np.array([[0.0, -1.0, 1.0], [1.0, 0.0, -1.0]])
    found = projection(held, along_forces(held))
    np.testing.assert_allclose(found, [MASSES / MASSES.sum()] * 3, rtol=1e-14)
    assert found[0].tolist() == found[1].tolist() == found[2].tolist()
    pair = projection(held[:1], along_forces(held[:1]))
    np.testing.assert_allclose(pair, [[1, 0, 0], [0, 0.375, 0.625], [0, 0.375, 0.625]], rtol=1e-14)
    assert pair[1].tolist() == pair[2].tolist()


def test_functions_that_follow_from_one_another_hold_as_those_that_do_not() -> None:
    ring = np.array([[1.0, -1.0, 0.0], [0.0, 1.0, -1.0], [1.0, 0.0, -1.0], [1e-6, 0.0, 0.0]])
    of_three = projection(ring[:3], along_forces(ring[:3]))
    np.testing.assert_allclose(of_three, [MASSES / MASSES.sum()] * 3, rtol=1e-13)
    assert not projection(ring, along_forces(ring)).any()


def test_rows_that_differ_by_rounding_are_made_equal() -> None:
    nearly = 1.0 + 1e-15
    rows = np.array([[-1.0, -2.0], [3.0, 4.0], [-1.0, -2.0 * nearly], [3.0 * nearly, 4.0], [0.0, 0.0]])
    given = rows.copy()
    expected = [[-1.0, -2.0], [3.0, 4.0], [-1.0, -2.0], [3.0, 4.0], [0.0, 0.0]]
    assert _with_equal_rows(rows).tolist() == expected
    assert (rows == given).all()
    apart = np.array([[-1e-3, 2e-3], [-1e-3, 2e-3 + 3e-15], [1e-3, -2e-3], [0.0, 0.0], [1e-300, 0.0]])
    assert _with_equal_rows(apart).tolist() == apart.tolist()
    assert _with_equal_rows(np.array([[5.0, -9.0], [5.0, -9.0 + 8e-12]])).tolist() == [[5.0, -9.0]] * 2
