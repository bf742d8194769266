"""Steps that are worked by hand: each line is what SymPy derives, and a wrong one is refused."""

from dataclasses import replace

import pytest
import sympy

from derivations import by_hand
from derivations.algebra.identity import UnprovenError
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.symbols import c2, k2, q2
from derivations.transfer_steps import output_numerator, transfer_function_step


@pytest.fixture(scope="module")
def derivation():
    return derive_linear_trimmer()


def test_a_wrong_line_is_not_shown(derivation):
    wrong = replace(derivation, lagrangian=derivation.lagrangian + k2 * q2**2)
    with pytest.raises(UnprovenError, match="force of the springs"):
        by_hand.worked_equation(wrong)
    other = replace(derivation, rayleigh_function=2 * derivation.rayleigh_function)
    with pytest.raises(UnprovenError, match="damper"):
        by_hand.worked_equation(other)


def test_the_velocity_acts_as_the_displacement_does(derivation):
    matrices = derivation.matrices
    assert sympy.simplify(matrices.velocity_force / c2 - matrices.displacement_force / k2).is_zero_matrix
    assert r"1 + \frac{c_2}{k_2} s" in transfer_function_step(derivation).formulas[-1].latex
    assert len(output_numerator(derivation)) == 7
