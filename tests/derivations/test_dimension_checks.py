"""Which derived expressions the dimension checks reach: all, each with its own dimension."""

from dataclasses import replace
from functools import cache

import pytest
import sympy

from derivations.dimension_checks import dimension_checks, require_consistent
from derivations.dimensions import DimensionError
from derivations.linear_trimmer import LinearTrimmer, derive_linear_trimmer
from derivations.symbols import A, f, m1
from tests.quick import quick

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


@pytest.mark.parametrize("body", range(BODIES))
def test_each_acceleration_is_checked(body: int) -> None:
    accelerations = list(derived().accelerations)
    accelerations[body] = accelerations[body] / f
    assert failing(replace(derived(), accelerations=tuple(accelerations))) == f"acceleration of q{body + 1}"


@pytest.mark.parametrize("place", range(2 * BODIES + 1))
def test_each_coefficient_of_the_denominator_is_checked(place: int) -> None:
    denominator = list(derived().transfer.denominator)
    denominator[place] = denominator[place] * f
    wrong = replace(derived(), transfer=replace(derived().transfer, denominator=tuple(denominator)))
    assert failing(wrong) == f"denominator, s^{2 * BODIES - place}"


@pytest.mark.parametrize("name", ["from_displacement", "from_velocity"])
@pytest.mark.parametrize("body", quick(range(BODIES), 1))
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
