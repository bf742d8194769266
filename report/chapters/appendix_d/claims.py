"""Claims of appendix D: the equation of motion of the motor, step by step."""

from __future__ import annotations

import sympy

from derivations.symbols import accelerations, c1, c2, k1, k2, m1, q1, q2, t, u, u_dot, velocities
from report.chapters.chapter_2.claims import section_2_2_2, trimmer_printed
from report.claim import Impact
from report.comparisons.printed import total
from report.evidence import Evidence
from report.parts import expression, made_here, same
from report.record import Record, claim, text

SOURCE = "derivations/equations_of_motion.py"
V1, V2, *_ = velocities


@claim("eq-D.1", source=SOURCE)
def lagrangian(known: Evidence) -> Record:
    printed = total(trimmer_printed.kinetic_energy(), -trimmer_printed.potential_energy())
    yield expression("", printed, known.derivation.lagrangian, left=sympy.Symbol("L"))
    yield text("""
        The energies are those of equations 2.4 and 2.5, and their difference is right. The potential energy
        is called $V$ here and $U$ in section 2.2.1.
    """)


@claim("eq-D.2", source=SOURCE)
def momentum_rate(known: Evidence) -> Record:
    derived = known.derivation.lagrangian.diff(V1).diff(t)
    left = r"\frac{d}{dt}\left(\frac{\partial L}{\partial \dot{q}_1}\right)"
    yield expression("", m1 * accelerations[0], derived, left=left)
    yield text(r"Only the kinetic energy holds $\dot q_1$, so its rate of momentum is as printed.")


@claim("eq-D.3", source=SOURCE, impact=Impact.LOCAL)
def slope_of_lagrangian(known: Evidence) -> Record:
    derived = sympy.expand(known.derivation.lagrangian.diff(q1))
    spring_force = sympy.expand(m1 * known.derivation.newton[0].subs({V1: 0, V2: 0, u_dot: 0}))
    yield expression(
        "",
        total(k1 * q1, -k2 * q2, k2 * q1, k2 * u),
        derived,
        left=r"\frac{\partial L}{\partial q_1}",
        second=same("the spring forces on the motor at rest", spring_force, derived),
        slip=made_here("the slope of U is written for the slope of L = T - U", -derived),
    )
    yield text(r"""
        Every sign is reversed: printed is $\partial U/\partial q_1$, which is $-\partial L/\partial q_1$. Put
        into equation 2.6 as it stands, it would turn both springs of the motor into pushing ones.

        None downstream: equation D.5, which should follow from this line, has the right signs.
    """)


@claim("eq-D.4", source=SOURCE)
def slope_of_dissipation(known: Evidence) -> Record:
    derived = sympy.expand(known.derivation.rayleigh_function.diff(V1))
    # The rates have to survive when u and the coordinates are put to zero, so they are named first.
    named = {rate: sympy.Dummy(real=True) for rate in (u_dot, *velocities)}
    back = {name: rate for rate, name in named.items()}
    damper_force = (-m1 * known.derivation.newton[0].subs(named).subs({q1: 0, q2: 0, u: 0})).subs(back)
    yield expression(
        "",
        total(c1 * V1, -c2 * V2, c2 * V1, c2 * u_dot),
        derived,
        left=r"\frac{\partial R}{\partial \dot{q}_1}",
        second=same("the damper forces on the motor", damper_force, derived),
    )
    yield text("The slope of the dissipation function is right, with all its signs.")


@claim("eq-D.5", source=SOURCE)
def equation_of_motion(known: Evidence) -> Record:
    derived = known.derivation.accelerations[0]
    by_newton = same("Newton's second law", known.derivation.newton[0], derived)
    yield expression("", trimmer_printed.accelerations()[0], derived, left=accelerations[0], second=by_newton)
    yield text("""
        The result is right and the same as in equation 2.9. It does not follow from equation D.3 as printed,
        whose signs are reversed.
    """)


again = section_2_2_2.state_space_in_laplace_domain.items
laplace_domain = claim("eq-D.6", source="derivations/algebra/laplace.py")(again)
