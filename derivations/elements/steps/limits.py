"""The limits of the general backlash are friction- and inertia-controlled backlash."""

import sympy
from sympy import cos, exp, sin

from derivations import assumed
from derivations.algebra.unevaluated import total
from derivations.elements.backlash import GAMMA, SEPARATION, limits, separation_angle
from derivations.elements.backlash_closed_forms import (
    friction_fundamental,
    friction_harmonic,
    general_fundamental,
    general_harmonic,
    inertia_fundamental,
    inertia_harmonic,
)
from derivations.elements.backlash_harmonics import DECAY, FLIGHT, MEANINGS
from derivations.elements.proven_step import Equality, ProvenStep

FRICTION = r"\lim_{\gamma \to 0}"
INERTIA = r"\lim_{\gamma \to \infty}"
_DECAY = exp(-FLIGHT / GAMMA)
_DELAY = assumed.positive("tau")


def step() -> ProvenStep:
    """Return the step on the limits γ → 0 and γ → ∞ of the closed forms."""
    return ProvenStep(
        "df-limits",
        "The limits are friction- and inertia-controlled backlash",
        "At a given angle of flight separation and impact tend to those of the two limiting cases. The "
        "closed forms of $N_n$ hold $E$ only together with $\\cos\\phi_s$, and are continuous in both. So "
        "their limits are their values at the limits of $\\phi_s$ and $E$, and these are the closed forms "
        "of friction-controlled ($\\phi_s = \\pi/2$) and inertia-controlled ($\\phi_s = 0$) backlash.",
        (*_friction(), *_inertia()),
        code=(limits,),
    )


def _friction() -> tuple[Equality, ...]:
    separation, decay = (sympy.limit(each, GAMMA, 0, "+") for each in (separation_angle(), _DECAY))
    ratio = limits(sympy.Integer(0)).ratio.subs(_DELAY, FLIGHT)
    return (
        Equality(rf"{FRICTION} \phi_s", sympy.pi / 2, separation),
        Equality(rf"{FRICTION} E", sympy.Integer(0), decay),
        Equality(rf"{FRICTION} \frac{{g}}{{A}}", total(1, -cos(FLIGHT)), ratio),
        *_describing_functions(
            FRICTION,
            (friction_fundamental(), friction_harmonic()),
            ((SEPARATION, sympy.pi / 2), (DECAY, sympy.Integer(0))),
        ),
    )


def _inertia() -> tuple[Equality, ...]:
    separation, decay = (sympy.limit(each, GAMMA, sympy.oo) for each in (separation_angle(), _DECAY))
    ratio = limits(sympy.oo).ratio.subs(_DELAY, FLIGHT)
    return (
        Equality(rf"{INERTIA} \phi_s", sympy.Integer(0), separation),
        Equality(rf"{INERTIA} E", sympy.Integer(1), decay),
        Equality(rf"{INERTIA} \frac{{g}}{{A}}", total(FLIGHT, -sin(FLIGHT)), ratio),
        *_describing_functions(
            INERTIA,
            (inertia_fundamental(), inertia_harmonic()),
            ((SEPARATION, sympy.Integer(0)), (DECAY, sympy.Integer(1))),
        ),
    )


def _describing_functions(
    limit: str, forms: tuple[sympy.Expr, sympy.Expr], values: tuple[tuple[sympy.Expr, sympy.Expr], ...]
) -> tuple[Equality, ...]:
    """Return the limits of N_1 and N_n: the general closed forms at the limits of φ_s and E."""
    generals = (general_fundamental(), general_harmonic())
    names = (f"{limit} N_1", f"{limit} N_n")
    return tuple(
        Equality(name, form, sympy.together(general.subs(MEANINGS)).subs(values), given=(*MEANINGS, *values))
        for name, form, general in zip(names, forms, generals, strict=True)
    )
