"""Fourier coefficients and integrals of waveforms, with a number or a symbol for the harmonic."""

import mpmath
import pytest
import sympy
from sympy import Rational, pi, sqrt

from derivations.algebra.identity import UnprovenError
from derivations.elements.harmonics import HARMONIC, evaluated, first_half
from derivations.elements.waveform import (
    THETA,
    Segment,
    Waveform,
    describing_function,
    segment_integral,
    simplified_describing_function,
)
from derivations.symbols import A

x, g = sympy.symbols("x g", positive=True)
j = sympy.I
DIGITS = 40


@pytest.mark.parametrize(
    "integrand",
    [
        sympy.sin(x) * sympy.exp(-j * HARMONIC * x),
        sympy.cos(x) * sympy.exp(-j * x),
        x**3 * sympy.exp(-x / g) * sympy.sin(2 * x),
        (1 + x) ** 2,
        sympy.exp(-(1 - x) / g) * sympy.cos(x),
    ],
)
def test_integrals_are_those_of_quadrature(integrand):
    values = {HARMONIC: sympy.Integer(5), g: sympy.Rational(3, 7)}
    limits = (sympy.Rational(1, 3), sympy.Rational(5, 2))
    found = evaluated(sympy.Integral(integrand, (x, *limits))).subs(values).evalf(DIGITS)
    function = sympy.lambdify(x, integrand.subs(values), "mpmath")
    with mpmath.workdps(DIGITS):
        expected = mpmath.quad(function, [mpmath.mpf(limit.p) / limit.q for limit in limits])
        assert abs(mpmath.mpmathify(found) - expected) < mpmath.mpf(10) ** (3 - DIGITS)


def test_a_waveform_that_is_not_odd_is_refused():
    uneven = Waveform((Segment(sympy.Integer(0), sympy.pi, x), Segment(sympy.pi, 2 * sympy.pi, -2 * x)))
    late = Waveform((Segment(sympy.Integer(0), sympy.pi, x), Segment(sympy.pi, 3 * sympy.pi, -x)))
    shifted = Waveform((Segment(sympy.Integer(0), sympy.pi, THETA), Segment(sympy.pi, 2 * sympy.pi, -THETA)))
    for waveform in (uneven, late, shifted):
        with pytest.raises(UnprovenError, match="half a period"):
            first_half(waveform)


HEIGHT, SHARE = sympy.symbols("h s", positive=True)
PULSE = Waveform((Segment(sympy.Integer(0), pi / 3, HEIGHT), Segment(pi / 3, 2 * pi, sympy.Integer(0))))


def test_sine_and_cosine_of_a_pulse():
    # Over 60 degrees sin and cos give 1/2 and sqrt(3)/2; those of the doubled angle 3/4 and sqrt(3)/4.
    assert PULSE.sine_coefficient() == HEIGHT / (2 * pi)
    assert PULSE.cosine_coefficient() == sqrt(3) * HEIGHT / (2 * pi)
    assert PULSE.sine_coefficient(2) == Rational(3, 4) * HEIGHT / pi
    assert PULSE.cosine_coefficient(2) == sqrt(3) * HEIGHT / (4 * pi)
    assert PULSE.jumps() == (-HEIGHT, HEIGHT)
    risen = Waveform((Segment(sympy.Integer(0), pi, THETA), Segment(pi, 2 * pi, pi)))
    assert risen.jumps() == (0, -pi)
    assert PULSE.segments[0].position(sympy.Integer(1)) == HEIGHT
    assert segment_integral(Segment(pi / 6, pi / 2, THETA), sympy.Integer(1)) == pi**2 / 9


def test_the_describing_function_of_a_pulse():
    expected = HEIGHT * (1 + sympy.I * sqrt(3)) / (2 * pi * A)
    assert sympy.expand(describing_function(PULSE, A) - expected) == 0
    assert sympy.expand(simplified_describing_function(PULSE, A) - expected) == 0
    real, imaginary = simplified_describing_function(PULSE, A, (HEIGHT, SHARE * A)).args
    assert (real, imaginary.doit()) == (SHARE / (2 * pi), sympy.I * sqrt(3) * SHARE / (2 * pi))
