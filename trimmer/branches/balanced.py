"""Multi-harmonic balance beside an exact orbit, and how far it is from it."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.branches.outputs import body_coefficients
from trimmer.harmonics.balance import harmonic_balance_of
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.course import Course


@dataclass(frozen=True, eq=False)
class BalancedOrbit:
    """The same orbit by multi-harmonic balance.

    Attributes:
        distance: Root mean square of the difference from the exact displacements, relative to those, of the
            body where it is largest; a number.
        converged: Whether the forces balance.
    """

    distance: float
    converged: bool


def balanced_beside(course: Course, mechanism: Mechanism, periods: int, harmonics: int) -> BalancedOrbit:
    """Balance the forces harmonic by harmonic from an exact orbit on.

    Args:
        course: The exact motion over its period.
        mechanism: The mechanism; it has a drive.
        periods: Drive periods that the motion lasts.
        harmonics: Harmonics of the drive up to which the forces balance.

    Raises:
        UnsupportedMotionError: if a spring leans on a pin that moves on.
    """
    exact = body_coefficients(course, periods, periods * harmonics)
    balance = harmonic_balance_of(mechanism, exact, periods)
    moved = course.nodes.states[:, : len(exact)] - exact[:, 0].real
    power = course.nodes.weights @ moved**2 / course.duration
    # What the exact motion has beyond the last harmonic is a part of the difference.
    beyond = np.maximum(power - _power(exact), 0.0)
    apart = _power(balance.coefficients - exact) + beyond
    distance = float(np.sqrt((apart / np.where(power > 0.0, power, 1.0)).max()))
    return BalancedOrbit(distance, balance.converged)


def _power(harmonics: Complexes) -> Reals:
    """Return the mean square of displacements without their mean, (bodies,)."""
    power: Reals = 0.5 * (abs(harmonics[:, 1:]) ** 2).sum(axis=1)
    return power
