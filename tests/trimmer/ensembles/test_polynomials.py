from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from trimmer.ensembles.polynomials import on_axis, roots, value_and_slope


def random(seed: int, count: int, degree: int) -> np.ndarray:
    coefficients = np.random.default_rng(seed).normal(size=(count, degree + 1))
    coefficients[:, 0] = 1.0
    return coefficients


@given(st.integers(0, 2**32), st.integers(1, 9))
def test_values_are_those_of_numpy(seed: int, degree: int) -> None:
    rows, omegas = random(seed, 3, degree), np.linspace(0.1, 3.0, 6)
    for row, value in zip(rows, on_axis(rows, np.repeat(omegas[None], 3, axis=0)), strict=True):
        np.testing.assert_allclose(value, np.polyval(row, 1j * omegas), rtol=1e-10, atol=1e-12)
    s = np.array([0.3 + 1j, -2.0, 1j])
    value, slope = value_and_slope(rows.astype(complex), s)
    for at in range(3):
        np.testing.assert_allclose(value[at], np.polyval(rows[at], s[at]), atol=1e-10)
        np.testing.assert_allclose(slope[at], np.polyval(np.polyder(rows[at]), s[at]), atol=1e-10)


@given(st.integers(0, 2**32), st.integers(2, 9))
def test_roots_are_those_of_the_companion_matrix(seed: int, degree: int) -> None:
    rows = random(seed, 4, degree)
    start = np.repeat((0.7 * np.exp(1j * (0.3 + 2 * np.pi * np.arange(degree) / degree)))[None], 4, axis=0)
    values, found = roots(rows, start)
    for row, ours, sure in zip(rows, values, found, strict=True):
        if sure:
            # Sums and products of roots tell a missing one, even where single roots are ill-conditioned.
            np.testing.assert_allclose(np.poly(ours), row, rtol=1e-6, atol=1e-8)
    assert found.all()


def test_what_is_not_found_is_said() -> None:
    values, found = roots(np.array([[1.0, -2.0, 1.0]]), np.array([[np.nan, 2.0]], dtype=complex))
    assert values.shape == (1, 2)
    assert not found.any()
