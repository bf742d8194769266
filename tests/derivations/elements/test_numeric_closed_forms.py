"""The code of the numeric elements, run on symbols, gives the derived closed forms: a proof, not a sample."""

import numpy as np
import pytest
import sympy
from sympy import cos, exp, pi, sin

from derivations.algebra.identity import UnprovenError
from derivations.elements.backlash import GAMMA, SEPARATION
from derivations.elements.backlash_closed_forms import general_fundamental, general_harmonic
from derivations.elements.backlash_harmonics import FLIGHT, general_motion, in_phases
from derivations.elements.backlash_slopes import (
    AFTER_EVALUATION,
    closed_slope_by_log_gamma,
    closed_slope_by_ratio,
    relative_velocity,
)
from derivations.elements.harmonics import HARMONIC
from derivations.elements.proven_step import Equality
from tests.derivations.symbolic_numpy import SymbolicNumPy, exact, integrated
from trimmer.elements import small_arguments
from trimmer.elements.backlashes import (
    backlash_frequency,
    backlash_harmonics,
    backlash_motion,
    contact_equation,
    short_flight,
)

RATIO = sympy.Symbol("u", positive=True)
C, S = cos(SEPARATION), sin(SEPARATION)
VELOCITY = C * exp(-FLIGHT / GAMMA) - cos(SEPARATION + FLIGHT)
MOTION = backlash_motion.BacklashMotion(GAMMA, C, S, FLIGHT, pi - FLIGHT, VELOCITY)
SMALL = sympy.Rational(1, 10**9)
LONG, BRIEF, SHORT = ({FLIGHT: flight, GAMMA: 1} for flight in (2.5, 1.0, 0.1))
"""Samples: a flight longer than the contact, one that is not, and one for which the series are used."""


def prove(code, closed, given=()):
    Equality("code", closed, code, given=(*given, *AFTER_EVALUATION)).prove()


def ratio():
    return in_phases(general_motion().ratio())


def complex_sum(real, imaginary):
    return real + sympy.I * imaginary


DEFINITIONS = {
    "complex_of": lambda real, imaginary: real + sympy.I * imaginary,
    "relative_velocity": lambda t, gamma, cosine: cosine * (exp(-t / gamma) - cos(t) + sin(t) / gamma),
    "argument_less_sine": lambda x: x - sin(x),
    "damped_excess_of_sinh": lambda x: 2 * exp(-x) * (sympy.sinh(x) - x),
    "sine_remainder": lambda x: (x - sin(x)) / x**3,
    "cosine_remainder": lambda x: (cos(x) - 1 + x**2 / 2) / x**4,
    "decay_remainder": lambda x: (exp(-x) - 1 + x) / x**2,
    "decay_integral_remainder": lambda x: (1 - exp(-x) - x + x**2 / 2) / x**3,
}
"""What the functions for small arguments stand for; they have tests of their own."""


@pytest.fixture
def on_symbols(monkeypatch):
    """Return a function that makes a module compute with symbols, its branches decided at a sample."""

    def prepare(module, sample, *defined):
        monkeypatch.setattr(module, "np", SymbolicNumPy(sample))
        for name in defined:
            monkeypatch.setattr(module, name, DEFINITIONS[name])

    return prepare


@pytest.mark.parametrize("sample", [LONG, BRIEF], ids=["long", "brief"])
def test_fundamental(on_symbols, sample):
    on_symbols(backlash_motion, sample, "argument_less_sine", "damped_excess_of_sinh", "complex_of")
    code = exact(backlash_motion.fundamental(MOTION)).rewrite(sympy.sinh, exp)
    prove(code, general_fundamental())
    with pytest.raises(UnprovenError):
        prove(code * (1 + SMALL), general_fundamental())


@pytest.mark.parametrize("sample", [LONG, BRIEF, SHORT], ids=["long", "brief", "short"])
def test_harmonics(on_symbols, sample):
    """Gauss's rule stands for its integral; how many nodes it needs is a matter of the numeric tests."""
    on_symbols(backlash_harmonics, sample, "relative_velocity")
    code = integrated(backlash_harmonics.harmonic_of(MOTION, HARMONIC))
    prove(code, general_harmonic())
    with pytest.raises(UnprovenError):
        prove(code * (1 + SMALL), general_harmonic())


def test_slope_by_ratio(on_symbols):
    on_symbols(backlash_motion, LONG, "complex_of")
    assert 2 / np.pi == backlash_motion.SLOPE_BY_RATIO
    code = backlash_motion.slope_by_ratio(MOTION) / backlash_motion.SLOPE_BY_RATIO
    prove(2 / pi * exact(code), closed_slope_by_ratio())


def test_slope_by_log_gamma(on_symbols):
    """The closed form for small gamma; the quadrature for the others has the same integrand."""
    on_symbols(backlash_frequency, LONG)
    integral = exact(backlash_frequency._closed_form(GAMMA, FLIGHT))
    prove(2 * sympy.I / pi * C * exp(-sympy.I * SEPARATION) * integral, closed_slope_by_log_gamma())


def test_equation_of_the_flight(on_symbols):
    on_symbols(contact_equation, LONG)
    value, slope, curvature = map(exact, contact_equation._flight_residual(FLIGHT, RATIO, GAMMA, C, S))
    prove(value, ratio() - RATIO)
    prove(slope, relative_velocity())
    prove(curvature, VELOCITY.diff(FLIGHT))


def test_equation_of_the_contact(on_symbols):
    """The same equation by the distance to the largest g/A and by the contact, which runs backwards."""
    on_symbols(contact_equation, LONG)
    last = sympy.Symbol("last", positive=True)
    largest = 2 * S + GAMMA * C * (1 - last)
    value, slope, curvature = map(
        exact, contact_equation._contact_residual(pi - FLIGHT, largest - RATIO, GAMMA, C, S)
    )
    prove(value, RATIO - ratio(), given=((exp(-pi / GAMMA), last),))
    prove(slope, relative_velocity())
    prove(curvature, -VELOCITY.diff(FLIGHT))


def test_equation_of_a_short_flight(on_symbols):
    remainders = ("decay_integral_remainder", "decay_remainder", "sine_remainder", "cosine_remainder")
    on_symbols(short_flight, SHORT, *remainders)
    value, slope, curvature = map(exact, short_flight.short_residual(FLIGHT, RATIO, GAMMA, C))
    prove(value, ratio() - RATIO)
    prove(slope, relative_velocity())
    prove(curvature, VELOCITY.diff(FLIGHT))


@pytest.mark.parametrize(
    ("coefficients", "function", "power"),
    [
        (small_arguments.SINE, "sine_remainder", 2),
        (small_arguments.COSINE, "cosine_remainder", 2),
        (small_arguments.DECAY, "decay_remainder", 1),
        (small_arguments.DECAY_INTEGRAL, "decay_integral_remainder", 1),
    ],
)
def test_series_for_small_arguments_are_those_of_the_definitions(coefficients, function, power):
    x = sympy.Symbol("x")
    order = power * (len(coefficients) - 1) + 1
    series = sympy.series(DEFINITIONS[function](x), x, 0, order).removeO()
    expected = [float(series.coeff(x, power * index)) for index in range(len(coefficients))]
    assert coefficients == pytest.approx(expected, rel=1e-15, abs=0.0)
    assert all(series.coeff(x, each) == 0 for each in range(order) if each % power)
