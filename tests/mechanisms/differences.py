"""The period map of a mechanism by brute force, and its Jacobian by finite differences."""

import numpy as np

from tests.mechanisms.brute_force import BruteForce, BruteMotion, extend, settle
from tests.mechanisms.decision import Judge
from tests.mechanisms.dynamics import System

# Of the fourth order: f'(0) = (8 (f(h) - f(-h)) - (f(2h) - f(-2h))) / 12 h.
STENCIL = ((1, 8.0), (-1, -8.0), (2, -1.0), (-2, 1.0))


def once_around(force: BruteForce, system: System, state: np.ndarray, periods: int = 1) -> BruteMotion:
    """Run a number of drive periods from time 0."""
    return force.run(system, state, 0.0, periods / system.mechanism.frequency)


def monodromy(
    force: BruteForce, system: System, state: np.ndarray, periods: int = 1, step: float = 1e-5
) -> np.ndarray:
    """Return the Jacobian of the period map in units of usual sizes.

    What the mode at time 0 holds fixed (a velocity in stick, z in contact) follows the other directions.

    Args:
        force: The integrator.
        system: What moves.
        state: A point of the orbit at time 0.
        periods: Drive periods of the orbit.
        step: Of the differences, in usual sizes; too large a one meets another sequence of events.
    """
    usual = system.usual[: system.rows.state_size]
    mode = Judge(system).decide(extend(system, state, 0.0)).mode
    columns = []
    for place, size in enumerate(usual):
        total = np.zeros(len(usual))
        for multiple, weight in STENCIL:
            moved = np.array(state, dtype=float)
            moved[place] += multiple * step * size
            moved = settle(system, mode, moved, 0.0)
            total += weight * once_around(force, system, moved, periods).final
        columns.append(total / (12 * step * usual))
    return np.array(columns).T
