"""Claims of section 3.3 on Coulomb friction in the equations of motion (equation 3.2)."""

from __future__ import annotations

import sympy

from derivations.coulomb_contact import friction_forces, power, relative_velocity
from derivations.friction import FORCE
from derivations.identity import prove_equal
from derivations.mechanism import Body
from derivations.symbols import masses, velocities
from report.chapters.chapter_2.claims.trimmer_printed import accelerations
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.expression import SameExpression
from report.comparisons.printed import over, product, total
from report.comparisons.second_ways import second_way
from report.evidence import Evidence

SOURCE = "derivations/coulomb_contact.py"
PRINTED_RATE = velocities[1] - velocities[0]
PRINTED_FRICTION = product(FORCE, sympy.sign(total(velocities[1], -velocities[0])))
PRINTED_SIGNS = (-1, 1, 0, 0)
"""Sign of the friction in each line of equation 3.2."""
ALONG = "friction acts along the relative motion instead of against it"
NAMES = ("first", "second", "third", "fourth")


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_equations(evidence), _force(evidence))


def _derived_forces(evidence: Evidence) -> tuple[sympy.Expr, ...]:
    """Return friction between cutter and motor, whose relative velocity equation 3.2 has."""
    mechanism = evidence.derivation.mechanism
    motor, cutter = mechanism.bodies[:2]
    return friction_forces(mechanism, cutter, motor)


def _printed_lines() -> tuple[sympy.Expr, ...]:
    """Return the right sides of equation 3.2."""
    lines = []
    for linear, mass, sign in zip(accelerations(), masses, PRINTED_SIGNS, strict=True):
        _, bracket = linear.args
        friction = {1: (PRINTED_FRICTION,), -1: (-PRINTED_FRICTION,), 0: ()}[sign]
        lines.append(over(total(*bracket.args, *friction), mass))
    return tuple(lines)


def _equations(evidence: Evidence) -> Claim:
    derivation, forces = evidence.derivation, _derived_forces(evidence)
    takes = Confirmation(
        "the power of the two forces, which is $-F_c$ times the relative speed",
        SameExpression(-FORCE * sympy.sign(PRINTED_RATE) * PRINTED_RATE, power(derivation.mechanism, forces)),
    )
    parts = []
    for index, printed in enumerate(_printed_lines()):
        linear, force = derivation.accelerations[index], forces[index] / masses[index]
        wrong = force != 0
        parts.append(
            Part(
                f"{NAMES[index]} line",
                SameExpression(printed, linear + force, left=rf"\ddot q_{index + 1}"),
                takes if wrong else _by_newton(evidence, index),
                Slip(ALONG, linear - force, Verdict.ERRATUM) if wrong else None,
            )
        )
    run, opposite = evidence.motion.printed_friction.as_printed[0], evidence.motion.printed_friction.opposite
    return Claim(
        id="eq-3.2",
        parts=tuple(parts),
        explanation=(
            "The linear terms are those of equation 2.9. The friction of the first two lines has the wrong "
            "sign: it pushes either body the way it already slides. Simulated as printed, beside a pin that "
            f"does not reach the bridge, the trimmer's energy rises from {1e6 * run.energy[0]:.0f} to "
            f"{1e6 * run.energy[-1]:.0f} µJ in {run.times[-1]:.1f} s with {run.force} N; with the signs "
            f"turned it falls below {1e6 * opposite.energy[-1]:.2f} µJ."
        ),
        consequence=(
            "A model built as printed oscillates by itself, with an amplitude that grows with $F_c$. The "
            "text reports amplitudes that fall, so what was simulated had, it seems, the right sign."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _by_newton(evidence: Evidence, index: int) -> Confirmation:
    derivation = evidence.derivation
    return Confirmation(
        "the forces on the body", SameExpression(derivation.newton[index], derivation.accelerations[index])
    )


def _force(evidence: Evidence) -> Claim:
    first, *_, last = evidence.motion.printed_friction.as_printed
    return Claim(
        id="txt-3.3-friction-force",
        parts=(_rubbing_parts(evidence), _direction(evidence)),
        explanation=(
            "Equation 3.2 lets motor and cutter rub on each other; section 2.3.5 and the text of 3.3 speak "
            "of cutter and guard, whose forces belong into the second and fourth line. As printed the force "
            "feeds the motion: beside a pin that does not reach it the trimmer then oscillates at "
            f"{first.frequency:.0f} Hz, a natural mode, whatever the gap, with {1e6 * first.amplitude:.0f} "
            f"µm for {first.force} N and {1e6 * last.amplitude:.0f} µm for {last.force} N."
        ),
        consequence=(
            "This report simulates friction between cutter and guard, against their motion. Between motor "
            "and cutter it would act much alike, since the guard moves little."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _body(evidence: Evidence, index: int) -> Body:
    return evidence.derivation.mechanism.bodies[index]


def _rubbing_parts(evidence: Evidence) -> Part:
    cutter, guard = _body(evidence, 1), _body(evidence, 3)
    proof = prove_equal(PRINTED_RATE, relative_velocity(cutter, guard))
    return Part(
        "which parts rub",
        Assertion(
            statement="the relative velocity in the force is that of cutter and guard",
            derived=proof.holds,
            evidence=(
                "$\\dot q_2 - \\dot q_1$ is the velocity of the cutter relative to the motor; relative to "
                "the guard it is $\\dot q_2 - \\dot q_4$"
            ),
            method="relative velocity of two bodies of the mechanism",
        ),
        second_way(
            "cutter and guard moving as one, which do not rub and for which the printed velocity is not zero",
            PRINTED_RATE.subs({velocities[0]: 0, velocities[1]: 1, velocities[3]: 1}) != 0,
        ),
    )


def _direction(evidence: Evidence) -> Part:
    mechanism = evidence.derivation.mechanism
    printed = power(mechanism, tuple(sign * PRINTED_FRICTION for sign in PRINTED_SIGNS))
    right = power(mechanism, _derived_forces(evidence))
    simulated = evidence.motion.printed_friction
    as_printed, opposite = simulated.as_printed[0], simulated.opposite
    return Part(
        "which way it acts",
        Assertion(
            statement="the forces of equation 3.2 resist the relative motion",
            derived=prove_equal(printed, right).holds,
            evidence=(
                "their power is $+F_c|\\dot q_2 - \\dot q_1|$, that of friction $-F_c|\\dot q_2 - \\dot q_1|$"
            ),
            method="sum of force times velocity over the lines, against the dissipation function",
        ),
        second_way(
            "the simulated energy, which rises with the printed signs and falls with the others",
            as_printed.energy[-1] > as_printed.energy[0] and opposite.energy[-1] < opposite.energy[0],
        ),
    )
