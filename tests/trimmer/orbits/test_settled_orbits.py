"""How the ends of motions are counted, how the last period is found, and what it is polished to."""

from __future__ import annotations

from types import SimpleNamespace

import control
import numpy as np
import pytest

from trimmer import ClosedLoop, OrbitSearch, Relay, periodic_orbits
from trimmer.motion.kernel import CYCLING, DIVERGED, FULL, REACHED_END, STEP_LIMIT
from trimmer.orbits import settling
from trimmer.orbits.return_map import follow
from trimmer.orbits.search import SimulationSearch
from trimmer.orbits.settling import Ending, Turn, _follow, _integrate, _last_turn, _polished, settled_orbits

LOOP = ClosedLoop(control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0))
ENDS = [
    *[Ending.SETTLED] * 5,
    *[Ending.AT_REST] * 4,
    *[Ending.DIVERGED] * 3,
    *[Ending.ACCUMULATED] * 2,
    *[Ending.LEFT],
]


def searched(monkeypatch: pytest.MonkeyPatch, ends: list, starts: int) -> tuple[list, SimulationSearch]:
    """Search with motions that end as they are told, and add an orbit where they settle."""
    waiting = list(ends)

    def follow(loop, mode, state, steps, orbits):
        assert (loop, state, steps) == ("loop", -mode, 77)
        if waiting[0] is None:
            raise KeyboardInterrupt
        if waiting[0] is Ending.SETTLED:
            orbits.append(mode)
        return waiting.pop(0)

    def drawn(loop, count, seed):
        assert (loop, count, seed) == ("loop", starts, 9)
        return ((number, -number) for number in range(count))

    monkeypatch.setattr(settling, "_follow", follow)
    monkeypatch.setattr(settling, "initial_states", drawn)
    return settled_orbits("loop", OrbitSearch("always", starts=starts, seed=9, steps=77), ["known", "too"])


def test_ends_are_counted_by_their_kind(monkeypatch: pytest.MonkeyPatch) -> None:
    found, told = searched(monkeypatch, ENDS, 15)
    assert found == [0, 1, 2, 3, 4]
    assert told == SimulationSearch(15, 9, 5, 4, 3, 2, 1, 15)
    assert not told.interrupted


def test_an_interrupt_leaves_what_was_found_until_then(monkeypatch: pytest.MonkeyPatch) -> None:
    found, told = searched(monkeypatch, [*ENDS[:7], None], 15)
    assert found == [0, 1, 2, 3, 4]
    assert told == SimulationSearch(7, 9, 5, 2, 0, 0, 0, 15)
    assert told.interrupted


def ending(monkeypatch: pytest.MonkeyPatch, reason: int, start: list, states: list) -> Ending:
    """How a motion ends whose first stretch is given; it repeats nowhere."""
    log = SimpleNamespace(start=np.array(start), state=np.array(states))
    monkeypatch.setattr(settling, "_integrate", lambda *given: (reason, log, 9.0))
    monkeypatch.setattr(settling, "_last_turn", lambda loop, log: None)
    monkeypatch.setattr(settling, "_steps", lambda loop, log, end: 10)
    monkeypatch.setattr(settling, "_quiet_state", lambda loop, log, end: (0, np.zeros(3)))
    monkeypatch.setattr(settling, "quiet_time", lambda loop: 5.0)
    loop = SimpleNamespace(modes=SimpleNamespace(layout=SimpleNamespace(order=2)))
    return _follow(loop, 0, np.zeros(3), 100, [])


MOVING = [[0.0, 5.0, 1.0], [1.0, -5.0, 1.0], [0.0, 5.0, 1.0]]


def test_a_motion_ends_as_its_integration_does(monkeypatch: pytest.MonkeyPatch) -> None:
    for reason, expected in (
        (DIVERGED, Ending.DIVERGED),
        (CYCLING, Ending.ACCUMULATED),
        (STEP_LIMIT, Ending.LEFT),
        (FULL, Ending.LEFT),
    ):
        assert ending(monkeypatch, reason, [0.0, 1.0, 2.0], MOVING) is expected
        assert ending(monkeypatch, reason, [0.0, 0.0, 0.0], MOVING) is expected
    # Without an event it is at rest after a long time; events at its very beginning do not count.
    assert ending(monkeypatch, REACHED_END, [0.0], MOVING[:1]) is Ending.AT_REST
    assert ending(monkeypatch, REACHED_END, [0.0, 0.0], MOVING[:2]) is Ending.AT_REST
    assert ending(monkeypatch, REACHED_END, [0.0, 0.0, 1.0], MOVING) is Ending.LEFT


def test_a_motion_is_at_rest_where_no_state_swings_any_more(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its last 64 events against all; what is beyond the linear system's states does not count."""
    for swing, expected in ((0.9e-7, Ending.AT_REST), (1.1e-7, Ending.LEFT)):
        for entry, size in ((0, 1.0), (1, 10.0)):
            states = np.tile([3.0, -2.0, 1.0], (70, 1))
            states[0] = 3.0, -2.0, 5.0
            states[1] = 4.0, 8.0, -5.0
            states[40, entry] += swing * size
            states[50, 2] = 9.0
            assert ending(monkeypatch, FULL, list(range(70)), states) is expected
    # The first six events are too long ago.
    states = np.tile([3.0, -2.0, 1.0], (70, 1))
    states[5] = 4.0, 8.0, 1.0
    assert ending(monkeypatch, FULL, list(range(70)), states) is Ending.AT_REST
    states[6] = 4.0, 8.0, 1.0
    assert ending(monkeypatch, FULL, list(range(70)), states) is Ending.LEFT


def test_a_turn_is_polished_with_its_symmetry_and_else_without(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list = []
    answers: list = []

    def solve(problem, mode, state, span, iterations):
        assert (problem.modes, problem.driven, problem.sizes) == (LOOP.modes, False, "sizes")
        assert (mode, state, iterations) == ("mode", "state", 12)
        asked.append((problem.mirrored, span))
        return answers.pop(0)

    monkeypatch.setattr(settling, "solve", solve)
    mirrored = Turn("mode", "state", 1.5, True, "sizes", 0.0)
    for given, expected, tried in (
        (["a"], (True, "a"), [(True, 1.5)]),
        ([None, "b"], (False, "b"), [(True, 1.5), (False, 3.0)]),
        ([None, None], None, [(True, 1.5), (False, 3.0)]),
    ):
        asked.clear()
        answers[:] = given
        found = _polished(LOOP, mirrored)
        assert (None if found is None else (found[0].mirrored, found[1])) == expected
        assert asked == tried
    asked.clear()
    answers[:] = ["c"]
    problem, shot = _polished(LOOP, Turn("mode", "state", 1.5, False, "sizes", 0.0))
    assert (problem.mirrored, shot, asked) == (False, "c", [(False, 1.5)])


def test_a_stretch_has_room_for_its_events(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list = []
    monkeypatch.setattr(settling, "integrate_on", lambda *given: asked.append(given))
    _integrate(LOOP, 1, np.zeros(6), 2.5, 128, 70)
    ((modes, log, duration, segments, steps),) = asked
    assert (modes, len(log.start), int(log.mode[0])) == (LOOP.modes, 130, 1)
    assert (duration, segments, steps) == (2.5, 129, 70)


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
