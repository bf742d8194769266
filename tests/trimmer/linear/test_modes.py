import dataclasses
import math

import control
import numpy as np
import pytest
from hypothesis import given, settings

from tests.trimmer.trimmers import trimmers
from trimmer import TrimmerParameters, linear_model, modes
from trimmer.generated import linear_trimmer
from trimmer.linear import undamped_modes

THESIS = TrimmerParameters.thesis()


def test_frequencies_and_damping_ratios_are_those_of_python_control() -> None:
    natural, ratios, poles = control.damp(linear_model(THESIS), doprint=False)
    upper = poles.imag > 0
    order = np.argsort(natural[upper])
    found = modes(THESIS)
    np.testing.assert_allclose([m.omega_natural for m in found], natural[upper][order], rtol=1e-12)
    np.testing.assert_allclose([m.damping_ratio for m in found], ratios[upper][order], rtol=1e-10)
    np.testing.assert_allclose([m.omega_damped for m in found], poles[upper][order].imag, rtol=1e-12)
    np.testing.assert_allclose([m.frequency for m in found], poles[upper][order].imag / math.tau, rtol=1e-12)


@settings(max_examples=10)
@given(trimmers())
def test_shapes_solve_the_equation_of_motion(parameters: TrimmerParameters) -> None:
    M, C, K = (
        np.array(getattr(linear_trimmer, name)(*parameters.values()))
        for name in ("mass_matrix", "damping_matrix", "stiffness_matrix")
    )
    for mode in modes(parameters):
        s, shape = mode.eigenvalue, np.array(mode.shape)
        terms = np.abs(s**2 * M) + np.abs(s * C) + np.abs(K)
        residual = (s**2 * M + s * C + K) @ shape
        assert np.abs(residual).max() <= 1e-9 * (terms @ np.abs(shape)).max()
        assert np.abs(shape).max() == pytest.approx(1.0, abs=1e-15)
        assert 1.0 in mode.shape


@settings(max_examples=10)
@given(trimmers())
def test_modes_are_ordered_and_account_for_all_eigenvalues(parameters: TrimmerParameters) -> None:
    found = modes(parameters)
    assert [m.omega_natural for m in found] == sorted(m.omega_natural for m in found)
    assert sum(1 if m.omega_damped == 0 else 2 for m in found) == 8
    product = math.prod(m.omega_natural if m.omega_damped == 0 else m.omega_natural**2 for m in found)
    constant = linear_trimmer.characteristic_polynomial(*parameters.values())[-1]
    assert product == pytest.approx(constant, rel=1e-8)


def test_an_overdamped_oscillator_is_two_modes_that_do_not_oscillate() -> None:
    # With the bridge open the motor stands alone: m s^2 + c s + k has the roots -1 and -3 1/s.
    alone = dataclasses.replace(THESIS, m1=1.0, k1=3.0, c1=4.0, k2=0.0, c2=0.0)
    slow, fast = (m for m in modes(alone) if m.omega_damped == 0)
    assert (slow.eigenvalue, fast.eigenvalue) == (pytest.approx(-1.0), pytest.approx(-3.0))
    for mode in (slow, fast):
        assert (mode.damping_ratio, mode.frequency) == (1.0, 0.0)
        assert mode.shape == pytest.approx((1, 0, 0, 0), abs=1e-9)


def test_a_drift_has_no_damping_ratio() -> None:
    drifting = dataclasses.replace(THESIS, k1=0.0, c1=1.0, k2=0.0, c2=0.0)
    drift = modes(drifting)[0]
    assert drift.eigenvalue == 0
    assert drift.damping_ratio == 0.0


def test_undamped_frequencies_are_those_of_damping_that_vanishes() -> None:
    lightly = dataclasses.replace(THESIS, c1=0.0, c2=0.0, c3=0.0, c4=0.0)
    for damped, undamped in zip(modes(lightly), undamped_modes(THESIS), strict=True):
        assert damped.omega_damped == pytest.approx(undamped.omega, rel=1e-12)
        assert damped.shape == pytest.approx(undamped.shape, abs=1e-8)


@settings(max_examples=10)
@given(trimmers())
def test_undamped_shapes_are_orthogonal_in_mass_and_stiffness(parameters: TrimmerParameters) -> None:
    found = undamped_modes(parameters)
    shapes = np.array([mode.shape for mode in found])
    for name in ("mass_matrix", "stiffness_matrix"):
        gram = shapes @ np.array(getattr(linear_trimmer, name)(*parameters.values())) @ shapes.T
        scale = np.sqrt(np.outer(np.diag(gram), np.diag(gram)))
        np.testing.assert_allclose(gram / scale, np.eye(4), atol=1e-8)
    assert [mode.omega for mode in found] == sorted(mode.omega for mode in found)


def test_a_free_trimmer_has_an_undamped_mode_of_frequency_zero() -> None:
    free = dataclasses.replace(THESIS, k1=0.0, k3=0.0)
    rigid = undamped_modes(free)[0]
    assert rigid.omega == pytest.approx(0.0, abs=1e-3)
    assert rigid.shape == pytest.approx((1, 1, 1, 1), rel=1e-6)


def test_without_springs_bodies_drift_or_creep_and_are_in_order() -> None:
    loose = dataclasses.replace(THESIS, **dict.fromkeys(("k1", "k2", "k3", "k4", "k5"), 0.0))
    found = modes(loose)
    assert len(found) == 8
    assert all(mode.omega_damped == 0 for mode in found)
    sizes = [mode.omega_natural for mode in found]
    assert sizes == sorted(sizes)
    assert found[-1].damping_ratio == pytest.approx(1.0)
    exact = np.linalg.eigvals(linear_model(loose).A)
    assert sizes[4:] == pytest.approx(np.sort(np.abs(exact))[4:], rel=1e-9)
