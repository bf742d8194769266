"""Derivatives of N_1 of backlash by g/A and by ln γ, and the Jacobian determinant of both."""

from sympy import cos, exp

from derivations.algebra.unevaluated import product
from derivations.elements.backlash import GAMMA, SEPARATION
from derivations.elements.backlash_slopes import (
    AFTER_EVALUATION,
    ELAPSED,
    closed_jacobian,
    closed_slope_by_log_gamma,
    closed_slope_by_ratio,
    jacobian,
    lead,
    position_by_log_gamma,
    slope_by_log_gamma,
    slope_by_ratio,
)
from derivations.elements.proven_step import Equality, ProvenStep
from derivations.latex import latex
from derivations.step import Formula

BY_RATIO = r"\frac{\partial N_1}{\partial (g/A)}"
BY_LOG_GAMMA = r"\frac{\partial N_1}{\partial \ln\gamma}"


def step() -> ProvenStep:
    """Return the step on the derivatives, on which the bounds of the numeric element rest."""
    return ProvenStep(
        "df-slopes",
        "How backlash changes with amplitude and load",
        "At constant $\\gamma$ the derivative of $N_1$ by $g/A$ has the same modulus everywhere and points "
        "to the phase of impact. At constant $g/A$ a larger $\\gamma$ carries the flying load further at "
        "every phase, because $k(t)$ rises from $k(0) = 0$; so it meets the wall sooner. The change of "
        "$N_1$ is an integral over the flight alone, as position and velocity are continuous at separation "
        "and the position at impact.\n\nThe last line is the Jacobian determinant of $N_1$ as a map of "
        "$(g/A, \\ln\\gamma)$ into the complex plane. It is an integral of what is positive for $0 < t < "
        "\\lambda \\le \\pi$, so it is never zero.",
        (
            Equality(BY_RATIO, closed_slope_by_ratio(), slope_by_ratio(), given=AFTER_EVALUATION),
            Formula(f"k(t) = {latex(lead())}"),
            Equality(r"\frac{dk}{dt}", product(ELAPSED / GAMMA, exp(-ELAPSED / GAMMA)), lead().diff(ELAPSED)),
            Equality(
                r"\frac{1}{A} \frac{\partial y}{\partial \ln\gamma}",
                product(cos(SEPARATION), lead()),
                position_by_log_gamma(),
                given=AFTER_EVALUATION,
            ),
            Equality(BY_LOG_GAMMA, closed_slope_by_log_gamma(), slope_by_log_gamma(), given=AFTER_EVALUATION),
            Equality(
                rf"\operatorname{{Im}} \left(\left({BY_RATIO}\right)^{{*}} {BY_LOG_GAMMA}\right)",
                closed_jacobian(),
                jacobian(),
                given=AFTER_EVALUATION,
            ),
        ),
        code=(slope_by_ratio, slope_by_log_gamma, jacobian),
    )
