"""Systems that are stored and built again: with each name, matrix and state."""

import pickle

import control
import numpy as np
import pytest

from trimmer.linear.stored_system import restored, stored


@pytest.mark.parametrize("dt", [0, 0.25, True, None])
def test_a_system_comes_back_with_its_names_and_with_states_that_nothing_reaches(dt: float | None) -> None:
    A, B = np.array([[-1.0, 2.0, 0.0], [0.0, -3.0, 0.0], [0.0, 0.0, 0.0]]), [[1.0], [4.0], [0.0]]
    given = control.StateSpace(
        *(A, B, [[5.0, 6.0, 0.0], [7.0, 8.0, 0.0]], [[9.0], [10.0]], dt),
        remove_useless_states=False,
        name="by hand",
        states=["a", "b", "idle"],
        inputs=["force"],
        outputs=["left", "right"],
    )
    found = restored(pickle.loads(pickle.dumps(stored(given))))
    for name in "ABCD":
        assert getattr(found, name).tolist() == getattr(given, name).tolist()
    assert (found.dt, found.name) == (dt, "by hand")
    assert found.state_labels == ["a", "b", "idle"]
    assert (found.input_labels, found.output_labels) == (["force"], ["left", "right"])


def test_what_is_no_state_space_stays_as_it_is() -> None:
    for value in (control.tf([1.0], [1.0, 2.0]), 3.0, None):
        assert stored(value) is value
        assert restored(value) is value
