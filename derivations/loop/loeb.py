"""Loeb's rule: whether a small change of the amplitude dies away, from the condition of harmonic balance."""

import sympy

from derivations import assumed
from derivations.algebra.unevaluated import total
from derivations.elements.proven_step import Equality, ProvenStep
from derivations.step import Formula

CHANGE_OF_AMPLITUDE, CHANGE_OF_OMEGA, GROWTH = assumed.real("delta_A delta_omega sigma")
SLOPES = assumed.real("X_A Y_A X_omega Y_omega")


def growth_rate() -> sympy.Expr:
    """Return σ over the change δA of the amplitude, 1/(m s), from the real slopes of F = X + jY.

    It solves F_A δA + F_ω (δω − jσ) = 0, whose unknowns δω and σ are real.
    """
    x_a, y_a, x_omega, y_omega = SLOPES
    by_amplitude, by_omega = x_a + sympy.I * y_a, x_omega + sympy.I * y_omega
    change = by_amplitude * CHANGE_OF_AMPLITUDE + by_omega * (CHANGE_OF_OMEGA - sympy.I * GROWTH)
    equations = (sympy.re(sympy.expand(change)), sympy.im(sympy.expand(change)))
    solution = sympy.solve(equations, (CHANGE_OF_OMEGA, GROWTH))
    return sympy.factor(solution[GROWTH] / CHANGE_OF_AMPLITUDE)


def loeb_step() -> ProvenStep:
    """Return the step that derives Loeb's rule."""
    x_a, y_a, x_omega, y_omega = SLOPES
    return ProvenStep(
        "loeb",
        "Loeb’s rule: is the limit cycle stable?",
        "A limit cycle is stable if an amplitude that is a little too large shrinks. Let the amplitude "
        "differ by $\\delta A$ and change slowly, by the factor $e^{\\sigma t}$. An oscillation $e^{j\\omega "
        "t} e^{\\sigma t}$ is $e^{j(\\omega - j\\sigma)t}$: a growing amplitude is a complex frequency. So "
        "the condition $F(A, \\omega) = 1 + N G = 0$ holds on, with $\\omega + \\delta\\omega - j\\sigma$ in "
        "place of $\\omega$.\n\nThe rule sees one pair of poles and slow changes only. What it leaves out is "
        "checked by itself: the other poles of the loop, and the multipliers of the exact orbit.",
        (
            Formula(r"F(A + \delta A,\; \omega + \delta\omega - j\sigma) = 0"),
            Formula(
                r"F_A\, \delta A + F_\omega\, (\delta\omega - j\sigma) = 0, \quad "
                r"F_A = X_A + j Y_A, \quad F_\omega = X_\omega + j Y_\omega",
                words="To first order, as $F(A, \\omega)$ itself is zero, with indices for derivatives:",
            ),
            Equality(
                r"\frac{\sigma}{\delta A}",
                -total(x_a * y_omega, -x_omega * y_a) / total(x_omega**2, y_omega**2),
                growth_rate(),
                words="Its real and imaginary part are two linear equations for $\\delta\\omega$ and "
                "$\\sigma$. Solved for the second:",
            ),
            Formula(
                r"X_A Y_\omega - X_\omega Y_A > 0",
                words="So $\\sigma$ is negative for a positive $\\delta A$, and positive for a negative one, "
                "if and only if",
            ),
            Formula(
                r"F_A = G\, \frac{dN}{dA}, \quad F_\omega = N\, \frac{dG}{d\omega}",
                words="Where $N$ depends on the amplitude alone the slopes are these. The left side of the "
                "rule is $|F_A|\\,|F_\\omega|$ times the sine of the angle from $F_A$ to $F_\\omega$: it "
                "tells on which side the contour crosses the locus. Where that sine is near zero the two "
                "only touch, and the rule decides nothing.",
            ),
        ),
        code=(growth_rate,),
    )
