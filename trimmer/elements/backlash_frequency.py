"""How the describing function of backlash changes with frequency, that is, with gamma = omega M/D."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.elements.backlash_motion import complex_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.elements.backlash_motion import BacklashMotion

    Reals = NDArray[np.float64]
    Complexes = NDArray[np.complex128]

NODES = 20
"""Gauss-Legendre nodes for a flight of at most half a period at gamma >= 1."""


def slope_by_log_gamma(motion: BacklashMotion) -> Complexes:
    """Evaluate dN/d(ln gamma) of the first harmonic at constant g/A.

    At a fixed phase θ_s + s of the flight, the derivative of y/A by ln gamma is cos θ_s times
    k(s) = gamma (1 - exp(-s/gamma)) - s exp(-s/gamma): the changes of θ_s cancel, because position,
    velocity and acceleration are continuous there. The flight's end does not count either, as the position is
    continuous. So dN/d(ln gamma) = 2j/π cos θ_s exp(-jθ_s) ∫ k(s) exp(-js) ds over the flight.
    """
    integral = _quadrature(motion)
    slow = motion.gamma < 1.0
    integral[slow] = _closed_form(motion.gamma[slow], motion.flight[slow])
    integral *= (2.0 / np.pi) * motion.cosine * complex_of(motion.sine, motion.cosine)
    return integral


def _closed_form(gamma: Reals, flight: Reals) -> Complexes:
    """Integrate k(s) exp(-js); the rounding error grows with gamma."""
    rate = 1.0 / gamma + 1j
    decayed = np.exp(-rate * flight)
    turning = (1.0 - np.exp(-1j * flight)) / 1j
    decaying = (1.0 - decayed) / rate
    return np.asarray(gamma * (turning - decaying) - (decaying - flight * decayed) / rate)


def _quadrature(motion: BacklashMotion) -> Complexes:
    """Integrate k(s) exp(-js) by a rule that is exact to rounding for gamma >= 1."""
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    total = np.zeros(motion.flight.shape, dtype=complex)
    for node, weight in zip(nodes, weights, strict=True):
        angle = 0.5 * (1.0 + node) * motion.flight
        decay = angle / motion.gamma
        slope = motion.gamma * -np.expm1(-decay) - angle * np.exp(-decay)
        total += 0.5 * weight * slope * np.exp(-1j * angle)
    total *= motion.flight
    return total
