"""Folds and period doublings of the definition's published examples, without any continuation code."""

from __future__ import annotations

import numpy as np
import pytest

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.differences import once_around
from tests.mechanisms.dynamics import System
from tests.mechanisms.special_points import (
    SpecialPoint,
    body_with_stop,
    dead_zone,
    orbit,
    special_point,
)

# Omega to the digits of the definition, a state near the orbit at t = 0, and the multiplier.
POINTS = {
    "period doubling": (body_with_stop, 5.5567187941, (9.379, 20.1047), -1.0),
    "second period doubling": (body_with_stop, 5.7079092816, (9.3283, 24.9095), -1.0),
    "fold": (body_with_stop, 8.566393659, (-10.87, 123.76), 1.0),
    "fold of the dead zone": (dead_zone, 0.7080316187, (1.0032, 0.2467), 1.0),
    "second fold of the dead zone": (dead_zone, 0.8284639844, (1.2122, 0.02869), 1.0),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", list(POINTS))
def test_the_point_has_the_digits_of_the_definition(name):
    at, printed, state, multiplier = POINTS[name]
    guess = SpecialPoint(printed * (1 + 1e-7), np.array(state))
    found = special_point(at, guess, multiplier, step=2e-5)
    assert found.omega == pytest.approx(printed, abs=6e-10 if printed > 8 else 6e-11)


def test_newton_finds_an_orbit_beside_a_fold():
    mechanism = dead_zone(0.82)
    state = orbit(mechanism, np.array([1.1963, 0.0198]))
    assert once_around(BruteForce(), System(mechanism), state).final == pytest.approx(state, abs=1e-11)
