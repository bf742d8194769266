"""Describing functions by quadrature of the waveform in 40 digits, from mechanics only.

Nothing of trimmer is used: the load is pushed until the contact force vanishes, flies on by the solution of
gamma y'' + y' = 0, and the flight ends where bisection finds it at the other wall. N_n is then the integral
(2j/π) ∫ y exp(-jnθ) dθ over half a period, for A = 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import mpmath
from mpmath import mpc, mpf

DIGITS = 40


@dataclass(frozen=True)
class ExactBacklash:
    """Backlash for A = 1 with a total clearance ``ratio``; gamma = omega M/D may be 0 or infinite."""

    ratio: mpf
    gamma: mpf

    @classmethod
    def of(cls, amplitude: float, gamma: float) -> ExactBacklash:
        """Take exactly this amplitude, with a gap of 1, and exactly this gamma."""
        with mpmath.workdps(3 * DIGITS):
            return cls(1 / mpf(amplitude), mpf(gamma))

    def separation(self) -> mpf:
        return mpmath.pi / 2 if self.gamma == 0 else mpmath.atan(1 / self.gamma)

    def flight(self, elapsed: mpf) -> mpf:
        """Position after separation."""
        start = mpmath.sin(self.separation()) - self.ratio / 2
        if self.gamma == 0:
            return start
        velocity = mpmath.cos(self.separation())
        if self.gamma == mpmath.inf:
            return start + velocity * elapsed
        return start - velocity * self.gamma * mpmath.expm1(-elapsed / self.gamma)

    @cached_property
    def duration(self) -> mpf:
        """Length of the flight: the last bits come from bisection of the distance to the other wall."""
        separation = self.separation()

        def distance(elapsed: mpf) -> mpf:
            return mpmath.sin(separation + elapsed) + self.ratio / 2 - self.flight(elapsed)

        with mpmath.workdps(3 * DIGITS):
            shortest, longest = mpf(10) ** -30, +mpmath.pi
            while longest / shortest > 1.001:
                middle = mpmath.sqrt(shortest * longest)
                shortest, longest = (middle, longest) if distance(middle) > 0 else (shortest, middle)
            return mpmath.findroot(distance, (shortest, longest), solver="anderson", tol=mpf(10) ** -180)

    def describing_function(self, harmonic: int) -> mpc:
        with mpmath.workdps(DIGITS + 10):
            separation, duration = self.separation(), self.duration
            layers = [] if self.gamma in (0, mpmath.inf) else [self.gamma * 3**k for k in range(5)]
            cuts = sorted({mpf(0), duration / 2, duration, *(cut for cut in layers if cut < duration)})
            flight = mpmath.quad(
                lambda t: self.flight(t) * mpmath.expj(-harmonic * (separation + t)),
                cuts,
                method="gauss-legendre",
            )
            contact = mpmath.quad(
                lambda theta: (mpmath.sin(theta) + self.ratio / 2) * mpmath.expj(-harmonic * theta),
                [separation + duration, (2 * separation + duration + mpmath.pi) / 2, separation + mpmath.pi],
                method="gauss-legendre",
            )
            return 2j / mpmath.pi * (flight + contact)


def largest_ratio(gamma: mpf) -> mpf:
    """g/A at which the flight takes half a period."""
    with mpmath.workdps(DIGITS):
        start = ExactBacklash(mpf(0), gamma)
        return start.flight(mpmath.pi) + mpmath.sin(start.separation())
