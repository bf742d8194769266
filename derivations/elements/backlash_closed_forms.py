"""Closed forms for backlash, as they are shown and used; the modules of ``steps`` prove them from waveforms.

Symbols are those of derivations/elements/backlash_harmonics.py. An integral is that of y exp(-jnθ) over a
segment of the waveform, in m rad; N_n is a number (m/m).
"""

import sympy
from sympy import cos, exp, pi, sin

from derivations.algebra.unevaluated import product, total
from derivations.elements.backlash import CONTACT, GAMMA, GAP, SEPARATION
from derivations.elements.backlash_harmonics import CONTACT_ANGLE, DECAY, FLIGHT, IMPACT_VELOCITY
from derivations.elements.harmonics import HARMONIC
from derivations.elements.waveform import THETA
from derivations.symbols import A

j, n = sympy.I, HARMONIC
HALF_GAP = GAP / 2
BEYOND_FUNDAMENTAL = total(n**2, sympy.Integer(-1))
IMPEDANCE = total(1 / GAMMA, j * n)


def flight() -> sympy.Expr:
    """Position of a load with inertia and friction in its flight, m, at the phase θ."""
    travel = product(A * GAMMA * cos(SEPARATION), total(1, -exp(-total(THETA, -SEPARATION) / GAMMA)))
    return total(A * sin(SEPARATION), -HALF_GAP, travel)


def turned(phase: sympy.Expr) -> sympy.Expr:
    """Return exp(-jn · phase), the weight of harmonic n, at a phase in rad."""
    return exp(-j * n * phase)


def swept(phase: sympy.Expr) -> sympy.Expr:
    """Return an antiderivative of (1 - n²) cos θ exp(-jnθ) at a phase in rad."""
    return product(total(sin(phase), -j * n * cos(phase)), turned(phase))


def resting_antiderivative() -> sympy.Expr:
    """Antiderivative of (A - g/2) exp(-jnθ): a load at rest."""
    return product(j / n, total(A, -HALF_GAP), turned(THETA))


def straight_antiderivative() -> sympy.Expr:
    """Antiderivative of (Aθ - g/2) exp(-jnθ): a load at constant velocity."""
    moving = product(A / n**2, total(1, j * n * THETA), turned(THETA))
    return total(moving, -product(j * GAP / (2 * n), turned(THETA)))


def braked_antiderivative() -> sympy.Expr:
    """Antiderivative of the general flight times exp(-jnθ)."""
    rest = total(A * sin(SEPARATION), A * GAMMA * cos(SEPARATION), -HALF_GAP)
    decayed = exp(-total(THETA, -SEPARATION) / GAMMA)
    moving = product(A * GAMMA * cos(SEPARATION) / IMPEDANCE, decayed, turned(THETA))
    return total(product(j / n, rest, turned(THETA)), moving)


def contact_antiderivative() -> sympy.Expr:
    """Antiderivative of (A sin θ + g/2) exp(-jθ): a load that follows the pin, for n = 1."""
    pin = product(A / 4, exp(-2 * j * THETA))
    return total(-j * A * THETA / 2, -pin, product(j * HALF_GAP, exp(-j * THETA)))


def contact_antiderivative_of_harmonic() -> sympy.Expr:
    """Antiderivative of (A sin θ + g/2) exp(-jnθ) for odd n >= 3."""
    pin = product(A / BEYOND_FUNDAMENTAL, total(cos(THETA), j * n * sin(THETA)), turned(THETA))
    return total(pin, product(j * GAP / (2 * n), turned(THETA)))


def resting_integral() -> sympy.Expr:
    """Integral of the flight without inertia, at rest from π/2 to φ_c."""
    return product(j / n, total(A, -HALF_GAP), total(turned(CONTACT), -turned(pi / 2)))


def straight_integral() -> sympy.Expr:
    """Integral of the flight without friction, at constant velocity from 0 to φ_c."""
    moving = product(A / n**2, total(product(total(1, j * n * CONTACT), turned(CONTACT)), -1))
    return total(moving, -product(j * GAP / (2 * n), total(turned(CONTACT), -1)))


def braked_integral() -> sympy.Expr:
    """Integral of the general flight, from φ_s to φ_c."""
    rest = total(A * sin(SEPARATION), A * GAMMA * cos(SEPARATION), -HALF_GAP)
    moving = product(A * GAMMA * cos(SEPARATION) / IMPEDANCE, _decayed())
    return total(product(j / n, rest, total(turned(CONTACT), -turned(SEPARATION))), -moving)


def _decayed() -> sympy.Expr:
    return total(turned(SEPARATION), -product(DECAY, turned(CONTACT)))


def contact_integral(separation: sympy.Expr) -> sympy.Expr:
    """Integral of the contact for n = 1, from φ_c to half a period after the separation, a phase in rad."""
    pin = product(A / 4, total(exp(-2 * j * CONTACT), -exp(-2 * j * separation)))
    wall = product(j * HALF_GAP, total(exp(-j * CONTACT), exp(-j * separation)))
    return total(-j * A * CONTACT_ANGLE / 2, pin, -wall)


def contact_integral_of_harmonic(separation: sympy.Expr) -> sympy.Expr:
    """Integral of the contact for odd n >= 3, between the same phases as for n = 1."""
    start, end = (
        product(total(cos(phase), j * n * sin(phase)), turned(phase)) for phase in (CONTACT, separation)
    )
    wall = product(j * GAP / (2 * n), total(turned(CONTACT), turned(separation)))
    return total(product(A / BEYOND_FUNDAMENTAL, total(end, -start)), -wall)


def friction_fundamental() -> sympy.Expr:
    """N_1 of friction-controlled backlash by the angle of contact ℓ (thesis, equation 2.41)."""
    real = product(1 / pi, total(CONTACT_ANGLE, -sin(CONTACT_ANGLE) * cos(CONTACT_ANGLE)))
    return total(real, -j * sin(CONTACT_ANGLE) ** 2 / pi)


def friction_harmonic() -> sympy.Expr:
    """N_n of friction-controlled backlash for odd n >= 3."""
    return product(2 / (pi * n * BEYOND_FUNDAMENTAL), total(swept(CONTACT), -turned(pi / 2)))


def inertia_fundamental() -> sympy.Expr:
    """N_1 of inertia-controlled backlash by the phase of impact φ_c (thesis, equation 2.43)."""
    sine, cosine = sin(CONTACT), cos(CONTACT)
    real = product(1 / pi, total(pi, -CONTACT, 2 * sine, -sine * cosine))
    return total(real, -product(j / pi, total(1, -cosine) ** 2))


def inertia_harmonic() -> sympy.Expr:
    """N_n of inertia-controlled backlash for odd n >= 3."""
    load = product(j / n, total(turned(CONTACT), -1))
    pin = product(1 / BEYOND_FUNDAMENTAL, total(swept(CONTACT), j * n))
    return product(2 / (pi * n), total(load, pin))


def general_fundamental() -> sympy.Expr:
    """N_1 of viscous-controlled backlash, in the form that `trimmer.elements.backlashes` evaluates."""
    middle = cos(total(SEPARATION, -CONTACT_ANGLE / 2)) ** 2
    bracket = total(DECAY * cos(SEPARATION) ** 2, middle)
    real = total(CONTACT_ANGLE, -sin(CONTACT_ANGLE), product(2 * sin(CONTACT_ANGLE), bracket))
    lost = product(cos(SEPARATION) ** 2, total(1, -(DECAY**2)))
    kept = 2 * DECAY * sin(SEPARATION) * cos(SEPARATION) * sin(FLIGHT)
    return total(product(1 / pi, real), -product(j / pi, total(IMPACT_VELOCITY**2, lost, -kept)))


def general_harmonic() -> sympy.Expr:
    """N_n of viscous-controlled backlash for odd n >= 3."""
    load = product(cos(SEPARATION) / IMPEDANCE, _decayed())
    pin = product(1 / BEYOND_FUNDAMENTAL, total(swept(CONTACT), -swept(SEPARATION)))
    return product(2 / (pi * n), total(load, pin))
