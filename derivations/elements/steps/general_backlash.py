"""Backlash in front of a load with inertia and friction: its motion, and its describing function."""

import sympy
from sympy import cos, exp, pi, sin

from derivations import assumed
from derivations.algebra.unevaluated import product, total
from derivations.elements.backlash import (
    CONTACT,
    GAMMA,
    SEPARATION,
    contact_force,
    contact_ratio,
    free_flight,
    general_waveform,
    separation_angle,
)
from derivations.elements.backlash_closed_forms import (
    braked_antiderivative,
    braked_integral,
    contact_antiderivative,
    contact_antiderivative_of_harmonic,
    contact_integral,
    contact_integral_of_harmonic,
    flight,
    general_fundamental,
    general_harmonic,
)
from derivations.elements.backlash_harmonics import DECAY, DECAYED, MEANINGS, general_motion
from derivations.elements.backlash_slopes import ELAPSED
from derivations.elements.harmonics import HARMONIC, odd_harmonic
from derivations.elements.proven_step import Equality, ProvenStep, antiderivative_on, cases, integral_over
from derivations.elements.waveform import THETA, Segment
from derivations.step import Formula
from derivations.symbols import A

ONE = sympy.Integer(1)
GIVEN = (DECAYED, *MEANINGS)
ON_FLIGHT = "On the flight, and between its limits:"
ON_CONTACT = "On the contact, for $n = 1$:"
BEYOND = "On the contact, for odd $n \\ge 3$:"


def motion() -> ProvenStep:
    """Return the step on the motion of the load: contact, separation, flight (thesis, 2.44 to 2.46)."""
    return ProvenStep(
        "df-load",
        "A load with inertia and friction behind a backlash",
        "The load obeys $M\\ddot y + D\\dot y = F$ with the force $F$ of a wall, which can push and not "
        "pull. While the load follows the rising pin at $A\\sin\\theta - g/2$ the force is positive up to "
        "the separation $\\phi_s$. Then the load flies freely, $\\gamma y'' + y' = 0$, solved from the "
        "pin's position and velocity at $\\phi_s$, until it meets the other wall at $\\phi_c$. That wall "
        "pushes the other way, with $-F$ positive up to $\\phi_s + \\pi$, where the second half of the "
        "period begins.\n\nThe velocity $v(t)$ of the load relative to the pin after $t$ of flight, over "
        "$A\\omega$, is an integral of what is positive for $t < \\pi$. So the flight ends once, and $g/A$ "
        "rises with its length up to the largest value, at $\\lambda = \\phi_c - \\phi_s = \\pi$.",
        (*_contact(), *_flight()),
        code=(contact_force, separation_angle, free_flight, contact_ratio),
    )


def _contact() -> tuple[Formula | Equality, ...]:
    """Return the force of the wall, and the phase at which it is zero."""
    force = -sin(total(THETA, -SEPARATION)) / sin(SEPARATION)
    return (
        Formula(r"\gamma = \frac{M \omega}{D}", "2.45"),
        Equality(r"\frac{F}{A D \omega}", force, contact_force(-1) / A, given=MEANINGS),
        Equality(r"\phi_s", sympy.atan(1 / GAMMA), separation_angle(), "2.44"),
    )


def _flight() -> tuple[Formula | Equality, ...]:
    """Return the flight, the condition of impact, the relative velocity and the largest g/A."""
    rest = product(GAMMA * cos(SEPARATION), total(1, -DECAY))
    largest = product(sin(SEPARATION), total(2, product(GAMMA**2, total(1, -exp(-pi / GAMMA)))))
    return (
        Equality(r"y(\theta)", flight(), free_flight()),
        Equality(r"\frac{g}{A}", total(sin(SEPARATION), -sin(CONTACT), rest), contact_ratio(), "2.46", GIVEN),
        Formula(r"E = e^{-\lambda/\gamma}"),
        Equality("v(t)", _closed_velocity(), _velocity(), given=MEANINGS),
        Equality("v(t)", _positive_velocity(), _velocity(), given=MEANINGS),
        Equality(
            r"\left(\frac{g}{A}\right)_{\lambda = \pi}",
            largest,
            sympy.expand(contact_ratio().subs(CONTACT, SEPARATION + pi)),
            given=((exp(-pi / GAMMA), DECAY), *MEANINGS),
        ),
    )


def _velocity() -> sympy.Expr:
    """Velocity of load less pin in the flight, over A ω."""
    relative = (free_flight() - A * sin(THETA)).diff(THETA) / A
    return relative.subs(THETA, SEPARATION + ELAPSED)


def _closed_velocity() -> sympy.Expr:
    return total(cos(SEPARATION) * exp(-ELAPSED / GAMMA), -cos(total(SEPARATION, ELAPSED)))


def _positive_velocity() -> sympy.Expr:
    past = assumed.positive("tau")
    weight = product(exp(-total(ELAPSED, -past) / GAMMA), sin(past))
    return product(1 / cos(SEPARATION), sympy.Integral(weight, (past, 0, ELAPSED)))


def describing_function() -> ProvenStep:
    """Return the step on the describing function for every odd harmonic (thesis, equation 2.47)."""
    load = general_motion()
    first_half = (Segment(load.flight.start, load.flight.end, flight()), load.contact)
    return ProvenStep(
        "df-general-backlash",
        "Viscous-controlled backlash",
        "The gap is eliminated by the condition of impact, and $\\gamma$ by that of separation, $\\gamma = "
        "\\cot\\phi_s$. Real and imaginary part of $N_1$ are given in the form in which they are computed: "
        "no digits cancel in it. Here $v$ is the relative velocity at the impact: $v^2$ stands for the work "
        "lost in it.",
        (
            cases("y", first_half),
            antiderivative_on(load.flight, HARMONIC, braked_antiderivative(), ON_FLIGHT),
            integral_over(load.flight, HARMONIC, braked_integral(), GIVEN),
            antiderivative_on(load.contact, ONE, contact_antiderivative(), ON_CONTACT),
            integral_over(load.contact, ONE, contact_integral(SEPARATION), GIVEN),
            antiderivative_on(load.contact, HARMONIC, contact_antiderivative_of_harmonic(), BEYOND),
            integral_over(load.contact, HARMONIC, contact_integral_of_harmonic(SEPARATION), GIVEN),
            Equality(
                "v",
                total(DECAY * cos(SEPARATION), -cos(CONTACT)),
                _velocity().subs(ELAPSED, CONTACT - SEPARATION),
                given=GIVEN,
            ),
            Equality("N_1", general_fundamental(), load.describing_function(ONE), "2.47", MEANINGS),
            Equality("N_n", general_harmonic(), load.describing_function(HARMONIC), given=MEANINGS),
        ),
        code=(general_waveform, odd_harmonic, general_fundamental),
    )
