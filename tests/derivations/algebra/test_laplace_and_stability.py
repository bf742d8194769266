"""The Laplace domain of a general system, and the facts about stability that the thesis leans on."""

import numpy as np
import pytest
import scipy.linalg
import scipy.signal
import sympy

from derivations.algebra.laplace import general_system, transform, transform_of_derivative
from derivations.algebra.stability import (
    LINEAR_PART,
    NONLINEAR_PART,
    NUMBER_OF_POLES,
    NUMBER_OF_ZEROS,
    closed_loop,
    double_integrator,
    encirclements_of_origin,
    exponential_norm,
)
from derivations.symbols import s, t


def test_transform_of_a_derivative_holds_the_start():
    start = sympy.Symbol("q_start")
    assert sympy.expand(transform_of_derivative(start) - (s * sympy.Symbol("Q") - start)) == 0


def test_general_output_agrees_with_scipy():
    system = general_system()
    names = [*system.a, *system.b, *system.c, system.d]
    values = np.array([-1.0, 2.0, -3.0, -4.0, 0.5, 1.5, 2.5, -0.5, 0.25])
    point = 0.7
    numerator, denominator = scipy.signal.ss2tf(
        values[:4].reshape(2, 2),
        values[4:6].reshape(2, 1),
        values[6:8].reshape(1, 2),
        values[8:].reshape(1, 1),
    )
    expected = np.polyval(numerator[0], point) / np.polyval(denominator, point)
    output = transform(system).output.subs(dict(zip(names, values, strict=True)))
    assert float(output.subs({s: point, system.input_transform: 1})) == pytest.approx(expected, rel=1e-12)


def test_encirclements_are_zeros_less_poles_as_a_contour_integral_finds():
    assert encirclements_of_origin() == NUMBER_OF_ZEROS - NUMBER_OF_POLES
    angle = np.linspace(0, 2 * np.pi, 20001)
    contour = 2 * np.exp(1j * angle)
    values = (contour - 1) ** 3 * (contour + 5) / (contour + 0.5) ** 2
    turns = np.unwrap(np.angle(values))
    assert round((turns[-1] - turns[0]) / (2 * np.pi)) == 3 - 2


def test_closed_loop_solves_the_loop():
    result = closed_loop(NONLINEAR_PART, LINEAR_PART)
    assert sympy.simplify(result - LINEAR_PART / (1 + LINEAR_PART * NONLINEAR_PART)) == 0
    ahead = closed_loop(sympy.Integer(1), LINEAR_PART * NONLINEAR_PART)
    assert sympy.denom(sympy.together(ahead)).equals(sympy.denom(sympy.together(result)))


def test_counterexample_has_zero_eigenvalues_and_grows():
    matrix = double_integrator()
    assert set(matrix.eigenvals()) == {0}
    norm = exponential_norm(matrix)
    assert sympy.limit(norm, t, sympy.oo) == sympy.oo
    numeric = np.linalg.norm(scipy.linalg.expm(7.0 * np.array(matrix, dtype=float)))
    assert float(norm.subs(t, 7.0)) == pytest.approx(numeric)
