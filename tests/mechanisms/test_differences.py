"""Multipliers by finite differences where they are known on paper."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.mechanisms import cases
from tests.mechanisms.brute_force import BruteForce, start_state
from tests.mechanisms.differences import monodromy, multipliers, once_around
from tests.mechanisms.dynamics import System


def test_a_linear_oscillator():
    system = System(cases.driven_oscillator({}, {}))
    found = multipliers(monodromy(BruteForce(), system, start_state(system), step=1e-2))
    exponent = complex(-0.125, math.sqrt(4 - 0.125**2))
    exact = np.exp(exponent * 2 * math.pi / 3)
    np.testing.assert_allclose(found[np.argmin(found.imag)], exact, atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(("ratio", "force"), [(0.7, 0.2)])
def test_dry_friction_damps_as_the_saltation_at_reversals_says(ratio, force):
    """The determinant is the product of the ratios of accelerations at the two reversals."""
    system = System(cases.den_hartog(ratio, force))
    state = np.array(start_state(system))
    for _ in range(40):
        state = once_around(BruteForce(1e-10), system, state).final
    motion = once_around(BruteForce(), system, state)
    jacobian = monodromy(BruteForce(), system, state)
    wanted = 1.0
    for event in motion.events:
        before, after = motion.accelerations(np.array([event.time - 1e-9, event.time + 1e-9]))[:, 0]
        wanted *= after / before
    assert np.linalg.det(jacobian) == pytest.approx(wanted, rel=1e-6)
