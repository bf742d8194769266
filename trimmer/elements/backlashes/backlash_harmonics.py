"""Higher harmonics of backlash, from the velocity of the load relative to the pin.

By partial integration N_n = 2/(π n) ∫ y'(θ)/A exp(-jnθ) dθ over half a period. The pin's own velocity gives
nothing for odd n >= 3, so what counts is the relative velocity in flight, cos θ_s exp(-t/gamma) -
cos(θ_s + t). Its first term is integrated in closed form, its second by Gauss-Legendre quadrature over the
shorter one of flight and contact, and both together where the flight is so short that they nearly cancel. So
the relative error stays near rounding at both edges of the domain.
"""

import numpy as np

from trimmer.arrays import Complexes
from trimmer.elements.backlashes.backlash_motion import BacklashMotion
from trimmer.elements.backlashes.short_flight import relative_velocity
from trimmer.elements.small_arguments import SMALL

NODES_BESIDE_HARMONIC = 14
"""Nodes for a quarter of the pin's period; each multiple of the fundamental takes one more."""


def harmonic_of(motion: BacklashMotion, harmonic: int) -> Complexes:
    """Evaluate N_n for odd n >= 3, in the shape of the motion's arrays; NaN where there is no motion."""
    short = motion.flight < SMALL * np.minimum(1.0, motion.gamma)
    flying = motion.flight < motion.contact
    length = np.minimum(motion.flight, motion.contact)
    side = np.where(flying, 1.0, -1.0)
    rate = 1.0 / motion.gamma + 1j * harmonic
    decaying = -motion.cosine * np.expm1(-rate * motion.flight) / rate
    integral: Complexes = np.where(short, 0.0, decaying)
    nodes, weights = np.polynomial.legendre.leggauss(NODES_BESIDE_HARMONIC + harmonic)
    for node, weight in zip(nodes, weights, strict=True):
        angle = 0.5 * (1.0 + node) * length
        turning = motion.sine * np.sin(angle) - side * motion.cosine * np.cos(angle)
        velocity = np.where(short, relative_velocity(angle, motion.gamma, motion.cosine), turning)
        integral += 0.5 * weight * length * velocity * np.exp(-1j * harmonic * side * angle)
    at_separation = np.arctan2(motion.sine, motion.cosine)
    integral *= 2.0 / (np.pi * harmonic) * np.exp(-1j * harmonic * at_separation)
    return integral
