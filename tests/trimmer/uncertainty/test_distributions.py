"""Distributions, and points that are turned into values of them."""

import numpy as np
import pytest
from scipy import stats

from trimmer.uncertainty import JointScatter, Normal, Plan, Scatter, Uncertainty, Uniform
from trimmer.uncertainty.points import within_cube

SHARES = np.array([1e-6, 0.1, 0.5, 0.9, 1 - 1e-6])


def test_quantiles_are_those_of_scipy() -> None:
    pairs = (Normal(3.0, 0.2), stats.norm(3.0, 0.2)), (Uniform(-1.0, 4.0), stats.uniform(-1.0, 5.0))
    for own, theirs in pairs:
        np.testing.assert_allclose(own.quantile(SHARES), theirs.ppf(SHARES), rtol=1e-12)


@pytest.mark.parametrize("plan", list(Plan))
def test_samples_have_the_moments_that_were_asked_for(plan: Plan) -> None:
    covariance = ((4.0, -1.5), (-1.5, 1.0))
    scatters = (
        Scatter("a", "m", Normal(1.0, 2.0)),
        Scatter("b", "N", Uniform(2.0, 5.0)),
        Scatter("c", "kg", Normal(-3.0, 1.0)),
    )
    uncertainty = Uncertainty(scatters, (JointScatter(("a", "c"), covariance),))
    values = uncertainty.values(plan.points(2**14, 3, 7))
    np.testing.assert_allclose(values.mean(axis=0), [1.0, 3.5, -3.0], atol=0.02)
    found = np.cov(values.T)
    np.testing.assert_allclose(found[np.ix_([0, 2], [0, 2])], covariance, atol=0.04)
    assert found[1, 1] == pytest.approx(9.0 / 12.0, rel=0.01)
    assert abs(found[1, [0, 2]]).max() < 0.06  # four standard errors


def test_two_numbers_that_are_one_scatter_as_one() -> None:
    scatters = (Scatter("a", "m", Normal(0.0, 1.0)), Scatter("b", "m", Normal(5.0, 2.0)))
    values = Uncertainty(scatters, (JointScatter(("a", "b"), ((1.0, 2.0), (2.0, 4.0))),)).values(
        Plan.LATIN_HYPERCUBE.points(50, 2, 1)
    )
    np.testing.assert_allclose(values[:, 1] - 5.0, 2.0 * values[:, 0], atol=1e-7)


def test_only_numbers_that_tell_of_each_other_are_dependent() -> None:
    scatters = (Scatter("a", "m", Normal(0.0, 1.0)), Scatter("b", "m", Normal(5.0, 2.0)))
    assert Uncertainty(scatters).independent
    assert Uncertainty(scatters, (JointScatter(("a", "b"), ((1.0, 0.0), (0.0, 4.0))),)).independent
    assert not Uncertainty(scatters, (JointScatter(("a", "b"), ((1.0, 0.1), (0.1, 4.0))),)).independent


def test_a_latin_hypercube_has_one_point_in_each_slice() -> None:
    points = Plan.LATIN_HYPERCUBE.points(40, 3, 5)
    assert (np.sort(np.floor(40 * points), axis=0) == np.arange(40)[:, None]).all()


def test_sobol_goes_on_with_the_same_points() -> None:
    assert Plan.SOBOL.count(100) == 128
    few, many = Plan.SOBOL.points(16, 3, 5), Plan.SOBOL.points(64, 3, 5)
    np.testing.assert_array_equal(many[:16], few)


def test_points_are_those_of_scipy_and_lie_on_no_face() -> None:
    np.testing.assert_array_equal(Plan.SOBOL.points(4, 3, 1), stats.qmc.Sobol(3, rng=1).random(4))
    expected = stats.qmc.LatinHypercube(3, rng=1).random(4)
    np.testing.assert_array_equal(Plan.LATIN_HYPERCUBE.points(4, 3, 1), expected)
    faces = within_cube(np.array([0.0, 0.3, 1.0]))
    assert faces.tolist() == [2.0**-40, 0.3, 1.0 - 2.0**-40]
    assert np.isfinite(Normal(0.0, 1.0).quantile(faces)).all()
    assert [Plan.SOBOL.count(wanted) for wanted in (1, 2, 3, 64, 65)] == [1, 2, 4, 64, 128]
    assert Plan.LATIN_HYPERCUBE.count(65) == 65


def test_values_are_placed_by_column_each_with_its_own_mean() -> None:
    """Those that scatter together are drawn by a root of their covariance, whatever their order."""
    covariance = np.array([[0.25, 0.0, 0.3], [0.0, 4.0, 1.2], [0.3, 1.2, 1.0]])
    joint = JointScatter(("c", "a", "b"), tuple(map(tuple, covariance.tolist())))
    scatters = tuple(
        Scatter(name, "m", each)
        for name, each in zip(
            "pabc", (Uniform(1.0, 3.0), Normal(1.0, 2.0), Normal(3.5, 1.0), Normal(-3.0, 0.5)), strict=True
        )
    )
    np.testing.assert_allclose(joint.root @ joint.root.T, covariance, atol=1e-12)
    found = Uncertainty(scatters, (joint,)).values(np.array([[0.25, 0.2, 0.6, 0.9]]))[0]
    together = np.array([-3.0, 1.0, 3.5]) + joint.root @ stats.norm.ppf([0.9, 0.2, 0.6])
    assert found == pytest.approx([1.5, together[1], together[2], together[0]])
    assert Uncertainty(()).values(np.zeros((3, 0))).shape == (3, 0)
