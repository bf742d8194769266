"""The gain for the mean of an oscillating input, beside outputs averaged over many steps of a period."""

from __future__ import annotations

import control
import numpy as np
import pytest

from trimmer import CoulombFriction, FrictionBacklash, Relay, ViscousBacklash, ViscousFriction
from trimmer.elements import ControlElement

STEPS = 200_001
BIAS = 1e-3
PHASES = np.linspace(0.0, 2.0 * np.pi, STEPS)[:-1]


def slope(lower: np.ndarray, upper: np.ndarray) -> float:
    """Return the slope of the mean output between the biases -BIAS and BIAS."""
    return float(upper.mean() - lower.mean()) / (2.0 * BIAS)


def test_a_relay_passes_the_mean_with_half_of_its_describing_function() -> None:
    relay, amplitude = Relay(3.0), 1.7
    lower, upper = (3.0 * np.sign(bias + amplitude * np.sin(PHASES)) for bias in (-BIAS, BIAS))
    assert relay.mean_gain(amplitude) == pytest.approx(slope(lower, upper), rel=0.02)
    assert relay.mean_gain(amplitude) == pytest.approx(
        0.5 * relay.describing_function(amplitude).real, rel=1e-15
    )


def test_a_play_passes_the_mean_as_it_is() -> None:
    def load(bias: float) -> np.ndarray:
        """Trace a play of the gap 1 over two periods; the second one is steady."""
        place, places = 0.0, []
        for pin in np.tile(bias + 1.3 * np.sin(PHASES[::20]), 2):
            place = min(max(place, pin - 0.5), pin + 0.5)
            places.append(place)
        return np.array(places[len(places) // 2 :])

    assert slope(load(-BIAS), load(BIAS)) == pytest.approx(1.0, rel=1e-6)
    assert FrictionBacklash(1.0).mean_gain(1.3) == 1.0
    assert ViscousBacklash(1.0, 0.2).mean_gain([1.3, 5.0]).tolist() == [1.0, 1.0]


def test_of_python_control_only_what_has_no_memory_tells_it() -> None:
    clipped = ControlElement(control.saturation_nonlinearity(0.5))
    lower, upper = (np.clip(bias + 1.7 * np.sin(PHASES), -0.5, 0.5) for bias in (-BIAS, BIAS))
    assert clipped.mean_gain(1.7) == pytest.approx(slope(lower, upper), rel=1e-3)
    assert np.isnan(ControlElement(control.friction_backlash_nonlinearity(1.0)).mean_gain(1.7))


def test_friction_does_not_pass_the_mean() -> None:
    assert CoulombFriction(2.0).mean_gain(1.0) == 0.0
    assert ViscousFriction(2.0).mean_gain([1.0, 2.0]).tolist() == [0.0, 0.0]


def test_sums_factors_and_frozen_elements_pass_it_on() -> None:
    play, relay = ViscousBacklash(1.0, 0.2), Relay(1.0)
    amplitudes = np.array([0.9, 4.0])
    together = (2.0 * play - 0.5 * relay + CoulombFriction(1.0)).mean_gain(amplitudes)
    np.testing.assert_allclose(together, 2.0 - 0.5 * relay.mean_gain(amplitudes), rtol=1e-15)
    assert play.at(3.0).mean_gain(0.9) == 1.0
