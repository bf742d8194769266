"""Backlash between a pin and a load with inertia and friction: contact, separation, free flight, impact.

The pin moves as A sin θ with θ = ωt; the load M v' + D v = 0 lies between two walls of the bridge a total
``GAP`` apart. A wall can push and not pull. Friction-controlled (M/D → 0) and inertia-controlled (M/D → ∞)
backlash are limits of this one element. The cases are those of Gelb and Vander Velde, Multiple-Input
Describing Functions (1968); the derivation is from mechanics.
"""

from dataclasses import dataclass
from functools import cache

import sympy

from derivations import assumed
from derivations.elements.waveform import THETA, Segment, Waveform
from derivations.symbols import A

GAP = assumed.positive("g")  # Total clearance, m
GAMMA = assumed.positive("gamma")
"""M ω / D, a number: angular frequency times the load's time constant."""
CONTACT = assumed.positive("phi_c")
"""Phase of the impact, at which the load meets the other wall, rad."""
SEPARATION = assumed.positive("phi_s")
"""Phase of the separation, beyond which the wall would have to pull, rad."""


def contact_force(side: int) -> sympy.Expr:
    """Return the force of the wall on the load over D ω, m, while the load follows the pin.

    Args:
        side: 1 or -1; the load is then at A sin θ + side g/2.
    """
    load = A * sympy.sin(THETA) + side * GAP / 2
    return GAMMA * load.diff(THETA, 2) + load.diff(THETA)


@cache
def separation_angle() -> sympy.Expr:
    """Return the phase in (0, π/2) at which the pushing force of the rising contact reaches zero, rad."""
    tangent = assumed.positive("tangent")
    force = sympy.expand(contact_force(-1) / (A * sympy.cos(THETA)))
    in_tangent = force.subs(sympy.sin(THETA), tangent * sympy.cos(THETA))
    return sympy.atan(sympy.solve(sympy.expand(in_tangent), tangent)[0])


@cache
def free_flight() -> sympy.Expr:
    """Return the load's position in flight, m, from γ y'' + y' = 0 and the pin's state at separation."""
    position = sympy.Function("y")
    pin = A * sympy.sin(THETA) - GAP / 2
    conditions = {
        position(SEPARATION): pin.subs(THETA, SEPARATION),
        position(THETA).diff(THETA).subs(THETA, SEPARATION): pin.diff(THETA).subs(THETA, SEPARATION),
    }
    equation = sympy.Eq(GAMMA * position(THETA).diff(THETA, 2) + position(THETA).diff(THETA), 0)
    return sympy.dsolve(equation, position(THETA), ics=conditions).rhs


@cache
def contact_ratio() -> sympy.Expr:
    """Return g/A as a function of the phase of impact: the flight ends where it meets the falling wall."""
    meeting = free_flight().subs(THETA, CONTACT) - (A * sympy.sin(CONTACT) + GAP / 2)
    gap = -meeting.subs(GAP, 0) / meeting.diff(GAP)
    return sympy.expand(gap / A)


def general_waveform() -> Waveform:
    """Return the load's position, m, over a period that begins at separation; odd under a shift by π."""
    flight, contact = free_flight(), A * sympy.sin(THETA) + GAP / 2
    first = (Segment(SEPARATION, CONTACT, flight), Segment(CONTACT, SEPARATION + sympy.pi, contact))
    second = (
        Segment(
            segment.start + sympy.pi, segment.end + sympy.pi, -segment.value.subs(THETA, THETA - sympy.pi)
        )
        for segment in first
    )
    return Waveform((*first, *second))


def friction_waveform(gap: sympy.Expr = GAP) -> Waveform:
    """Return the position of a load without inertia, m, from the peak of the pin on: it stays, then follows.

    Args:
        gap: Total clearance, m.
    """
    half, pi = gap / 2, sympy.pi
    contact = sympy.asin(1 - gap / A)
    pin = A * sympy.sin(THETA)
    return Waveform(
        (
            Segment(pi / 2, pi - contact, A - half),
            Segment(pi - contact, 3 * pi / 2, pin + half),
            Segment(3 * pi / 2, 2 * pi - contact, -(A - half)),
            Segment(2 * pi - contact, 5 * pi / 2, pin - half),
        )
    )


def inertia_waveform(gap: sympy.Expr = GAP) -> Waveform:
    """Return the position of a load without friction, m, from the pin's largest velocity on.

    The load keeps that velocity until it meets the other wall.

    Args:
        gap: Total clearance, m.
    """
    half, pi = gap / 2, sympy.pi
    pin = A * sympy.sin(THETA)
    return Waveform(
        (
            Segment(sympy.Integer(0), CONTACT, A * THETA - half),
            Segment(CONTACT, pi, pin + half),
            Segment(pi, pi + CONTACT, -A * (THETA - pi) + half),
            Segment(pi + CONTACT, 2 * pi, pin - half),
        )
    )


def inertia_contact_ratio() -> sympy.Expr:
    """Return g/A of inertia-controlled backlash as a function of the phase of impact."""
    flight, follow = inertia_waveform().segments[:2]
    meeting = (flight.value - follow.value).subs(THETA, CONTACT)
    gap = -meeting.subs(GAP, 0) / meeting.diff(GAP)
    return sympy.expand(gap / A)


@dataclass(frozen=True)
class LoadLimit:
    """Limits of the general element for M/D → 0 or M/D → ∞."""

    separation: sympy.Expr  # Phase of separation, rad
    ratio: sympy.Expr  # g/A as a function of the angle of flight τ
    flight: sympy.Expr  # Position at the angle τ after separation, m


@cache
def limits(towards: sympy.Expr) -> LoadLimit:
    """Return the limits of the general element.

    Args:
        towards: Limit of γ: 0 for friction-controlled, ∞ for inertia-controlled backlash.
    """
    angle = separation_angle()
    delay = assumed.positive("tau")
    ratio, flight = (
        expression.subs(phase, SEPARATION + delay).subs(SEPARATION, angle)
        for expression, phase in ((contact_ratio(), CONTACT), (free_flight(), THETA))
    )
    return LoadLimit(_limit(angle, towards), _limit(ratio, towards), _limit(flight, towards))


def _limit(expression: sympy.Expr, towards: sympy.Expr) -> sympy.Expr:
    if towards == 0:
        # Every term has a finite limit by itself, and SymPy finds those more easily.
        terms = sympy.Add.make_args(sympy.expand(expression, trig=True))
        return sympy.simplify(sympy.Add(*(sympy.limit(term, GAMMA, 0, "+") for term in terms)))
    return sympy.simplify(sympy.limit(sympy.simplify(expression), GAMMA, towards))
