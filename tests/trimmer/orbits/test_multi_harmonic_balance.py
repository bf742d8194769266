"""Harmonic balance with several harmonics converges to the exact orbit."""

from __future__ import annotations

import control
import numpy as np
import pytest

from trimmer import (
    CoulombFriction,
    Element,
    FrictionBacklash,
    InertiaBacklash,
    InputChannels,
    OrbitNotFoundError,
    Relay,
    TrimmerParameters,
    ViscousBacklash,
    ViscousFriction,
    limit_cycles,
    multi_harmonic_balance,
    periodic_orbits,
    pin_model,
)
from trimmer.orbits.steady_response import steady_response
from trimmer.orbits.trigonometric import OddPolynomial

TRIMMER = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
ELEMENTS = [
    FrictionBacklash(1.0),
    ViscousBacklash(1.0, 3e-4),
    InertiaBacklash(1.0),
    CoulombFriction(0.5),
    Relay(2.0),
    FrictionBacklash(1.0) - 0.3 * CoulombFriction(0.5) + 1e-5 * ViscousFriction(2.0),
]


@pytest.mark.parametrize("element", ELEMENTS)
@pytest.mark.parametrize("phase", [-2.0, 0.3, 1.9])
def test_response_to_a_sinusoid_is_the_describing_function_of_each_harmonic(
    element: Element, phase: float
) -> None:
    amplitude, omega = 1.7, 4600.0
    given = OddPolynomial(np.array([amplitude * np.exp(1j * phase), 0, 0, 0]))
    response = steady_response(element, given, omega)
    assert response is not None
    expected = [
        amplitude * complex(element.describing_function(amplitude, omega, n)) * np.exp(1j * n * phase)
        for n in (1, 3, 5, 7)
    ]
    assert response == pytest.approx(np.array(expected), rel=1e-9, abs=1e-12)


def test_no_steady_output_inside_the_gap() -> None:
    given = OddPolynomial(np.array([0.3 + 0j]))
    assert steady_response(FrictionBacklash(1.0), given, 1.0) is None


@pytest.mark.parametrize("element", ELEMENTS[:3])
@pytest.mark.parametrize("which", [0, -1])
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


def test_relay_converges_too() -> None:
    plant = control.tf([1], [1, 2, 1, 0])
    (orbit,) = periodic_orbits(plant, Relay(1.0))
    (cycle,) = limit_cycles(plant, Relay(1.0))
    first, last = multi_harmonic_balance(plant, Relay(1.0), cycle, (1, 15))
    assert abs(last.omega / orbit.omega - 1) < 0.01 * abs(first.omega / orbit.omega - 1)


def test_orders_are_odd_and_rise() -> None:
    (cycle,) = limit_cycles(control.tf([1], [1, 2, 1, 0]), Relay(1.0))
    for orders in ((), (2,), (3, 1), (1, 1), (-1,)):
        with pytest.raises(ValueError, match="odd, positive and rising"):
            multi_harmonic_balance(TRIMMER, Relay(1.0), cycle, orders)


def test_without_a_solution_it_says_so() -> None:
    (cycle,) = limit_cycles(control.tf([1], [1, 2, 1, 0]), Relay(1.0))
    with pytest.raises(OrbitNotFoundError, match="harmonics up to 1"):
        multi_harmonic_balance(control.tf([1], [1, 1, 1]), FrictionBacklash(1.0), cycle, (1,))
