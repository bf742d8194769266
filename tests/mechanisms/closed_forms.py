"""Answers that follow on paper, with mpmath: nothing here knows of the engine or of the brute force."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath
from mpmath import mp, mpf


def den_hartog_amplitude(frequency_ratio, force_ratio) -> mpf:
    """Return x k / P of ``m x'' + k x + F sgn x' = P cos(omega t)`` that moves without stops.

    Den Hartog, Trans. ASME 53 (1931) APM-107.

    Args:
        frequency_ratio: omega / omega_0.
        force_ratio: F / P.
    """
    r, b = mpf(frequency_ratio), mpf(force_ratio)
    magnification = 1 / (1 - r**2)
    loss = mpmath.sin(mp.pi / r) / (r * (1 + mpmath.cos(mp.pi / r)))
    return mpmath.sqrt(magnification**2 - (b * loss) ** 2)


@dataclass(frozen=True)
class StickSlip:
    """Stick-slip of a block that a spring holds on a belt: half of peak to peak and durations."""

    amplitude: mpf
    slip: mpf
    stick: mpf

    @property
    def period(self) -> mpf:
        return self.slip + self.stick


def block_on_belt(mass, stiffness, static, kinetic, speed) -> StickSlip:
    """Return the motion: a circle about kinetic / stiffness in the phase plane, cut off by stick."""
    omega = mpmath.sqrt(mpf(stiffness) / mass)
    excess, fast = (mpf(static) - kinetic) / stiffness, speed / omega
    return StickSlip(
        mpmath.sqrt(excess**2 + fast**2),
        2 * (mp.pi - mpmath.atan2(excess, fast)) / omega,
        2 * excess / speed,
    )


def rebound_ratio(damping_ratio) -> mpf:
    """Return rebound over approach speed at a Kelvin-Voigt wall that cannot pull."""
    zeta = mpf(damping_ratio)
    eta = mpmath.sqrt(1 - zeta**2)
    return mpmath.exp(-zeta / eta * mpmath.atan2(2 * zeta * eta, 2 * zeta**2 - 1))


def flight(displacement, velocity, force, mass, time) -> mpf:
    """Return the displacement of a free body under a constant force."""
    return mpf(displacement) + mpf(velocity) * time + mpf(force) / mass * mpf(time) ** 2 / 2


def steady_state(masses, damping, stiffness, forces, omega) -> mpmath.matrix:
    """Return complex amplitudes X of displacements Im(X exp(i omega t)) for forces Im(F exp(i omega t))."""
    dynamic = mpmath.matrix(stiffness) + 1j * omega * mpmath.matrix(damping)
    for place, mass in enumerate(masses):
        dynamic[place, place] -= mpf(omega) ** 2 * mass
    return mpmath.lu_solve(dynamic, mpmath.matrix(forces))


def grazing_omega(masses, damping, stiffness, forces, reach, near) -> mpf:
    """Return the omega near one given at which the steady amplitude of a body has a value.

    Args:
        masses: Of the bodies.
        damping: Matrix.
        stiffness: Matrix.
        forces: Amplitudes, as a function of omega.
        reach: Number of the body and the amplitude at which it just touches.
        near: A guess.
    """
    body, amplitude = reach

    def beyond(omega):
        return abs(steady_state(masses, damping, stiffness, forces(omega), omega)[body]) - amplitude

    return mpmath.findroot(beyond, near)
