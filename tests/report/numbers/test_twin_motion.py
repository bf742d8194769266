"""The twin's central motions by three means: exact, Runge-Kutta in the report, brute force of the tests."""

from __future__ import annotations

import numpy as np
import pytest

from report.numbers.independent.twin_motion import PlayedTrimmer, integrated
from report.numbers.twin.cases import followed
from report.numbers.twin.mechanism import twin
from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.dynamics import System
from trimmer import TrimmerParameters

TURN = 2 * np.pi
CASES = pytest.mark.parametrize(("gap", "force", "count"), [(40e-6, 0.5, 1), (200e-6, 2.0, 3)])


@pytest.fixture(scope="module")
def orbits():
    return {gap: followed(twin(gap, force)) for gap, force in ((40e-6, 0.5), (200e-6, 2.0))}


@CASES
def test_brute_force_returns_to_the_start_of_the_orbit(gap, force, count, orbits):
    start = orbits[gap].motion.orbit.instant.state
    brute = BruteForce(tolerance=1e-11).run(System(twin(gap, force)), start, 0.0, count / 110)
    assert abs(brute.final - start) == pytest.approx(0, abs=1e-9 * abs(start).max())


@CASES
def test_the_reports_method_agrees_with_the_exact_motion_all_the_way(gap, force, count, orbits):
    found = orbits[gap]
    times = np.linspace(0, count / 110, 301)
    trimmer = PlayedTrimmer(TrimmerParameters.thesis(), gap, force, 1.5e-3, TURN * 110)
    states = integrated(trimmer, found.motion.orbit.instant.state, times)
    exact = found.course.states(times)[:, :9].T
    # Between its steps DOP853 interpolates with a lower order: 1.3e-9 of the stretch, the smallest state.
    assert (abs(states - exact).max(axis=1) <= 1e-8 * abs(exact).max(axis=1)).all()


def test_it_sticks_where_friction_holds():
    trimmer = PlayedTrimmer(TrimmerParameters.thesis(), 40e-6, 50.0, 1.5e-3, TURN * 110)
    states = integrated(trimmer, np.zeros(9), np.linspace(0, 0.02, 50))
    assert abs(states[1] - states[3]).max() < 1e-15


def test_three_drive_periods_are_needed_and_not_one(orbits):
    found = orbits[200e-6]
    first, later = found.course.states(np.array([0.0, 1 / 110]))[:, :9]
    assert found.period_count == 3
    assert abs(later - first).max() > 1e-2 * abs(first).max()
