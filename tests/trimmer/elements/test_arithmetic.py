from __future__ import annotations

import numpy as np
import pytest

from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.elements.coulomb_friction import CoulombFriction
from trimmer.elements.relay import Relay
from trimmer.elements.scaled_element import ScaledElement
from trimmer.elements.sum_of_elements import SumOfElements
from trimmer.elements.viscous_friction import ViscousFriction

BACKLASH = ViscousBacklash(2.0, 0.1)
AMPLITUDE = np.array([1.5, 4.0, 90.0])


@pytest.mark.parametrize("harmonic", [1, 2, 3, 5])
def test_describing_functions_add_and_scale(harmonic: int) -> None:
    friction = CoulombFriction(0.7)
    total = BACKLASH + 2.0 * friction - friction * 0.5
    expected = BACKLASH.describing_function(AMPLITUDE, 3.0, harmonic)
    expected = expected + 1.5 * friction.describing_function(AMPLITUDE, 3.0, harmonic)
    assert total.describing_function(AMPLITUDE, 3.0, harmonic) == pytest.approx(expected)


def test_a_sum_is_missing_where_one_term_is() -> None:
    assert np.isnan((Relay(1.0) + FrictionBacklash(2.0)).describing_function(0.9))


def test_a_sum_depends_on_frequency_when_one_term_does() -> None:
    assert not (Relay(1.0) + CoulombFriction(2.0)).depends_on_frequency
    assert (Relay(1.0) + ViscousFriction(2.0)).depends_on_frequency
    assert (-ViscousFriction(2.0)).depends_on_frequency


def test_results_are_values() -> None:
    assert -Relay(1.0) == ScaledElement(Relay(1.0), -1.0)
    assert Relay(1.0) + Relay(2.0) == SumOfElements((Relay(1.0), Relay(2.0)))
    assert hash(2 * Relay(1.0)) == hash(Relay(1.0) * 2)


def test_only_elements_add() -> None:
    with pytest.raises(TypeError, match="unsupported operand"):
        Relay(1.0) + 1.0  # type: ignore[operator]
    with pytest.raises(TypeError, match="unsupported operand"):
        Relay(1.0) - 1.0  # type: ignore[operator]


def test_a_frozen_element_ignores_omega() -> None:
    frozen = BACKLASH.at(3.0)
    assert not frozen.depends_on_frequency
    assert frozen.amplitude_scale == 2.0
    for omega in (None, 50.0):
        value = frozen.describing_function(AMPLITUDE, omega, 3)
        assert np.array_equal(value, BACKLASH.describing_function(AMPLITUDE, 3.0, 3))
        output = frozen.waveform([0.1, 0.2], 4.0, omega)
        assert np.array_equal(output, BACKLASH.waveform([0.1, 0.2], 4.0, 3.0))
