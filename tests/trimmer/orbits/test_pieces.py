"""Trigonometric polynomials, the pieces of an output, and the steady response of each element."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
import scipy.optimize

from trimmer import (
    CoulombFriction,
    DeadZone,
    FrictionBacklash,
    InertiaBacklash,
    Preload,
    Relay,
    Saturation,
    ViscousBacklash,
    ViscousFriction,
)
from trimmer.elements.element import Element
from trimmer.motion.backlash_component import BacklashComponent
from trimmer.motion.corner_component import ABOVE, BELOW, BETWEEN, CornerComponent
from trimmer.motion.threshold_component import NEGATIVE, POSITIVE, SILENT, ThresholdComponent
from trimmer.orbits.pieces import _passes, corner_pieces, mode_on, relay_pieces, switching_phases
from trimmer.orbits.steady_response import flight_of, steady_response
from trimmer.orbits.trigonometric import OddPolynomial, falls_through_zero

PI = math.pi


def polynomial(*coefficients: complex) -> OddPolynomial:
    return OddPolynomial(np.array(coefficients, dtype=complex))


def test_a_polynomial_and_its_derivatives_are_sums_of_sines() -> None:
    given = polynomial(1 + 2j, 0.3 - 0.1j, 0.05j)
    phases = np.array([[-1.0, 0.0], [0.4, 7.0]])

    def term(c: complex, n: int, order: int) -> np.ndarray:
        angle = n * phases + order * PI / 2
        return n**order * (c.real * np.sin(angle) + c.imag * np.cos(angle))

    for order in (0, 1, 2):
        expected = term(1 + 2j, 1, order) + term(0.3 - 0.1j, 3, order) + term(0.05j, 5, order)
        np.testing.assert_allclose(given(phases, order), expected, rtol=1e-13)
    assert given.numbers.tolist() == [1, 3, 5]


def test_the_largest_value_is_exact() -> None:
    assert polynomial(3 - 4j).largest() == pytest.approx(5.0, rel=1e-13)
    # sin x + sin(3x)/3 has its maxima at pi/4 and 3 pi/4.
    assert polynomial(2, 2 / 3).largest() == pytest.approx(2 * 4 / 3 * math.sqrt(0.5), rel=1e-13)


def test_the_first_fall_through_zero() -> None:
    assert falls_through_zero(lambda x: np.cos(3 * x), 0.0, 6.0) == pytest.approx(PI / 6, rel=1e-13)
    assert falls_through_zero(np.sin, 0.0, 6.0) == pytest.approx(PI, rel=1e-13)
    assert falls_through_zero(lambda x: x - 2.0, 0.0, 6.0) is None
    assert falls_through_zero(lambda x: 6.0 - x, 0.0, 6.0) == 6.0


def test_the_pieces_of_a_corner() -> None:
    component = CornerComponent(0.5, 2.0, 0.3)
    pieces = corner_pieces(component, polynomial(np.exp(0.7j)))  # sin(x + 0.7)
    cuts = [0.0, 5 * PI / 6 - 0.7, 7 * PI / 6 - 0.7, PI]
    assert [piece[0] for piece in pieces] + [pieces[-1][1]] == pytest.approx(cuts, rel=1e-12)
    assert all(one[1] == other[0] for one, other in pairwise(pieces))
    phases = np.array([0.3, 2.4, 3.1])
    sines = np.sin(phases + 0.7)
    assert sines[0] > 0.5 > abs(sines[1])
    assert sines[2] < -0.5
    expected = [1.0 + 0.3 * (sines[0] - 0.5), 2 * sines[1], -1.0 + 0.3 * (sines[2] + 0.5)]
    assert [float(piece[2](phases[k])) for k, piece in enumerate(pieces)] == pytest.approx(expected)


@pytest.mark.parametrize("off", [0.4, -0.6])
def test_a_relay_switches_at_its_thresholds(off: float) -> None:
    component, given = ThresholdComponent(3.0, 1.2, off), polynomial(2 * np.exp(0.4j))
    rise, fall = switching_phases(component, given)
    assert math.remainder(rise - (math.asin(0.6) - 0.4), 2 * PI) == pytest.approx(0.0, abs=1e-12)
    assert fall - rise == pytest.approx(PI - math.asin(off / 2) - math.asin(0.6), rel=1e-12)
    (begin, middle, level), (again, end, silent) = relay_pieces(component, given)
    assert (begin, middle, again, end) == (rise, fall, fall, rise + PI)
    assert level(np.zeros(3)).tolist() == [3.0] * 3
    assert silent(np.ones(3)).tolist() == [0.0] * 3


def test_a_relay_without_dead_zone_has_one_piece_and_too_small_an_input_none() -> None:
    component = ThresholdComponent(3.0, 1.2, -1.2)
    ((begin, end, _),) = relay_pieces(component, polynomial(2.0))
    assert end - begin == pytest.approx(PI, rel=1e-12)
    assert relay_pieces(component, polynomial(1.1)) is None
    assert switching_phases(component, polynomial(0.0, 1.1)) is None
    assert mode_on(component, polynomial(1.1), 1.0) == SILENT


def test_the_first_rise_from_the_lowest_value_counts() -> None:
    """2 sin x + 1.2 sin 3x rises to 2.28, falls to 0.8 in the middle, and rises once more."""

    def value(x: float) -> float:
        return 2 * math.sin(x) + 1.2 * math.sin(3 * x)

    rise = scipy.optimize.brentq(lambda x: value(x) - 1.5, 0.0, 0.5)
    component = ThresholdComponent(3.0, 1.5, -0.4)
    fall = scipy.optimize.brentq(lambda x: value(x) + 0.4, 3.0, 3.4)
    for shift in np.arange(12) * PI / 6 + 0.01:
        given = polynomial(2 * np.exp(1j * shift), 1.2 * np.exp(3j * shift))
        found = switching_phases(component, given)
        assert math.remainder(found[0] - rise + shift, 2 * PI) == pytest.approx(0.0, abs=1e-10)
        assert found[1] - found[0] == pytest.approx(fall - rise, rel=1e-10)
        assert mode_on(component, given, PI / 2 - shift) == POSITIVE
        # Where it is told apart from what falls below the same limit, the positive output ends before.
        early = switching_phases(ThresholdComponent(3.0, 1.5, 1.5), given)
        top = scipy.optimize.brentq(lambda x: value(x) - 1.5, 0.6, PI / 2)
        assert early[1] - early[0] == pytest.approx(top - rise, rel=1e-9)


def test_a_relay_without_hysteresis_falls_where_the_input_does_however_slowly() -> None:
    rise, fall = switching_phases(ThresholdComponent(3.0, 1.2e-5, 1.2e-5), polynomial(2e-5))
    assert math.remainder(rise - math.asin(0.6), 2 * PI) == pytest.approx(0.0, abs=1e-12)
    assert fall - rise == pytest.approx(PI - 2 * math.asin(0.6), rel=1e-12)


def test_a_peak_between_two_points_switches_nothing() -> None:
    component = ThresholdComponent(3.0, 1.2, 0.4)
    assert switching_phases(component, polynomial(1.2 * (1 + 1e-9) * np.exp(0.004j))) is None
    assert switching_phases(component, polynomial(1.2 * (1 + 1e-4) * np.exp(0.004j))) is not None
    assert switching_phases(ThresholdComponent(3.0, 1.25, 0.4), polynomial(1.25)) is None


@pytest.mark.parametrize("beside", [-1e-9, 1e-9])
def test_a_zero_at_the_end_of_a_part_may_have_another_sign_there_alone(beside: float) -> None:
    class Given:
        """x - 1, whose zero is moved to just outside of the part of the grid that it lies in."""

        def __call__(self, phase):
            grid = np.linspace(0.0, PI, 721)
            last = int(np.searchsorted(grid, 1.0))
            moved = grid[last] + beside if beside > 0 else grid[last - 1] + beside
            return phase - (moved if np.ndim(phase) == 0 else 1.0)

    grid = np.linspace(0.0, PI, 721)
    last = int(np.searchsorted(grid, 1.0))
    assert _passes(Given(), 0.0) == [grid[last] if beside > 0 else grid[last - 1]]


def test_the_mode_on_a_phase() -> None:
    corner = CornerComponent(1.0, 1.0, 0.0)
    phases = [0.1, PI / 2, 3.0, -PI / 2]
    assert [mode_on(corner, polynomial(2.0), each) for each in phases] == [BETWEEN, ABOVE, BETWEEN, BELOW]
    relay = ThresholdComponent(3.0, 1.2, 0.4)
    # Positive from asin 0.6 = 0.64 to pi - asin 0.2 = 2.94.
    phases = [0.6, 0.7, 2.9, 3.0, PI + 0.6, PI + 0.7, PI + 2.9, PI + 3.0]
    modes = [SILENT, POSITIVE, POSITIVE, SILENT, SILENT, NEGATIVE, NEGATIVE, SILENT]
    assert [mode_on(relay, polynomial(2.0), each) for each in phases] == modes
    assert [mode_on(relay, polynomial(2.0), each - 8 * PI) for each in phases] == modes


AMPLITUDE, OMEGA, TURN = 6e-5, 691.0, 0.8
ELEMENTS = {
    "relay": Relay(2.0),
    "relay with hysteresis and dead zone": Relay(2.0, 1e-5, 2e-5),
    "saturation": Saturation(2e-5, 3.0),
    "dead zone": DeadZone(2e-5, 3.0),
    "friction-controlled": FrictionBacklash(4e-5),
    "viscous-controlled": ViscousBacklash(4e-5, 1e-3),
    "inertia-controlled": InertiaBacklash(4e-5),
    "Coulomb friction": CoulombFriction(0.7),
    "viscous friction": ViscousFriction(0.02),
    "preload": Preload(2.0, 0.5),
    "sum": 2.0 * FrictionBacklash(4e-5) + (-3.0) * ViscousFriction(0.02),
}


@pytest.mark.parametrize("name", ELEMENTS)
def test_the_response_to_a_sine_is_that_of_describing_functions(name: str) -> None:
    element: Element = ELEMENTS[name]
    given = polynomial(AMPLITUDE * np.exp(1j * TURN), 0.0, 0.0)
    response = steady_response(element, given, OMEGA)
    expected = [
        AMPLITUDE * complex(element.describing_function(AMPLITUDE, OMEGA, harmonic=n)) * np.exp(1j * n * TURN)
        for n in (1, 3, 5)
    ]
    np.testing.assert_allclose(response, expected, rtol=1e-9, atol=1e-11 * abs(expected[0]))


def test_where_there_is_no_steady_output_there_is_no_response() -> None:
    assert steady_response(Relay(1.0), polynomial(0.0), 1.0) is None
    assert steady_response(FrictionBacklash(1.0), polynomial(0.3), 1.0) is None
    assert steady_response(Relay(1.0, 0.3, 0.9), polynomial(1.1), 1.0) is None
    assert flight_of(BacklashComponent(0.5, 0.0), polynomial(0.0), 3.0) is None


def test_viscous_friction_differentiates_each_harmonic() -> None:
    response = steady_response(ViscousFriction(0.5), polynomial(2.0, 1j), 10.0)
    np.testing.assert_allclose(response, [10j, -15.0], rtol=1e-14)


def test_a_load_that_slows_down_leaves_and_flies_as_its_equation_says() -> None:
    gap, time_constant, shift = 0.5, 0.02, 0.3
    gamma = OMEGA / 50 * time_constant
    component, given = BacklashComponent(gap, time_constant), polynomial(np.exp(-1j * shift))
    flight = flight_of(component, given, OMEGA / 50)
    leave = math.atan(1 / gamma)  # cos x = gamma sin x
    assert math.remainder(flight.leave - leave - shift, 2 * PI) == pytest.approx(0.0, abs=1e-12)
    since = np.array([0.0, 0.3, 0.9])
    expected = math.sin(leave) - gap / 2 + gamma * math.cos(leave) * (1 - np.exp(-since / gamma))
    np.testing.assert_allclose(flight.position(flight.leave + since), expected, rtol=1e-12)
    assert float(given(flight.meet)) + gap / 2 == pytest.approx(float(flight.position(np.array(flight.meet))))
    assert flight.leave < flight.meet < flight.leave + PI


def test_a_load_without_friction_keeps_its_velocity_and_one_without_mass_its_place() -> None:
    since = np.array([0.2, 0.5])
    free = flight_of(BacklashComponent(0.5, math.inf), polynomial(1.0), 3.0)
    assert math.remainder(free.leave, 2 * PI) == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_allclose(free.position(free.leave + since), since - 0.25, rtol=1e-12)
    held = flight_of(BacklashComponent(0.5, 0.0), polynomial(1.0), 3.0)
    assert math.remainder(held.leave - PI / 2, 2 * PI) == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_allclose(held.position(held.leave + since), [0.75, 0.75], rtol=1e-14)
    assert held.meet - held.leave == pytest.approx(math.acos(0.5), rel=1e-12)
    assert flight_of(BacklashComponent(0.5, 0.0), polynomial(0.2), 3.0) is None
