"""Claims of appendix D: the equation of motion of the motor, step by step."""

from __future__ import annotations

import sympy

from derivations.symbols import (
    accelerations,
    c1,
    c2,
    k1,
    k2,
    m1,
    q1,
    q2,
    t,
    u,
    u_dot,
    velocities,
)
from report.chapters.chapter_2.claims import trimmer_printed
from report.chapters.chapter_2.claims.section_2_2_2 import transformed_state_space
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.evidence import Evidence

SOURCE = "derivations/equations_of_motion.py"
V1, V2, *_ = velocities


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _lagrangian(evidence),
        _momentum_rate(evidence),
        _slope_of_lagrangian(evidence),
        _slope_of_dissipation(evidence),
        _equation_of_motion(evidence),
        transformed_state_space(evidence, "eq-D.6"),
    )


def _lagrangian(evidence: Evidence) -> Claim:
    printed = total(trimmer_printed.kinetic_energy(), -trimmer_printed.potential_energy())
    return Claim(
        id="eq-D.1",
        parts=(Part("", SameExpression(printed, evidence.derivation.lagrangian, left=sympy.Symbol("L"))),),
        explanation=(
            "The energies are those of equations 2.4 and 2.5, and their difference is right. The potential "
            "energy is called $V$ here and $U$ in section 2.2.1."
        ),
        source=SOURCE,
    )


def _momentum_rate(evidence: Evidence) -> Claim:
    derived = evidence.derivation.lagrangian.diff(V1).diff(t)
    return Claim(
        id="eq-D.2",
        parts=(
            Part(
                "",
                SameExpression(
                    m1 * accelerations[0],
                    derived,
                    left=r"\frac{d}{dt}\left(\frac{\partial L}{\partial \dot{q}_1}\right)",
                ),
            ),
        ),
        explanation="Only the kinetic energy holds $\\dot q_1$, so its rate of momentum is as printed.",
        source=SOURCE,
    )


def _slope_of_lagrangian(evidence: Evidence) -> Claim:
    printed = total(k1 * q1, -k2 * q2, k2 * q1, k2 * u)
    derived = sympy.expand(evidence.derivation.lagrangian.diff(q1))
    at_rest = {V1: 0, V2: 0, u_dot: 0}
    spring_force = sympy.expand(m1 * evidence.derivation.newton[0].subs(at_rest))
    return Claim(
        id="eq-D.3",
        parts=(
            Part(
                "",
                SameExpression(printed, derived, left=r"\frac{\partial L}{\partial q_1}"),
                Confirmation("the spring forces on the motor at rest", SameExpression(spring_force, derived)),
                Slip("the slope of U is written for the slope of L = T - U", -derived, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "Every sign is reversed: printed is $\\partial U/\\partial q_1$, which is $-\\partial "
            "L/\\partial q_1$. Put into equation 2.6 as it stands, it would turn both springs of the motor "
            "into pushing ones."
        ),
        consequence=(
            "None downstream: equation D.5, which should follow from this line, has the right signs."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _slope_of_dissipation(evidence: Evidence) -> Claim:
    printed = total(c1 * V1, -c2 * V2, c2 * V1, c2 * u_dot)
    derived = sympy.expand(evidence.derivation.rayleigh_function.diff(V1))
    at_rest = {q1: 0, q2: 0, u: 0}
    # The rate u' has to survive when u is put to zero, so it is named first.
    rate = sympy.Symbol("rate", real=True)
    newton = evidence.derivation.newton[0].subs(u_dot, rate)
    named = {velocity: sympy.Symbol(f"v_{index}", real=True) for index, velocity in enumerate(velocities)}
    damper_force = -m1 * newton.subs(named).subs(at_rest)
    back = {symbol: velocity for velocity, symbol in named.items()} | {rate: u_dot}
    return Claim(
        id="eq-D.4",
        parts=(
            Part(
                "",
                SameExpression(printed, derived, left=r"\frac{\partial R}{\partial \dot{q}_1}"),
                Confirmation(
                    "the damper forces on the motor", SameExpression(damper_force.subs(back), derived)
                ),
            ),
        ),
        explanation="The slope of the dissipation function is right, with all its signs.",
        source=SOURCE,
    )


def _equation_of_motion(evidence: Evidence) -> Claim:
    derived = evidence.derivation.accelerations[0]
    return Claim(
        id="eq-D.5",
        parts=(
            Part(
                "",
                SameExpression(trimmer_printed.accelerations()[0], derived, left=accelerations[0]),
                Confirmation("Newton's second law", SameExpression(evidence.derivation.newton[0], derived)),
            ),
        ),
        explanation=(
            "The result is right and the same as in equation 2.9. It does not follow from equation D.3 as "
            "printed, whose signs are reversed."
        ),
        source=SOURCE,
    )
