"""What is proven of contours and slopes of backlash, seen in numbers from the oracle's motion."""

from functools import cache

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from derivations.elements.backlash import CONTACT, GAMMA, SEPARATION
from derivations.elements.backlash_closed_forms import (
    friction_fundamental,
    general_fundamental,
    inertia_fundamental,
)
from derivations.elements.backlash_harmonics import CONTACT_ANGLE, DECAY, FLIGHT, MEANINGS
from derivations.elements.backlash_slopes import closed_jacobian, closed_slope_by_log_gamma
from derivations.elements.harmonics import evaluated
from tests.quick import quick
from tests.trimmer.elements.oracle import ExactBacklash

general = sympy.lambdify((SEPARATION, CONTACT, DECAY), general_fundamental().subs(MEANINGS))
angles = st.floats(0.1, 0.95).map(lambda share: share * np.pi)
gammas = st.floats(-1.5, 1.5).map(lambda exponent: 10.0**exponent)


def value(gamma, flight):
    """N_1 of the general backlash at γ and an angle of flight, rad."""
    separation = np.arctan(1 / gamma)
    return complex(general(separation, separation + flight, np.exp(-flight / gamma)))


@cache
def curve():
    """Friction's contour from 1 to its end, the axis, and inertia's contour back to 1."""
    angle = np.linspace(0, np.pi, 4001)
    friction = sympy.lambdify(CONTACT_ANGLE, friction_fundamental())(np.pi - angle)
    inertia = sympy.lambdify(CONTACT, inertia_fundamental())(angle)
    return np.concatenate([friction, inertia[::-1]])


def turns(point):
    """Number of times the closed curve runs round a point, in the direction of the clock."""
    steps = np.append(curve(), curve()[0]) - point
    return -np.angle(steps[1:] / steps[:-1]).sum() / (2 * np.pi)


@given(gammas, angles)
def test_contours_lie_inside_of_the_curve(gamma, flight):
    assert abs(turns(value(gamma, flight))) == pytest.approx(1)


@pytest.mark.parametrize("gamma", ["0.3", "1.25", "8"])
@pytest.mark.parametrize("ratio", quick(["0.1", "1.2", "1.9"], 1))
def test_slope_by_log_gamma_is_that_of_a_difference_quotient(gamma, ratio):
    with mpmath.workdps(60):
        gamma, ratio, step = mpmath.mpf(gamma), mpmath.mpf(ratio), mpmath.mpf(10) ** -12
        above, below = (
            ExactBacklash(ratio, gamma * mpmath.exp(sign * step)).describing_function(1) for sign in (1, -1)
        )
        motion = ExactBacklash(ratio, gamma)
        point = (gamma, motion.separation(), motion.duration)
        slope, jacobian = (
            sympy.lambdify((GAMMA, SEPARATION, FLIGHT), evaluated(form), "mpmath")(*point)
            for form in (closed_slope_by_log_gamma(), closed_jacobian())
        )
        assert abs((above - below) / (2 * step) - slope) < mpmath.mpf(10) ** -20
        by_ratio = 2 / mpmath.pi * mpmath.expj(-motion.separation() - motion.duration)
        assert abs(mpmath.im(mpmath.conj(by_ratio) * slope) - jacobian) < mpmath.mpf(10) ** -35
        assert mpmath.re(jacobian) > 0
