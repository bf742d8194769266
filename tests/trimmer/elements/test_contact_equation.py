"""The equation for the end of a flight, its derivatives in 30 digits, and where it is solved in which way."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest

from trimmer.elements.backlashes.backlash_motion import separation
from trimmer.elements.backlashes.contact_equation import (
    _contact_residual,
    _flight_residual,
    _halley,
    _margin,
    largest_ratio,
    steady_motion,
)
from trimmer.elements.backlashes.short_flight import relative_velocity, short_residual

GAMMAS = (0.3, 1.0, 4.0)


def ratio(t: mpmath.mpf, gamma: float, order: int = 0) -> mpmath.mpf:
    """g/A of a flight of t, c (γ (1 - exp(-t/γ)) - sin t) + s (1 - cos t), or a derivative of it."""
    gamma = mpmath.mpf(gamma)
    c, s = gamma / mpmath.sqrt(1 + gamma**2), 1 / mpmath.sqrt(1 + gamma**2)
    decay = mpmath.exp(-t / gamma)
    return (
        c * (gamma * (1 - decay) - mpmath.sin(t)) + s * (1 - mpmath.cos(t)),
        c * (decay - mpmath.cos(t)) + s * mpmath.sin(t),
        c * mpmath.sin(t) + s * (mpmath.cos(t) - decay),
    )[order]


def arrays(*values: float) -> list[np.ndarray]:
    return [np.array([value]) for value in values]


@pytest.mark.parametrize("gamma", GAMMAS)
@pytest.mark.parametrize("t", [0.2, 1.1, 2.9])
def test_residuals_and_their_derivatives(gamma: float, t: float) -> None:
    cosine, sine = (float(each[0]) for each in separation(np.array([gamma])))
    with mpmath.workdps(30):
        exact = [float(ratio(mpmath.mpf(t), gamma, order)) for order in range(3)]
        beyond = ratio(mpmath.pi, gamma) - ratio(mpmath.pi - mpmath.mpf(t), gamma)
        at_contact = [float(beyond), *(float(ratio(mpmath.pi - mpmath.mpf(t), gamma, k)) for k in (1, 2))]
        assert float(largest_ratio(np.array(gamma))) == pytest.approx(
            float(ratio(mpmath.pi, gamma)), rel=1e-14
        )
    found = _flight_residual(*arrays(t, 0.7, gamma, cosine, sine))
    assert [each[0] for each in found] == pytest.approx([exact[0] - 0.7, exact[1], exact[2]], abs=1e-14)
    found = _contact_residual(*arrays(t, 0.4, gamma, cosine, sine))
    assert [each[0] for each in found] == pytest.approx(
        [at_contact[0] - 0.4, at_contact[1], -at_contact[2]], abs=1e-14
    )


@pytest.mark.parametrize("gamma", [1e-3, 0.3, 4.0])
def test_short_flights_keep_their_digits(gamma: float) -> None:
    cosine = separation(np.array([gamma]))[0]
    for share in (1e-6, 0.01, 0.24):
        t = share * min(1.0, gamma)
        with mpmath.workdps(40):
            value, slope, curvature = (float(ratio(mpmath.mpf(t), gamma, order)) for order in range(3))
        found = short_residual(*arrays(t, 0.0, gamma), cosine)
        assert [found[0][0], found[1][0]] == pytest.approx([value, slope], rel=1e-13, abs=0.0)
        assert found[2][0] == pytest.approx(curvature, rel=1e-6)
        assert relative_velocity(*arrays(t, gamma), cosine)[0] == pytest.approx(slope, rel=1e-13, abs=0.0)
        assert short_residual(*arrays(t, 0.5, gamma), cosine)[0][0] == pytest.approx(value - 0.5)


def test_the_margin_is_taken_from_what_keeps_its_digits() -> None:
    gamma = np.array([0.01, 0.5, 0.999, 1.0, 3.0])
    with mpmath.workdps(30):
        largest = np.array([float(ratio(mpmath.pi, each)) for each in gamma])
    found = _margin(np.full(5, 0.3), np.full(5, 0.1), gamma)
    assert found[:3] == pytest.approx(0.3 + largest[:3] - 2.0, rel=1e-13)
    assert found[3:] == pytest.approx(largest[3:] - 0.1, rel=1e-13)


def test_three_steps_find_a_root_and_the_slope_there() -> None:
    def square(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        return x**2 - 0.5, 2.0 * x, np.full_like(x, 2.0)

    root, slope = _halley(square, np.array([0.7, 0.75]))
    assert root == pytest.approx([math.sqrt(0.5)] * 2, rel=1e-15)
    assert slope == pytest.approx([math.sqrt(2.0)] * 2, rel=1e-9)
    # Steps end at 0 and at a quarter of the period.
    ends, _ = _halley(lambda x: (x + 9.0, np.ones_like(x), np.zeros_like(x)), np.array([0.3]))
    assert ends.tolist() == [0.0]
    ends, _ = _halley(lambda x: (x - 9.0, np.ones_like(x), np.zeros_like(x)), np.array([0.3]))
    assert ends.tolist() == [0.5 * math.pi]


@pytest.mark.parametrize("gamma", [1.0, 4.0])
def test_at_the_edge_of_the_domain_there_is_no_motion(gamma: float) -> None:
    edge = float(largest_ratio(np.array(gamma)))
    motion = steady_motion(edge, np.array([1.0, 1.0 + 1e-9]), np.full(2, gamma))
    assert np.isnan(motion.flight).tolist() == np.isnan(motion.contact).tolist() == [True, False]
    assert motion.flight[1] == pytest.approx(math.pi, abs=1e-7)


@pytest.mark.parametrize("gamma", [1e-3, 0.3, 1.0, 40.0])
def test_flights_of_all_lengths_end_at_the_other_wall(gamma: float) -> None:
    lengths = np.array([1e-4, 0.1, 0.24, 0.26, 1.0, 1.57, 1.58, 3.0, 3.14]) * min(1.0, gamma) ** (1 / 9)
    with mpmath.workdps(30):
        ratios = np.array([float(ratio(mpmath.mpf(each), gamma)) for each in lengths])
        slopes = np.array([float(ratio(mpmath.mpf(each), gamma, 1)) for each in lengths])
    motion = steady_motion(4e-5, 4e-5 / ratios, np.full(9, gamma))
    assert motion.flight == pytest.approx(lengths, rel=1e-10)
    assert motion.contact == pytest.approx(math.pi - lengths, rel=1e-9)
    assert motion.impact == pytest.approx(slopes, rel=1e-8)
    assert motion.impact_phase == pytest.approx(math.atan(1.0 / gamma) + lengths, rel=1e-10)
