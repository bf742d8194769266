"""Facts about stability that the thesis rests on: argument principle, closed loop, bound on exp(A t)."""

import sympy

from derivations.symbols import s, t

NUMBER_OF_ZEROS = sympy.Symbol("Z", integer=True, nonnegative=True)
NUMBER_OF_POLES = sympy.Symbol("P", integer=True, nonnegative=True)
LINEAR_PART = sympy.Symbol("G")
NONLINEAR_PART = sympy.Symbol("N")


def encirclements_of_origin() -> sympy.Expr:
    """Return how often f turns round the origin on a contour about a zero of order Z and a pole of order P.

    The number of turns is the sum of the residues of f'/f inside; f carries a factor without zeros or poles
    there, which adds nothing. Contour and turns are counted in the same sense.
    """
    zero, pole = sympy.symbols("a b")
    regular = sympy.Function("h")(s)
    logarithm = (
        NUMBER_OF_ZEROS * sympy.log(s - zero) - NUMBER_OF_POLES * sympy.log(s - pole) + sympy.log(regular)
    )
    terms = sympy.Add.make_args(logarithm.diff(s))
    residues = (
        sympy.cancel(term * (s - point)).subs(s, point).doit() for term in terms for point in (zero, pole)
    )
    return sympy.Add(*residues)


def closed_loop(feedback: sympy.Expr, forward: sympy.Expr) -> sympy.Expr:
    """Return Y/U of a loop with negative feedback, solved from its equation Y = forward (U − feedback Y)."""
    output, reference = sympy.symbols("Y U")
    solution = sympy.solve(sympy.Eq(output, forward * (reference - feedback * output)), output)
    return sympy.simplify(solution[0] / reference)


def double_integrator() -> sympy.ImmutableMatrix:
    """Return a matrix with both eigenvalues zero whose exponential grows without bound."""
    return sympy.ImmutableMatrix([[0, 1], [0, 0]])


def exponential_norm(matrix: sympy.ImmutableMatrix) -> sympy.Expr:
    """Return the Frobenius norm of exp(A t) for t ≥ 0, with A for the n × n ``matrix``."""
    growth = (matrix * t).exp()
    return sympy.sqrt(sum(entry**2 for entry in growth))
