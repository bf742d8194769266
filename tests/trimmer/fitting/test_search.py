"""Several starts on misfits with known minima."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from tests.trimmer.fitting.known import Known
from trimmer.fitting import search as module
from trimmer.fitting.search import _begun, _Descent, search
from trimmer.fitting.unknowns import Unknown

UNKNOWNS = tuple(Unknown(f"plays.p{each}.gap", "m", 4e-5, True) for each in range(2))


def searched(misfit: Known, starts: int, spread: float = 2.0, seed: int = 0) -> Any:
    made: Any = misfit
    return search(made, starts, spread, seed)


def test_starts_lie_within_the_spread_around_the_first() -> None:
    first, *others = _begun(UNKNOWNS, 9, 3.0, 4)
    np.testing.assert_array_equal(first, [0.0, 0.0])
    shares = np.array(others) / math.log(3.0)
    assert shares.shape == (8, 2)
    # One in each of eight slices of -1 to 1.
    for column in shares.T:
        assert sorted(np.floor(4 * (column + 1)).astype(int).tolist()) == list(range(8))
    assert [each.tolist() for each in _begun(UNKNOWNS, 1, 3.0, 4)] == [[0.0, 0.0]]
    np.testing.assert_array_equal(list(_begun(UNKNOWNS, 9, 3.0, 4))[3], others[2])


def test_all_starts_of_a_linear_misfit_agree() -> None:
    misfit = Known(lambda at: np.array([3.0, *(20.0 * (at - [0.4, -0.3]))]))
    found = searched(misfit, 4)
    assert (found.starts, found.agreeing, found.elsewhere, found.lost) == (4, 4, (), 0)
    assert found.best.coordinates == pytest.approx([0.4, -0.3], abs=1e-6)
    assert found.best.chi_square == pytest.approx(9.0)


def two_valleys(at: np.ndarray) -> np.ndarray | None:
    """Return a residual whose square is least at 0.4, where it is 9, and at -0.6, where it is 16."""
    x = at[0] + 0.1
    return np.array([3.0 if x > 0 else 4.0, 20.0 * (abs(x) - 0.5), 10.0 * at[1]])


def test_starts_in_another_valley_are_counted_apart() -> None:
    misfit = Known(two_valleys)
    found = searched(misfit, 6, 2.5)
    begun = list(_begun(UNKNOWNS, 6, 2.5, 0))
    right = sum(each[0] > -0.1 for each in begun)
    assert 0 < right < 5
    assert found.best.coordinates == pytest.approx([0.4, 0.0], abs=1e-6)
    assert (found.agreeing, found.agreeing + len(found.elsewhere), found.lost) == (right, 6, 0)
    assert found.elsewhere == pytest.approx((16.0,) * (6 - right))


def test_starts_without_a_motion_are_lost() -> None:
    misfit = Known(lambda at: None if at[0] < -0.1 else np.array([3.0, 20.0 * (at[0] - 0.2), at[1]]))
    found = searched(misfit, 6, 2.5)
    lost = sum(each[0] < -0.1 for each in _begun(UNKNOWNS, 6, 2.5, 0))
    assert 0 < lost < 6
    assert (found.lost, found.agreeing, found.starts) == (lost, 6 - lost, 6)
    assert searched(Known(lambda at: None if at.any() else np.ones(2), 2), 1).lost == 0

    class Nothing(Known):
        def settled(self, coordinates: np.ndarray) -> None:
            return None

    assert searched(Nothing(two_valleys), 2) is None


def test_where_no_motion_is_the_residual_is_large() -> None:
    misfit: Any = Known(lambda at: None if at[0] > 1 else np.array([6.0, 8.0, 0.0, 0.0]))
    descent = _Descent(misfit, misfit.at(0.0, 0.0))
    # Ten times the root mean square of the start, which is 5.
    np.testing.assert_allclose(descent._residual(np.array([2.0, 0.0])), np.full(4, 50.0))
    small: Any = Known(lambda at: None if at[0] > 1 else np.full(4, 0.1))
    descent = _Descent(small, small.at(0.0, 0.0))
    np.testing.assert_allclose(descent._residual(np.array([2.0, 0.0])), np.full(4, 10.0))


def test_a_motion_is_computed_once_and_gone_on_from() -> None:
    misfit: Any = Known(lambda at: np.array([3.0, *(20.0 * at)]))
    begun = misfit.at(0.1, 0.2)
    descent = _Descent(misfit, begun)
    assert descent.near is begun
    np.testing.assert_array_equal(descent._residual(np.array([0.1, 0.2])), begun.residual)
    assert misfit.tried == []
    descent._residual(np.array([0.3, 0.2]))
    assert len(misfit.tried) == 1
    assert descent.near is begun
    np.testing.assert_allclose(descent._jacobian(np.array([0.3, 0.2])), [[0, 0], [20, 0], [0, 20]], atol=1e-6)
    assert descent.near.coordinates.tolist() == [0.3, 0.2]
    assert descent.lowest().chi_square == pytest.approx(9.0)


def test_only_fits_near_the_least_are_made_exact(monkeypatch: pytest.MonkeyPatch) -> None:
    exact: list[float] = []

    def kept(misfit: object, fitted: Any, free: np.ndarray) -> Any:
        assert free.tolist() == [True, True]
        exact.append(fitted.chi_square)
        return fitted

    monkeypatch.setattr(module, "nearby_minimum", kept)
    searched(Known(two_valleys), 6, 2.5)  # up to 1.5 * 9 + 3
    assert len(exact) == 6
    exact.clear()
    found = searched(Known(lambda at: np.add(two_valleys(at), [0.1 * (at[0] < -0.1), 0, 0])), 6, 2.5)
    assert len(exact) == found.agreeing
    assert found.elsewhere == pytest.approx((4.1**2,) * (6 - found.agreeing), rel=1e-3)
