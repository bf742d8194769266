"""The formulas of the explorable: from the derivation, for the thesis's trimmer, as functions of what moves.

Every function returns the expressions that the page computes; ``report.explorable.script`` prints them.
"""

from dataclasses import dataclass

import sympy

from derivations import assumed
from derivations.elements.backlash import CONTACT, GAMMA, GAP, SEPARATION, general_waveform, separation_angle
from derivations.elements.backlash_closed_forms import flight, general_fundamental
from derivations.elements.backlash_harmonics import (
    CONTACT_ANGLE,
    DECAY,
    FLIGHT,
    IMPACT_VELOCITY,
    general_motion,
)
from derivations.elements.equivalent_nonlinearity import friction_term
from derivations.elements.friction import FORCE
from derivations.elements.waveform import THETA
from derivations.linear_trimmer import LinearTrimmer
from derivations.symbols import A, c2, k2, omega, s
from derivations.transfer_steps import output_numerator, rubbing_numerator

SHARE = assumed.nonnegative("share")
"""Share of the pin's velocity that acts on the bridge: 0 in the thesis's loop, 1 in the trimmer."""
LOST = assumed.positive("lost")  # 1 - exp(-λ/γ), computed without cancellation


@dataclass(frozen=True)
class Function:
    """A function of the page."""

    name: str  # Its name in the script
    arguments: tuple[sympy.Symbol, ...]  # Its arguments, in order
    results: dict[str, sympy.Expr]  # What it returns, by name; real expressions in the arguments
    # Quantities that the results share, with their expressions, in order
    given: tuple[tuple[sympy.Symbol, sympy.Expr], ...] = ()


def functions(derivation: LinearTrimmer, values: dict[sympy.Expr, sympy.Rational]) -> tuple[Function, ...]:
    """Return all functions of the page, with values of the parameters; the damping c2 stays a variable."""
    return (
        _inverse_response(derivation, values),
        _rubbing(derivation, values),
        _polynomials(derivation, values),
        _element(),
        _friction(values[k2]),
        _position("flight", flight()),
        _position("contact", general_waveform().segments[1].value),
    )


def _inverse_response(derivation: LinearTrimmer, values: dict[sympy.Expr, sympy.Rational]) -> Function:
    """Return 1/G at s = jω and its derivative by ω, from the coefficients of the transfer function."""
    plant = _plant(derivation, values)
    return _over_numerator("inverseResponse", plant["b"], plant["a"])


def _rubbing(derivation: LinearTrimmer, values: dict[sympy.Expr, sympy.Rational]) -> Function:
    """Return k2 H/G at s = jω and its derivative by ω.

    H leads from a force on the cutter, and its reaction on the guard, to the output. There the friction rubs.
    """
    plant = _plant(derivation, values)
    return _over_numerator("rubbing", plant["b"], plant["h"])


def _plant(derivation: LinearTrimmer, values: dict[sympy.Expr, sympy.Rational]) -> dict[str, sympy.Expr]:
    """Return the numerators of G (``b``) and of k2 H (``h``) over their common denominator (``a``)."""
    fixed = {symbol: value for symbol, value in values.items() if symbol != c2}
    numerator = _polynomial(output_numerator(derivation), fixed)
    return {
        "b": sympy.expand(numerator * (1 + SHARE * s * c2 / fixed[k2])),
        "h": sympy.expand(fixed[k2] * _polynomial(rubbing_numerator(derivation), fixed)),
        "a": _polynomial(list(derivation.transfer.denominator), fixed),
    }


def _over_numerator(name: str, divisor: sympy.Expr, dividend: sympy.Expr) -> Function:
    """Return a quotient of two polynomials in s at s = jω, and its derivative by ω."""
    real, imaginary = _parts(divisor), _parts(dividend)
    below, above = assumed.real("P_r P_i"), assumed.real("Q_r Q_i")
    by_below, by_above = assumed.real("dP_r dP_i"), assumed.real("dQ_r dQ_i")
    quotient = (above[0] + sympy.I * above[1]) / (below[0] + sympy.I * below[1])
    change = (by_above[0] + sympy.I * by_above[1] - quotient * (by_below[0] + sympy.I * by_below[1])) / (
        below[0] + sympy.I * below[1]
    )
    given = (
        *zip(below, real, strict=True),
        *zip(above, imaginary, strict=True),
        *zip(by_below, (sympy.horner(each.diff(omega), omega) for each in real), strict=True),
        *zip(by_above, (sympy.horner(each.diff(omega), omega) for each in imaginary), strict=True),
    )
    results = {}
    for suffix, value in (("", quotient), ("ByOmega", change)):
        for part, take in (("real", sympy.re), ("imaginary", sympy.im)):
            results[f"{part}{suffix}"] = sympy.simplify(take(value))
    return Function(name, (omega, c2, SHARE), results, given)


def _polynomials(derivation: LinearTrimmer, values: dict[sympy.Expr, sympy.Rational]) -> Function:
    """Return the coefficients of the polynomials of G and k2 H, for the poles of the closed loop."""
    results = {
        f"{name}{power}": polynomial.coeff(s, power)
        for name, polynomial in _plant(derivation, values).items()
        for power in range(len(derivation.transfer.denominator) - 1, -1, -1)
    }
    return Function("polynomials", (c2, SHARE), results)


def _polynomial(coefficients: list[sympy.Expr], fixed: dict[sympy.Expr, sympy.Rational]) -> sympy.Expr:
    highest = len(coefficients) - 1
    return sympy.Add(
        *(each.subs(fixed) * s ** (highest - drop) for drop, each in enumerate(coefficients))
    ).expand()


def _parts(polynomial: sympy.Expr) -> tuple[sympy.Expr, sympy.Expr]:
    """Return real and imaginary part of a polynomial at s = jω, nested by Horner's rule."""
    on_axis = sympy.expand(polynomial.subs(s, sympy.I * omega))
    real = on_axis.subs(sympy.I, 0)
    imaginary = sympy.expand((on_axis - real) / sympy.I)
    return sympy.horner(real, omega), sympy.horner(imaginary, omega)


def _element() -> Function:
    """Return g/A and N of backlash by angle of flight λ and γ, with their derivatives."""
    motion, decay = general_motion(), 1 - LOST
    ratio = motion.ratio().subs(sympy.exp(-CONTACT / GAMMA), DECAY * sympy.exp(-SEPARATION / GAMMA))
    meanings = (
        (IMPACT_VELOCITY, DECAY * sympy.cos(SEPARATION) - sympy.cos(CONTACT)),
        (CONTACT_ANGLE, sympy.pi - FLIGHT),
        (CONTACT, SEPARATION + FLIGHT),
        (DECAY, decay),
    )
    real, imaginary = (part.subs(meanings) for part in general_fundamental().as_real_imag())
    expressions = {
        "ratio": sympy.expand(sympy.expand(ratio).subs(meanings)),
        "real": real,
        "imaginary": imaginary.subs(1 - decay**2, sympy.expand(1 - decay**2)),
    }
    lost = -sympy.Function("expm1")(-FLIGHT / GAMMA)
    changes = (
        ("ByFlight", ((FLIGHT, sympy.Integer(1)), (LOST, decay / GAMMA))),
        (
            "ByGamma",
            (
                (GAMMA, sympy.Integer(1)),
                (SEPARATION, separation_angle().diff(GAMMA)),
                (LOST, -decay * FLIGHT / GAMMA**2),
            ),
        ),
    )
    results: dict[str, sympy.Expr] = {"separation": SEPARATION, **expressions}
    for suffix, rates in changes:
        for name, value in expressions.items():
            total = sympy.Add(*(value.diff(symbol) * rate for symbol, rate in rates))
            results[f"{name}{suffix}"] = total
    return Function("element", (FLIGHT, GAMMA), results, ((SEPARATION, separation_angle()), (LOST, lost)))


def _friction(stiffness: sympy.Rational) -> Function:
    """Return the imaginary part of N of Coulomb friction over the stiffness of the bridge, and its slope."""
    imaginary = friction_term() / sympy.I / stiffness
    results = {"imaginary": imaginary, "imaginaryByAmplitude": imaginary.diff(A)}
    return Function("friction", (FORCE, A), results)


def _position(name: str, value: sympy.Expr) -> Function:
    given = ((SEPARATION, separation_angle()),)
    return Function(name, (THETA, GAMMA, GAP), {"position": value.subs(A, 1)}, given)
