"""Solve for the flight of the load behind a backlash: it ends where the load meets the other side.

With gamma = omega M/D, c = cos θ_s and s = sin θ_s at the separation phase atan(1/gamma), a flight of t takes
g/A = c gamma (1 - exp(-t/gamma)) - c sin t + s (1 - cos t). Its derivative is the relative velocity, positive
on (0, π), so there is one flight for each g/A up to that of t = π. The equation is solved for t up to a
quarter period, where it is convex, and beyond it for the contact π - t, from the distance to the largest g/A.

Flights of t <= SMALL and x = t/gamma <= SMALL, rad, have series of their own: to first order g/A is
c (1 + 1/gamma²) t³/6, while its terms as written are of the order of t, and lose their digits.
"""

from collections.abc import Callable

import numpy as np

from trimmer.arrays import Reals
from trimmer.elements.backlashes.backlash_motion import BacklashMotion, separation
from trimmer.elements.small_arguments import (
    SMALL,
    cosine_remainder,
    decay_integral_remainder,
    decay_remainder,
    sine_remainder,
)

Residual = tuple[Reals, Reals, Reals]

STEPS = 3  # Halley steps that take every starting value below to rounding; a test covers all gamma and g/A
QUARTER = 0.5 * np.pi
_LARGEST_AMPLITUDE = 1e200
"""Amplitude over gap beyond which powers of the flight underflow; N is 1 there in double precision."""


def steady_motion(gap: float, amplitude: Reals, gamma: Reals) -> BacklashMotion:
    """Find the steady motion at amplitudes and gammas within ``GAMMA_LIMITS``, (n,); NaN where none is."""
    cosine, sine = separation(gamma)
    finite = np.minimum(amplitude, _LARGEST_AMPLITUDE * gap)
    ratio = gap / finite
    margin = _margin(2.0 * ((finite - 0.5 * gap) / finite), ratio, gamma)
    shortest = _flight_residual(SMALL * np.minimum(1.0, gamma), 0.0, gamma, cosine, sine)[0]
    longest = cosine * (gamma * -np.expm1(-QUARTER / gamma) - 1.0) + sine
    short = ratio < shortest
    medium = ~short & (ratio <= longest)
    brief_contact = ~short & ~medium & (margin > 0)
    flight, contact, impact = (np.full(ratio.shape, np.nan) for _ in range(3))
    for group, equation, known in (
        (short, _short_flight, ratio),
        (medium, _medium_flight, ratio),
        (brief_contact, _brief_contact, margin),
    ):
        if not group.any():
            continue
        given = (known[group], gamma[group], cosine[group], sine[group])
        flight[group], contact[group], impact[group] = equation(*given)
    return BacklashMotion(gamma, cosine, sine, flight, contact, impact)


def largest_ratio(gamma: Reals) -> Reals:
    """Return the g/A of a flight of half a period, (2 + gamma² (1 - exp(-π/gamma))) / sqrt(1 + gamma²).

    It has the shape of gamma.
    """
    cosine, sine = separation(gamma)
    return np.asarray(2.0 * sine - cosine * gamma * np.expm1(-np.pi / gamma))


def _margin(friction_margin: Reals, ratio: Reals, gamma: Reals) -> Reals:
    """Return the largest g/A less g/A; ``friction_margin`` is 2 - g/A without the rounding of g/A.

    For small gamma N is small near the edge of the domain, so the difference needs its relative precision.
    """
    root = np.sqrt(1.0 + gamma**2)
    beyond_friction = gamma**2 * ((gamma / (1.0 + root)) ** 2 - np.exp(-np.pi / gamma)) / root
    return np.where(gamma < 1.0, friction_margin + beyond_friction, largest_ratio(gamma) - ratio)


def _short_flight(ratio: Reals, gamma: Reals, cosine: Reals, sine: Reals) -> Residual:
    """Solve where neither the flight nor the flight over gamma exceeds ``SMALL``."""
    cubic = np.cbrt(6.0 * ratio * cosine)
    flight, impact = _halley(
        lambda t: short_residual(t, ratio, gamma, cosine), cubic * (1.0 + cubic / (12.0 * gamma))
    )
    return flight, np.pi - flight, impact


def _medium_flight(ratio: Reals, gamma: Reals, cosine: Reals, sine: Reals) -> Residual:
    """Solve up to a quarter period, from the limits for a short and a long flight over gamma."""
    inertial = np.cbrt(6.0 * ratio * cosine)
    resting = gamma + np.sqrt(np.maximum(2.0 * ratio / sine - gamma**2, 0.0))
    start = np.where(2.0 * ratio > sine * gamma**2, np.maximum(inertial, resting), inertial)
    flight, impact = _halley(
        lambda t: _flight_residual(t, ratio, gamma, cosine, sine), np.minimum(start, QUARTER)
    )
    return flight, np.pi - flight, impact


def _brief_contact(margin: Reals, gamma: Reals, cosine: Reals, sine: Reals) -> Residual:
    """Solve beyond a quarter period for the contact, from its quadratic at zero."""
    linear = cosine * (1.0 + np.exp(-np.pi / gamma))
    start = 2.0 * margin / (linear + np.sqrt(linear**2 + 2.0 * sine * margin))
    contact, impact = _halley(
        lambda angle: _contact_residual(angle, margin, gamma, cosine, sine), np.minimum(start, QUARTER)
    )
    return np.pi - contact, contact, impact


def _halley(residual: Callable[[Reals], Residual], start: Reals) -> tuple[Reals, Reals]:
    """Return the root and the residual's slope there; steps stay between 0 and a quarter period."""
    angle = start
    for _ in range(STEPS):
        value, slope, curvature = residual(angle)
        newton = np.where(slope > 0, value / slope, 0.0)
        following = np.clip(angle - newton / (1.0 - 0.5 * newton * curvature / slope), 0.0, QUARTER)
        slope += curvature * (following - angle)
        angle = following
    return angle, slope


def _flight_residual(t: Reals, ratio: Reals | float, gamma: Reals, cosine: Reals, sine: Reals) -> Residual:
    lost = np.expm1(-t / gamma)
    half_sine, half_cosine = np.sin(0.5 * t), np.cos(0.5 * t)
    sine_of_t, versine = 2.0 * half_sine * half_cosine, 2.0 * half_sine**2
    value = sine * versine - cosine * (gamma * lost + sine_of_t) - ratio
    slope = cosine * (lost + versine) + sine * sine_of_t
    return value, slope, cosine * sine_of_t - sine * (versine + lost)


def _contact_residual(angle: Reals, margin: Reals, gamma: Reals, cosine: Reals, sine: Reals) -> Residual:
    decay = np.exp((angle - np.pi) / gamma)
    half_sine, half_cosine = np.sin(0.5 * angle), np.cos(0.5 * angle)
    sine_of_angle, versine = 2.0 * half_sine * half_cosine, 2.0 * half_sine**2
    travel = gamma * cosine * decay * -np.expm1(-angle / gamma)
    value = cosine * sine_of_angle + sine * versine + travel - margin
    slope = cosine * (decay + 1.0 - versine) + sine * sine_of_angle
    return value, slope, sine * (decay + 1.0 - versine) - cosine * sine_of_angle


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
