"""Backlash and Coulomb friction as one nonlinearity, with a check of its units."""

import sympy

from derivations import assumed
from derivations.algebra.unevaluated import total
from derivations.dimensions import NUMBER, Dimension
from derivations.elements.backlash import GAP
from derivations.elements.backlash_closed_forms import friction_fundamental
from derivations.elements.backlash_harmonics import CONTACT_ANGLE
from derivations.elements.equivalent_nonlinearity import (
    BACKLASH,
    FILTER,
    FRICTION,
    UnitsCheck,
    equivalent,
    friction_term,
    units_check,
)
from derivations.elements.friction import FORCE, friction_waveform, relay_waveform
from derivations.elements.harmonics import odd_harmonic
from derivations.elements.proven_step import Equality, ProvenStep
from derivations.latex import latex
from derivations.step import Formula
from derivations.symbols import A, k2, omega

ONE = sympy.Integer(1)


def step() -> ProvenStep:
    """Return the step on the equivalent nonlinearity (thesis, equations 2.57 to 2.60 and 5.14).

    Raises:
        DimensionError: if friction could be added to backlash as it stands, or not even over a stiffness.
    """
    backlash = friction_fundamental().subs(CONTACT_ANGLE, sympy.acos(GAP / A - 1))
    units = units_check(backlash)
    units.require_sum()
    return ProvenStep(
        "df-equivalent",
        "Equivalent nonlinearity of backlash and friction",
        "In figure 2.15 backlash acts on the displacement $G_g v$ and friction on the velocity $v$ of the "
        "plant $G_m$, and both feed back into it. Collected over $G_m G_g$ this is one loop. With the "
        "integrator $G_g = 1/s$ friction sees the velocity's amplitude $\\omega A$, and $N_f/G_g$ is $N_1$ "
        "of Coulomb friction with the displacement as its input.\n\nThe units do not fit: backlash gives a "
        "displacement for a displacement, friction a force. The two can be added once the force is divided "
        "by a stiffness, here that of the driving bridge. Harmonics add in the same way: $N_n$ of backlash "
        "and $N_n$ of friction over $k_2$.",
        (
            Formula(r"1 + N_{eq} G_m G_g = 0", "2.57"),
            Equality("N_{eq}", total(BACKLASH, FRICTION / FILTER), equivalent(), "2.58"),
            Equality("N_f", 4 * FORCE / (sympy.pi * omega * A), _friction_of_velocity(), "2.60"),
            Equality(
                r"\frac{N_f}{G_g}",
                4 * sympy.I * FORCE / (sympy.pi * A),
                odd_harmonic(friction_waveform(), A, ONE),
            ),
            Equality(r"j \omega N_f", 4 * sympy.I * FORCE / (sympy.pi * A), friction_term()),
            *_units(units),
            Formula(f"N_{{eq}} = N_r + {latex(4 * sympy.I * FORCE / (sympy.pi * k2 * A))}", "5.14"),
        ),
        code=(equivalent, friction_term, units_check),
    )


def _friction_of_velocity() -> sympy.Expr:
    velocity = assumed.positive("A_v")
    return odd_harmonic(relay_waveform(), velocity, ONE).subs(velocity, omega * A)


def _units(units: UnitsCheck) -> tuple[Formula, ...]:
    found = (
        ("N_r", units.backlash),
        (r"\frac{N_f}{G_g}", units.friction),
        (r"\frac{N_f}{k_2 G_g}", units.over_stiffness),
    )
    return (
        Formula(r", \quad ".join(rf"\left[{name}\right] = {_unit(dimension)}" for name, dimension in found)),
    )


def _unit(dimension: Dimension | None) -> str:
    """Return LaTeX of a dimension in SI units."""
    if dimension in (None, NUMBER):
        return "1"
    powers = (("kg", dimension.mass), ("m", dimension.length), ("s", dimension.time))
    return r"\,".join(
        rf"\mathrm{{{unit}}}" + (f"^{{{power}}}" if power != 1 else "") for unit, power in powers if power
    )
