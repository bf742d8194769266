"""Claims of section 3.3 on Coulomb friction in the equations of motion (equation 3.2)."""

from __future__ import annotations

import sympy

from derivations.coulomb_contact import friction_forces, power, relative_velocity
from derivations.friction import FORCE
from derivations.identity import prove_equal
from derivations.symbols import masses, velocities
from report.chapters.chapter_2.claims.trimmer_printed import accelerations
from report.claim import Confirmation, Impact
from report.comparisons.expression import SameExpression
from report.comparisons.printed import over, product, total
from report.evidence import Evidence
from report.parts import assertion, expression, made_here, so
from report.record import Record, claim, text

SOURCE = "derivations/coulomb_contact.py"
PRINTED_RATE = velocities[1] - velocities[0]
PRINTED_FRICTION = product(FORCE, sympy.sign(total(velocities[1], -velocities[0])))
PRINTED_SIGNS = (-1, 1, 0, 0)
"""Sign of the friction in each line of equation 3.2."""
NAMES = ("first", "second", "third", "fourth")


def derived_forces(known: Evidence) -> tuple[sympy.Expr, ...]:
    """Return friction between cutter and motor, whose relative velocity equation 3.2 has."""
    motor, cutter, *_ = known.derivation.mechanism.bodies
    return friction_forces(known.derivation.mechanism, cutter, motor)


@claim("eq-3.2", source=SOURCE, impact=Impact.LOCAL)
def equations_of_motion(known: Evidence) -> Record:
    derivation, forces = known.derivation, derived_forces(known)
    takes = Confirmation(
        "the power of the two forces, which is $-F_c$ times the relative speed",
        SameExpression(-FORCE * sympy.sign(PRINTED_RATE) * PRINTED_RATE, power(derivation.mechanism, forces)),
    )
    slip = "friction acts along the relative motion instead of against it"
    for index, (printed, sign) in enumerate(zip(accelerations(), PRINTED_SIGNS, strict=True)):
        _, bracket = printed.args
        friction = {1: (PRINTED_FRICTION,), -1: (-PRINTED_FRICTION,), 0: ()}[sign]
        linear, force = derivation.accelerations[index], forces[index] / masses[index]
        by_newton = Confirmation("the forces on the body", SameExpression(derivation.newton[index], linear))
        yield expression(
            f"{NAMES[index]} line",
            over(total(*bracket.args, *friction), masses[index]),
            linear + force,
            left=rf"\ddot q_{index + 1}",
            second=takes if force != 0 else by_newton,
            slip=made_here(slip, linear - force) if force != 0 else None,
        )
    run, opposite = known.motion.printed_friction.as_printed[0], known.motion.printed_friction.opposite
    yield text(
        """
        The linear terms are those of equation 2.9. The friction of the first two lines has the wrong sign: it
        pushes either body the way it already slides. Simulated as printed, beside a pin that does not reach
        the bridge, the trimmer's energy rises from [[ start | f0 ]] to [[ end | f0 ]] µJ in [[ time | f1 ]] s
        with [[ force ]] N; with the signs turned it falls below [[ turned | f2 ]] µJ.

        A model built as printed oscillates by itself, with an amplitude that grows with $F_c$. The text
        reports amplitudes that fall, so what was simulated had, it seems, the right sign.
        """,
        start=1e6 * run.energy[0],
        end=1e6 * run.energy[-1],
        time=run.times[-1],
        force=run.force,
        turned=1e6 * opposite.energy[-1],
    )


@claim("txt-3.3-friction-force", source=SOURCE, impact=Impact.DOWNSTREAM)
def force_of_friction(known: Evidence) -> Record:
    mechanism, simulated = known.derivation.mechanism, known.motion.printed_friction
    _, cutter, _, guard = mechanism.bodies
    as_one = "cutter and guard moving as one, which do not rub and for which the printed velocity is not zero"
    together = PRINTED_RATE.subs({velocities[0]: 0, velocities[1]: 1, velocities[3]: 1})
    relative = r"$\dot q_2 - \dot q_1$ is the velocity of the cutter relative to the motor"
    yield assertion(
        "which parts rub",
        "the relative velocity in the force is that of cutter and guard",
        prove_equal(PRINTED_RATE, relative_velocity(cutter, guard)).holds,
        rf"{relative}; relative to the guard it is $\dot q_2 - \dot q_4$",
        method="relative velocity of two bodies of the mechanism",
        second=so(as_one, together != 0),
    )
    printed = power(mechanism, tuple(sign * PRINTED_FRICTION for sign in PRINTED_SIGNS))
    first, *_, last = simulated.as_printed
    rises, falls = (run.energy[-1] > run.energy[0] for run in (first, simulated.opposite))
    energy = "the simulated energy, which rises with the printed signs and falls with the others"
    yield assertion(
        "which way it acts",
        "the forces of equation 3.2 resist the relative motion",
        prove_equal(printed, power(mechanism, derived_forces(known))).holds,
        r"their power is $+F_c|\dot q_2 - \dot q_1|$, that of friction $-F_c|\dot q_2 - \dot q_1|$",
        method="sum of force times velocity over the lines, against the dissipation function",
        second=so(energy, rises and not falls),
    )
    yield text(
        """
        Equation 3.2 lets motor and cutter rub on each other; section 2.3.5 and the text of 3.3 speak of
        cutter and guard, whose forces belong into the second and fourth line. As printed the force feeds the
        motion: beside a pin that does not reach it the trimmer then oscillates at [[ frequency | f0 ]] Hz, a
        natural mode, whatever the gap, with [[ least | f0 ]] µm for [[ least_force ]] N and [[ most | f0 ]]
        µm for [[ most_force ]] N.

        This report simulates friction between cutter and guard, against their motion. Between motor and
        cutter it would act much alike, since the guard moves little.
        """,
        frequency=first.frequency,
        least=1e6 * first.amplitude,
        least_force=first.force,
        most=1e6 * last.amplitude,
        most_force=last.force,
    )
