"""The derivation of the linear trimmer step by step: prose and formulas, for the report and for LaTeX.

Prose is plain text with TeX mathematics between dollar signs, fit for Markdown and for LaTeX alike.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from derivations.dimension_checks import dimension_checks, require_consistent
from derivations.equations_of_motion import MotionMatrices
from derivations.latex import latex, latex_equation
from derivations.linear_motion import LinearMotion
from derivations.linear_trimmer import LinearTrimmer
from derivations.mechanism import Mechanism, elongation
from derivations.state_space import output_row

CUTTER, GUARD = 1, 3
MOST_TERMS_SHOWN = 19


@dataclass(frozen=True)
class Formula:
    """A displayed equation.

    Attributes:
        latex: The equation in LaTeX, without delimiters.
        thesis: Its number in the thesis; empty where it has none.
    """

    latex: str
    thesis: str = ""


@dataclass(frozen=True)
class Step:
    """A step of a derivation.

    Attributes:
        id: Identifier, unique among all steps.
        title: Heading.
        text: Prose, paragraphs separated by an empty line.
        formulas: Displayed equations, shown after the prose.
    """

    id: str
    title: str
    text: str
    formulas: tuple[Formula, ...]


def narrative(derivation: LinearTrimmer) -> tuple[Step, ...]:
    """Return the steps of the derivation, from the mechanism to the checks.

    Raises:
        DimensionError: if a derived equation is not consistent in its dimensions.
        ValueError: if the power balance does not hold.
    """
    return (
        _elongations(derivation),
        _energies(derivation),
        _motion(derivation),
        _matrices(derivation),
        _power(derivation),
        _state_space(derivation),
        _transfer_function(derivation),
        _checks(derivation),
    )


def elongations(mechanism: Mechanism) -> tuple[Formula, ...]:
    """Return the elongation of each spring of a mechanism."""
    return tuple(
        Formula(f"e_{{{latex(spring.stiffness)}}} = {latex(elongation(spring))}")
        for spring in mechanism.springs
    )


def energies(motion: LinearMotion, thesis: tuple[str, str, str] = ("", "", "")) -> tuple[Formula, ...]:
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


def _elongations(derivation: LinearTrimmer) -> Step:
    return Step(
        "mechanism",
        "Bodies, springs and dampers",
        "Four bodies move along one line: motor, cutter, guard housing and guard, with displacements $q_1$ "
        "to $q_4$. The eccentric pin rides on the motor's shaft and is displaced by $u$ relative to the "
        "motor, so its position is $q_1 + u$. Each spring and damper is declared by its two ends; its "
        "elongation is the position of one end less that of the other. The dampers $c_1$ to $c_4$ sit beside "
        "the springs $k_1$ to $k_4$.",
        elongations(derivation.mechanism),
    )


def _energies(derivation: LinearTrimmer) -> Step:
    return Step(
        "energies",
        "Energies and dissipation",
        "Kinetic energy belongs to the bodies, potential energy to the springs, and Rayleigh's function, "
        "half of the power that is lost, to the dampers.",
        energies(derivation, ("2.4", "2.5", "2.7")),
    )


def _motion(derivation: LinearTrimmer) -> Step:
    bodies = derivation.mechanism.bodies
    lines = tuple(
        Formula(f"{latex(body.mass)} {_accelerated(index)} = {latex(sympy.numer(acceleration))}", "2.9")
        for index, (body, acceleration) in enumerate(
            zip(bodies, derivation.accelerations, strict=True), start=1
        )
    )
    return Step(
        "motion",
        "Equations of motion",
        "The Euler-Lagrange equation of each body, with no force besides those of springs and dampers. The "
        "sum of forces by Newton's law gives the same four lines.",
        (euler_lagrange_equation("0", "2.6"), *lines),
    )


def _accelerated(index: int) -> str:
    return rf"\ddot{{q}}_{{{index}}}"


def _matrices(derivation: LinearTrimmer) -> Step:
    matrices = derivation.matrices
    return Step(
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
    )


def _power(derivation: LinearTrimmer) -> Step:
    balance = derivation.power
    if not balance.holds:
        raise ValueError(f"the power balance of the mechanism does not close: {balance.residual}")
    return Step(
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
    )


def _state_space(derivation: LinearTrimmer) -> Step:
    space = derivation.space
    row = output_row(CUTTER, GUARD, len(derivation.mechanism.bodies))
    return Step(
        "state-space",
        "State space",
        "With the state $x = (q, \\dot q)$ and both inputs of the pin, its displacement and its velocity.",
        (
            Formula(r"\dot{x} = A x + B \begin{pmatrix} u \\ \dot{u} \end{pmatrix}, \quad y = C x", "2.10"),
            Formula(latex_equation(sympy.Symbol("A"), space.a), "2.12"),
            Formula(latex_equation(sympy.Symbol("B"), space.b), "2.13"),
            Formula(latex_equation(sympy.Symbol("C"), row), "2.14"),
        ),
    )


def _transfer_function(derivation: LinearTrimmer) -> Step:
    transfer = derivation.transfer
    output = [
        sympy.factor(cutter - guard)
        for cutter, guard in zip(
            transfer.from_displacement[CUTTER], transfer.from_displacement[GUARD], strict=True
        )
    ]
    return Step(
        "transfer-function",
        "Transfer function",
        "Cramer's rule on $(Ms^2 + Cs + K)\\,Q = f_u U$ gives the transfer function from the pin's "
        "displacement to $q_2 - q_4$ with symbolic coefficients. Those with few terms are shown; the command "
        "`trimmer derive` writes them all. The pin's velocity acts through $c_2$ as its displacement acts "
        "through $k_2$, so both together give $G = (1 + s\\,c_2/k_2)\\,G_1$.",
        (
            Formula(r"G_1(s) = \frac{b_6 s^6 + b_5 s^5 + \dots + b_0}{s^8 + a_7 s^7 + \dots + a_0}", "2.21"),
            *_coefficients("b", output),
            *_coefficients("a", list(transfer.denominator)),
        ),
    )


def _coefficients(name: str, coefficients: list[sympy.Expr]) -> tuple[Formula, ...]:
    return tuple(
        Formula(f"{name}_{{{power}}} = {latex(coefficient)}")
        for power, coefficient in zip(range(len(coefficients) - 1, -1, -1), coefficients, strict=True)
        if coefficient != 1 and _number_of_terms(coefficient) <= MOST_TERMS_SHOWN
    )


def _number_of_terms(coefficient: sympy.Expr) -> int:
    return len(sympy.Add.make_args(sympy.expand(coefficient)))


def _checks(derivation: LinearTrimmer) -> Step:
    checks = dimension_checks(derivation)
    require_consistent(checks)
    return Step(
        "checks",
        "Checks",
        f"All {len(checks)} derived expressions pass a dimension check that knows only the units of the "
        "symbols. The equations of motion are derived a second time from forces alone, and a third time in "
        "the tests by SymPy's own mechanics package.",
        (),
    )
