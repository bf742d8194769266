"""Transfer functions and state space: two ways to one result, and hand-computed limits."""

import pytest
import sympy

from derivations.linear_trimmer import derive_linear_trimmer
from derivations.state_space import output_row
from derivations.symbols import PARAMETERS, k1, k2, k3, k5, s

# Values chosen at random, as fractions, so that identities can be checked exactly.
VALUES = dict(
    zip(
        (quantity.symbol for quantity in PARAMETERS),
        [sympy.Rational(numerator, 7) for numerator in (3, 5, 2, 9, 11, 4, 13, 6, 1, 8, 10, 12, 15)],
        strict=True,
    )
)


@pytest.fixture(scope="module")
def derivation():
    return derive_linear_trimmer()


def test_resolvent_gives_the_same_transfer_functions(derivation):
    a, b = derivation.space.a.subs(VALUES), derivation.space.b.subs(VALUES)
    point = sympy.Rational(3, 4)
    states = (point * sympy.eye(8) - a).inv() * b
    denominator = sympy.Poly([c.subs(VALUES) for c in derivation.transfer.denominator], s).eval(point)
    for channel, numerators in enumerate(
        (derivation.transfer.from_displacement, derivation.transfer.from_velocity)
    ):
        for body, numerator in enumerate(numerators):
            value = sympy.Poly([c.subs(VALUES) for c in numerator], s).eval(point) / denominator
            assert value == states[body, channel]


def test_static_gain_is_that_of_springs_in_series(derivation):
    """At rest the pin's displacement is shared by the springs; from the chain of springs by hand."""
    static = [row[-1] / derivation.transfer.denominator[-1] for row in derivation.transfer.from_displacement]
    support = 1 / k1 + 1 / (k5 * k3 / (k3 + k5)) + 1 / k2
    force = 1 / support
    assert sympy.simplify(static[1] - static[0] - (1 - force / k2)) == 0
    assert sympy.simplify(static[0] + force / k1) == 0
    assert sympy.simplify(static[2] - force / k3) == 0
    assert sympy.simplify(static[3] - static[2]) == 0


def test_output_row_selects_a_difference():
    assert list(output_row(1, 3, 4)) == [0, 1, 0, -1, 0, 0, 0, 0]
    assert list(output_row(2, None, 4)) == [0, 0, 1, 0, 0, 0, 0, 0]
