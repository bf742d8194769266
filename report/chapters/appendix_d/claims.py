"""Claims of appendix D: the equation of motion of the motor, step by step."""

import sympy

from derivations.symbols import accelerations, c1, c2, k1, k2, m1, q1, q2, t, u, u_dot, velocities
from report.chapters.chapter_2.claims import trimmer_printed
from report.chapters.chapter_2.claims.section_2_2_1 import MOTOR_ITEM
from report.chapters.chapter_2.claims.section_2_2_2 import transformed_state_space
from report.judging.comparisons.printed import total
from report.judging.parts import expression, made_here, same
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence

V1, V2, *_ = velocities


@claim("eq-D.1")
def lagrangian(known: Evidence) -> Record:
    printed = total(trimmer_printed.kinetic_energy(), -trimmer_printed.potential_energy())
    yield expression("", printed, known.derivation.lagrangian, left=sympy.Symbol("L"))
    yield text("""
        The energies are those of [equations 2.4](#eq-2.4) and [2.5](#eq-2.5), and their difference is right.
        The potential energy is called $V$ here and $U$ in section 2.2.1.
    """)


@claim("eq-D.2")
def momentum_rate(known: Evidence) -> Record:
    derived = known.derivation.lagrangian.diff(V1).diff(t)
    left = r"\frac{d}{dt}\left(\frac{\partial L}{\partial \dot{q}_1}\right)"
    form = rf"{left} = \frac{{d}}{{dt}}(m_1\dot q_1) = m_1\ddot q_1"
    yield expression("", m1 * accelerations[0], derived, form=form)
    yield text(r"Of the Lagrangian only the kinetic energy contains $\dot q_1$, so the line is right.")


@claim("eq-D.3")
def slope_of_lagrangian(known: Evidence) -> Record:
    derived = sympy.expand(known.derivation.lagrangian.diff(q1))
    spring_force = sympy.expand(m1 * known.derivation.newton[0].subs({V1: 0, V2: 0, u_dot: 0}))
    printed = total(k1 * q1, -k2 * q2, k2 * q1, k2 * u)
    yield expression(
        "",
        printed,
        derived,
        left=r"\frac{\partial L}{\partial q_1}",
        second=same("the spring forces on the motor at rest", spring_force, derived),
        slip=made_here("the minus sign before the slope is left out", -derived),
        severity=Severity.SLIP,
        certainty=Certainty.READING,
    )
    yield text(r"""
        Every sign is reversed: the right side is $-\partial L/\partial q_1$. One minus sign before the slope,
        which the Euler-Lagrange equation has there, makes the line right. A machine that read the page could
        have dropped it, but it has kept every minus sign of the right side and of the lines around. So the
        slip is rather the author's; the page shows it.

        Nothing comes of it: [equation D.5](#eq-D.5) has the right signs.
    """)


@claim("eq-D.4")
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


@claim("eq-D.5")
def equation_of_motion(known: Evidence) -> Record:
    derived = known.derivation.accelerations[0]
    by_newton = same("Newton's second law", known.derivation.newton[0], derived)
    printed, left = trimmer_printed.accelerations()[0], accelerations[0]
    yield expression("", printed, derived, left=left, second=by_newton, item=MOTOR_ITEM)
    yield text("""
        The result is right and the same as in [equation 2.9](#eq-2.9). It follows from
        [equation D.3](#eq-D.3) once that line has its minus sign.
    """)


@claim("eq-D.6")
def laplace_domain(known: Evidence) -> Record:
    yield from transformed_state_space(known)
    yield text("These are the lines of [equation 2.20](#eq-2.20), right for a system that starts at rest.")
