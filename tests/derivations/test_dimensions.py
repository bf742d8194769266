"""The dimension check: what passes, what fails, and that SymPy's unit system agrees."""

import re
from dataclasses import replace

import pytest
import sympy
from sympy.physics.units import length, mass, time
from sympy.physics.units.systems.si import SI

from derivations import symbols
from derivations.dimension_checks import dimension_checks, require_consistent
from derivations.dimensions import FORCE, LENGTH, MASS, NUMBER, TIME, DimensionError, dimension_of
from derivations.linear_trimmer import derive_linear_trimmer
from derivations.symbols import DIMENSIONS, QUANTITIES, A, c1, f, k1, m1, q1, q2, t, u, u_dot


def test_every_derived_equation_is_consistent_and_each_is_named_where_it_is_not():
    derived = derive_linear_trimmer()
    require_consistent(checks := dimension_checks(derived))
    assert len(checks) == 155  # energies, powers, accelerations; A and B; transfer functions: 10 + 80 + 65
    power, transfer = derived.power, derived.transfer
    denominator, numerators = list(transfer.denominator), [list(row) for row in transfer.from_velocity]
    denominator[3], numerators[1][-1] = f * denominator[3], f * numerators[1][-1]
    for name, wrong in {
        "kinetic energy": replace(derived, kinetic_energy=m1 * derived.kinetic_energy),
        "dissipation function": replace(derived, rayleigh_function=derived.rayleigh_function / f),
        "dissipated power": replace(
            derived, power=replace(power, dissipated_power=A * power.dissipated_power)
        ),
        "acceleration of q3": replace(
            derived, accelerations=tuple(f * each for each in derived.accelerations)
        ),
        "denominator, s^5": replace(derived, transfer=replace(transfer, denominator=tuple(denominator))),
        "numerator of q2, s^0": replace(derived, transfer=replace(transfer, from_velocity=numerators)),
    }.items():
        checks = tuple(each for each in dimension_checks(wrong) if each.name == name)
        with pytest.raises(DimensionError, match=re.escape(name)):
            require_consistent(checks)


def test_every_symbol_has_a_meaning_and_a_unit_once():
    names = [quantity.symbol for quantity in QUANTITIES]
    assert len(set(names)) == len(names)
    assert all(quantity.meaning and quantity.unit.text for quantity in QUANTITIES)


UNITS = [each for each in vars(symbols).values() if isinstance(each, symbols.Unit)]
OF_NAMES = {"kg": MASS, "m": LENGTH, "s": TIME, "N": FORCE, "Hz": TIME**-1, "rad": NUMBER, "1": NUMBER}


def written(text):
    """Return the dimension that a unit is written with: a product, over a product or a single unit."""
    above, below = re.fullmatch(r"(.*?)(?:(?<!\^1)(?<!\^-1)/\(?([^)]*)\)?)?", text.replace("²", "^2")).groups(
        ""
    )
    found = NUMBER
    for part, sign in ((above, 1), (below, -1)):
        for name, power in re.findall(r"(\w+)(?:\^(-?\d+(?:/\d+)?))?", part):
            found = found * OF_NAMES[name] ** (sign * sympy.Rational(power or 1))
    return found


@pytest.mark.parametrize("unit", UNITS, ids=lambda unit: unit.text)
def test_a_unit_has_the_dimension_that_it_is_written_with(unit):
    assert written(unit.text) == unit.dimension


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (m1 * q1.diff(t, 2), FORCE),
        (k1 * q1 + c1 * q1.diff(t), FORCE),
        (A * sympy.sin(2 * sympy.pi * f * t), LENGTH),
        (sympy.sqrt(k1 / m1), TIME**-1),
        (sympy.Integer(3), NUMBER),
        (sympy.sqrt(q1 * q2) ** 3, LENGTH**3),
        (sympy.Derivative(k1 * q1, q1, evaluate=False), MASS / TIME**2),
        (sympy.Derivative(sympy.Integer(0) * q1, t, evaluate=False), None),
        (sympy.Add(sympy.Integer(0), q1, q2, evaluate=False), LENGTH),
        (sympy.Mul(q1, sympy.Integer(0), evaluate=False), None),
        ((q1 / q2) ** (A / q1), NUMBER),
    ],
)
def test_dimension_of_an_expression(expression, expected):
    assert dimension_of(expression, DIMENSIONS) == expected


@pytest.mark.parametrize(
    "expression",
    [
        q1 + q1.diff(t),
        sympy.sin(q1),
        k1 * q1 + c1 * q1,
        sympy.exp(t),
        1 + A,
        2**q1,
        q1**f,
        sympy.atan2(q1, q2),
    ],
)
def test_inconsistent_expressions_are_refused(expression):
    with pytest.raises(DimensionError):
        dimension_of(expression, DIMENSIONS)


def test_zero_has_every_dimension_and_unknown_symbols_have_none():
    assert dimension_of(sympy.Integer(0), DIMENSIONS) is None
    with pytest.raises(KeyError):
        dimension_of(sympy.Symbol("unknown"), DIMENSIONS)


def test_printed_pin_velocity_without_amplitude_fails_the_check():
    printed = 2 * sympy.pi * f * sympy.cos(2 * sympy.pi * f * t)
    assert dimension_of(printed, DIMENSIONS) != dimension_of(u_dot, DIMENSIONS)
    assert dimension_of(A * printed, DIMENSIONS) == dimension_of(u_dot, DIMENSIONS)


@pytest.mark.parametrize("expression", [m1 * A * f**2, k1 * A**2 / 2, c1 * A * f, sympy.sqrt(k1 / m1) * A])
def test_sympy_units_agree(expression):
    replaced = {}
    for symbol in expression.free_symbols:
        dimension = DIMENSIONS[symbol]
        replaced[symbol] = mass**dimension.mass * length**dimension.length * time**dimension.time
    found = sympy.Integer(1)
    for factor in expression.as_ordered_factors():
        found = found * (1 if factor.is_number else factor.subs(replaced))
    exponents = SI.get_dimension_system().get_dimensional_dependencies(found)
    ours = dimension_of(expression, DIMENSIONS)
    assert {
        base: power
        for base, power in zip((mass, length, time), (ours.mass, ours.length, ours.time), strict=True)
        if power
    } == {base: power for base, power in exponents.items() if power}


def test_require_consistent_names_the_failing_expression():
    (check, *_) = dimension_checks(derive_linear_trimmer())
    wrong = type(check)("a wrong one", q1 * q2 * u, LENGTH)
    with pytest.raises(DimensionError, match="a wrong one"):
        require_consistent((check, wrong))


def test_a_product_with_zero_has_every_dimension():
    nothing = sympy.Mul(sympy.Integer(0), m1, evaluate=False)
    assert dimension_of(sympy.Add(k1 * q1, nothing, evaluate=False), DIMENSIONS) == FORCE
    hidden = sympy.Add(q1, -q1, evaluate=False)
    assert dimension_of(sympy.Mul(m1, hidden, evaluate=False), DIMENSIONS) in (None, MASS * LENGTH)
