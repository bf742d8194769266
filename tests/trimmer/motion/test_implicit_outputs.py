"""Outputs that follow from conditions on rates, as the forces of frictions that stick together."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer import IllPosedLoopError
from trimmer.motion.implicit_outputs import least_outputs


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
