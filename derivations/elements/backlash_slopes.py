"""How the describing function of backlash changes with the gap and with the load's time constant.

The first harmonic is a function of φ_s, φ_c and E = exp(-(φ_c - φ_s) tan φ_s), where γ = ω M/D = cot φ_s. So
a change at constant γ is one at constant φ_s, and a change at constant g/A moves φ_s and φ_c together.
"""

from functools import cache

import sympy
from sympy import cos, exp, pi, sin

from derivations import assumed
from derivations.algebra.unevaluated import product, total
from derivations.elements.backlash import CONTACT, GAMMA, SEPARATION, free_flight
from derivations.elements.backlash_closed_forms import general_fundamental
from derivations.elements.backlash_harmonics import DECAY, FLIGHT, MEANINGS, general_motion, in_phases
from derivations.elements.harmonics import evaluated
from derivations.elements.waveform import THETA
from derivations.symbols import A

ELAPSED = assumed.positive("t")  # Phase since separation, rad
TANGENT = sin(SEPARATION) / cos(SEPARATION)
AFTER_EVALUATION = ((exp(-FLIGHT / GAMMA), DECAY), *MEANINGS)
"""What symbols stand for where an integral over the flight has brought in exp(-λ/γ)."""


@cache
def _fundamental() -> sympy.Expr:
    return sympy.expand(general_fundamental().subs(MEANINGS))


@cache
def _ratio() -> sympy.Expr:
    return in_phases(general_motion().ratio())


def _by_impact(expression: sympy.Expr) -> sympy.Expr:
    """Differentiate by φ_c at constant φ_s."""
    return expression.diff(CONTACT) - TANGENT * DECAY * expression.diff(DECAY)


def _by_separation(expression: sympy.Expr) -> sympy.Expr:
    """Differentiate by φ_s at constant φ_c."""
    decay = DECAY * (TANGENT - (CONTACT - SEPARATION) / cos(SEPARATION) ** 2)
    return expression.diff(SEPARATION) + decay * expression.diff(DECAY)


LOG_GAMMA_BY_SEPARATION = -1 / (sin(SEPARATION) * cos(SEPARATION))  # d(ln γ)/dφ_s for γ = cot φ_s


def relative_velocity() -> sympy.Expr:
    """Return d(g/A)/dφ_c at constant γ: the load's velocity relative to the pin at the impact, over A ω."""
    return _by_impact(_ratio())


def slope_by_ratio() -> sympy.Expr:
    """Return dN_1/d(g/A) at constant γ, from the closed form."""
    return _by_impact(_fundamental()) / relative_velocity()


def slope_by_log_gamma() -> sympy.Expr:
    """Return dN_1/d(ln γ) at constant g/A, from the closed form and the slope by g/A."""
    change = _by_separation(_fundamental()) - closed_slope_by_ratio() * _by_separation(_ratio())
    return change / LOG_GAMMA_BY_SEPARATION


def position_by_log_gamma() -> sympy.Expr:
    """Return the derivative by ln γ of the position over A, at a phase φ_s + t of the flight (t in rad)."""
    position = sympy.expand((free_flight() / A).subs(GAMMA, 1 / TANGENT))
    change = position.diff(SEPARATION) / LOG_GAMMA_BY_SEPARATION
    return change.subs(THETA, SEPARATION + ELAPSED)


def lead() -> sympy.Expr:
    """Return k(t), with which the position over A rises by cos φ_s k(t) d(ln γ)."""
    decay = exp(-ELAPSED / GAMMA)
    return total(product(GAMMA, total(1, -decay)), -ELAPSED * decay)


def closed_slope_by_ratio() -> sympy.Expr:
    """Return dN_1/d(g/A) at constant γ in closed form: its modulus is 2/π everywhere."""
    return 2 / pi * exp(-sympy.I * CONTACT)


def closed_slope_by_log_gamma() -> sympy.Expr:
    """Return dN_1/d(ln γ) at constant g/A as an integral over the flight."""
    integral = sympy.Integral(lead() * exp(-sympy.I * ELAPSED), (ELAPSED, 0, FLIGHT))
    return product(2 * sympy.I / pi, cos(SEPARATION), exp(-sympy.I * SEPARATION), integral)


def jacobian() -> sympy.Expr:
    """Return the imaginary part of conj(dN_1/d(g/A)) dN_1/d(ln γ), from the closed slopes."""
    turned = evaluated(sympy.conjugate(closed_slope_by_ratio()) * closed_slope_by_log_gamma())
    return (turned - sympy.conjugate(turned)) / (2 * sympy.I)


def closed_jacobian() -> sympy.Expr:
    """Return Im(conj(dN_1/d(g/A)) dN_1/d(ln γ)) as an integral of what is not negative."""
    weight = product(ELAPSED / GAMMA, exp(-ELAPSED / GAMMA), sin(total(FLIGHT, -ELAPSED)))
    return product(4 / pi**2, cos(SEPARATION), sympy.Integral(weight, (ELAPSED, 0, FLIGHT)))
