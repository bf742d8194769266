import control
import numpy as np
import pytest

from trimmer import TrimmerParameters, linear_model, pin_model, resonance_peaks, response_at
from trimmer.linear import (
    UnsupportedSystemError,
    ZeroPoleGain,
    antiresonances,
    asymptotic_roll_off,
    bandwidth,
    encirclements,
    filtering_ratio,
    gain_crossings,
    local_slope,
    real_axis_crossings,
    steady_state,
)

THESIS = TrimmerParameters.thesis()
UNSUPPORTED = {
    "discrete-time": (control.tf([1], [1, 0.5], 0.1), r"discrete-time system \(dt = 0.1\)"),
    "several inputs": (linear_model(THESIS), "a system of 2 inputs and 1 outputs"),
    "measured": (control.frd([1, 2], [1, 2]), "FrequencyResponseData is not accepted"),
    "a number": (3.0, "float is not accepted"),
}
FUNCTIONS = {
    "response_at": lambda system: response_at(system, 1.0),
    "gain_crossings": gain_crossings,
    "real_axis_crossings": real_axis_crossings,
    "resonance_peaks": resonance_peaks,
    "antiresonances": antiresonances,
    "bandwidth": bandwidth,
    "asymptotic_roll_off": asymptotic_roll_off,
    "local_slope": lambda system: local_slope(system, 1.0),
    "filtering_ratio": lambda system: filtering_ratio(system, 1.0, 2),
    "encirclements": encirclements,
    "steady_state": lambda system: steady_state(system, 1.0),
    "ZeroPoleGain": ZeroPoleGain.of,
}


@pytest.mark.parametrize("function", FUNCTIONS.values(), ids=FUNCTIONS)
@pytest.mark.parametrize(("system", "message"), UNSUPPORTED.values(), ids=UNSUPPORTED)
def test_unsupported_systems_are_refused_by_every_function(function, system, message) -> None:
    with pytest.raises(UnsupportedSystemError, match=message):
        function(system)


def test_a_system_of_unspecified_time_counts_as_continuous() -> None:
    assert response_at(control.tf([1], [1, 1], None), 1.0) == pytest.approx(1 / (1 + 1j))


def test_the_response_has_the_shape_of_the_frequencies() -> None:
    system = pin_model(THESIS)
    omega = np.geomspace(10, 1e5, 6).reshape(2, 3)
    response = response_at(system, omega)
    assert response.shape == (2, 3)
    magnitude, phase, _ = control.frequency_response(system, omega.ravel())
    np.testing.assert_allclose(response.ravel(), magnitude * np.exp(1j * phase), rtol=1e-12)
    assert response_at(system, 10.0).shape == ()
