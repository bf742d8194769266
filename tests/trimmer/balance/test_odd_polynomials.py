"""Where a signal of odd harmonics changes its sign."""

import numpy as np
import pytest

from trimmer.balance.many_harmonics.trigonometric import OddPolynomial, sign_changes


@pytest.mark.parametrize("derivative", [0, 1, 2])
@pytest.mark.parametrize("coefficients", [[1], [1, 0.2], [-1, 0.3], [0.3, 1], [0.1, 0.2, -0.4], [1j, 0.7j]])
def test_a_turned_signal_changes_its_sign_as_often(coefficients: list[complex], derivative: int) -> None:
    """Turning by a third of pi moves all changes, those that stood exactly at phase 0 too."""
    still = np.array(coefficients, dtype=complex)
    turned = still * np.exp(1j * np.pi / 3 * (2 * np.arange(still.size) + 1))
    moved = sorted((place + np.pi / 3) % np.pi for place in sign_changes(OddPolynomial(turned), derivative))
    found = sign_changes(OddPolynomial(still), derivative)
    assert len(found) == len(moved) and len(found) % 2 == 1
    away = np.subtract.outer(found, moved)
    np.testing.assert_allclose(np.abs(away - np.pi * np.round(away / np.pi)).min(axis=1), 0.0, atol=1e-9)
