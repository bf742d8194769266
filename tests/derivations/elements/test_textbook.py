"""The derivation of saturation, dead zone, preload and relays: proven, and each proof can fail."""

import re
from dataclasses import replace

import pytest
import sympy

from derivations.algebra.identity import UnprovenError
from derivations.elements.friction import LEVEL
from derivations.elements.harmonics import HARMONIC
from derivations.elements.narrative import textbook_narrative
from derivations.elements.steps import textbook as steps
from derivations.elements.textbook import (
    CORNER,
    FALL,
    SLOPE,
    relay_harmonic,
    saturation_fundamental,
    saturation_harmonic,
)
from derivations.symbols import A
from trimmer import Relay, Saturation

SMALL = sympy.Rational(1, 10**9)


@pytest.fixture(scope="module")
def declared():
    return steps.steps()


def test_every_equation_is_proven_by_algebra(declared):
    for step, proven in zip(declared, textbook_narrative(), strict=True):
        assert f"Proven equations: {len(step.equalities)}." in proven.text
        assert "random" not in proven.text


def test_no_corrupted_equation_is_proven(declared):
    for step in declared:
        for equality in step.equalities:
            closed = equality.closed * (1 + SMALL) if equality.closed != 0 else SMALL
            with pytest.raises(UnprovenError, match=re.escape(equality.name)):
                replace(equality, closed=closed).prove()


def test_the_numbers_are_those_of_the_derivation():
    """The closed forms that are proven here, beside the elements, which evaluate other forms of them."""
    for alpha in (0.01, 0.6, 1.5):
        amplitude = 1.0 / float(sympy.sin(alpha).evalf())
        at = {CORNER: alpha, SLOPE: 0.7, A: amplitude}
        saturation = Saturation(1.0, 0.7)
        assert complex(saturation_fundamental().subs(at)) == pytest.approx(
            complex(saturation.describing_function(amplitude)), rel=1e-13
        )
        for n in (3, 11):
            exact = complex(saturation_harmonic().subs(at).subs(HARMONIC, n).evalf(30))
            value = complex(saturation.describing_function(amplitude, harmonic=n))
            assert value == pytest.approx(exact, rel=1e-11)
    relay = Relay(2.0, hysteresis=0.3, dead_zone=0.5)
    at = {A: 1.7, LEVEL: 2.0, CORNER: sympy.asin(0.8 / 1.7), FALL: sympy.asin(0.2 / 1.7)}
    for n in (1, 3, 11):
        assert complex(relay_harmonic().subs(at).subs(HARMONIC, n).evalf(30)) == pytest.approx(
            complex(relay.describing_function(1.7, harmonic=n)), rel=1e-13
        )


def test_what_is_shown_is_the_closed_form_not_what_it_came_from(declared):
    ideal = 4 * LEVEL / (sympy.pi * HARMONIC * A)
    expected = {
        r"N_n(r = 1)": ideal * sympy.cos(HARMONIC * CORNER),
        r"N_n(r = -1)": ideal * sympy.exp(-sympy.I * HARMONIC * CORNER),
        r"N_n(\Delta = 0)": ideal,
        r"\lim N_n": ideal,
        r"\lim N_1": 4 * LEVEL / (sympy.pi * A),
        r"N_1(A = \Delta)": SLOPE,
    }
    shown = {each.name: each.closed for step in declared for each in step.equalities}
    assert {name: shown[name] for name in expected} == expected
