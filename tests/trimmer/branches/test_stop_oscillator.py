"""Branches of oscillators with a stop against published examples. Digits: two independent computations."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.branches.published import DEAD_ZONE, OSCILLATOR_WITH_STOP
from tests.trimmer.branches.stop_oscillator import StopOscillator, of_dead_zone, of_pyharm
from trimmer.branches.branch import Branch, BranchEnd
from trimmer.branches.continuation import continuation
from trimmer.branches.settings import FollowSettings


def followed(map: StopOscillator, start: float, stop: float, periods: int, switches: int = 0) -> Branch:
    state = np.array([2.0, 0.0]) * map.unit_of_length
    for _ in range(periods):
        state = map.passage(start, state).end
    return continuation(map, state, start, stop, FollowSettings(switches=switches))


def test_derivatives_of_the_closed_form() -> None:
    map, state, step = of_pyharm(), np.array([5.0, 30.0]), 1e-6
    for omega in (5.0, 8.0):
        passage = map.passage(omega, state)
        by_state = [
            (map.passage(omega, state + each).end - map.passage(omega, state - each).end) / (2.0 * step)
            for each in step * np.eye(2)
        ]
        by_omega = (map.passage(omega + step, state).end - map.passage(omega - step, state).end) / (
            2.0 * step
        )
        assert passage.jacobian == pytest.approx(np.array(by_state).T, rel=1e-6, abs=1e-6)
        assert passage.rate() == pytest.approx(by_omega, rel=1e-6)


@pytest.mark.slow
def test_oscillator_with_a_stop() -> None:
    branch = followed(of_pyharm(), 5.0, 12.0, 60)
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    assert [point.kind for point in branch.special] == [kind for kind, _ in OSCILLATOR_WITH_STOP]
    assert [point.value for point in branch.special] == pytest.approx(
        [each for _, each in OSCILLATOR_WITH_STOP], rel=2e-10
    )


@pytest.mark.slow
def test_units_of_length_and_frequency_make_no_difference() -> None:
    branch = followed(of_pyharm(), 5.0, 12.0, 60)
    unit = 1.0 / (2.0 * np.pi)
    other = followed(of_pyharm(1e-3, unit), 5.0 * unit, 12.0 * unit, 60)
    assert len(branch.points) == len(other.points)
    for point, same in zip(branch.special, other.special, strict=True):
        assert same.kind is point.kind
        assert same.value / unit == pytest.approx(point.value, rel=1e-11)
        assert same.state / 1e-3 == pytest.approx(point.state, rel=1e-6)


@pytest.mark.slow
def test_period_doubled_branch_joins_at_its_other_end() -> None:
    branch = followed(of_pyharm(), 5.4, 5.8, 60, switches=1)
    (doubled,) = branch.branches
    assert doubled.reason is BranchEnd.REJOINED
    assert doubled.points[0].value == pytest.approx(5.5567187941, rel=1e-4)
    assert doubled.points[-1].value == pytest.approx(5.7079092816, rel=1e-3)


def test_dead_zone() -> None:
    branch = followed(of_dead_zone(), 0.5, 1.6, 200)
    assert [point.kind for point in branch.special] == [kind for kind, _ in DEAD_ZONE]
    assert [point.value for point in branch.special] == pytest.approx(
        [each for _, each in DEAD_ZONE], rel=1e-10
    )
