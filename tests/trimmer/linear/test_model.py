import dataclasses
import math
from itertools import permutations

import control
import numpy as np
import pytest
import scipy.linalg
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.quick import quick
from tests.trimmer.trimmers import exact_displacements, trimmers
from trimmer import TrimmerParameters, linear_model, pin_model, transfer_function
from trimmer.linear.model import INPUTS, STATES
from trimmer.thesis import Displacement, InputChannels, ParameterError, TrimmerBody

THESIS = TrimmerParameters.thesis()
OUTPUTS = (*map(Displacement, TrimmerBody), *(Displacement(*pair) for pair in permutations(TrimmerBody, 2)))
CHANNELS = tuple(InputChannels)
OMEGAS = (10.0, 628.3, 1400.0, 2230.0, 3453.0, 7160.0, 1e5)


def velocity_too(channels: InputChannels) -> bool:
    return channels is InputChannels.DISPLACEMENT_AND_VELOCITY


def rounding_of_solve(system: control.StateSpace, omega: float) -> float:
    """Bound the rounding of C (j omega - A)^-1 B + D, solved by Gaussian elimination in complex numbers.

    Higham, Accuracy and Stability of Numerical Algorithms, theorem 9.4: the entries of what is solved are off
    by at most 3 n u |L| |U|. All displacements are solved at once, of which this may be by far the smallest.
    """
    matrix = 1j * omega * np.eye(system.nstates) - system.A
    order, lower, upper = scipy.linalg.lu(matrix)
    off = 3 * system.nstates * math.sqrt(2) * np.finfo(float).eps * order @ abs(lower) @ abs(upper)
    solved = abs(np.linalg.solve(matrix, system.B))
    return float((abs(system.C) @ abs(np.linalg.inv(matrix)) @ off @ solved).item())


def test_the_linear_model_names_its_signals() -> None:
    model = linear_model(THESIS)
    assert (model.nstates, model.ninputs, model.noutputs) == (8, 2, 1)
    assert model.input_labels == list(INPUTS)
    assert model.output_labels == ["q2-q4"]
    assert model.state_labels == list(STATES)
    assert model.isctime()


def test_the_linear_model_is_that_of_the_thesis() -> None:
    m1, m2, m3, m4, k1, k2, k3, k4, k5, c1, c2, c3, c4 = THESIS.values()
    lower = [  # equation 2.12, as printed
        [-(k1 + k2) / m1, k2 / m1, 0, 0, -(c1 + c2) / m1, c2 / m1, 0, 0],
        [k2 / m2, -(k2 + k5) / m2, k5 / m2, 0, c2 / m2, -c2 / m2, 0, 0],
        [0, k5 / m3, -(k3 + k4 + k5) / m3, k4 / m3, 0, 0, -(c3 + c4) / m3, c4 / m3],
        [0, 0, k4 / m4, -k4 / m4, 0, 0, c4 / m4, -c4 / m4],
    ]
    model = linear_model(THESIS)
    np.testing.assert_allclose(model.A, np.vstack([np.eye(4, 8, 4), lower]), rtol=1e-15)
    B = np.zeros((8, 2))  # equation 2.13, as printed
    B[4:6] = [[-k2 / m1, -c2 / m1], [k2 / m2, c2 / m2]]
    np.testing.assert_allclose(model.B, B, rtol=1e-15)
    assert model.C.tolist() == [[0, 1, 0, -1, 0, 0, 0, 0]]  # equation 2.14
    assert not model.D.any()


def test_several_outputs_keep_their_order() -> None:
    model = linear_model(THESIS, OUTPUTS)
    assert model.output_labels == [output.label for output in OUTPUTS]
    alone = linear_model(THESIS, OUTPUTS[5])
    assert model.C[5].tolist() == alone.C[0].tolist()
    with pytest.raises(ValueError, match="at least one output"):
        linear_model(THESIS, [])


@pytest.mark.parametrize("channels", CHANNELS)
@pytest.mark.parametrize("build", [pin_model, transfer_function])
@pytest.mark.parametrize("output", quick(OUTPUTS, 0, 1, 5, 9), ids=lambda output: output.label)
def test_the_response_is_that_of_the_force_balance(build, output, channels) -> None:
    system = build(THESIS, output, channels)
    assert system.input_labels == ["pin_displacement"]
    assert system.output_labels == [output.label]
    for omega in OMEGAS:
        moved = exact_displacements(THESIS, omega, velocity_too(channels))
        exact = complex(sum(factor * q for factor, q in zip(output.row, moved, strict=True)))
        rounding = rounding_of_solve(system, omega) if build is pin_model else 0.0
        assert system(1j * omega) == pytest.approx(exact, rel=1e-9, abs=rounding)


def test_states_that_are_no_velocities_are_not_called_velocities() -> None:
    assert pin_model(THESIS, channels=InputChannels.DISPLACEMENT_ONLY).state_labels == list(STATES)
    assert pin_model(THESIS).state_labels == ["q1", "q2", "q3", "q4", "z1", "z2", "z3", "z4"]


def test_a_pin_that_touches_nothing_gives_a_zero_transfer_function() -> None:
    loose = dataclasses.replace(THESIS, k2=0.0, c2=0.0)
    assert transfer_function(loose).num[0][0].tolist() == [0.0]


@given(trimmers(), st.sampled_from(OUTPUTS), st.sampled_from(CHANNELS))
@settings(max_examples=10)
def test_state_space_and_transfer_function_agree_for_any_trimmer(parameters, output, channels) -> None:
    state_space = pin_model(parameters, output, channels)
    rational = transfer_function(parameters, output, channels)
    for pole in state_space.poles():
        omega = abs(pole)
        exact = exact_displacements(parameters, omega, velocity_too(channels))
        scale = max(abs(complex(q)) for q in exact)
        expected = complex(sum(factor * q for factor, q in zip(output.row, exact, strict=True)))
        assert state_space(1j * omega) == pytest.approx(expected, rel=1e-8, abs=1e-8 * scale)
        assert rational(1j * omega) == pytest.approx(expected, rel=1e-8, abs=1e-8 * scale)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("channels", CHANNELS)
def test_parameters_so_far_apart_that_the_equations_overflow_are_named(channels) -> None:
    far = dict.fromkeys(("m1", "m2", "m3", "m4"), 1e-50) | dict.fromkeys(("k1", "k2", "k3", "k4"), 1e50)
    with pytest.raises(ParameterError, match=r"overflow: the lightest body has m1 = 1e-50 kg"):
        transfer_function(dataclasses.replace(THESIS, **far), channels=channels)
