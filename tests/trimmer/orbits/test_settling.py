"""How a long motion is judged: its last period, its steps, how it ends, and the extremes on the way."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import control
import numpy as np
import pytest

from trimmer import ClosedLoop, OrbitSearch, Relay, Saturation, Simulations, periodic_orbits
from trimmer.motion.integration import new_log
from trimmer.motion.taylor import DEGREE
from trimmer.orbits import settling
from trimmer.orbits.distinct import _prime_factors, same
from trimmer.orbits.initial_states import initial_states, quiet_time
from trimmer.orbits.measures import _extremes_of
from trimmer.orbits.return_map import follow
from trimmer.orbits.settling import (
    Ending,
    _collapsed,
    _follow,
    _last_turn,
    _polished,
    _quiet_state,
    _settles,
    _steps,
    settled_orbits,
)

LOOP = ClosedLoop(control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0))


@pytest.fixture(scope="module")
def orbit():
    """The only orbit, with two switches in a period."""
    (found,) = periodic_orbits(LOOP)
    return found


@pytest.fixture(scope="module")
def log(orbit):
    """Five and a quarter periods on it."""
    start = orbit.motion.log
    return follow(LOOP.modes, int(start.mode[0]), start.state[0], 5.25 * orbit.period)


def test_the_last_turn_is_the_last_half_period(orbit, log) -> None:
    turn = _last_turn(LOOP, log)
    assert turn.mirrored
    assert turn.miss < 1e-9
    assert turn.span == pytest.approx(orbit.period / 2, rel=1e-9)
    lasting = np.flatnonzero(np.diff(log.start) > 0)
    last = lasting[-1]
    middle = 0.5 * (log.start[last - 1] + log.start[last])
    assert turn.mode == log.mode[last - 1]
    order = LOOP.modes.layout.order
    np.testing.assert_allclose(turn.state[:order], orbit.motion.state(middle % orbit.period), rtol=1e-7)
    largest = np.maximum(abs(log.state[lasting]).max(axis=0), abs(turn.state))
    largest[largest == 0] = 1.0
    np.testing.assert_array_equal(turn.sizes, largest)


def test_without_mirrored_segments_a_turn_is_a_whole_period(orbit, log) -> None:
    """The same motion, of which every other segment was left out of sight."""
    count = len(log.start) // 2 * 2
    kept = type(log)._make(column[1:count:2] for column in log)
    turn = _last_turn(LOOP, kept)
    assert not turn.mirrored
    assert turn.span == pytest.approx(orbit.period, rel=1e-9)
    assert turn.miss < 1e-9


def test_a_motion_without_a_return_has_no_turn(log) -> None:
    def first(rows: int):
        return type(log)._make(column[:rows] for column in log)

    assert _last_turn(LOOP, first(1)) is None
    assert _last_turn(LOOP, first(2)) is None
    moved = first(5)._replace(state=first(5).state * np.geomspace(1, 3, 5)[:, None])
    assert _last_turn(LOOP, moved) is None


def test_a_turn_leads_to_the_orbit(orbit, log) -> None:
    turn = _last_turn(LOOP, log)
    problem, shot = _polished(LOOP, turn)
    assert problem.mirrored
    assert shot.span == pytest.approx(orbit.period / 2, rel=1e-10)
    assert not _collapsed(shot, turn)
    whole = type(turn)(turn.mode, turn.state, 2 * turn.span, False, turn.sizes, turn.miss)
    problem, shot = _polished(LOOP, whole)
    assert not problem.mirrored
    assert shot.span == pytest.approx(orbit.period, rel=1e-10)
    known = [orbit]
    assert _settles(LOOP, turn, known)
    assert known == [orbit]
    fresh = []
    assert _settles(LOOP, whole, fresh)
    assert len(fresh) == 1
    assert same(fresh[0], orbit)
    assert fresh[0].period == pytest.approx(orbit.period, rel=1e-10)


def test_a_motion_stays_where_newtons_method_hardly_moves_it(orbit, log) -> None:
    turn = replace(_last_turn(LOOP, log), miss=1e-3)
    order = LOOP.modes.layout.order
    for entry in range(order):
        for share, stays in ((0.01, True), (0.4, False)):
            state = turn.state.copy()
            state[entry] += share * turn.sizes[entry]
            assert _settles(LOOP, replace(turn, state=state), [orbit]) is stays
    assert _settles(LOOP, replace(turn, span=1.01 * turn.span), [orbit])
    assert not _settles(LOOP, replace(turn, span=1.2 * turn.span), [orbit])
    assert not _settles(LOOP, replace(turn, span=turn.span / 1.2), [orbit])


def test_an_unstable_orbit_is_kept_but_a_motion_leaves_it(orbit, log, monkeypatch) -> None:
    turn = replace(_last_turn(LOOP, log), miss=1e-3)
    unstable = SimpleNamespace(stable=False)
    monkeypatch.setattr(settling, "orbit_of", lambda *_: unstable)
    monkeypatch.setattr(settling, "same", lambda one, other: one is other)
    known: list = []
    assert not _settles(LOOP, turn, known)
    assert known == [unstable]
    assert _settles(LOOP, replace(turn, miss=1e-9), known)
    assert known == [unstable]


def test_what_does_not_move_or_has_no_event_has_collapsed() -> None:
    def shot(states: list, last: list):
        return SimpleNamespace(
            log=SimpleNamespace(state=np.array(states), start=np.arange(len(states))), state=np.array(last)
        )

    turn = SimpleNamespace(sizes=np.array([10.0, 0.1]))
    assert not _collapsed(shot([[1.0, 0.0], [1.0, 0.0]], [1.0, 2e-7]), turn)
    assert _collapsed(shot([[1.0, 0.0], [1.0, 0.0]], [1.0, 0.5e-7]), turn)
    assert _collapsed(shot([[1.0, 0.0]], [5.0, 1.0]), turn)
    assert not _collapsed(shot([[1.0, 0.0], [1.0, 0.0]], [5.0, 0.0]), turn)


def test_the_quiet_state_is_in_the_middle_of_the_last_segment(orbit, log) -> None:
    end = float(log.start[-1]) + 0.2 * orbit.period
    mode, state = _quiet_state(LOOP, log, end)
    order = LOOP.modes.layout.order
    time = (float(log.start[-1]) + 0.1 * orbit.period) % orbit.period
    assert mode == log.mode[-1]
    np.testing.assert_allclose(state[:order], orbit.motion.state(time), rtol=1e-7, atol=1e-9)
    # Nothing lasts of the last row; the one before it counts.
    mode, state = _quiet_state(LOOP, log, float(log.start[-1]))
    time = 0.5 * (float(log.start[-2]) + float(log.start[-1])) % orbit.period
    assert mode == log.mode[-2]
    np.testing.assert_allclose(state[:order], orbit.motion.state(time), rtol=1e-7, atol=1e-9)


def test_steps_are_counted_by_segment() -> None:
    loop = SimpleNamespace(modes=SimpleNamespace(tables=SimpleNamespace(step=np.array([0.5, 0.1]))))
    log = SimpleNamespace(start=np.array([0.0, 2.0]), mode=np.array([0, 1]))
    assert _steps(loop, log, 3.05) == 4 + 1 + 10 + 1


ENDS = {
    "stable with a relay that stops": (control.tf([1.0], [1.0, 2.0]), Relay(1.0), Ending.AT_REST),
    "unstable": (control.tf([1.0], [1.0, -0.5, 1.0]), Saturation(1.0, 1.0), Ending.DIVERGED),
    "a limit cycle": (control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0), Ending.SETTLED),
}


@pytest.mark.parametrize("name", ENDS)
def test_how_a_motion_ends(name: str) -> None:
    plant, element, ending = ENDS[name]
    loop = ClosedLoop(plant, element)
    (mode, state), *_ = initial_states(loop, 1, 0)
    orbits: list = []
    assert _follow(loop, mode, state, 200_000, orbits) is ending
    assert len(orbits) == (ending is Ending.SETTLED)


def test_a_motion_with_too_few_steps_is_left() -> None:
    (mode, state), *_ = initial_states(LOOP, 1, 0)
    assert _follow(LOOP, mode, state, 3, []) is Ending.LEFT


def test_a_motion_is_looked_at_ever_more_rarely_until_it_is_given_up(monkeypatch) -> None:
    (mode, state), *_ = initial_states(LOOP, 1, 0)
    asked: list = []
    integrate = settling._integrate

    def integrated(loop, mode, state, duration, events, steps):
        asked.append((duration, events, steps))
        return integrate(loop, mode, state, duration, events, steps)

    monkeypatch.setattr(settling, "_integrate", integrated)
    monkeypatch.setattr(settling, "_last_turn", lambda loop, log: None)
    monkeypatch.setattr(settling, "MOST_EVENTS", 321)
    assert _follow(LOOP, mode, state, 200_000, []) is Ending.LEFT
    assert [events for _, events, _ in asked] == [128, 192, 288]
    assert {duration for duration, _, _ in asked} == {quiet_time(LOOP)}
    steps = [steps for _, _, steps in asked]
    assert steps[0] == 200_000 > steps[1] > steps[2]
    asked.clear()
    monkeypatch.setattr(settling, "MOST_EVENTS", 320)
    assert _follow(LOOP, mode, state, 200_000, []) is Ending.LEFT
    assert [events for _, events, _ in asked] == [128, 192]
    asked.clear()
    assert _follow(LOOP, mode, state, 0, []) is Ending.LEFT
    assert asked == []


def test_a_motion_is_polished_again_where_it_has_come_much_nearer(monkeypatch) -> None:
    (mode, state), *_ = initial_states(LOOP, 1, 0)
    misses = iter([1e-3, 3e-4, 1.9e-4, None, 1e-4, 0.9e-9, 0.9e-9])
    tried: list = []

    def last_turn(loop, log):
        miss = next(misses)
        return None if miss is None else SimpleNamespace(miss=miss)

    def settles(loop, turn, orbits):
        tried.append(turn.miss)
        return len(tried) == 4

    monkeypatch.setattr(settling, "_last_turn", last_turn)
    monkeypatch.setattr(settling, "_settles", settles)
    assert _follow(LOOP, mode, state, 10**6, []) is Ending.SETTLED
    assert tried == [1e-3, 1.9e-4, 0.9e-9, 0.9e-9]


def test_only_what_is_new_is_given_back(orbit) -> None:
    search = OrbitSearch(Simulations.ALWAYS, starts=3, seed=2)
    found, told = settled_orbits(LOOP, search, [])
    assert len(found) == 1
    assert same(found[0], orbit)
    assert (told.starts, told.planned, told.seed, told.settled) == (3, 3, 2, 3)
    assert (told.at_rest, told.diverged, told.accumulated, told.left) == (0, 0, 0, 0)
    known = [orbit]
    again, _ = settled_orbits(LOOP, search, known)
    assert again == []
    assert known == [orbit]


def test_a_log_begins_with_its_first_segment() -> None:
    log = new_log(3, 1, np.array([1.0, 2.0]))
    assert log.mode.tolist() == [1, 0, 0]


def test_prime_factors() -> None:
    factors = {1: [], 2: [2], 9: [3, 3], 12: [2, 2, 3], 49: [7, 7], 97: [97], 4 * 5 * 11: [2, 2, 5, 11]}
    assert {number: _prime_factors(number) for number in factors} == factors


def test_extremes_of_a_polynomial_on_a_part_of_a_step() -> None:
    coefficients = np.zeros(DEGREE + 1)
    coefficients[:4] = 2.0, -3.0, 0.0, 9.0  # 2 - 3 x + 9 x^3 has its minimum at 1/3.
    low = 2 - 1 + 1 / 3
    assert _extremes_of(coefficients, 1.0) == pytest.approx([2.0, 8.0, low], rel=1e-14)
    assert _extremes_of(coefficients, 0.8) == pytest.approx([2.0, 2 - 2.4 + 9 * 0.512, low], rel=1e-14)
    assert _extremes_of(coefficients, 0.3) == pytest.approx([2.0, 2 - 0.9 + 9 * 0.027], rel=1e-14)
    sine = np.array([math.sin(n * math.pi / 2) * 5.0**n / math.factorial(n) for n in range(DEGREE + 1)])
    ends = [0.0, math.sin(4.9)]
    error = 5.0 ** (DEGREE + 1) / math.factorial(DEGREE + 1)
    assert _extremes_of(sine, 0.98) == pytest.approx([*ends, 1.0, -1.0], abs=10 * error + 1e-12)
