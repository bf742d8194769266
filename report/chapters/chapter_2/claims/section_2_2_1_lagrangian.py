"""Claims of section 2.2.1 on energies and equations of motion (equations 2.2 to 2.7, and 2.9)."""

from __future__ import annotations

import sympy

from derivations.equations_of_motion import euler_lagrange
from derivations.symbols import accelerations, coordinates, masses, u_dot, velocities
from report.chapters.chapter_2.claims import trimmer_printed
from report.claim import Claim, Confirmation, Mathematics, Part
from report.comparisons.expression import SameExpression, SameMatrix
from report.comparisons.printed import total
from report.evidence import Evidence

NEWTON = "Newton's second law for each body"
ENERGIES = "derivations/energies.py"
MOTION = "derivations/equations_of_motion.py"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _lagrangian(evidence),
        _kinetic_energy_in_general(),
        _kinetic_energy(evidence),
        _potential_energy(evidence),
        _euler_lagrange(evidence),
        _rayleigh_function(evidence),
        _equations_of_motion(evidence),
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
