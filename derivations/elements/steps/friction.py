"""Describing functions of the ideal relay, of Coulomb friction and of viscous friction."""

import sympy

from derivations import assumed
from derivations.algebra.unevaluated import product, total
from derivations.elements.backlash_closed_forms import BEYOND_FUNDAMENTAL, swept
from derivations.elements.friction import (
    DAMPING,
    FORCE,
    LEVEL,
    friction_waveform,
    relay_waveform,
    viscous_waveform,
)
from derivations.elements.harmonics import HARMONIC, odd_harmonic
from derivations.elements.proven_step import Equality, ProvenStep, antiderivative_on, cases, integral_over
from derivations.elements.waveform import THETA
from derivations.latex import latex
from derivations.step import Formula
from derivations.symbols import A, omega

ONE = sympy.Integer(1)
VELOCITY_AMPLITUDE = assumed.positive("A_v")  # Amplitude of a velocity, m/s
UP = "On the first half of the period:"
COUNT = sympy.Symbol("m", integer=True, nonnegative=True)


def relay() -> ProvenStep:
    """Return the step on the ideal relay, which Coulomb friction of a velocity is."""
    waveform = relay_waveform(LEVEL)
    first = waveform.segments[0]
    return ProvenStep(
        "df-relay",
        "Ideal relay",
        "The output is $L$ while the input is positive and $-L$ while it is negative.",
        (
            cases("y", waveform.segments),
            antiderivative_on(first, HARMONIC, sympy.I * LEVEL / HARMONIC * _turned(HARMONIC), UP),
            integral_over(first, HARMONIC, -2 * sympy.I * LEVEL / HARMONIC),
            Equality("N_n", 4 * LEVEL / (sympy.pi * HARMONIC * A), odd_harmonic(waveform, A, HARMONIC)),
        ),
        code=(relay_waveform, odd_harmonic),
    )


def coulomb_friction() -> ProvenStep:
    """Return the step on Coulomb friction of a velocity and of a displacement (thesis, 2.48 to 2.52)."""
    of_velocity, of_displacement = relay_waveform(FORCE), friction_waveform()
    first = of_displacement.segments[0]
    fourfold = tuple(total(4 * COUNT, rest) for rest in (1, 3))
    integrals = (2 * FORCE / fourfold[0], -2 * FORCE / fourfold[1])
    harmonics = tuple(
        sign * sympy.I * 4 * FORCE / (sympy.pi * harmonic * A)
        for sign, harmonic in zip((1, -1), fourfold, strict=True)
    )
    return ProvenStep(
        "df-coulomb-friction",
        "Coulomb friction",
        "The force has the sign of the velocity. For a velocity $A_v\\sin\\theta$ as input it is a relay, "
        "and $N_n$ is in N s/m. For a displacement $A\\sin\\theta$ as input the velocity is proportional to "
        "$\\cos\\theta$: the force leads by a quarter period, $N_n$ is imaginary, in N/m, and its sign "
        "changes from one odd harmonic to the next ($m = 0, 1, 2, \\dots$).",
        (
            Formula(rf"y = {latex(FORCE)} \operatorname{{sign}} \dot{{x}}", "2.48"),
            Equality("a_1", sympy.Integer(0), of_velocity.cosine_coefficient(), "2.50"),
            Equality("b_1", 4 * FORCE / sympy.pi, of_velocity.sine_coefficient(), "2.51"),
            Equality(
                "N_n",
                4 * FORCE / (sympy.pi * HARMONIC * VELOCITY_AMPLITUDE),
                odd_harmonic(of_velocity, VELOCITY_AMPLITUDE, HARMONIC),
                "2.52",
            ),
            cases("y", of_displacement.segments),
            antiderivative_on(first, HARMONIC, -sympy.I * FORCE / HARMONIC * _turned(HARMONIC), UP),
            *(
                integral_over(first, harmonic, closed)
                for harmonic, closed in zip(fourfold, integrals, strict=True)
            ),
            *(
                Equality(f"N_{{{latex(harmonic)}}}", closed, odd_harmonic(of_displacement, A, harmonic))
                for harmonic, closed in zip(fourfold, harmonics, strict=True)
            ),
        ),
        code=(relay_waveform, friction_waveform, odd_harmonic),
    )


def viscous_friction() -> ProvenStep:
    """Return the step on viscous friction of a displacement, a linear element."""
    waveform = viscous_waveform()
    first = waveform.segments[0]
    size = DAMPING * omega * A
    force, beyond = product(sympy.pi / 2, size), -size / BEYOND_FUNDAMENTAL
    return ProvenStep(
        "df-viscous-friction",
        "Viscous friction",
        "A force $d\\,\\dot x$ of a displacement $A\\sin\\theta$ is linear: it has no higher harmonics, and "
        "$N_1$ is its transfer function at $s = j\\omega$.",
        (
            Formula(f"y = {latex(first.value)}"),
            antiderivative_on(first, ONE, product(size, _fundamental_of_cosine()), f"{UP[:-1]}, $n = 1$:"),
            integral_over(first, ONE, force),
            antiderivative_on(first, HARMONIC, product(beyond, swept(THETA)), "For odd $n \\ge 3$:"),
            integral_over(first, HARMONIC, sympy.Integer(0)),
            Equality("N_1", sympy.I * omega * DAMPING, odd_harmonic(waveform, A, ONE)),
            Equality("N_n", sympy.Integer(0), odd_harmonic(waveform, A, HARMONIC)),
        ),
        code=(viscous_waveform, odd_harmonic),
    )


def _turned(harmonic: sympy.Expr) -> sympy.Expr:
    return sympy.exp(-sympy.I * harmonic * THETA)


def _fundamental_of_cosine() -> sympy.Expr:
    """Return an antiderivative of cos θ exp(-jθ)."""
    return total(THETA / 2, sympy.I / 4 * _turned(2))
