"""Harmonic balance: the condition 1 + N G = 0 from the loop, and Newton's method for its solution."""

import sympy

from derivations import assumed
from derivations.algebra.unevaluated import product, total
from derivations.elements.backlash_closed_forms import friction_fundamental
from derivations.elements.backlash_harmonics import CONTACT_ANGLE
from derivations.elements.proven_step import Equality, ProvenStep
from derivations.step import Formula
from derivations.symbols import A

ELEMENT, PLANT = sympy.symbols("N G")
REAL_PARTS = assumed.real("n_p n_q G_p G_q")
RESIDUAL, BY_ANGLE, BY_OMEGA = sympy.symbols("F F_ell F_omega")
CHANGES = assumed.real("Delta_ell Delta_omega")


def loop_residual(element: sympy.Expr, plant: sympy.Expr) -> sympy.Expr:
    """Return the element's input less what comes back to it after one turn of the loop, m.

    Args:
        element: Describing function N.
        plant: Transfer function G at s = jω.
    """
    output = element * A
    returned = -plant * output
    return A - returned


def newton_step() -> tuple[sympy.Expr, sympy.Expr]:
    """Solve F + F_ℓ Δℓ + F_ω Δω = 0, one complex equation, for its two real unknowns.

    Returns:
        Δℓ and Δω by real and imaginary parts of F, F_ℓ and F_ω.
    """
    parts = {symbol: _split(symbol) for symbol in (RESIDUAL, BY_ANGLE, BY_OMEGA)}
    equation = parts[RESIDUAL] + parts[BY_ANGLE] * CHANGES[0] + parts[BY_OMEGA] * CHANGES[1]
    solution = sympy.solve((sympy.re(equation), sympy.im(equation)), CHANGES)
    return solution[CHANGES[0]], solution[CHANGES[1]]


def balance_step() -> ProvenStep:
    """Return the step that derives 1 + N G = 0 (thesis, equations 2.53 to 2.56)."""
    n_real, n_imaginary, g_real, g_imaginary = REAL_PARTS
    whole = sympy.expand((1 + ELEMENT * PLANT).subs(_by_parts()))
    return ProvenStep(
        "balance",
        "Harmonic balance: 1 + N G = 0",
        "The loop has negative feedback: what leaves the element passes the trimmer $G$ and comes back to "
        "the element's input with the other sign. Let that input be $A \\sin\\theta$. The element answers "
        "with all odd harmonics. The trimmer weakens the higher ones, because $|G|$ is small there, and only "
        "the first one is kept. In complex amplitudes the input is $A$, the element's output $N A$, and "
        "what comes back $-G N A$. A motion that goes on by itself has to come back as it left. How large "
        "what was dropped is, is computed afterwards: it is the share of each harmonic that comes back.",
        (
            Formula(r"A = -G(j\omega)\, N(A, \omega)\, A"),
            Equality(
                r"A - (-G N A)", product(A, total(1, product(ELEMENT, PLANT))), loop_residual(ELEMENT, PLANT)
            ),
            Formula(
                r"1 + N(A, \omega)\, G(j\omega) = 0 \quad \Leftrightarrow \quad "
                r"G(j\omega) = -\frac{1}{N(A, \omega)}",
                words="The amplitude is not zero, so the bracket is. In the plane of $G$ a limit cycle is a "
                "point that the locus of $G$ and the contour of $-1/N$ have in common.",
            ),
            Equality(
                r"\operatorname{Re}(1 + N G)",
                total(1, n_real * g_real, -n_imaginary * g_imaginary),
                sympy.re(whole),
                words="One complex equation is two real ones, for the two unknowns $A$ and $\\omega$. With "
                "$N = n_p + j n_q$ and $G = G_p + j G_q$ both of these have to be zero:",
            ),
            Equality(
                r"\operatorname{Im}(1 + N G)",
                total(n_real * g_imaginary, n_imaginary * g_real),
                sympy.im(whole),
            ),
            Formula(
                r"\frac{|N_n G(jn\omega)|}{|N_1 G(j\omega)|}, \quad n = 3, 5, 7, \dots",
                words="What was dropped, over what was kept:",
            ),
        ),
        code=(loop_residual,),
    )


def solution_step() -> ProvenStep:
    """Return the step on Newton's method for friction-controlled backlash."""
    angle, omega_change = newton_step()
    along = {symbol: _split(symbol) for symbol in (RESIDUAL, BY_ANGLE, BY_OMEGA)}
    return ProvenStep(
        "newton",
        "Newton’s method for amplitude and frequency",
        "For friction-controlled backlash $N$ is a function of the angle of contact $\\ell$ alone, and "
        "$g/A = 1 + \\cos\\ell$ gives the amplitude afterwards. So the unknowns are $\\ell$ and $\\omega$. "
        "The equation is divided by $G$, since $1/G$ is a quotient of the two polynomials turned over and "
        "has no poles where $G$ resonates. From a first guess the equation is solved again and again with "
        "its tangents in place of the curves.",
        (
            Formula(r"F(\ell, \omega) = N(\ell) + \frac{1}{G(j\omega)} = 0"),
            Equality(
                r"F_\ell = \frac{dN}{d\ell}",
                product(
                    -2 * sympy.I / sympy.pi, sympy.sin(CONTACT_ANGLE), sympy.exp(sympy.I * CONTACT_ANGLE)
                ),
                friction_fundamental().diff(CONTACT_ANGLE),
            ),
            Formula(
                r"F_\omega = \frac{d}{d\omega} \frac{1}{G(j\omega)}, \quad "
                r"F + F_\ell\, \Delta\ell + F_\omega\, \Delta\omega = 0"
            ),
            Equality(
                r"\Delta\ell",
                -_cross(BY_OMEGA, RESIDUAL) / _cross(BY_OMEGA, BY_ANGLE),
                angle,
                given=tuple(along.items()),
                words="To eliminate $\\Delta\\omega$ the last equation is multiplied by the conjugate of "
                "$F_\\omega$; the term with $\\Delta\\omega$ is then real, and the imaginary part leaves "
                "$\\Delta\\ell$. In the same way:",
            ),
            Equality(
                r"\Delta\omega",
                -_cross(BY_ANGLE, RESIDUAL) / _cross(BY_ANGLE, BY_OMEGA),
                omega_change,
                given=tuple(along.items()),
            ),
        ),
        code=(newton_step, friction_fundamental),
    )


def _cross(first: sympy.Symbol, second: sympy.Symbol) -> sympy.Expr:
    return sympy.im(sympy.conjugate(first) * second, evaluate=False)


def _split(symbol: sympy.Symbol) -> sympy.Expr:
    real, imaginary = assumed.real(f"{symbol}_r {symbol}_i")
    return real + sympy.I * imaginary


def _by_parts() -> dict[sympy.Symbol, sympy.Expr]:
    n_real, n_imaginary, g_real, g_imaginary = REAL_PARTS
    return {ELEMENT: n_real + sympy.I * n_imaginary, PLANT: g_real + sympy.I * g_imaginary}
