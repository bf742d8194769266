"""Closed forms for backlash against 40-digit quadrature from mechanics, which uses nothing of SymPy."""

from functools import cache

import mpmath
import pytest
import sympy

from derivations.elements.backlash import CONTACT, GAMMA, SEPARATION
from derivations.elements.backlash_closed_forms import (
    friction_fundamental,
    friction_harmonic,
    general_fundamental,
    general_harmonic,
    inertia_fundamental,
    inertia_harmonic,
)
from derivations.elements.backlash_harmonics import (
    DECAY,
    MEANINGS,
    friction_motion,
    general_motion,
    inertia_motion,
)
from derivations.elements.harmonics import HARMONIC
from tests.trimmer.elements.oracle import DIGITS, ExactBacklash

FORMS = {
    "friction": (friction_fundamental, friction_harmonic),
    "inertia": (inertia_fundamental, inertia_harmonic),
    "general": (general_fundamental, general_harmonic),
}
TOLERANCE = mpmath.mpf(10) ** (5 - DIGITS)


def case(gamma):
    return "friction" if gamma == 0 else "inertia" if gamma == mpmath.inf else "general"


@cache
def formula(name, first):
    fundamental, higher = FORMS[name]
    form = (fundamental if first else higher)().subs(MEANINGS)
    return sympy.lambdify((SEPARATION, CONTACT, DECAY, HARMONIC), form, "mpmath")


def closed_form(motion, harmonic):
    """Evaluate the closed form at the exact motion of the oracle."""
    separation = motion.separation()
    impact = separation + motion.duration
    decay = mpmath.exp(-motion.duration / motion.gamma) if motion.gamma else mpmath.mpf(0)
    return formula(case(motion.gamma), harmonic == 1)(separation, impact, decay, mpmath.mpf(harmonic))


def marked(quick, slow):
    return [*quick, *(pytest.param(each, marks=pytest.mark.slow) for each in slow)]


@pytest.mark.parametrize("harmonic", marked([1, 5], [3, 9]))
@pytest.mark.parametrize("ratio", marked(["0.05", "1.3"], ["0.7", "1.9"]))
@pytest.mark.parametrize("gamma", marked(["0", "1.25", "inf"], ["0.02", "0.4", "30"]))
def test_harmonics(gamma, ratio, harmonic):
    with mpmath.workdps(DIGITS + 10):
        motion = ExactBacklash(mpmath.mpf(ratio), mpmath.mpf(gamma))
        expected = motion.describing_function(harmonic)
        assert abs(closed_form(motion, harmonic) - expected) < TOLERANCE


@pytest.mark.parametrize(
    ("motion", "gamma"), [(friction_motion, "0"), (inertia_motion, "inf"), (general_motion, "0.6")]
)
def test_gap_over_amplitude_is_that_of_the_impact(motion, gamma):
    with mpmath.workdps(DIGITS + 10):
        exact = ExactBacklash(mpmath.mpf("1.1"), mpmath.mpf(gamma))
        values = (exact.separation(), exact.separation() + exact.duration, exact.gamma)
        ratio = sympy.lambdify((SEPARATION, CONTACT, GAMMA), motion().ratio(), "mpmath")(*values)
        assert abs(ratio - exact.ratio) < TOLERANCE
