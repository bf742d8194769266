"""Formulas and text that are hard to show."""

import functools
import itertools

import sympy

SPECIAL = r"< & > _ % # $ | \ * ` ~ ^ { } [ ] @ ' \" - 1. <b>not bold</b> $x$ :::"

K = sympy.symbols("k1:6", positive=True)
D = sympy.symbols("c1:6", positive=True)
M = sympy.symbols("m1:5", positive=True)


@functools.cache
def state_matrix() -> sympy.ImmutableMatrix:
    """Return an 8 by 8 matrix with fractions, as large as the largest of the thesis."""
    stiffness = sympy.Matrix(
        4, 4, lambda i, j: -(K[i] + K[i + 1]) / M[i] if i == j else (K[i] / M[i] if abs(i - j) == 1 else 0)
    )
    damping = sympy.Matrix(
        4, 4, lambda i, j: -(D[i] + D[i + 1]) / M[i] if i == j else (D[i] / M[i] if abs(i - j) == 1 else 0)
    )
    top = sympy.Matrix.hstack(sympy.zeros(4), sympy.eye(4))
    return sympy.ImmutableMatrix(sympy.Matrix.vstack(top, sympy.Matrix.hstack(stiffness, damping)))


@functools.cache
def long_coefficient() -> str:
    """Return the LaTeX of a coefficient of the characteristic polynomial, a sum of many products.

    It is the one of s**4: the determinant less two rows and columns, times the masses that stood in them.
    """
    stiffness = sympy.diag(*[K[i] + K[i + 1] for i in range(4)])
    for i in range(3):
        stiffness[i, i + 1] = stiffness[i + 1, i] = -K[i + 1]
    coefficient = sum(
        M[i] * M[j] * stiffness.minor_submatrix(j, j).minor_submatrix(i, i).det()
        for i, j in itertools.combinations(range(4), 2)
    )
    return f"a_{{4}} = {sympy.latex(sympy.expand(coefficient))}"


NESTED = (
    r"\beta = \sqrt{1 - \sqrt{1 - \frac{4 b}{A} \left(1 - \frac{b}{A}\right)}} + \sqrt[3]{x^{2} + \sqrt{y}}"
)
CASES = (
    r"y{\left(t \right)} = \begin{cases} A \sin{\left(\omega t \right)} - b & \text{for}\: 0 \leq \omega t < "
    r"\frac{\pi}{2} \\ A - b & \text{for}\: \frac{\pi}{2} \leq \omega t < \pi - \beta \\ "
    r"A \sin{\left(\omega t \right)} + b & \text{otherwise} \end{cases}"
)
DOTS = (
    r"m_{1} \ddot{q}_{1} + c_{1} \left(\dot{q}_{1} - \dot{q}_{2}\right) + k_{1} \left(q_{1} - q_{2}\right)"
    r" = c_{5} \dot{u} + k_{5} u"
)
INTEGRAL = (
    r"a_{1} = \frac{1}{\pi} \int\limits_{0}^{2 \pi} y{\left(\theta \right)}"
    r" \cos{\left(\theta \right)}\, d\theta"
)
KINETIC_ENERGY = "T = " + " + ".join(rf"\frac{{m_{{{i}}} \dot{{q}}_{{{i}}}^{{2}}}}{{2}}" for i in range(1, 5))
