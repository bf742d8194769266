import control
import numpy as np
import pytest
from matplotlib.figure import Figure

from trimmer import FrictionBacklash, Relay, Saturation, ViscousBacklash, ViscousFriction, WrongTypeError
from trimmer.elements import ControlElement, CoulombFriction, ElementAtFrequency, ScaledElement, SumOfElements

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


def test_one_infinite_amplitude_is_enough_for_no_waveform() -> None:
    with pytest.raises(ValueError, match="amplitude must be finite"):
        Relay(1.0).waveform(0.3, [1.0, np.inf])


def test_nonlinearities_of_python_control_are_frozen_as_elements() -> None:
    peer = control.saturation_nonlinearity(0.5)
    frozen = ElementAtFrequency(peer, 3.0)  # type: ignore[arg-type]
    assert isinstance(frozen.element, ControlElement)
    assert frozen.describing_function(2.0) == Saturation(0.5).describing_function(2.0)


def test_pictures_are_drawn_at_the_frequency_and_on_the_axes_that_are_given() -> None:
    for draw in (BACKLASH.plot, BACKLASH.plot_locus):
        first, second = (Figure().add_subplot() for _ in range(2))
        assert draw(first, 3.0) is first
        assert draw(second, omega=30.0) is second
        slow, fast = (axes.lines[0].get_ydata() for axes in (first, second))
        assert len(slow) > 10
        assert not np.array_equal(slow, fast)
        with pytest.raises(WrongTypeError, match="ax must be"):
            draw(3.0, 3.0)  # type: ignore[arg-type]
