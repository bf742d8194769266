"""Which derived expressions the dimension checks reach: all, each with its own dimension."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest
import sympy

from derivations.dimension_checks import DimensionCheck, dimension_checks, require_consistent
from derivations.dimensions import ENERGY, LENGTH, MASS, NUMBER, POWER, TIME, DimensionError, dimension_of
from derivations.linear_trimmer import LinearTrimmer, derive_linear_trimmer
from derivations.symbols import DIMENSIONS, A, c1, f, k1, m1, q1, q2, t, u

BODIES = 4


@cache
def derived() -> LinearTrimmer:
    return derive_linear_trimmer()


def failing(derivation: LinearTrimmer) -> str:
    """Return the name of the first expression that is not consistent, empty if all are."""
    for check in dimension_checks(derivation):
        try:
            require_consistent((check,))
        except DimensionError:
            return check.name
    return ""


def with_power(name: str, factor: sympy.Expr) -> LinearTrimmer:
    power = derived().power
    return replace(derived(), power=replace(power, **{name: getattr(power, name) * factor}))


@pytest.mark.parametrize(
    ("attribute", "name"),
    [
        ("kinetic_energy", "kinetic energy"),
        ("potential_energy", "potential energy"),
        ("rayleigh_function", "dissipation function"),
    ],
)
@pytest.mark.parametrize("factor", [A, 1 / f, m1])
def test_an_energy_with_a_wrong_factor_is_named(attribute: str, name: str, factor: sympy.Expr) -> None:
    wrong = replace(derived(), **{attribute: getattr(derived(), attribute) * factor})
    assert failing(wrong) == name


def test_powers_with_a_wrong_factor_are_named() -> None:
    assert failing(with_power("input_power", A)) == "power of the pin"
    assert failing(with_power("dissipated_power", f)) == "dissipated power"


@pytest.mark.parametrize("body", range(BODIES))
def test_each_acceleration_is_checked(body: int) -> None:
    accelerations = list(derived().accelerations)
    accelerations[body] = accelerations[body] / f
    assert failing(replace(derived(), accelerations=tuple(accelerations))) == f"acceleration of q{body + 1}"


@pytest.mark.parametrize("name", ["a", "b"])
def test_each_entry_of_the_state_space_is_checked(name: str) -> None:
    """A wrong factor, or an entry in the place of one of another row or column, is named with its place."""
    space = derived().space
    matrix = getattr(space, name)
    for row in range(2 * BODIES):
        for column in range(matrix.cols):
            if matrix[row, column] == 0:
                continue
            changed = matrix.as_mutable()
            changed[row, column] = matrix[row, column] * f
            wrong = replace(derived(), space=replace(space, **{name: changed.as_immutable()}))
            assert failing(wrong).startswith(f"{name.upper()}[{row + 1}, {column + 1}] in the rate of ")


def test_where_a_state_is_zero_each_other_dimension_is_refused_too() -> None:
    """A displacement in the rate of a displacement needs a factor of 1/s, in that of a velocity of 1/s²."""
    space = derived().space
    for row, entry in ((0, k1 / m1), (BODIES, c1 / m1)):
        changed = space.a.as_mutable()
        changed[row, 0] = entry
        wrong = replace(derived(), space=replace(space, a=changed.as_immutable()))
        assert failing(wrong).startswith(f"A[{row + 1}, 1] in the rate of ")


@pytest.mark.parametrize("place", range(2 * BODIES + 1))
def test_each_coefficient_of_the_denominator_is_checked(place: int) -> None:
    denominator = list(derived().transfer.denominator)
    denominator[place] = denominator[place] * f
    wrong = replace(derived(), transfer=replace(derived().transfer, denominator=tuple(denominator)))
    assert failing(wrong) == f"denominator, s^{2 * BODIES - place}"


@pytest.mark.parametrize("name", ["from_displacement", "from_velocity"])
@pytest.mark.parametrize("body", range(BODIES))
def test_each_coefficient_of_the_numerators_is_checked(name: str, body: int) -> None:
    transfer = derived().transfer
    numerators = getattr(transfer, name)
    count = len(numerators[body])
    for place, coefficient in enumerate(numerators[body]):
        if coefficient == 0:
            continue
        rows = [list(row) for row in numerators]
        rows[body][place] = coefficient * f
        wrong = replace(derived(), transfer=replace(transfer, **{name: tuple(map(tuple, rows))}))
        assert failing(wrong) == f"numerator of q{body + 1}, s^{count - 1 - place}"


def test_a_check_finds_the_dimension_and_zero_has_any() -> None:
    check = DimensionCheck("energy", k1 * q1**2, ENERGY)
    assert check.found == ENERGY
    assert DimensionCheck("nothing", sympy.Integer(0), POWER).found is None
    require_consistent((check, DimensionCheck("nothing", sympy.Integer(0), POWER)))
    own = DimensionCheck("own symbols", m1 * q1, NUMBER, {m1: MASS, q1: MASS**-1})
    require_consistent((own,))


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (sympy.sqrt(q1 * q2) ** 3, LENGTH**3),
        (sympy.sqrt(q1), LENGTH ** sympy.Rational(1, 2)),
        (q1.diff(t, 3), LENGTH / TIME**3),
        (sympy.Derivative(k1 * q1, q1, evaluate=False), MASS / TIME**2),
        (sympy.Derivative(sympy.Integer(0) * q1, t, evaluate=False), None),
        (sympy.Add(sympy.Integer(0), q1, u, evaluate=False), LENGTH),
        (sympy.Mul(q1, sympy.Integer(0), evaluate=False), None),
        (sympy.atan2(q1 / q2, 3), NUMBER),
        ((q1 / q2) ** (A / u), NUMBER),
        (sympy.pi * 2, NUMBER),
        (sympy.Max(q1 / q2, 1), NUMBER),
    ],
)
def test_dimensions_by_hand(expression: sympy.Expr, expected: object) -> None:
    assert dimension_of(expression, DIMENSIONS) == expected


@pytest.mark.parametrize(
    "expression",
    [sympy.atan2(q1, q2), q1 ** (q1 / q2), (q1 / q2) ** q1, q1 + 2 * q2 + k1, q1 ** sympy.sqrt(2)],
)
def test_what_has_no_dimension_is_refused(expression: sympy.Expr) -> None:
    with pytest.raises(DimensionError):
        dimension_of(expression, DIMENSIONS)


def test_dimensions_are_written_as_units() -> None:
    assert str(ENERGY) == "kg m^2 s^-2"
    assert str(NUMBER) == "1"
    assert str(MASS / LENGTH) == "kg m^-1"
