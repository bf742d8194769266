"""One equation of motion worked by hand, term by term: that of the cutter."""

import sympy

from derivations.algebra.identity import require_equal
from derivations.algebra.unevaluated import product, total
from derivations.energies import HALF
from derivations.equations_of_motion import euler_lagrange
from derivations.latex import latex
from derivations.linear_trimmer import LinearTrimmer
from derivations.step import Formula, NarrativeStep
from derivations.symbols import c2, k2, k5, m2, q1, q2, q3, t, u

BRIDGE = total(q2, -q1, -u)  # Elongation of the driving bridge, m: the cutter less the pin
COIL = total(q2, -q3)  # Elongation of the coil spring, m: the cutter less the housing
RATE = total(q2.diff(t), -q1.diff(t), -u.diff(t))  # Rate at which the driving bridge grows longer, m/s


def worked_equation(derivation: LinearTrimmer) -> NarrativeStep:
    """Return the cutter's equation of motion worked by hand, each line held against SymPy's derivative.

    Raises:
        UnprovenError: if a line is not what SymPy derives.
    """
    moving, stored, lost = (
        product(HALF, m2, q2.diff(t) ** 2),
        total(product(HALF, k2, BRIDGE**2), product(HALF, k5, COIL**2)),
        product(HALF, c2, RATE**2),
    )
    momentum = m2 * q2.diff(t)
    by_place = total(-product(k2, BRIDGE), -product(k5, COIL))
    by_rate = product(c2, RATE)
    balance = total(m2 * q2.diff(t, 2), by_rate, product(k2, BRIDGE), product(k5, COIL))
    lagrangian, dissipation = derivation.lagrangian, derivation.rayleigh_function
    for name, written, derived in (
        ("momentum of the cutter", momentum, lagrangian.diff(q2.diff(t))),
        ("force of the springs on the cutter", by_place, lagrangian.diff(q2)),
        ("force of the damper on the cutter", by_rate, dissipation.diff(q2.diff(t))),
        ("balance of the cutter", balance, euler_lagrange(lagrangian, dissipation, q2)),
        ("terms with the cutter", total(moving, -stored).diff(q2), lagrangian.diff(q2)),
        ("energy of the cutter", moving.diff(q2.diff(t)), momentum),
        ("power that the damper loses", lost.diff(q2.diff(t)), by_rate),
    ):
        require_equal(name, _flat(written), _flat(derived))
    return NarrativeStep(
        "by-hand",
        "One equation by hand: the cutter",
        "The Lagrangian is $L = T - U$. To derive it by $q_2$ only the terms with $q_2$ are needed: the "
        "cutter's own mass, the two springs that end on the cutter, and the damper beside the first of them.",
        (
            Formula(rf"T = {latex(moving)} + \dots, \quad U = {latex(stored)} + \dots"),
            Formula(rf"R = {latex(lost)} + \dots"),
            Formula(
                rf"\frac{{\partial L}}{{\partial \dot{{q}}_2}} = {latex(momentum)}, \quad "
                rf"\frac{{d}}{{dt}} \frac{{\partial L}}{{\partial \dot{{q}}_2}} = "
                rf"{latex(m2 * q2.diff(t, 2))}",
                words="First the momentum and its rate.",
            ),
            Formula(
                r"\frac{\partial L}{\partial q_2} = -\frac{\partial U}{\partial q_2} = "
                rf"-{latex(k2)} \left({latex(BRIDGE)}\right) \cdot 1 - "
                rf"{latex(k5)} \left({latex(COIL)}\right) \cdot 1",
                words="Then the chain rule: the derivative of $\\frac{1}{2} k e^2$ is $k e$ times that of "
                "the elongation $e$ by $q_2$, which is 1 in both springs. In the equation of the motor the "
                "same spring gives the same force with the other sign, as $e$ falls when $q_1$ rises.",
            ),
            Formula(
                rf"\frac{{\partial R}}{{\partial \dot{{q}}_2}} = {latex(c2)} \left({latex(RATE)}\right)",
                words="The damper in the same way, with rates in place of lengths.",
            ),
            Formula(
                rf"{latex(m2 * q2.diff(t, 2))} + {latex(c2)} \left({latex(RATE)}\right) + "
                rf"{latex(k2)} \left({latex(BRIDGE)}\right) + {latex(k5)} \left({latex(COIL)}\right) = 0",
                words="The sum is Newton's law for the cutter. Solved for $m_2 \\ddot q_2$ it is the second "
                "line of the equations of motion below.",
            ),
        ),
        code=(euler_lagrange,),
    )


def _flat(expression: sympy.Expr) -> sympy.Expr:
    """Put plain symbols in the place of functions of time and their rates, and multiply out."""
    names: dict[sympy.Expr, sympy.Symbol] = {}
    for coordinate in (q1, q2, q3, u):
        for order in (2, 1, 0):
            function = coordinate.diff(t, order) if order else coordinate
            names[function] = sympy.Symbol(f"{coordinate.func.__name__}{order}", real=True)
    return sympy.expand(expression.xreplace(names))
