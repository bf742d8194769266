"""Claims of section 3.3 on friction in equation 3.2: between which parts, and which way it acts."""

import sympy

from derivations.algebra.identity import prove_equal
from derivations.elements.coulomb_contact import friction_forces, power, relative_velocity
from derivations.elements.friction import FORCE
from derivations.symbols import masses, velocities
from report.chapters.chapter_2.claims.trimmer_printed import accelerations
from report.judging.comparisons.printed import over, product, total
from report.judging.parts import assertion, expression, made_here, same, so
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence

PRINTED_RATE = velocities[1] - velocities[0]
PRINTED_FRICTION = product(FORCE, sympy.sign(total(velocities[1], -velocities[0])))
PRINTED_SIGNS = (-1, 1, 0, 0)  # Sign of the friction in each line of equation 3.2
SIGN_OF_FRICTION = "sign of Coulomb friction in equation 3.2"


def derived_forces(known: Evidence) -> tuple[sympy.Expr, ...]:
    """Return friction between cutter and motor, whose relative velocity equation 3.2 has."""
    motor, cutter, *_ = known.derivation.mechanism.bodies
    return friction_forces(known.derivation.mechanism, cutter, motor)


@claim("eq-3.2")
def equations_of_motion(known: Evidence) -> Record:
    derivation, forces = known.derivation, derived_forces(known)
    takes = same(
        "the power of the two forces, which is $-F_c$ times the relative speed",
        -FORCE * sympy.sign(PRINTED_RATE) * PRINTED_RATE,
        power(derivation.mechanism, forces),
    )
    slip = "friction acts along the relative motion instead of against it"
    for index, (printed, sign) in enumerate(zip(accelerations(), PRINTED_SIGNS, strict=True)):
        _, bracket = printed.args
        friction = {1: (PRINTED_FRICTION,), -1: (-PRINTED_FRICTION,), 0: ()}[sign]
        linear, force = derivation.accelerations[index], forces[index] / masses[index]
        by_newton = same("the forces on the body", derivation.newton[index], linear)
        yield expression(
            f"{('first', 'second', 'third', 'fourth')[index]} line",
            over(total(*bracket.args, *friction), masses[index]),
            linear + force,
            left=rf"\ddot q_{index + 1}",
            second=takes if force != 0 else by_newton,
            slip=made_here(slip, linear - force) if force != 0 else None,
            item=SIGN_OF_FRICTION if force != 0 else "",
        )
    run, opposite = known.motion.printed_friction.as_printed[0], known.motion.printed_friction.opposite
    yield text(f"""
        The linear terms are those of equation 2.9. The friction of the first two lines has the wrong sign: it
        pushes either body the way it already slides. Simulated as printed, with a pin that never reaches the
        bridge, the trimmer gains energy: {1e6 * run.energy[0]:.0f} µJ become {1e6 * run.energy[-1]:.0f} µJ in
        {run.times[-1]:.1f} s with {run.force} N. With the signs turned less than
        {1e6 * opposite.energy[-1]:.2f} µJ are left.

        A model built as printed oscillates by itself, with an amplitude that grows with $F_c$. The text
        reports amplitudes that fall, so the model that was simulated seems to have had the right sign.
    """)


@claim("txt-3.3-friction-force")
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
    gain, loss = (run.energy[-1] - run.energy[0] for run in (first, simulated.opposite))
    energy = "the simulated energy, which rises with the printed signs and falls with the others"
    yield assertion(
        "which way it acts",
        "the forces of equation 3.2 resist the relative motion",
        prove_equal(printed, power(mechanism, derived_forces(known))).holds,
        r"their power is $+F_c|\dot q_2 - \dot q_1|$, that of friction $-F_c|\dot q_2 - \dot q_1|$",
        method="sum of force times velocity over the lines, against the dissipation function",
        second=so(energy, gain > 0 > loss),
        item=SIGN_OF_FRICTION,
    )
    yield text(f"""
        Equation 3.2 lets motor and cutter rub on each other. Section 2.3.5 and the text of 3.3 speak of
        cutter and guard, whose forces belong into the second and fourth line. The sign is that of [equation
        3.2](#eq-3.2): the force feeds the motion. Even with a pin that never reaches the bridge the trimmer
        then oscillates at {first.frequency:.0f} Hz, a natural mode, by {1e6 * first.amplitude:.0f} µm for
        {first.force} N and by {1e6 * last.amplitude:.0f} µm for {last.force} N.

        This report simulates friction between cutter and guard, against their motion. Between motor and
        cutter it would act much alike, since the guard moves little.
    """)
