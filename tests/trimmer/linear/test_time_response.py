import math

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.quick import quick
from trimmer.generated import linear_trimmer
from trimmer.linear import UnsupportedSystemError, pin_model, steady_state, time_response, transfer_function
from trimmer.thesis import Displacement, InputChannels, TrimmerBody, TrimmerParameters, linear_model

THESIS = TrimmerParameters.thesis()
OMEGA, AMPLITUDE = 200 * math.pi, 0.0015  # the pin of figure 5.1 of the thesis

FIRST_ORDER = control.ss(-1.0, 1.0, 1.0, 0.0)


def test_a_ramp_is_exact_on_the_coarsest_grid() -> None:
    times = np.array([0.0, 3.0, 6.0])
    response = time_response(FIRST_ORDER, times, times)
    np.testing.assert_allclose(response.outputs, times - 1 + np.exp(-times), atol=1e-14)
    two = time_response(FIRST_ORDER, [2.0, 5.0], [1.0, 1.0], [4.0])
    np.testing.assert_allclose(two.outputs, [4.0, 1.0 + 3.0 * math.exp(-3.0)], rtol=1e-14)
    rounded = np.round(np.arange(0.0, 1.0, 1 / 3000), 10)  # counts as equally spaced
    assert time_response(FIRST_ORDER, rounded, np.ones(rounded.size)).outputs.shape == rounded.shape


def test_a_released_trimmer_moves_as_newton_says() -> None:
    M, C, K = (
        np.array(getattr(linear_trimmer, name)(*THESIS.values()))
        for name in ("mass_matrix", "damping_matrix", "stiffness_matrix")
    )
    times = np.linspace(0, 0.01, 201)
    start = np.array([1e-3, -2e-3, 0.5e-3, 1e-3, 0.1, 0.2, -0.3, 0.0])
    response = time_response(linear_model(THESIS), times, np.zeros((2, times.size)), start)

    def motion(_: float, state: np.ndarray) -> np.ndarray:
        q, velocity = state[:4], state[4:]
        return np.concatenate([velocity, -np.linalg.solve(M, C @ velocity + K @ q)])

    expected = solve_ivp(motion, (0, times[-1]), start, t_eval=times, rtol=1e-10, atol=1e-12).y
    np.testing.assert_allclose(response.states[:4], expected[:4], atol=1e-9)
    np.testing.assert_allclose(response.outputs[0], expected[1] - expected[3], atol=1e-9)
    assert (response.time == times).all()


def test_tying_the_inputs_gives_the_response_to_both() -> None:
    times = np.linspace(0, 0.02, 20_001)
    displacement = AMPLITUDE * np.sin(OMEGA * times)
    velocity = AMPLITUDE * OMEGA * np.cos(OMEGA * times)
    both = time_response(linear_model(THESIS), times, np.array([displacement, velocity]))
    tied = time_response(pin_model(THESIS), times, displacement)
    np.testing.assert_allclose(tied.outputs, both.outputs[0], atol=1e-6 * AMPLITUDE)
    np.testing.assert_allclose(tied.states[:4], both.states[:4], atol=1e-6 * AMPLITUDE)


@pytest.mark.parametrize("channels", quick(InputChannels, 0))
def test_after_the_transient_the_steady_state_remains(channels: InputChannels) -> None:
    system = pin_model(THESIS, channels=channels)
    times = np.linspace(0, 0.6, 60_001)
    simulated = time_response(system, times, AMPLITUDE * np.sin(OMEGA * times))
    steady = steady_state(system, OMEGA, AMPLITUDE)
    last = times > 0.55
    np.testing.assert_allclose(simulated.outputs[last], steady.at(times[last]), atol=1e-5 * AMPLITUDE)


def test_steady_state_of_a_first_order_system_and_of_a_gain() -> None:
    steady = steady_state(control.tf([1], [1, 1]), 1.0, 2.0)
    assert steady.amplitude == pytest.approx(math.sqrt(2))
    assert steady.phase == pytest.approx(-math.pi / 4)
    assert steady.at([[0.0, math.pi / 4]]) == pytest.approx(np.array([[-1.0, 0.0]]), abs=1e-15)
    gain = steady_state(control.tf([-2.0], [1.0]), 3.0, 1.5)
    assert (gain.omega, gain.amplitude, gain.phase) == (3.0, 3.0, math.pi)


@pytest.mark.parametrize("denominator", [[1, 0], [1, -1], [1, 0, 4]])
def test_without_asymptotic_stability_there_is_no_steady_state(denominator: list[float]) -> None:
    with pytest.raises(UnsupportedSystemError, match="does not settle"):
        steady_state(control.tf([1], denominator), 1.0)


def test_several_outputs_are_rows() -> None:
    model = linear_model(THESIS, [Displacement(TrimmerBody.CUTTER), Displacement(TrimmerBody.GUARD)])
    times = np.linspace(0, 0.01, 101)
    response = time_response(model, times, np.ones((2, times.size)))
    assert response.outputs.shape == (2, 101)
    np.testing.assert_array_equal(response.outputs, response.states[[1, 3]])
    assert type(response.outputs) is type(response.states) is np.ndarray


@pytest.mark.parametrize("system", [transfer_function(THESIS), control.ss(-0.5, 1, 1, 0, 0.1)])
def test_transfer_functions_and_discrete_time_are_refused(system: control.lti.LTI) -> None:
    with pytest.raises(UnsupportedSystemError, match=r"continuous-time control\.StateSpace"):
        time_response(system, np.arange(3), np.zeros(3))


@pytest.mark.parametrize(("noutputs", "ninputs"), [(1, 1), (1, 2), (2, 1), (2, 3)])
def test_arguments_names_and_shapes_are_those_of_python_control(noutputs: int, ninputs: int) -> None:
    system, times = control.rss(3, noutputs, ninputs, strictly_proper=True), np.linspace(0, 1, 11)
    inputs = np.sin(times) * np.arange(1, ninputs + 1)[:, None]
    given = inputs[0] if ninputs == 1 else inputs
    ours, theirs = time_response(system, times, given), control.forced_response(system, times, given)
    for name in ("time", "outputs", "inputs", "states"):
        np.testing.assert_allclose(getattr(ours, name), getattr(theirs, name), atol=1e-14)
        assert getattr(ours, name).shape == getattr(theirs, name).shape


TIMES = np.arange(3.0)


@pytest.mark.parametrize(
    ("times", "inputs", "message"),
    [
        (TIMES, np.zeros(4), r"inputs must have shape \(3,\).*not \(4,\)"),
        (TIMES, np.zeros((2, 3)), r"inputs must have shape \(3,\).*not \(2, 3\)"),
        (TIMES, np.zeros(()), r"inputs must have shape"),
        (TIMES, np.array([0.0, math.nan, 1.0]), "inputs must be finite"),
        (TIMES, np.zeros(3) * 1j, "inputs must be a real number"),
        (np.array([0.0, 1.0, 3.0]), TIMES, r"times must be at equal distances.*after 1\.0 s.*2\.0 s"),
        (np.array([0.0, 1e-7, 2.1e-7]), TIMES, "times must be at equal distances"),
        (np.array([0.0, 2.0, 3.0]), TIMES, "times must be at equal distances"),
        (np.zeros(3), TIMES, r"times must rise.*before the inputs"),
        (np.sin(TIMES * 3), TIMES, "times must rise"),
        (TIMES[::-1], TIMES, "times must rise"),
        (TIMES[:, None], TIMES, r"times must be two or more instants in one dimension.*\(3, 1\)"),
        (np.zeros(1), np.zeros(1), "times must be two or more instants"),
        (["a", "b"], TIMES, "times must be a real number"),
        (np.array([0.0, math.inf]), np.zeros(2), "times must be finite"),
    ],
)
def test_wrong_times_and_inputs_are_named(times: object, inputs: object, message: str) -> None:
    with pytest.raises((ValueError, TypeError), match=message):
        time_response(FIRST_ORDER, times, inputs)


@pytest.mark.parametrize("state", [[0.0, 0.0], [[1.0]], "rest", [math.nan]])
def test_a_wrong_initial_state_is_named(state: object) -> None:
    with pytest.raises((ValueError, TypeError), match="initial_state must"):
        time_response(FIRST_ORDER, TIMES, np.zeros(3), state)


@pytest.mark.parametrize("later", [0.4, 0.5])
def test_the_first_instant_that_does_not_rise_is_named(later: float) -> None:
    with pytest.raises(ValueError, match=rf"but 0\.5 s is followed by {later} s"):
        time_response(FIRST_ORDER, [0.0, 0.25, 0.5, later, 0.2], np.zeros(5))


def test_signals_are_numbered_where_there_are_several() -> None:
    times = np.array([0.0, 0.5, 1.0])
    two = control.ss(-np.eye(2), np.eye(2), [[1.0, 2.0]], np.zeros((1, 2)))
    inputs = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])
    response = time_response(two, times, inputs, [7.0, 8.0])
    assert list(response.named) == ["input 1", "input 2", "output 1"]
    first = response.to_dataframe().iloc[0].to_dict()
    values = {"input 1": 1.0, "input 2": 4.0, "output 1": 23.0, "state 1": 7.0, "state 2": 8.0}
    assert first == {"time": 0.0, **values}
    alone = time_response(FIRST_ORDER, times, times)
    assert list(alone.named) == ["input", "output"]
    assert alone.to_dataframe().iloc[2].tolist() == [1.0, 1.0, *[pytest.approx(math.exp(-1.0))] * 2]
    assert "3 samples from 0 to 1 s" in repr(alone)
