from __future__ import annotations

import math

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from trimmer.displacement import Body, Displacement
from trimmer.generated import linear_trimmer
from trimmer.linear.frequency_response import UnsupportedSystemError
from trimmer.linear.model import InputChannels, linear_model, pin_model, transfer_function
from trimmer.linear.time_response import steady_state, time_response
from trimmer.parameters import TrimmerParameters

THESIS = TrimmerParameters.thesis()
OMEGA, AMPLITUDE = 200 * math.pi, 0.0015  # the pin of figure 5.1 of the thesis

FIRST_ORDER = control.ss(-1.0, 1.0, 1.0, 0.0)


def test_a_ramp_is_exact_on_the_coarsest_grid() -> None:
    times = np.array([0.0, 3.0, 6.0])
    response = time_response(FIRST_ORDER, times, times)
    np.testing.assert_allclose(response.output, times - 1 + np.exp(-times), atol=1e-14)


def test_a_released_trimmer_moves_as_newton_says() -> None:
    M, C, K = (
        np.array(getattr(linear_trimmer, name)(*THESIS.values()))
        for name in ("mass_matrix", "damping_matrix", "stiffness_matrix")
    )
    times = np.linspace(0, 0.01, 201)
    start = np.array([1e-3, -2e-3, 0.5e-3, 1e-3, 0.1, 0.2, -0.3, 0.0])
    response = time_response(linear_model(THESIS), np.zeros((2, times.size)), times, start)

    def motion(_: float, state: np.ndarray) -> np.ndarray:
        q, velocity = state[:4], state[4:]
        return np.concatenate([velocity, -np.linalg.solve(M, C @ velocity + K @ q)])

    expected = solve_ivp(motion, (0, times[-1]), start, t_eval=times, rtol=1e-10, atol=1e-12).y
    np.testing.assert_allclose(response.states[:4], expected[:4], atol=1e-9)
    np.testing.assert_allclose(response.output, expected[1] - expected[3], atol=1e-9)
    assert (response.times == times).all()


def test_tying_the_inputs_gives_the_response_to_both() -> None:
    times = np.linspace(0, 0.02, 20_001)
    displacement = AMPLITUDE * np.sin(OMEGA * times)
    velocity = AMPLITUDE * OMEGA * np.cos(OMEGA * times)
    both = time_response(linear_model(THESIS), np.array([displacement, velocity]), times)
    tied = time_response(pin_model(THESIS), displacement, times)
    np.testing.assert_allclose(tied.output, both.output, atol=1e-6 * AMPLITUDE)
    np.testing.assert_allclose(tied.states[:4], both.states[:4], atol=1e-6 * AMPLITUDE)


@pytest.mark.parametrize("channels", InputChannels)
def test_after_the_transient_the_steady_state_remains(channels: InputChannels) -> None:
    system = pin_model(THESIS, channels=channels)
    times = np.linspace(0, 0.6, 60_001)
    simulated = time_response(system, AMPLITUDE * np.sin(OMEGA * times), times)
    steady = steady_state(system, OMEGA, AMPLITUDE)
    last = times > 0.55
    np.testing.assert_allclose(simulated.output[last], steady.at(times[last]), atol=1e-5 * AMPLITUDE)


def test_steady_state_of_a_first_order_system() -> None:
    steady = steady_state(control.tf([1], [1, 1]), 1.0, 2.0)
    assert steady.amplitude == pytest.approx(math.sqrt(2))
    assert steady.phase == pytest.approx(-math.pi / 4)
    assert steady.at([[0.0, math.pi / 4]]) == pytest.approx(np.array([[-1.0, 0.0]]), abs=1e-15)


@pytest.mark.parametrize("denominator", [[1, 0], [1, -1], [1, 0, 4]])
def test_without_asymptotic_stability_there_is_no_steady_state(denominator: list[float]) -> None:
    with pytest.raises(UnsupportedSystemError, match="does not settle"):
        steady_state(control.tf([1], denominator), 1.0)


def test_several_outputs_are_rows() -> None:
    model = linear_model(THESIS, [Displacement(Body.CUTTER), Displacement(Body.GUARD)])
    times = np.linspace(0, 0.01, 101)
    response = time_response(model, np.ones((2, times.size)), times)
    assert response.output.shape == (2, 101)
    np.testing.assert_array_equal(response.output, response.states[[1, 3]])
    assert type(response.output) is type(response.states) is np.ndarray


@pytest.mark.parametrize("system", [transfer_function(THESIS), control.ss(-0.5, 1, 1, 0, 0.1)])
def test_transfer_functions_and_discrete_time_are_refused(system: control.lti.LTI) -> None:
    with pytest.raises(UnsupportedSystemError, match=r"continuous-time control\.StateSpace"):
        time_response(system, np.zeros(3), np.arange(3))


@pytest.mark.parametrize(
    ("samples", "times"), [(np.zeros(4), np.arange(3.0)), (np.zeros(3), np.array([0.0, 1.0, 3.0]))]
)
def test_shapes_and_distances_must_fit(samples: np.ndarray, times: np.ndarray) -> None:
    with pytest.raises(ValueError, match=r"."):
        time_response(FIRST_ORDER, samples, times)
