"""Values along a motion at many times, against the matrix exponential, which knows no steps and no blocks."""

import control
import numpy as np
import pytest
from scipy.linalg import expm

from trimmer import ClosedLoop, FrictionBacklash, simulate
from trimmer.loops import LoopMotion

A = np.array([[0.0, 1.0, 0.0], [-400.0, -1.0, 50.0], [0.0, 0.0, -3.0]])
PLANT = control.ss(A, [[0.0], [0.0], [1.0]], [[1.0, 0.0, 0.0]], [[0.0]])
START = np.array([0.2, -1.0, 0.5])
NEVER = FrictionBacklash(100.0)
"""A play so wide that it is never taken up: the element's output stays 0, and the system is left alone."""


@pytest.fixture(scope="module")
def free() -> LoopMotion:
    motion = simulate(ClosedLoop(PLANT, NEVER), 4.0, initial_state=START)
    assert not [time for time in motion.event_times if time > 0.0]
    return motion


def exact(times: np.ndarray) -> np.ndarray:
    return np.array([expm(A * time) @ START for time in times]).T


@pytest.mark.parametrize("count", [1, 33, 64, 1000])
@pytest.mark.parametrize("end", [4.0, 1e-3])
def test_any_number_of_times(free: LoopMotion, count: int, end: float) -> None:
    times = np.random.default_rng(5).uniform(0.0, end, count)
    some = slice(None, None, max(1, count // 5))
    assert free.state(times)[:, some] == pytest.approx(exact(times[some]), abs=1e-12)
    assert free.output(times)[some] == pytest.approx(exact(times[some])[0], abs=1e-12)
    assert (np.diff(free.state(np.sort(times))[2]) < 0.0).all()  # a decay, which no sample may interrupt


def test_times_that_are_far_apart_or_all_the_same(free: LoopMotion) -> None:
    for times in ([3.999], [0.1, 3.9], [1.7] * 5):
        assert free.state(times) == pytest.approx(exact(np.array(times)), abs=1e-12)


def test_several_modes_each_from_its_own_start() -> None:
    """Between two events the play rests or follows; the flow is that of its mode."""
    motion = simulate(ClosedLoop(PLANT, FrictionBacklash(0.05)), 4.0, initial_state=START)
    starts = np.unique([0.0, *motion.event_times])
    assert len(starts) > 8
    for begin, end in zip(starts, [*starts[1:], 4.0], strict=True):
        inside = begin + (end - begin) * np.array([1e-6, 0.3, 0.6, 0.999])
        states, outputs = motion.state(inside), motion.element_output(inside)
        moving = np.ptp(outputs) > 1e-9
        feedback = PLANT.B @ PLANT.C if moving else np.zeros((3, 3))
        constant = outputs[0] + moving * motion.output(inside[0])
        matrix = np.block([[A - feedback, PLANT.B * constant], [np.zeros((1, 4))]])
        first = np.append(states[:, 0], 1.0)
        expected = [(expm(matrix * (time - inside[0])) @ first)[:3] for time in inside]
        assert states == pytest.approx(np.transpose(expected), abs=1e-11)
