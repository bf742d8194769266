"""Harmonics of backlash: from the waveform, in terms of the phases of separation and impact.

Half a period runs from the separation at φ_s over the free flight λ to the impact at φ_c = φ_s + λ, and over
the contact ℓ = π - λ to the next separation. Without inertia φ_s is π/2, without friction 0.
"""

from dataclasses import dataclass
from functools import cache

import sympy

from derivations import assumed
from derivations.elements.backlash import (
    CONTACT,
    GAMMA,
    GAP,
    SEPARATION,
    friction_waveform,
    general_waveform,
    inertia_waveform,
)
from derivations.elements.harmonics import odd_harmonic
from derivations.elements.waveform import Segment, Waveform
from derivations.symbols import A

FLIGHT = assumed.positive("lambda")  # Angle of free flight, rad
CONTACT_ANGLE = assumed.positive("ell")  # Angle of contact, π - λ, rad
DECAY = assumed.positive("E")
"""exp(-λ/γ): what is left at the impact of the load's velocity at separation."""
IMPACT_VELOCITY = assumed.positive("v")
"""Velocity of the load relative to the pin at the impact, over A ω."""

MEANINGS = (
    (CONTACT_ANGLE, SEPARATION + sympy.pi - CONTACT),
    (FLIGHT, CONTACT - SEPARATION),
    (IMPACT_VELOCITY, DECAY * sympy.cos(SEPARATION) - sympy.cos(CONTACT)),
    (GAMMA, sympy.cos(SEPARATION) / sympy.sin(SEPARATION)),
)
"""What symbols stand for in φ_s, φ_c and E, which are left; tan φ_s = 1/γ is the condition of separation."""
DECAYED = (sympy.exp(-CONTACT / GAMMA), DECAY * sympy.exp(-SEPARATION / GAMMA))
"""How E comes in, where an exponential of the phase over γ has been integrated over the flight."""


@dataclass(frozen=True)
class SteadyMotion:
    """The load's steady motion."""

    waveform: Waveform  # Position of the load, m, over the period that begins at the separation
    separation: sympy.Expr  # Phase of that separation, rad

    @property
    def flight(self) -> Segment:
        """Free flight, from separation to impact."""
        return self.waveform.segments[0]

    @property
    def contact(self) -> Segment:
        """Contact, from the impact to the next separation."""
        return self.waveform.segments[1]

    def ratio(self) -> sympy.Expr:
        """Return g/A as a function of the impact's phase, where the flight meets the other wall."""
        impact = self.flight.end
        meeting = self.flight.position(impact) - self.contact.position(impact)
        gap = -meeting.subs(GAP, 0) / meeting.diff(GAP)
        return sympy.expand(gap / A)

    def describing_function(self, harmonic: sympy.Expr) -> sympy.Expr:
        """Return N_n in φ_s, φ_c and E, with the gap taken from the impact.

        Raises:
            UnprovenError: if the waveform is not half-wave odd.
        """
        by_gap = odd_harmonic(self.waveform, A, harmonic)
        return in_phases(by_gap.subs(GAP, A * self.ratio()))


def in_phases(expression: sympy.Expr) -> sympy.Expr:
    """Eliminate the symbols of ``MEANINGS`` and the exponentials of phases over γ; φ_s, φ_c and E remain."""
    return expression.subs(*DECAYED).subs(MEANINGS)


@cache
def friction_motion() -> SteadyMotion:
    """Return the motion of a load without inertia, with φ_c for its phase of impact π - asin(1 - g/A)."""
    named = {sympy.asin(1 - GAP / A): sympy.pi - CONTACT}
    segments = (
        Segment(segment.start.xreplace(named), segment.end.xreplace(named), segment.value)
        for segment in friction_waveform().segments
    )
    return SteadyMotion(Waveform(tuple(segments)), sympy.pi / 2)


@cache
def inertia_motion() -> SteadyMotion:
    """Return the motion of a load without friction, which separates at the phase 0."""
    return SteadyMotion(inertia_waveform(), sympy.Integer(0))


@cache
def general_motion() -> SteadyMotion:
    """Return the motion of a load with inertia and friction, which separates at the phase φ_s."""
    return SteadyMotion(general_waveform(), SEPARATION)
