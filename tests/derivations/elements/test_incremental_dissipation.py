"""Two motions of the driven trimmer with the same pin come together, and what that rests on."""

from dataclasses import replace

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from derivations.elements.incremental_dissipation import incremental_dissipation
from derivations.equations_of_motion import motion_matrices
from derivations.linear_trimmer import derive_linear_trimmer

SPEEDS = st.floats(-10, 10)
STICKING = st.floats(-1, 1)


@pytest.fixture(scope="module")
def trimmer():
    return derive_linear_trimmer()


@pytest.mark.slow
def test_the_proof_holds_for_the_trimmer(trimmer):
    proof = incremental_dissipation(trimmer)
    assert proof.residual == 0
    assert len(proof.leading_minors) == 12
    assert proof.holds


def test_the_balance_does_not_close_with_another_dissipation(trimmer):
    wrong = replace(trimmer, rayleigh_function=2 * trimmer.rayleigh_function)
    assert incremental_dissipation(wrong).residual != 0
    assert not incremental_dissipation(wrong).holds


def test_a_guard_without_damper_is_not_covered(trimmer):
    """Then the guard could ring for ever: the damping matrix is singular."""
    mechanism = replace(trimmer.mechanism, dampers=trimmer.mechanism.dampers[:-1])
    undamped = replace(trimmer, matrices=motion_matrices(mechanism))
    proof = incremental_dissipation(undamped)
    assert proof.leading_minors[7] == 0
    assert not proof.holds


def test_minors_are_those_of_matrices_with_positive_eigenvalues(trimmer):
    matrices = trimmer.matrices
    for matrix in (matrices.mass, matrices.damping, matrices.stiffness):
        names = sorted(matrix.free_symbols, key=str)
        values = {name: sympy.Rational(index + 1, 3) for index, name in enumerate(names)}
        eigenvalues = sympy.Matrix(matrix.subs(values)).evalf().eigenvals(multiple=True)
        assert all(sympy.re(value) > 0 for value in eigenvalues)


@given(SPEEDS, SPEEDS, STICKING, STICKING)
def test_friction_never_feeds_a_difference(first, second, held_first, held_second):
    """The claim of the derivation, with the set-valued sign evaluated by hand."""

    def sign(speed, held):
        return held if speed == 0 else (1 if speed > 0 else -1)

    loss = (sign(first, held_first) - sign(second, held_second)) * (first - second)
    assert loss >= 0
