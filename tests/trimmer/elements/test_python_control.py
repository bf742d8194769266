"""The elements inside python-control, and beside its own."""

from __future__ import annotations

import control
import matplotlib
import numpy as np
import pytest

from trimmer import FrictionBacklash, Relay, ViscousBacklash

# 6/(s + 1)^3 is stable with the gain 1, and its Nyquist curve meets -1/N of backlash twice.
PLANT = control.tf([6], [1, 3, 3, 1])


def test_the_relay_is_that_of_python_control_without_hysteresis() -> None:
    amplitude = np.geomspace(1e-3, 1e3, 20)
    peer = control.describing_function(control.relay_hysteresis_nonlinearity(2.0, 0.0), amplitude)
    assert Relay(2.0).describing_function(amplitude) == pytest.approx(peer, rel=1e-14)


@pytest.mark.parametrize("element", [FrictionBacklash(1.0), ViscousBacklash(1.0, 0.2).at(0.8)], ids=repr)
def test_python_control_finds_intersections_with_our_elements(element: FrictionBacklash) -> None:
    amplitude, omega = np.linspace(0.6, 20, 150), np.geomspace(0.1, 10, 200)
    response = control.describing_function_response(PLANT, element, amplitude, omega)
    assert len(response) == 2
    for found_amplitude, found_omega in response:
        loop = element.describing_function(found_amplitude) * PLANT(1j * found_omega)
        assert loop == pytest.approx(-1.0, abs=1e-3)


def test_python_control_plots_our_elements() -> None:
    matplotlib.use("agg")
    amplitude, omega = np.linspace(0.6, 20, 40), np.geomspace(0.1, 10, 60)
    plot = control.describing_function_plot(PLANT, FrictionBacklash(1.0), amplitude, omega)
    assert len(plot.lines[1][0].get_xdata()) == 40
    matplotlib.pyplot.close(plot.figure)


def test_a_missing_omega_is_an_error_in_python_control_too() -> None:
    with pytest.raises(ValueError, match=r"depends on frequency: .* freeze it with \.at\(omega\)"):
        control.describing_function(ViscousBacklash(1.0, 0.2), [1.0])
