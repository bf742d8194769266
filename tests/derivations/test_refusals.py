"""Derivations refuse what is wrong: a force left out, a proof that does not close, an unlike dimension."""

from dataclasses import replace
from itertools import product

import pytest
import sympy

from derivations.algebra.identity import UnprovenError
from derivations.dimension_checks import DimensionCheck, dimension_checks, require_consistent
from derivations.dimensions import ENERGY, LENGTH, MASS, NUMBER, POWER, DimensionError
from derivations.elements.proven_step import antiderivative_on
from derivations.elements.waveform import THETA, Segment
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.loop.dissipation import dissipation_step
from derivations.mechanism import trimmer
from derivations.newton_euler import require_newton_euler
from derivations.symbols import A, f, m1, q1


@pytest.mark.parametrize("kind", ["springs", "dampers"])
def test_newtons_law_notices_a_part_on_a_body_that_is_not_declared(kind: str) -> None:
    """Its coordinate is the motor's, so energies take it; no sum of forces on a declared body does."""
    made = trimmer()
    require_newton_euler(made)
    first, *others = getattr(made, kind)
    elsewhere = replace(first, end=replace(first.end, name="another"))
    with pytest.raises(UnprovenError, match="the acceleration of motor by Lagrange and by Newton"):
        require_newton_euler(replace(made, **{kind: (elsewhere, *others)}))


def test_the_proof_of_dissipation_is_refused_where_its_balance_does_not_close() -> None:
    derived = derive_linear_trimmer()
    assert dissipation_step(derived).id == "dissipation"
    with pytest.raises(UnprovenError, match="are not proven to come together"):
        dissipation_step(replace(derived, rayleigh_function=2 * derived.rayleigh_function))


def test_a_wrong_antiderivative_is_refused() -> None:
    """By parts: that of x exp(-3jx) is exp(-3jx) (1/9 + jx/3)."""
    segment = Segment(sympy.Integer(0), sympy.pi, THETA)
    wave, right = sympy.exp(-3 * sympy.I * THETA), sympy.Rational(1, 9) + sympy.I * THETA / 3
    assert antiderivative_on(segment, sympy.Integer(3), wave * right, "").prove().holds
    with pytest.raises(UnprovenError):
        antiderivative_on(segment, sympy.Integer(3), wave * (right + THETA / 10**9), "").prove()


@pytest.mark.parametrize("name", ["a", "b"])
def test_each_entry_of_the_state_space_is_checked_alone(name: str) -> None:
    derived = derive_linear_trimmer()
    matrix = getattr(derived.space, name)
    for row, column in product(range(matrix.rows), range(matrix.cols)):
        if matrix[row, column] == 0 and (name, row, column) != ("a", 0, 0):
            continue
        wrong = matrix.as_mutable()
        wrong[row, column] = (matrix[row, column] or 1) * A
        changed = replace(derived, space=replace(derived.space, **{name: wrong.as_immutable()}))
        told = rf"{name.upper()}\[{row + 1}, {column + 1}\] in the rate of .* has dimension .*, expected "
        with pytest.raises(DimensionError, match=told):
            require_consistent(dimension_checks(changed))


def test_powers_are_checked_and_zero_has_any_dimension() -> None:
    derived = derive_linear_trimmer()
    for name, told in (("input_power", "power of the pin"), ("dissipated_power", "dissipated power")):
        wrong = replace(derived.power, **{name: getattr(derived.power, name) * f})
        with pytest.raises(DimensionError, match=f"{told} has dimension"):
            require_consistent(dimension_checks(replace(derived, power=wrong)))
    require_consistent((DimensionCheck("nothing", sympy.Integer(0), POWER),))
    require_consistent((DimensionCheck("own symbols", m1 * q1, NUMBER, {m1: MASS, q1: MASS**-1}),))
    assert (str(ENERGY), str(NUMBER), str(MASS / LENGTH)) == ("kg m^2 s^-2", "1", "kg m^-1")
