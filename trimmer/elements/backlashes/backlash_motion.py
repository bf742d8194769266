"""The steady motion of a load behind a backlash, with its waveform and its first harmonic.

The pin moves as A sin θ; the load M v' + D v = 0 lies in a gap g, with gamma = omega M/D. It is pushed along
y = A sin θ - g/2 up to the separation phase θ_s = atan(1/gamma), where the contact would have to pull; flies
freely for the angle ``flight`` until it meets the other side, y = A sin θ + g/2; impact is plastic, and it is
pushed for the angle ``contact`` = π - ``flight`` to the separation on that side, θ_s + π. The symbolic
derivation is in derivations/elements/backlash.py; Gelb and Vander Velde (1968) treat the two limits.
"""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.elements.small_arguments import argument_less_sine, damped_excess_of_sinh

GAMMA_LIMITS = (1e-150, 1e150)
"""Beyond these gamma, the motion equals friction- or inertia-controlled backlash in double precision."""

SLOPE_BY_RATIO = 2.0 / np.pi  # Modulus of dN/d(g/A) of the first harmonic, at any g/A and gamma


@dataclass(frozen=True)
class BacklashMotion:
    """A steady motion per entry of the arrays, all of the same shape; NaN where there is none."""

    gamma: Reals  # omega M/D, within ``GAMMA_LIMITS``
    cosine: Reals  # cos θ_s, which is also the load's velocity at separation over A omega
    sine: Reals  # sin θ_s
    flight: Reals  # Angle of free flight, rad
    contact: Reals  # Angle of contact, π - flight, rad, to full relative precision where it is small
    impact: Reals  # Velocity of the load relative to the pin at the impact, over A omega

    @property
    def impact_phase(self) -> Reals:
        """Phase of the pin at the impact, θ_s + flight, rad."""
        return np.arctan2(self.sine, self.cosine) + self.flight


def separation(gamma: Reals) -> tuple[Reals, Reals]:
    """Return cos θ_s and sin θ_s at θ_s = atan(1/gamma), in the shape of gamma."""
    root = np.sqrt(1.0 + gamma**2)
    return gamma / root, 1.0 / root


def position(motion: BacklashMotion, phase: Reals, amplitude: Reals, gap: float) -> Reals:
    """Evaluate the load's position at phases of the pin, rad, in the amplitude's unit; NaN without motion."""
    after_separation = np.mod(phase - np.arctan2(motion.sine, motion.cosine), 2.0 * np.pi)
    rising = after_separation < np.pi
    elapsed = np.where(rising, after_separation, after_separation - np.pi)
    travel = motion.cosine * motion.gamma * -np.expm1(-elapsed / motion.gamma)
    flying = np.where(rising, 1.0, -1.0) * (amplitude * (motion.sine + travel) - 0.5 * gap)
    pushed = amplitude * np.sin(phase) + np.where(rising, 0.5, -0.5) * gap
    return np.where(np.isnan(motion.flight), np.nan, np.where(elapsed < motion.flight, flying, pushed))


def fundamental(motion: BacklashMotion) -> Complexes:
    """Evaluate N_1, in the shape of the motion's arrays.

    Every term of the real and of the imaginary part has one sign, so no digits cancel.

    With v the relative velocity of impact, c = cos θ_s, E = exp(-flight/gamma) and l = contact:
    π Re N = l - sin l + 2 sin l (c² E + cos²(θ_s - l/2)),
    -π Im N = v² + 2 c² E (sinh(flight/gamma) - sin(flight)/gamma); the first term is the work lost in the
    impact, the second the work of the damping less what it would have been in contact.
    """
    cosine, sine, contact, flight = motion.cosine, motion.sine, motion.contact, motion.flight
    decay = np.exp(-flight / motion.gamma)
    middle = cosine * np.cos(0.5 * contact) + sine * np.sin(0.5 * contact)
    sine_of_contact = np.sin(np.minimum(contact, flight))
    real = argument_less_sine(contact) + 2.0 * sine_of_contact * (cosine**2 * decay + middle**2)
    damping = cosine**2 * damped_excess_of_sinh(flight / motion.gamma)
    damping += 2.0 * cosine * sine * decay * argument_less_sine(flight)
    return complex_of(real / np.pi, -(motion.impact**2 + damping) / np.pi)


def slope_by_ratio(motion: BacklashMotion) -> Complexes:
    """Evaluate dN_1/d(g/A) = (2/π) exp(-j impact phase) at constant omega, in the shape of the arrays."""
    return np.asarray(SLOPE_BY_RATIO * np.exp(-1j * motion.impact_phase))


def complex_of(real: Reals, imaginary: Reals) -> Complexes:
    """Return complex numbers from real and imaginary parts of equal shape, without the cost of a sum."""
    values = np.empty(real.shape, dtype=complex)
    values.real, values.imag = real, imaginary
    return values
