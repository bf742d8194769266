"""Backlash in front of a load without inertia, and of one without friction."""

import sympy

from derivations.algebra.unevaluated import product, total
from derivations.elements.backlash import CONTACT, GAP, SEPARATION, friction_waveform, inertia_waveform
from derivations.elements.backlash_closed_forms import (
    contact_antiderivative,
    contact_antiderivative_of_harmonic,
    contact_integral,
    contact_integral_of_harmonic,
    friction_fundamental,
    friction_harmonic,
    inertia_fundamental,
    inertia_harmonic,
    resting_antiderivative,
    resting_integral,
    straight_antiderivative,
    straight_integral,
    turned,
)
from derivations.elements.backlash_harmonics import (
    CONTACT_ANGLE,
    MEANINGS,
    SteadyMotion,
    friction_motion,
    inertia_motion,
)
from derivations.elements.harmonics import HARMONIC, odd_harmonic
from derivations.elements.proven_step import (
    Equality,
    ProvenStep,
    Substitutions,
    antiderivative_on,
    cases,
    integral_over,
)
from derivations.elements.steps.general_backlash import BEYOND, ON_CONTACT, ON_FLIGHT
from derivations.symbols import A

ONE = sympy.Integer(1)
ODD = (turned(3 * sympy.pi / 2), -turned(sympy.pi / 2))
"""Half a turn more changes the sign of exp(-jnθ) for odd n; SymPy does not see it at this phase."""


def friction_backlash() -> ProvenStep:
    """Return the step on friction-controlled backlash, M/D → 0 (thesis, equations 2.36 to 2.41)."""
    motion = friction_motion()
    given = (*_given(motion), ODD)
    fundamental = friction_fundamental()
    return ProvenStep(
        "df-friction-backlash",
        "Friction-controlled backlash",
        "A load without inertia ($M/D \\to 0$) stops as soon as it is not pushed. The pin leaves it at its "
        "peak, $\\theta = \\pi/2$, and meets it again at the phase $\\phi_c$ after the flight $\\lambda = "
        "\\phi_c - \\pi/2$; the angle of contact is $\\ell = \\pi - \\lambda$. It moves if $A > g/2$.",
        (
            cases("y", motion.waveform.segments, "2.36"),
            Equality(r"\frac{g}{A}", total(1, sympy.cos(CONTACT_ANGLE)), motion.ratio(), given=given),
            *_integrals(motion, (resting_antiderivative(), resting_integral()), given),
            Equality("N_1", fundamental, motion.describing_function(ONE), "2.41", given),
            *_coefficients(fundamental),
            Equality("N_n", friction_harmonic(), motion.describing_function(HARMONIC), given=given),
        ),
        code=(friction_waveform, odd_harmonic, friction_fundamental),
    )


def inertia_backlash() -> ProvenStep:
    """Return the step on inertia-controlled backlash, M/D → ∞ (thesis, equations 2.42 and 2.43)."""
    motion = inertia_motion()
    given = _given(motion)
    return ProvenStep(
        "df-inertia-backlash",
        "Inertia-controlled backlash",
        "A load without friction ($M/D \\to \\infty$) keeps its velocity. The pin leaves it where it is "
        "fastest, at $\\theta = 0$. The load meets it again at $\\phi_c$, which is also the angle of flight; "
        "the impact is plastic. There is such a motion for $\\phi_c < \\pi$, that is for $A > g/\\pi$.",
        (
            cases("y", motion.waveform.segments, "2.42"),
            Equality(r"\frac{g}{A}", total(CONTACT, -sympy.sin(CONTACT)), motion.ratio(), given=given),
            *_integrals(motion, (straight_antiderivative(), straight_integral()), given),
            Equality("N_1", inertia_fundamental(), motion.describing_function(ONE), "2.43", given),
            Equality("N_n", inertia_harmonic(), motion.describing_function(HARMONIC), given=given),
        ),
        code=(inertia_waveform, odd_harmonic, inertia_fundamental),
    )


def _given(motion: SteadyMotion) -> Substitutions:
    return (*MEANINGS, (SEPARATION, motion.separation))


def _integrals(
    motion: SteadyMotion, flight: tuple[sympy.Expr, sympy.Expr], given: Substitutions
) -> tuple[Equality, ...]:
    """Return antiderivative and integral of flight and contact, the latter for n = 1 and other odd n.

    Args:
        motion: The load's motion.
        flight: Antiderivative and integral of its flight in closed form.
        given: What symbols stand for, see ``Equality``.
    """
    separation, (primitive, integral) = motion.separation, flight
    return (
        antiderivative_on(motion.flight, HARMONIC, primitive, ON_FLIGHT),
        integral_over(motion.flight, HARMONIC, integral, given),
        antiderivative_on(motion.contact, ONE, contact_antiderivative(), ON_CONTACT),
        integral_over(motion.contact, ONE, contact_integral(separation), given),
        antiderivative_on(motion.contact, HARMONIC, contact_antiderivative_of_harmonic(), BEYOND),
        integral_over(motion.contact, HARMONIC, contact_integral_of_harmonic(separation), given),
    )


def _coefficients(fundamental: sympy.Expr) -> tuple[Equality, ...]:
    """Return a_1 and b_1 of friction-controlled backlash by gap and amplitude, as the thesis has them."""
    cosine = total(GAP / A, -1)
    root = sympy.sqrt(total(1, -(cosine**2)))
    given = ((CONTACT_ANGLE, sympy.acos(cosine)), (cosine, GAP / A - 1))
    real, imaginary = (sympy.expand(A * part(fundamental)) for part in (sympy.re, sympy.im))
    return (
        Equality("a_1", product(GAP / sympy.pi, total(GAP / A, -2)), imaginary, "2.38", given),
        Equality(
            "b_1",
            product(A / sympy.pi, total(sympy.acos(cosine), -product(cosine, root))),
            real,
            "2.40",
            given,
        ),
    )
