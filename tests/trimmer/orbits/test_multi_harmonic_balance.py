"""Harmonic balance with several harmonics converges to the exact orbit."""

import control
import numpy as np
import pytest

from tests.quick import quick
from trimmer import (
    OrbitNotFoundError,
    ViscousBacklash,
    ViscousFriction,
    WrongTypeError,
    limit_cycles,
    multi_harmonic_balance,
    periodic_orbits,
)
from trimmer.elements import CoulombFriction, Element, FrictionBacklash, InertiaBacklash, Relay
from trimmer.thesis import InputChannels, TrimmerParameters, pin_model

PLANT = control.tf([1.0], [1.0, 3.0, 2.0, 0.0])
TRIMMER = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
ELEMENTS = [FrictionBacklash(1.0), ViscousBacklash(1.0, 3e-4), InertiaBacklash(1.0)]


@pytest.mark.parametrize("element", ELEMENTS)
@pytest.mark.parametrize("which", quick([0, -1], 1))
def test_converges_to_the_exact_orbit(element: Element, which: int) -> None:
    orbit = periodic_orbits(TRIMMER, element)[which]
    assert orbit.prediction is not None
    solutions = multi_harmonic_balance(TRIMMER, element, orbit.prediction, (1, 3, 7, 15))
    errors = [abs(solution.amplitude / orbit.amplitude - 1) for solution in solutions]
    assert errors[0] == pytest.approx(abs(orbit.amplitude_error), rel=1e-6)
    assert errors[1] < errors[0]
    assert errors[-1] < 0.02 * errors[0]
    assert abs(solutions[-1].frequency / orbit.frequency - 1) < 0.02 * abs(orbit.frequency_error)
    harmonics = abs(orbit.harmonics[:5:2]) / abs(orbit.harmonics[0])
    balanced = abs(solutions[-1].harmonics[:3] / solutions[-1].harmonics[0])
    assert balanced == pytest.approx(harmonics, rel=0.05)


def test_harmonics_of_a_relay_are_those_of_a_square_wave_through_the_system() -> None:
    (cycle,) = limit_cycles(PLANT, Relay(1.5))
    solutions = multi_harmonic_balance(PLANT, Relay(1.5), cycle, (1, 3, 7))
    assert [each.order for each in solutions] == [1, 3, 7]
    assert (solutions[0].amplitude, solutions[0].omega) == pytest.approx((cycle.amplitude, cycle.omega))
    found, numbers = solutions[-1], np.array([1, 3, 5, 7])
    through = -np.array([complex(PLANT(1j * n * found.omega)) for n in numbers]) * 6 / np.pi / numbers
    turned = through * np.exp(1j * numbers * (np.angle(found.harmonics[0]) - np.angle(through[0])))
    np.testing.assert_allclose(found.harmonics, turned, rtol=1e-7)
    grid = np.exp(1j * np.outer(np.linspace(0, 2 * np.pi, 100_001), numbers))
    assert found.amplitude == pytest.approx((grid @ found.harmonics).imag.max(), rel=1e-8)
    assert found.frequency == found.omega / (2 * np.pi)
    assert found.residual < 1e-9


@pytest.mark.parametrize("parts", [(0.2,), (0.05, 0.15)])
def test_viscous_friction_of_the_element_is_that_of_the_system(parts: tuple[float, ...]) -> None:
    """x'' + 0.3 x' + x = sign x', with some of the damping in the element, in one part or two."""
    element = sum((share * ViscousFriction(1.0) for share in parts), -0.5 * CoulombFriction(2.0))
    solved = []
    for damping, law in ((0.3, -CoulombFriction(1.0)), (0.1, element)):
        oscillator = control.tf([1], [1, damping, 1])
        (cycle,) = limit_cycles(oscillator, law)
        solved.append(multi_harmonic_balance(oscillator, law, cycle, (1, 3, 7))[-1])
    first, second = solved
    assert (second.omega, second.amplitude) == pytest.approx((first.omega, first.amplitude), rel=1e-9)
    np.testing.assert_allclose(second.harmonics, first.harmonics, rtol=1e-7)
    assert first.omega < 0.995


def test_at_a_pole_of_the_system_nothing_is_called_a_solution() -> None:
    element = 0.3 * ViscousFriction(1.0) - CoulombFriction(1.0)
    (cycle,) = limit_cycles(control.tf([1], [1, 0, 1]), element)
    with pytest.raises(OrbitNotFoundError, match="harmonics up to 1"), np.errstate(all="ignore"):
        multi_harmonic_balance(control.tf([1], [1, 0, 1]), element, cycle)


def test_orders_are_odd_and_rise() -> None:
    (cycle,) = limit_cycles(control.tf([1], [1, 2, 1, 0]), Relay(1.0))
    for orders in ((), (0,), (2,), (3, 1), (1, 1), (-1, 1)):
        with pytest.raises(ValueError, match="odd, positive and rising"):
            multi_harmonic_balance(TRIMMER, Relay(1.0), cycle, orders)
    with pytest.raises(ValueError, match=r"orders\[1\]"):
        multi_harmonic_balance(TRIMMER, Relay(1.0), cycle, (1, 3.5))
    with pytest.raises(WrongTypeError, match="cycle must be"):
        multi_harmonic_balance(TRIMMER, Relay(1.0), (1.0, 2.0))


def test_without_a_solution_it_says_so() -> None:
    (cycle,) = limit_cycles(control.tf([1], [1, 2, 1, 0]), Relay(1.0))
    with pytest.raises(OrbitNotFoundError, match="harmonics up to 1"):
        multi_harmonic_balance(control.tf([1], [1, 1, 1]), FrictionBacklash(1.0), cycle, (1,))
