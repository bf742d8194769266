"""Claims of section 2.2.1, from the pin's motion to the equations of motion (equations 2.1 to 2.9)."""

from __future__ import annotations

import math

import sympy

from derivations.equations_of_motion import euler_lagrange
from derivations.symbols import A, accelerations, coordinates, f, masses, t, u_dot, velocities
from report.claim import Claim, Confirmation, Impact, Mathematics, Part, Slip, Verdict
from report.claims import trimmer_printed
from report.claims.printed import product, total
from report.comparisons.expression import SameExpression, SameMatrix
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, LinearNumbers
from trimmer import frequency_response

NEWTON = "Newton's second law for each body"
ENERGIES = "derivations/energies.py"
MOTION = "derivations/equations_of_motion.py"
PIN_MOTION = A * sympy.sin(2 * sympy.pi * f * t)
AMPLITUDE_LOST = "the amplitude A is lost in the derivative"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _pin_motion(),
        _lagrangian(evidence),
        _kinetic_energy_in_general(),
        _kinetic_energy(evidence),
        _potential_energy(evidence),
        _euler_lagrange(evidence),
        _rayleigh_function(evidence),
        _pin_velocity(evidence.numbers),
        _equations_of_motion(evidence),
        _pin_velocity_statement(evidence.numbers),
    )


def _pin_motion() -> Claim:
    turning_point = A * sympy.exp(2 * sympy.pi * sympy.I * f * t)
    return Claim(
        id="eq-2.1",
        parts=(Part("", SameExpression(PIN_MOTION, sympy.im(turning_point), left=sympy.Symbol("x_i"))),),
        explanation=(
            "A pin at distance $A$ from the axis of a shaft that turns $f$ times a second, seen along one "
            "direction, moves as printed. Its unit is the metre, as it must be."
        ),
        source="derivations/symbols.py",
    )


def _lagrangian(evidence: Evidence) -> Claim:
    kinetic, potential, sign = sympy.symbols("T U sigma")
    derivation = evidence.derivation
    energy = derivation.kinetic_energy + sign * derivation.potential_energy
    q, mass = coordinates[0], masses[0]
    balance = euler_lagrange(energy, derivation.rayleigh_function, q)
    newton = mass * (accelerations[0] - derivation.newton[0])
    solved = sympy.solve(sympy.expand(balance - newton), sign)
    return Claim(
        id="eq-2.2",
        parts=(
            Part(
                "",
                SameExpression(
                    total(kinetic, -potential), kinetic + solved[0] * potential, left=sympy.Symbol("L")
                ),
            ),
        ),
        explanation=(
            "With $L = T + \\sigma U$ the Euler-Lagrange equation of the motor equals Newton's second law "
            "only for $\\sigma = -1$, so the printed difference is the right one."
        ),
        source=MOTION,
    )


def _work_from_rest(mass: sympy.Expr, velocity: sympy.Expr) -> sympy.Expr:
    """Return the work that brings a mass from rest to a velocity, J."""
    speed = sympy.Dummy("v", real=True)
    return sympy.integrate(mass * speed, (speed, 0, velocity))


def _work_on_all() -> sympy.Expr:
    return sympy.Add(*(_work_from_rest(m, v) for m, v in zip(masses, velocities, strict=True)))


def _kinetic_energy_in_general() -> Claim:
    index = sympy.Symbol("i", integer=True)
    mass, velocity = sympy.IndexedBase("m"), sympy.IndexedBase("v")
    values = {mass[i + 1]: m for i, m in enumerate(masses)}
    values |= {velocity[i + 1]: v for i, v in enumerate(velocities)}
    printed = sympy.Sum(mass[index] * velocity[index] ** 2 / 2, (index, 1, len(masses))).doit().subs(values)
    return Claim(
        id="eq-2.3",
        parts=(Part("the sum for $n = 4$", SameExpression(printed, _work_on_all(), left=sympy.Symbol("T"))),),
        explanation=(
            "The work that brings each mass from rest to its velocity adds up to the printed sum. The "
            "velocities are absolute; the sentence before the equation calls them relative, which is true of "
            "springs and not of masses."
        ),
        source=ENERGIES,
    )


def _kinetic_energy(evidence: Evidence) -> Claim:
    derived = evidence.derivation.kinetic_energy
    comparison = SameExpression(trimmer_printed.kinetic_energy(), derived, left=sympy.Symbol("T"))
    confirmation = Confirmation("the work done on each mass", SameExpression(_work_on_all(), derived))
    return Claim(
        id="eq-2.4",
        parts=(Part("", comparison, confirmation),),
        explanation="The list of four masses gives the printed sum.",
        source=ENERGIES,
    )


def _potential_energy(evidence: Evidence) -> Claim:
    derived = evidence.derivation.potential_energy
    comparison = SameExpression(trimmer_printed.potential_energy(), derived, left=sympy.Symbol("U"))
    at_rest = {velocity: 0 for velocity in (*velocities, u_dot)}
    forces = sympy.ImmutableMatrix(
        [mass * newton.subs(at_rest) for mass, newton in zip(masses, evidence.derivation.newton, strict=True)]
    )
    slopes = sympy.ImmutableMatrix([-derived.diff(q) for q in coordinates])
    confirmation = Confirmation("the spring forces on each body at rest", SameMatrix(forces, slopes))
    return Claim(
        id="eq-2.5",
        parts=(Part("", comparison, confirmation),),
        explanation=(
            "The pin rides on the motor, so the driving bridge's spring is stretched by $q_2 - q_1 - u$. "
            "With that, the five springs give the printed sum."
        ),
        source=ENERGIES,
    )


def _euler_lagrange(evidence: Evidence) -> Claim:
    derivation = evidence.derivation
    printed = sympy.ImmutableMatrix(
        [euler_lagrange(derivation.lagrangian, derivation.rayleigh_function, q) for q in coordinates]
    )
    newton = sympy.ImmutableMatrix(
        [
            mass * (acceleration - force)
            for mass, acceleration, force in zip(masses, accelerations, derivation.newton, strict=True)
        ]
    )
    form = Mathematics(
        "\\frac{d}{dt}\\left(\\frac{\\partial L}{\\partial \\dot q_i}\\right) - "
        "\\frac{\\partial L}{\\partial q_i} + \\frac{\\partial R}{\\partial \\dot q_i} = Q_i"
    )
    return Claim(
        id="eq-2.6",
        parts=(
            Part(
                "the four bodies, $Q_i = 0$",
                SameMatrix(printed, newton),
                printed_form=form,
                derived_form=form,
            ),
        ),
        explanation=(
            "For each of the four bodies the printed left side equals mass times acceleration less the "
            "forces of Newton's law. The pin acts through $U$ and $R$, so every $Q_i$ is zero; the text says "
            "that $Q_i$ carries the input, but here it carries nothing."
        ),
        source=MOTION,
    )


def _rayleigh_function(evidence: Evidence) -> Claim:
    derived = evidence.derivation.rayleigh_function
    comparison = SameExpression(trimmer_printed.rayleigh_function(), derived, left=sympy.Symbol("R"))
    lost = evidence.derivation.power.dissipated_power
    confirmation = Confirmation("the power balance", SameExpression(lost / 2, derived))
    return Claim(
        id="eq-2.7",
        parts=(Part("", comparison, confirmation),),
        explanation=(
            "The four dampers give the printed sum, and twice that sum is exactly the power that the energy "
            "loses in every motion."
        ),
        source=ENERGIES,
    )


def _velocity_part() -> Part:
    printed = product(2 * sympy.pi * f, sympy.cos(2 * sympy.pi * f * t))
    derived = PIN_MOTION.diff(t)
    projected = sympy.re(2 * sympy.pi * f * A * sympy.exp(2 * sympy.pi * sympy.I * f * t))
    return Part(
        "velocity of the pin",
        SameExpression(printed, derived, left=u_dot),
        Confirmation("the velocity of a point on a circle", SameExpression(projected, derived)),
        Slip(AMPLITUDE_LOST, derived / A, Verdict.ERRATUM),
    )


def _output_with_the_slip(numbers: LinearNumbers) -> float:
    """Return the output's amplitude (m) at the drive, with the printed velocity as second input."""
    omega = 2 * math.pi * DRIVE_FREQUENCY
    gain = abs(complex(frequency_response(numbers.displacement_only, omega)))
    damper_over_spring = numbers.parameters.c2 / numbers.parameters.k2
    return gain * math.hypot(DRIVE_AMPLITUDE, damper_over_spring * omega)


def _pin_velocity(numbers: LinearNumbers) -> Claim:
    return Claim(
        id="eq-2.8",
        parts=(_velocity_part(),),
        explanation=(
            "The derivative of $A\\sin(2\\pi f t)$ keeps its amplitude, which the printed line loses. The "
            "units show it too: the printed right side is in 1/s, a velocity is in m/s."
        ),
        consequence=(
            f"The printed velocity is {1 / DRIVE_AMPLITUDE:.0f} times too large at $A = 1.5$ mm. Fed into "
            "the second input at 100 Hz, it would give figure 5.1 an amplitude of "
            f"{1e3 * _output_with_the_slip(numbers):.1f} mm; the thesis finds 1.5 mm there, and its loop "
            "drops the velocity (Listing A.1, line 58), so neither contains this slip."
        ),
        impact=Impact.LOCAL,
        source="derivations/symbols.py",
    )


def _equations_of_motion(evidence: Evidence) -> Claim:
    derivation = evidence.derivation
    parts = tuple(
        Part(
            f"$\\ddot q_{index}$",
            SameExpression(printed, derived, left=acceleration),
            Confirmation(NEWTON, SameExpression(newton, derived)),
        )
        for index, (printed, derived, newton, acceleration) in enumerate(
            zip(
                trimmer_printed.accelerations(),
                derivation.accelerations,
                derivation.newton,
                accelerations,
                strict=True,
            ),
            start=1,
        )
    )
    return Claim(
        id="eq-2.9",
        parts=parts,
        explanation=(
            "All four lines follow from the energies, and again from the forces alone. Signs and indices of "
            "every term are right."
        ),
        source=MOTION,
    )


def _pin_velocity_statement(numbers: LinearNumbers) -> Claim:
    rate = 2 * sympy.pi * f
    amplitude = A * rate
    at_drive = float(amplitude.subs({A: DRIVE_AMPLITUDE, f: DRIVE_FREQUENCY}))
    printed_at_drive = float(rate.subs(f, DRIVE_FREQUENCY))
    squared = sympy.trigsimp(PIN_MOTION.diff(t) ** 2 + (PIN_MOTION.diff(t, 2) / rate) ** 2)
    return Claim(
        id="txt-2.2.1-single-input-velocity",
        parts=(
            _velocity_part(),
            Part(
                "its amplitude",
                SameExpression(rate, amplitude),
                Confirmation("velocity and acceleration at any time", SameExpression(squared, amplitude**2)),
                Slip(AMPLITUDE_LOST, rate, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            f"The factor before the cosine of equation 2.8 is $2\\pi f$, {printed_at_drive:.1f}/s at "
            f"{DRIVE_FREQUENCY:.0f} Hz. The velocity of a pin with an eccentricity of "
            f"{1e3 * DRIVE_AMPLITUDE} mm has the amplitude $2\\pi f A = {at_drive:.4f}$ m/s."
        ),
        consequence=(
            "Equation 3.2 and the equations of motion take the velocity as an input. Figure 5.1 does not "
            f"contain the slip, which would make it {_output_with_the_slip(numbers) / DRIVE_AMPLITUDE:.1f} "
            "times too high; the models behind chapter 3 are not given."
        ),
        impact=Impact.LOCAL,
        source="derivations/symbols.py",
    )
