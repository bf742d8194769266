"""The derivation of the linear trimmer step by step: prose and formulas, for the report and for LaTeX.

Prose is plain text with TeX mathematics between dollar signs, fit for Markdown and for LaTeX alike.
"""

import sympy

from derivations.by_hand import worked_equation
from derivations.dimension_checks import dimension_checks, require_consistent
from derivations.energies import kinetic_energy, potential_energy, rayleigh_function
from derivations.equations_of_motion import MotionMatrices, accelerations, motion_matrices
from derivations.latex import latex, latex_equation
from derivations.linear_motion import SymbolicMotion
from derivations.linear_trimmer import LinearTrimmer
from derivations.mechanism import Mechanism, elongation, trimmer
from derivations.newton_euler import newton_accelerations
from derivations.power_balance import power_balance
from derivations.state_space import output_row, state_space
from derivations.step import Formula, NarrativeStep
from derivations.transfer_steps import CUTTER, GUARD, coefficients_step, transfer_function_step


def narrative(derivation: LinearTrimmer) -> tuple[NarrativeStep, ...]:
    """Return the steps of the derivation, from the mechanism to the checks.

    Raises:
        DimensionError: if a derived equation is not consistent in its dimensions.
        ValueError: if the power balance does not hold.
    """
    return (
        _elongations(derivation),
        _energies(derivation),
        worked_equation(derivation),
        _motion(derivation),
        _matrices(derivation),
        _power(derivation),
        _state_space(derivation),
        transfer_function_step(derivation),
        coefficients_step(derivation),
        _checks(derivation),
    )


def elongations(mechanism: Mechanism) -> tuple[Formula, ...]:
    """Return the elongation of each spring of a mechanism."""
    return tuple(
        Formula(f"e_{{{latex(spring.stiffness)}}} = {latex(elongation(spring))}")
        for spring in mechanism.springs
    )


def energies(motion: SymbolicMotion, thesis: tuple[str, str, str] = ("", "", "")) -> tuple[Formula, ...]:
    """Return kinetic and potential energy and Rayleigh's function, with their numbers in the thesis."""
    of_motion = (motion.kinetic_energy, motion.potential_energy, motion.rayleigh_function)
    return tuple(
        Formula(latex_equation(sympy.Symbol(name), energy), number)
        for name, energy, number in zip("TUR", of_motion, thesis, strict=True)
    )


def euler_lagrange_equation(right: str, thesis: str = "") -> Formula:
    """Return the Euler-Lagrange equation of a body, whose right side is given in LaTeX."""
    return Formula(
        r"\frac{d}{dt}\frac{\partial (T - U)}{\partial \dot{q}_i} - \frac{\partial (T - U)}{\partial q_i} + "
        rf"\frac{{\partial R}}{{\partial \dot{{q}}_i}} = {right}",
        thesis,
    )


def symmetric_matrices(matrices: MotionMatrices) -> tuple[Formula, ...]:
    """Return the matrices of mass, damping and stiffness."""
    named = zip("MCK", (matrices.mass, matrices.damping, matrices.stiffness), strict=True)
    return tuple(Formula(latex_equation(sympy.Symbol(name), matrix)) for name, matrix in named)


def _elongations(derivation: LinearTrimmer) -> NarrativeStep:
    return NarrativeStep(
        "mechanism",
        "Bodies, springs and dampers",
        "Four bodies move along one line: motor, cutter, guard housing and guard, with displacements $q_1$ "
        "to $q_4$. The eccentric pin rides on the motor's shaft and is displaced by $u$ relative to the "
        "motor, so its position is $q_1 + u$. Each spring and damper is declared by its two ends; its "
        "elongation is the position of one end less that of the other. The dampers $c_1$ to $c_4$ sit beside "
        "the springs $k_1$ to $k_4$.",
        elongations(derivation.mechanism),
        code=(trimmer, elongation),
    )


def _energies(derivation: LinearTrimmer) -> NarrativeStep:
    return NarrativeStep(
        "energies",
        "Energies and dissipation",
        "Kinetic energy belongs to the bodies, potential energy to the springs, and Rayleigh's function, "
        "half of the power that is lost, to the dampers.",
        energies(derivation, ("2.4", "2.5", "2.7")),
        code=(kinetic_energy, potential_energy, rayleigh_function),
    )


def _motion(derivation: LinearTrimmer) -> NarrativeStep:
    bodies = derivation.mechanism.bodies
    lines = tuple(
        Formula(f"{latex(body.mass)} {_accelerated(index)} = {latex(sympy.numer(acceleration))}", "2.9")
        for index, (body, acceleration) in enumerate(
            zip(bodies, derivation.accelerations, strict=True), start=1
        )
    )
    return NarrativeStep(
        "motion",
        "Equations of motion",
        "The Euler-Lagrange equation of each body, with no force besides those of springs and dampers. The "
        "sum of forces by Newton's law gives the same four lines.",
        (euler_lagrange_equation("0", "2.6"), *lines),
        code=(accelerations, newton_accelerations),
    )


def _accelerated(index: int) -> str:
    return rf"\ddot{{q}}_{{{index}}}"


def _matrices(derivation: LinearTrimmer) -> NarrativeStep:
    matrices = derivation.matrices
    return NarrativeStep(
        "matrices",
        "Matrices",
        "The equations of motion are linear, $M\\ddot q + C\\dot q + Kq = f_u u + f_v \\dot u$, with "
        "symmetric matrices.",
        (
            *symmetric_matrices(matrices),
            Formula(
                f"f_u = {latex(matrices.displacement_force)}, \\quad f_v = {latex(matrices.velocity_force)}"
            ),
        ),
        code=(motion_matrices,),
    )


def _power(derivation: LinearTrimmer) -> NarrativeStep:
    balance = derivation.power
    if not balance.holds:
        raise ValueError(f"the power balance of the mechanism does not close: {balance.residual}")
    return NarrativeStep(
        "power",
        "Power balance",
        "Along every motion the energy changes by the power of the pin less what the dampers take. The "
        "difference of both sides is zero identically, and the power lost is a sum of squares, so it is "
        "never negative.",
        (
            Formula(r"\frac{d}{dt}(T + U) = P - D"),
            Formula(latex_equation(sympy.Symbol("P"), sympy.factor_terms(balance.input_power))),
            Formula(f"{latex_equation(sympy.Symbol('D'), balance.dissipated_power)} \\ge 0"),
        ),
        code=(power_balance,),
    )


def _state_space(derivation: LinearTrimmer) -> NarrativeStep:
    space = derivation.space
    row = output_row(CUTTER, GUARD, len(derivation.mechanism.bodies))
    return NarrativeStep(
        "state-space",
        "State space",
        "Four equations of second order become eight of first order. The state $x$ holds the displacements "
        "and the velocities. Its first half changes by the velocities, its second half by the accelerations, "
        "for which the equations of motion are solved. Here $A$ is a matrix; elsewhere $A$ is an amplitude.",
        (
            Formula(r"x = \begin{pmatrix} q \\ \dot{q} \end{pmatrix}, \quad \dot{q} = 0\, q + I\, \dot{q}"),
            Formula(r"\ddot{q} = -M^{-1} K\, q - M^{-1} C\, \dot{q} + M^{-1} f_u\, u + M^{-1} f_v\, \dot{u}"),
            Formula(
                r"\dot{x} = A x + B \begin{pmatrix} u \\ \dot{u} \end{pmatrix}, \quad y = C x",
                "2.10",
                "In the last equation $C$ is the row that picks the output $y = q_2 - q_4$, not the damping.",
            ),
            Formula(
                r"A = \begin{pmatrix} 0 & I \\ -M^{-1} K & -M^{-1} C \end{pmatrix}, \quad "
                r"B = \begin{pmatrix} 0 & 0 \\ M^{-1} f_u & M^{-1} f_v \end{pmatrix}",
                words="In letters, with blocks of four rows:",
            ),
            Formula(latex_equation(sympy.Symbol("A"), space.a), "2.12", "Entry by entry:"),
            Formula(latex_equation(sympy.Symbol("B"), space.b), "2.13"),
            Formula(latex_equation(sympy.Symbol("C"), row), "2.14"),
        ),
        code=(state_space, output_row),
    )


def _checks(derivation: LinearTrimmer) -> NarrativeStep:
    checks = dimension_checks(derivation)
    require_consistent(checks)
    return NarrativeStep(
        "checks",
        "Checks",
        f"All {len(checks)} derived expressions pass a dimension check that knows only the units of the "
        "symbols. The equations of motion are derived a second time from forces alone, and a third time in "
        "the tests by SymPy's own mechanics package.",
        (),
        code=(require_consistent,),
    )
