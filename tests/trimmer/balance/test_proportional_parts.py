"""Relays and friction, part by part: c = N/u, ends of the range for any direction, and what was examined."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest

from tests.trimmer.balance.test_proportional import FACTOR, Bent, Plant
from trimmer.arrays import Reals
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.proportional import (
    _beside_root_on_axis,
    _coefficient,
    _quiet_end,
    _real_and_negative,
    proportional_range,
    solve_proportional,
)
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.expansion import Expansion
from trimmer.elements.relay import Relay
from trimmer.errors import UnsupportedElementError

NOTHING = np.empty(0, complex)


@dataclass(frozen=True)
class FlatAtFirst(Bent):
    """N = 0.5 for u up to 0.5, and 2 u² beyond."""

    def value(self, u: Reals, x: Reals) -> np.ndarray:
        return np.where(u < 0.5, 0.5, 2.0 * u**2).astype(complex)

    def expansion(self, u: Reals, x: Reals) -> Expansion:
        return Expansion(self.value(u, x), np.where(u < 0.5, 0.0, 4.0 * u), np.zeros_like(u))


def test_the_coefficient_is_n_over_u() -> None:
    assert _coefficient(ElementCurve(Relay(3.0))) == pytest.approx(FACTOR, rel=1e-14)
    assert _coefficient(ElementCurve(CoulombFriction(3.0))) == pytest.approx(1j * FACTOR, rel=1e-14)
    with pytest.raises(UnsupportedElementError, match="unbounded"):
        _coefficient(FlatAtFirst())


def test_no_gain_is_too_small_for_the_search() -> None:
    searched = solve_proportional(Plant(1.0, (-1.0,)).inverse(), ElementCurve(Relay(1.0)), None)
    assert searched.smallest_gain == 0.0


def test_the_range_ends_where_the_direction_says() -> None:
    """Roots of magnitude 1, of which the phase turns by 0.381 t but for t**2/(1 - t) at most.

    Towards 0 the direction of f is at 0.871 + (0.4 + 1) + pi/2 - 0.9, 0.2 short of pi: t = 1/4 is the first
    of 1/2, 1/4, ... at which 0.178 is less. Towards infinity it is at 1.5418, and 0.69 will do.
    """
    poles, zeros = np.array([0.0, -np.exp(0.4j)]), np.array([-np.exp(-1.0j)])
    given = InverseResponse(5.0 * np.exp(0.871j), poles, zeros, 30.0)
    assert proportional_range(given, 0.3 * np.exp(0.9j)) == (30.0 / 4.0, 30.0 * 2.0, True)


def test_without_roots_beside_the_origin_a_range_begins_at_the_reference() -> None:
    assert proportional_range(Plant(1.0, (0.0, 0.0)).inverse(), FACTOR) == (1e-6, 1e6, False)
    assert proportional_range(Plant(-1.0, (0.0, 0.0)).inverse(), FACTOR) == (0.5, 2.0, True)


@pytest.mark.parametrize(
    ("scales", "exponents", "end"),
    [
        # The phase of (1 + z): t against t**3 / (3 - 3 t**2).
        ([1.0], [1.0], 0.5),
        ([-1.0], [1.0], 0.5),
        # Of 0.28 ± 0.96j: 0.56 t.
        ([0.28 + 0.96j, 0.28 - 0.96j], [1.0, 1.0], 0.5),
        # Less 0.5 of a zero: 0.06 t against 0.0118 at 1/4, and 0.117 at 1/2.
        ([0.28 + 0.96j, 0.28 - 0.96j, 0.5], [1.0, 1.0, -1.0], 0.25),
        # The phase is not to come round: 18/4 is less than 2 pi, 30/4 is not.
        ([1.0] * 18, [1.0] * 18, 0.25),
        ([1.0] * 30, [1.0] * 30, 0.125),
        # Nothing is left of the trend.
        ([0.5, 0.5], [1.0, -1.0], None),
        ([1j, -1j], [1.0, 1.0], None),
    ],
)
def test_along_the_axis_the_phase_must_leave_it_and_not_return(
    scales: list[complex], exponents: list[float], end: float | None
) -> None:
    assert _quiet_end(np.array(scales, complex), np.array(exponents), -2.0 + 0j, True) == end


def test_beside_the_axis_the_phase_must_not_reach_it() -> None:
    # Of (1 + jt)**4: 1.105 at 1/4, 2.22 at 1/2.
    for angle, end in ((0.5 * math.pi, 0.25), (2.3, 0.5), (1.0, 0.125), (1e-11, None)):
        for sign in (1.0, -1.0):
            direction = -complex(math.cos(angle), sign * math.sin(angle))
            assert _quiet_end(np.ones(4, complex), np.ones(4), direction, True) == end


def test_intervals_without_a_solution_are_examined_once() -> None:
    # f = (1 + j omega)/c stays to the right of the axis.
    inverse = Plant(1.0, (-1.0,)).inverse()
    result = _real_and_negative(inverse, FACTOR, (-2.0, 2.0))
    assert (result.examined, result.x.size, len(result.undecided)) == (64, 0, 0)


def test_two_solutions_in_one_interval_are_told_apart() -> None:
    """1/G = (s + 1)**24 has the phase 24 atan(omega); the interval from -0.3 to 0.3 holds 5 pi and 7 pi."""
    turn = np.exp(0.3j)
    inverse = InverseResponse(turn, np.full(24, -1.0 + 0j), NOTHING, 1.0)
    result = _real_and_negative(inverse, 2.0 * turn, (-18.9, 19.5))
    expected = np.tan(np.pi * (2.0 * np.arange(6) + 1.0) / 24.0)
    assert np.exp(result.x) == pytest.approx(expected, rel=1e-12)
    assert result.u == pytest.approx((1.0 + expected**2) ** 12 / 2.0, rel=1e-10)


def test_a_solution_between_two_intervals_is_found_once() -> None:
    # 1/G = s (s + 1)² is -2 at 1 rad/s, to the last digit; one of 64 intervals ends there.
    result = _real_and_negative(Plant(1.0, (0.0, -1.0, -1.0)).inverse(), 4.0 + 0j, (-2.0, 2.0))
    assert (result.u.tolist(), result.x.tolist()) == ([0.5], [0.0])


def test_a_phase_that_stays_at_pi_is_undecided() -> None:
    result = _real_and_negative(Plant(1.0, (0.0, 0.0)).inverse(), FACTOR, (-1.0, 1.0))
    assert result.x.size == 0
    assert (result.undecided.x_lower.min(), result.undecided.x_upper.max()) == (-1.0, 1.0)


def test_what_is_beside_a_root_on_the_axis_is_within_nanometres_of_it() -> None:
    poles, zeros = np.array([2j, -2j, -3.0]), np.array([5j, -5j, 0.0])
    given = InverseResponse(1.0, poles, zeros, 7.0)
    x = np.log([14.0, 14.0, 14.0, 35.0, 21.0]) + np.array([0.0, 4.9e-9, -5.1e-9, -4.9e-9, 0.0])
    assert _beside_root_on_axis(given, x).tolist() == [True, True, False, True, False]
