"""The describing functions step by step: every equation is proven, and every proof can fail."""

import re
from dataclasses import replace

import mpmath
import pytest
import sympy

from derivations.algebra.identity import UnprovenError
from derivations.dimensions import DimensionError
from derivations.elements import narrative as element_narrative
from derivations.elements.backlash import GAP
from derivations.elements.equivalent_nonlinearity import units_check
from derivations.elements.friction import DAMPING, FORCE, LEVEL
from derivations.elements.harmonics import HARMONIC
from derivations.elements.steps import friction
from derivations.symbols import A, omega
from tests.quick import quick

DIGITS = 40
SMALL = sympy.Rational(1, 10**9)
VALUES = {
    A: sympy.Rational(13, 10),
    friction.VELOCITY_AMPLITUDE: sympy.Rational(13, 10),
    LEVEL: sympy.Rational(7, 10),
    FORCE: sympy.Rational(2, 5),
    DAMPING: sympy.Rational(1, 5),
    omega: sympy.Integer(3),
}


@pytest.fixture(scope="module")
def steps():
    return element_narrative.proven_steps()


@pytest.mark.slow
def test_no_equation_with_a_wrong_factor_is_proven(steps):
    for step in steps:
        for equality in step.equalities:
            closed = equality.closed * (1 + SMALL) if equality.closed != 0 else SMALL
            assert_unproven(equality, closed)


@pytest.mark.slow
def test_no_equation_with_a_wrong_sign_is_proven(steps):
    """The last of each step; all take the same way through the proof."""
    for step in steps:
        equality = step.equalities[-1]
        assert_unproven(equality, -equality.closed if equality.closed != 0 else sympy.I)


def assert_unproven(equality, closed):
    with pytest.raises(UnprovenError, match=re.escape(equality.name)):
        replace(equality, closed=closed).prove()


def quadrature(output, breaks, harmonic):
    """(j/(πA)) ∫ y exp(-jnθ) dθ over the period, from the output alone."""
    integral = mpmath.quad(lambda theta: output(theta) * mpmath.expj(-harmonic * theta), breaks)
    return mpmath.mpc(0, 1) * integral / (mpmath.pi * mpmath.mpf("1.3"))


def sign(value):
    return 1 if value > 0 else -1


CASES = {
    "relay": (friction.relay, "N_n", lambda theta: mpmath.mpf("0.7") * sign(mpmath.sin(theta))),
    "velocity": (friction.coulomb_friction, "N_n", lambda theta: mpmath.mpf("0.4") * sign(mpmath.sin(theta))),
    "displacement": (
        friction.coulomb_friction,
        "N_{4 m + {rest}}",
        lambda theta: mpmath.mpf("0.4") * sign(mpmath.cos(theta)),
    ),
    "viscous": (
        friction.viscous_friction,
        "N_1",
        lambda theta: mpmath.mpf("0.2") * 3 * mpmath.mpf("1.3") * mpmath.cos(theta),
    ),
}


@pytest.mark.parametrize("harmonic", quick([1, 3, 21], 1))
@pytest.mark.parametrize("name", CASES)
def test_relay_and_friction_are_those_of_quadrature(name, harmonic):
    step, left, output = CASES[name]
    left = "N_n" if name == "viscous" and harmonic > 1 else left.replace("{rest}", str(harmonic % 4))
    (equality,) = (each for each in step().equalities if each.name == left)
    values = VALUES | {HARMONIC: harmonic, friction.COUNT: harmonic // 4}
    closed = sympy.sympify(equality.closed).subs(values).evalf(DIGITS)
    with mpmath.workdps(DIGITS + 5):
        breaks = [mpmath.pi * quarter / 2 for quarter in range(5)]
        expected = quadrature(output, breaks, harmonic)
        assert abs(mpmath.mpmathify(closed) - expected) < mpmath.mpf(10) ** (4 - DIGITS)


def test_units_of_the_equivalent_nonlinearity_are_those_that_are_stated():
    units = units_check(GAP / A)
    units.require_sum()
    assert str(units.friction) == "kg s^-2"
    with pytest.raises(DimensionError, match="only the last"):
        replace(units, friction=units.backlash).require_sum()
    with pytest.raises(DimensionError, match="only the last"):
        replace(units, over_stiffness=units.friction).require_sum()
