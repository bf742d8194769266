"""Flights of the load behind a backlash that are so short that the equations as written lose their digits.

Valid for flights t <= SMALL, rad, and t/gamma <= SMALL; notation of contact_equation.py, with x = t/gamma. To
first order g/A is c (1 + 1/gamma²) t³/6, while its terms are of the order of t.
"""

import numpy as np

from trimmer.arrays import Reals
from trimmer.elements.small_arguments import (
    SMALL,
    cosine_remainder,
    decay_integral_remainder,
    decay_remainder,
    sine_remainder,
)


def short_residual(flight: Reals, ratio: Reals, gamma: Reals, cosine: Reals) -> tuple[Reals, Reals, Reals]:
    """Evaluate g/A of a short flight less a given ratio, and its first and second derivative by the flight.

    All arrays have shape (n,); the flight is in rad.
    """
    t, x = _limited(flight, gamma)
    braking = x**2 * t * decay_integral_remainder(x)
    turning = t**3 * sine_remainder(t) - x * t**3 * cosine_remainder(t)
    curvature = np.sin(t) + (np.cos(t) - np.exp(-x)) / gamma
    return cosine * (braking + turning) - ratio, relative_velocity(flight, gamma, cosine), cosine * curvature


def relative_velocity(flight: Reals, gamma: Reals, cosine: Reals) -> Reals:
    """Evaluate the load's velocity less the pin's over A omega, c (exp(-x) - cos t + sin t / gamma).

    All arrays have shape (n,); the flight is in rad.
    """
    t, x = _limited(flight, gamma)
    braking = x**2 * decay_remainder(x)
    turning = t**2 * (0.5 - t**2 * cosine_remainder(t)) - x * t**2 * sine_remainder(t)
    return cosine * (braking + turning)


def _limited(flight: Reals, gamma: Reals) -> tuple[Reals, Reals]:
    """Return t and t/gamma, limited to where the series hold (callers use no other entries)."""
    return np.minimum(flight, SMALL), np.minimum(flight / gamma, SMALL)
