"""Periodic motions return to themselves by brute force, with the multipliers of finite differences."""

import numpy as np
import pytest

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.differences import monodromy, once_around
from tests.mechanisms.dynamics import System
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from trimmer import Body, Force, Friction, Link, Mechanism, forced_orbit
from trimmer.response import MechanismOrbit

# Seeds of mechanisms that settle, and the drive periods after which they repeat.
SETTLING = {
    98: 1,
    **dict.fromkeys((4, 11, 15, 27, 38, 51, 58, 66, 78, 84, 96, 107, 121, 136, 158, 170, 196, 245), 1),
    **dict.fromkeys((68, 116), 2),
    25: 3,
}


def sorted_by_size(values: np.ndarray) -> np.ndarray:
    return values[np.lexsort((values.imag, values.real, -np.round(np.abs(values), 6)))]


def held_against_differences(mechanism: Mechanism, periods: int) -> MechanismOrbit:
    """Return what a mechanism settles to, one repetition of it."""
    system, orbit = System(mechanism), forced_orbit(mechanism, settling=200, periods=periods)
    size = system.rows.state_size
    state, usual = orbit.instant.state[:size], system.usual[:size]
    around = once_around(BruteForce(), system, state, periods).final
    assert np.max(np.abs(around - state) / usual) < 1e-9
    exact = sorted_by_size(orbit.multipliers)
    left = sorted_by_size(np.linalg.eigvals(monodromy(BruteForce(), system, state, periods))).tolist()
    for value in exact:
        nearest = min(left, key=lambda other, value=value: abs(other - value))
        assert abs(nearest - value) < 2e-6
        left.remove(nearest)
    return orbit


def test_stick_takes_a_dimension_from_a_driven_orbit() -> None:
    """While the first block is held its velocity is lost: one multiplier is 0, the rest as of differences."""
    made = Mechanism(
        bodies={"first": Body(1.0), "second": Body(2.0)},
        links={"wall": Link(("ground", "first"), 40.0, 0.3), "between": Link(("first", "second"), 25.0, 0.2)},
        frictions={"floor": Friction(("ground", "first"), 1.0, 1.3)},
        forces={"push": Force("second", 0.0, 3.0)},
        frequency=0.3,
    )
    orbit = held_against_differences(made, 1)
    assert orbit.measures.frictions["floor"].stick > 0.1
    sizes = np.sort(abs(orbit.multipliers))
    assert sizes[0] < 1e-14 < 0.1 < sizes[1]


@pytest.mark.parametrize(("seed", "periods"), quick(SETTLING.items(), 0))
def test_the_multipliers_of_a_periodic_motion(seed, periods):
    held_against_differences(random_mechanism(seed), periods)
