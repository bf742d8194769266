"""Derivative of backlash's describing function by frequency, that is, by ln gamma with gamma = omega M/D."""

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.elements.backlashes.backlash_motion import BacklashMotion, complex_of

NODES, WEIGHTS = np.polynomial.legendre.leggauss(20)
"""Gauss-Legendre quadrature for a flight of at most half a period at gamma >= 1."""

_TOGETHER = 4096  # Entries whose nodes are evaluated together: few enough for the processor's cache


def slope_by_log_gamma(motion: BacklashMotion) -> Complexes:
    """Evaluate dN_1/d(ln gamma) at constant g/A, in the shape (n,) of the motion's arrays.

    At a fixed phase θ_s + s of the flight, the derivative of y/A by ln gamma is cos θ_s times
    k(s) = gamma (1 - exp(-s/gamma)) - s exp(-s/gamma): the changes of θ_s cancel, because position,
    velocity and acceleration are continuous there. The flight's end does not count either, as the position is
    continuous. So dN/d(ln gamma) = 2j/π cos θ_s exp(-jθ_s) ∫ k(s) exp(-js) ds over the flight.
    """
    slow = motion.gamma < 1.0
    fast = ~slow
    integral = np.empty(motion.flight.shape, dtype=complex)
    integral[slow] = _closed_form(motion.gamma[slow], motion.flight[slow])
    integral[fast] = _quadrature(motion.gamma[fast], motion.flight[fast])
    integral *= (2.0 / np.pi) * motion.cosine * complex_of(motion.sine, motion.cosine)
    return integral


def _closed_form(gamma: Reals, flight: Reals) -> Complexes:
    """Integrate k(s) exp(-js); the rounding error grows with gamma."""
    rate = 1.0 / gamma + 1j
    decayed = np.exp(-rate * flight)
    turning = (1.0 - np.exp(-1j * flight)) / 1j
    decaying = (1.0 - decayed) / rate
    return np.asarray(gamma * (turning - decaying) - (decaying - flight * decayed) / rate)


def _quadrature(gamma: Reals, flight: Reals) -> Complexes:
    """Integrate k(s) exp(-js) by a rule that is exact to rounding for gamma >= 1."""
    total = np.empty(flight.shape, dtype=complex)
    for start in range(0, flight.size, _TOGETHER):
        block = slice(start, start + _TOGETHER)
        angle = 0.5 * (1.0 + NODES[:, None]) * flight[block]
        decay = angle / gamma[block]
        slope = gamma[block] * -np.expm1(-decay) - angle * np.exp(-decay)
        total[block] = 0.5 * flight[block] * (WEIGHTS[:, None] * slope * np.exp(-1j * angle)).sum(axis=0)
    return total
