"""The last period of a motion, of states and times that are moved by hand."""

from __future__ import annotations

import control
import numpy as np
import pytest

from trimmer import ClosedLoop, Relay, periodic_orbits
from trimmer.orbits.return_map import follow
from trimmer.orbits.settling import _last_turn

LOOP = ClosedLoop(control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0))


@pytest.fixture(scope="module")
def log():
    """Eleven segments of the only orbit, the last of which has no end."""
    (orbit,) = periodic_orbits(LOOP)
    start = orbit.motion.log
    return follow(LOOP.modes, int(start.mode[0]), start.state[0], 5.25 * orbit.period)


@pytest.mark.parametrize("entry", range(3))
def test_the_miss_of_a_turn_is_relative_to_the_sizes(log, entry: int) -> None:
    """All but the first and the last of the segments that end are moved by the same."""
    state = log.state.copy()
    state[1:9, entry] += 1e-3
    turn = _last_turn(LOOP, log._replace(state=state))
    assert turn.miss == pytest.approx(1e-3 / abs(state[:10, entry]).max(), rel=1e-6)
    assert turn.mirrored
    assert turn.span == pytest.approx(float(log.start[9] - log.start[8]))


@pytest.mark.parametrize(("shift", "earlier"), [(9e-5, 8), (1.1e-4, 7)])
def test_of_returns_that_are_not_ten_times_worse_the_latest_counts(log, shift: float, earlier: int) -> None:
    state = log.state.copy()
    state[1:8, 1] += 1e-5
    state[8, 1] += shift
    turn = _last_turn(LOOP, log._replace(state=state))
    assert turn.span == pytest.approx(float(log.start[9] - log.start[earlier]))
    assert turn.mirrored is (earlier == 8)


def test_segments_without_length_are_no_beginning_of_a_turn(log) -> None:
    expected = _last_turn(LOOP, log)
    # Before the last segment there is one that is just like it, but lasts no time.
    rows = [*range(9), 9, 9, 10]
    found = _last_turn(LOOP, type(log)._make(column[rows] for column in log))
    assert found.span == expected.span
    np.testing.assert_array_equal(found.state, expected.state)


def test_the_longest_segment_of_the_turn_counts_and_none_before_it(log) -> None:
    expected = _last_turn(LOOP, log)
    start = log.start.copy()
    start[:3] -= 5.0  # The third segment is by far the longest.
    found = _last_turn(LOOP, log._replace(start=start))
    assert (found.mode, found.span) == (expected.mode, expected.span)
    np.testing.assert_array_equal(found.state, expected.state)
    # Of a turn of two segments it is the longer one.
    whole = type(log)._make(column[1:10:2] for column in log)
    for last in (4, 3):
        rows = [0, 1, 2, 3, 4][: last + 1]
        turn = _last_turn(LOOP, type(log)._make(column[rows] for column in whole))
        assert turn.span == pytest.approx(4.5510710, rel=1e-6)
