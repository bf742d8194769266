"""Fourier coefficients of a pulse, whose values are elementary."""

import sympy
from sympy import Rational, pi, sqrt

from derivations.elements.waveform import (
    THETA,
    Segment,
    Waveform,
    describing_function,
    segment_integral,
    simplified_describing_function,
)
from derivations.symbols import A

HEIGHT, SHARE = sympy.symbols("h s", positive=True)
PULSE = Waveform((Segment(sympy.Integer(0), pi / 3, HEIGHT), Segment(pi / 3, 2 * pi, sympy.Integer(0))))


def test_sine_and_cosine_of_a_pulse():
    # Over 60 degrees sin and cos give 1/2 and sqrt(3)/2; those of the doubled angle 3/4 and sqrt(3)/4.
    assert PULSE.sine_coefficient() == HEIGHT / (2 * pi)
    assert PULSE.cosine_coefficient() == sqrt(3) * HEIGHT / (2 * pi)
    assert PULSE.sine_coefficient(2) == Rational(3, 4) * HEIGHT / pi
    assert PULSE.cosine_coefficient(2) == sqrt(3) * HEIGHT / (4 * pi)
    assert PULSE.jumps() == (-HEIGHT, HEIGHT)
    assert PULSE.segments[0].position(sympy.Integer(1)) == HEIGHT
    assert segment_integral(Segment(pi / 6, pi / 2, THETA), sympy.Integer(1)) == pi**2 / 9


def test_the_describing_function_of_a_pulse():
    expected = HEIGHT * (1 + sympy.I * sqrt(3)) / (2 * pi * A)
    assert sympy.expand(describing_function(PULSE, A) - expected) == 0
    assert sympy.expand(simplified_describing_function(PULSE, A) - expected) == 0
    real, imaginary = simplified_describing_function(PULSE, A, (HEIGHT, SHARE * A)).args
    assert (real, imaginary.doit()) == (SHARE / (2 * pi), sympy.I * sqrt(3) * SHARE / (2 * pi))
