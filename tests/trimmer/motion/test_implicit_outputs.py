"""Outputs that follow from conditions on rates, as the forces of frictions that stick together."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer import IllPosedLoopError
from trimmer.motion.implicit_outputs import component_signals, least_outputs
from trimmer.motion.interconnection import Layout


def test_conditions_that_repeat_each_other_share_the_output() -> None:
    outputs = least_outputs(np.array([[2.0, 2.0], [1.0, 1.0]]), np.array([[8.0, 0.0], [4.0, 0.0]]), "both")
    assert outputs == pytest.approx(np.array([[2.0, 0.0], [2.0, 0.0]]), abs=1e-15)


def test_conditions_that_contradict_each_other_are_an_error() -> None:
    with pytest.raises(IllPosedLoopError, match="the outputs of both are not determined by the motion"):
        least_outputs(np.array([[2.0, 2.0], [1.0, 1.0]]), np.array([[8.0], [5.0]]), "both")


def test_a_small_condition_beside_a_large_one_is_no_contradiction() -> None:
    outputs = least_outputs(np.array([[1.0, -1.0], [1.0, 1.0]]), np.array([[1e-9], [1e7]]), "both")
    assert outputs == pytest.approx(np.array([[5e6], [5e6]]), rel=1e-14)


@pytest.mark.parametrize("unit", [1e-200, 1e-9, 1e12])
def test_units_do_not_matter(unit: float) -> None:
    left = np.array([[3.0, 1.0], [unit, 2.0 * unit]])
    outputs = least_outputs(left, left @ np.array([[5.0], [-1.0]]), "both")
    assert outputs == pytest.approx(np.array([[5.0], [-1.0]]), rel=1e-13)


def test_conditions_of_any_sign_and_size() -> None:
    left = np.array([[-2e6, 1.0, 0.0], [0.0, -4e-5, 8e-5], [0.0, 0.0, -1e-9]])
    wanted = np.array([[3.0, -1.0], [-5.0, 2.0], [7.0, 4.0]])
    np.testing.assert_allclose(least_outputs(left, left @ wanted, "a"), wanted, rtol=1e-12)
    turned = left[[1, 2, 0]][:, [2, 0, 1]]
    np.testing.assert_allclose(
        least_outputs(turned, left[[1, 2, 0]] @ wanted, "a"), wanted[[2, 0, 1]], rtol=1e-12
    )


@pytest.mark.parametrize("size", [1.0, -1.0, 1e6, -1e6, 1e-6])
def test_conditions_that_contradict_each_other(size: float) -> None:
    left = np.array([[0.0, 1.0, 1.0], [0.0, 2.0, 2.0], [5.0, 0.0, 0.0]])
    agreeing = size * np.array([[3.0], [6.0], [5.0]])
    found = least_outputs(left, agreeing, "a")
    np.testing.assert_allclose(found, size * np.array([[1.0], [1.5], [1.5]]), rtol=1e-12)
    nearly = agreeing * (1.0 + 1e-11 * np.array([[0.0], [1.0], [0.0]]))
    np.testing.assert_allclose(least_outputs(left, nearly, "a"), found, rtol=1e-10)
    for share in (1.1, 0.9):
        with pytest.raises(IllPosedLoopError, match="the outputs of a, b are not determined by the motion"):
            least_outputs(left, agreeing * [[1.0], [share], [1.0]], "a, b")


def test_an_output_below_the_rounding_of_its_terms_is_zero() -> None:
    left, right = np.array([[1.0, 0.0], [1.0, 1.0]]), np.array([[1.0, 1.0], [1.0 + 1.5e-12, 1.0 + 2.5e-12]])
    # The second one is a difference of two terms of size one.
    found = least_outputs(left, right, "a", np.ones((2, 2)))
    assert found[1].tolist() == [0.0, pytest.approx(2.5e-12, rel=1e-3, abs=0.0)]
    assert found[0].tolist() == [1.0, 1.0]


def test_signals_of_a_component() -> None:
    layout = Layout(2, (2, 3), 5, 8)
    matrix, sizes = np.zeros((8, 8)), np.zeros((8, 8))
    given, output = np.array([-1.0, 1.0, 0, 0, 0, 0, 0, 0]), np.arange(8.0)
    matrix[0, :3], matrix[1, :3] = (1.0, 3.0, 2.0), (1.0 + 1.5e-12, 1.0, 2.0 + 2.5e-12)
    matrix[2, 0] = 7.0
    sizes[:2, :3] = 1.0
    signals = component_signals(layout, (matrix, sizes), given, output, 1, 2)
    assert signals.input is given
    assert signals.output is output
    assert signals.input_rate.tolist() == [0.0, -2.0, pytest.approx(2.5e-12, rel=1e-3, abs=0.0), *[0.0] * 5]
    assert signals.input_curvature == pytest.approx(signals.input_rate @ matrix, rel=1e-13)
    assert [each.tolist() for each in signals.states] == np.eye(8)[3:5].tolist()
    assert signals.one.tolist() == np.eye(8)[7].tolist()
    # The two terms of the curvature cancel each other but for rounding.
    matrix, sizes = np.zeros((8, 8)), np.ones((8, 8))
    matrix[0, 1:3], matrix[1:3, 0] = (-1.0, 1.0), (1.0, 1.0 + 1.5e-12)
    signals = component_signals(layout, (matrix, sizes), np.eye(8)[0], output, 0, 1)
    assert signals.input_rate.tolist() == [0.0, -1.0, 1.0, *[0.0] * 5]
    assert not signals.input_curvature.any()
