"""The common base of friction-, inertia- and viscous-controlled backlash."""

from abc import abstractmethod
from dataclasses import dataclass

import numpy as np

from trimmer.arguments import positive_number
from trimmer.arrays import Complexes, Reals
from trimmer.elements.backlashes.backlash_bounds import BacklashBox
from trimmer.elements.backlashes.backlash_motion import (
    SLOPE_BY_RATIO,
    BacklashMotion,
    complex_of,
    fundamental,
    position,
    slope_by_ratio,
)
from trimmer.elements.backlashes.contact_equation import largest_ratio, relative_velocity, steady_motion
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion
from trimmer.elements.small_arguments import SMALL

NODES, WEIGHTS = np.polynomial.legendre.leggauss(20)
"""Gauss-Legendre quadrature for a flight of at most half a period at gamma >= 1."""
_TOGETHER = 4096  # Entries whose nodes are evaluated together: few enough for the processor's cache
NODES_BESIDE_HARMONIC = 14
"""Nodes for a quarter of the pin's period; each multiple of the fundamental takes one more."""


@dataclass(frozen=True)
class Backlash(Element):
    """Backlash in front of a load M v' + D v = 0 with u = gap / amplitude; N is a number (m/m).

    Raises:
        ValueError: if the gap is not positive and finite.
    """

    gap: float  # Total clearance, > 0, in the unit of the input (m)

    def __post_init__(self) -> None:
        positive_number("gap", self.gap, "m")

    @property
    def amplitude_scale(self) -> float:
        """The gap, in the unit of the input (m): N depends on gap/amplitude alone."""
        return self.gap

    @abstractmethod
    def gamma(self, omega: Reals) -> Reals:
        """Return omega M/D, a number, at each omega (rad/s, any shape), limited to ``GAMMA_LIMITS``."""

    def _domain(self, omega: Reals) -> Reals | float:
        """Return the largest gap/amplitude, (2 + gamma² (1 - exp(-π/gamma))) / sqrt(1 + gamma²)."""
        return largest_ratio(self.gamma(omega))

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Return 2/π, which is |dN/du| everywhere, and a bound that follows from the longest flight."""
        dependent = self.depends_on_frequency
        return SLOPE_BY_RATIO, self._box(u, omega).slope_by_log_gamma() if dependent else 0.0

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Return bounds that follow from the range of the impact's phase."""
        box = self._box(u, omega)
        by_log_gamma = box.change_of_slope_by_log_gamma() if self.depends_on_frequency else 0.0
        return box.change_of_slope_by_ratio(), by_log_gamma

    def _mean_gain(self, amplitude: Reals) -> float:
        """Return 1: the load follows the mean of the pin, wherever that is."""
        return 1.0

    def _box(self, u: Limits, omega: Limits) -> BacklashBox:
        # Both impacts in one go: the solver takes little longer for them than for one.
        ratios, omegas = np.concatenate(u), np.concatenate(omega[::-1])
        earliest, latest = self._motion(self.gap / ratios, omegas).impact_phase.reshape(2, -1)
        highest_gamma, lowest_gamma = self.gamma(omegas).reshape(2, -1)
        return BacklashBox(lowest_gamma, highest_gamma, earliest, latest)

    def _motion(self, amplitude: Reals, omega: Reals) -> BacklashMotion:
        """Find the steady motion at arrays of one dimension and equal size; NaN where there is none."""
        return steady_motion(self.gap, amplitude, self.gamma(omega))

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        motion = self._motion(amplitude, omega)
        return fundamental(motion) if harmonic == 1 else harmonic_of(motion, harmonic)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return position(self._motion(amplitude, omega), phase, amplitude, self.gap)

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        motion = self._motion(amplitude, omega)
        by_u = slope_by_ratio(motion)
        by_log_omega = slope_by_log_gamma(motion) if self.depends_on_frequency else 0.0 * by_u
        return Expansion(fundamental(motion), by_u, by_log_omega)


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


def harmonic_of(motion: BacklashMotion, harmonic: int) -> Complexes:
    """Evaluate N_n for odd n >= 3, in the shape of the motion's arrays; NaN where there is no motion.

    By partial integration N_n = 2/(π n) ∫ y'(θ)/A exp(-jnθ) dθ over half a period. The pin's own velocity
    gives nothing, so the relative velocity in flight counts, cos θ_s exp(-t/gamma) - cos(θ_s + t). Its
    first term is integrated in closed form, its second by quadrature over the shorter one of flight and
    contact, and both together where the flight is so short that they nearly cancel. So the relative error
    stays near rounding at both edges of the domain.
    """
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
