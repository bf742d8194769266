"""The map of a mechanism that moves by itself, on a block on a belt whose motion is known."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.maps.machines import linear_oscillator
from trimmer.branches.period_maps.self_excited_map import (
    Section,
    SelfExcitedMap,
    SelfExcitedPassage,
    _halvings,
    section_at,
    with_trivial,
)
from trimmer.contact.flow import ExactFlow
from trimmer.errors import UnsupportedMotionError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Friction, Link, Output, Pin

OMEGA = 7.5
RESPONSE = 100.0 / (40.0 - OMEGA**2 + 0.1j * math.sqrt(40.0) * OMEGA)
SPEED = "pins.belt.velocity"
PERIOD = 2.0 * (math.pi - math.atan(0.5 / 0.2)) + 1.0 / 0.2


def settled_state() -> np.ndarray:
    return np.array([RESPONSE.real, (1j * OMEGA * RESPONSE).real])


def belt() -> Mechanism:
    """A block on a belt with static friction 1 and kinetic friction 0.5: its motion is known."""
    return Mechanism(
        bodies={"block": Body(1.0)},
        pins={"belt": Pin("ground", velocity=0.2)},
        links={"spring": Link(("ground", "block"), 1.0)},
        frictions={"rubbing": Friction(("belt", "block"), force=0.5, static=1.0)},
        outputs={"block": Output({"block": 1.0})},
    )


def test_the_period_of_a_motion_without_a_drive_is_a_part_of_the_state() -> None:
    map = SelfExcitedMap(belt(), SPEED, 0.2)
    assert map.size == 3
    # Slipping begins at x = 1 with the velocity of the belt; here amid the stick.
    state = np.array([0.7, 0.2, PERIOD])
    passage = map.passage(0.2, state)
    assert passage.end == pytest.approx(state, abs=1e-9)
    assert passage.course.duration == pytest.approx(PERIOD, rel=1e-14)
    assert passage.sizes[-1] == PERIOD
    assert passage.sizes[0] == pytest.approx(0.5 + math.hypot(0.5, 0.2), rel=1e-3)
    section = passage.section
    # The block moves with the belt: the plane is across its displacement, which grows.
    assert section.point == pytest.approx([0.7, 0.2], rel=1e-9)
    assert section.period == pytest.approx(PERIOD, rel=1e-12)
    assert section.normal[0] == pytest.approx(1.0 / passage.sizes[0], rel=1e-9)
    assert section.normal[1] == pytest.approx(0.0, abs=1e-12)
    assert section.height(np.array([[0.8, 9.0], [0.5, 0.0]])) == pytest.approx(
        np.array([0.1, -0.2]) / passage.sizes[0], rel=1e-9
    )
    assert passage.slant == pytest.approx(1.0, rel=1e-12)
    held = replace(map, section=replace(section, point=section.point - [0.1, 0.0]))
    late = held.passage(0.2, state)
    assert late.end[-1] == pytest.approx(PERIOD * (1.0 + 0.1 / passage.sizes[0]), rel=1e-9)
    # Where it sticks neither state has a say in what comes after; the period moves the end along.
    jacobian = late.jacobian
    assert jacobian[:2, 2] == pytest.approx([0.2, 0.0], abs=1e-12)
    assert jacobian[2] == pytest.approx([PERIOD / passage.sizes[0], 0.0, 1.0], abs=1e-9)
    assert abs(late.monodromy).max() < 1e-9
    twice = replace(map, periods=2).passage(0.2, state)
    assert twice.course.duration == pytest.approx(2.0 * PERIOD, rel=1e-14)
    assert twice.jacobian[:2, 2] == pytest.approx([0.4, 0.0], abs=1e-12)
    assert twice.section.period == pytest.approx(PERIOD, rel=1e-12)


def test_the_return_to_the_plane_is_the_motion_less_what_leads_along() -> None:
    change, rate = np.array([[0.5, 2.0], [-1.0, 0.25]]), np.array([3.0, -4.0])
    section = Section(np.zeros(2), np.array([2.0, 0.5]), 5.0)
    passage = SimpleNamespace(section=section, _end_rate=rate, _change=change, map=SimpleNamespace(periods=3))
    found = SelfExcitedPassage.monodromy.func(passage)  # type: ignore[attr-defined]
    # The motion rises by 4 a second; a start aside ends (0.5, 4.125) higher.
    wanted = change - np.outer(rate, [0.5, 4.125]) / 4.0
    assert found[:2, :2] == pytest.approx(wanted, rel=1e-14)
    assert not found[2].any() and not found[:, 2].any()
    jacobian = SelfExcitedPassage.jacobian.func(passage)  # type: ignore[attr-defined]
    assert jacobian.tolist() == [[0.5, 2.0, 9.0], [-1.0, 0.25, -12.0], [10.0, 2.5, 1.0]]


def test_the_period_at_the_end_is_longer_by_how_far_the_start_is_beyond_the_plane() -> None:
    section = Section(np.array([1.0, 2.0]), np.array([0.5, -0.25]), 4.0)
    course = SimpleNamespace(end=SimpleNamespace(state=np.array([8.0, 9.0])))
    passage = SimpleNamespace(section=section, course=course, start=np.array([3.0, 6.0, 7.0]))
    # It is 0.5 * 2 - 0.25 * 4 = 0 beyond, and then 0.5 * 2 - 0.25 * 3.
    end = SelfExcitedPassage.end.fget  # type: ignore[attr-defined]
    assert end(passage).tolist() == [8.0, 9.0, 7.0]
    passage.start = np.array([3.0, 5.0, 7.0])
    assert end(passage).tolist() == [8.0, 9.0, 8.0]


def test_half_of_a_doubled_motion_has_the_period_too() -> None:
    state = np.array([0.7, 0.2, PERIOD])
    map = SelfExcitedMap(belt(), SPEED, 0.2)
    assert map.passage(0.2, state).middle is None
    middle = map.doubled().passage(0.2, state).middle
    assert middle == pytest.approx([0.7, 0.2, PERIOD], abs=1e-9)


def test_an_orbit_may_begin_where_it_rises_through_the_plane(monkeypatch: pytest.MonkeyPatch) -> None:
    def states(times: np.ndarray) -> np.ndarray:
        # Up through zero at 1, where something happens, down at 2, and up at 3.25.
        x = np.interp(times, [0.0, 1.0, 1.5, 2.5, 4.0], [-1.0, 0.0, 1.0, -1.0, 1.0])
        return np.column_stack([x, 10.0 + times, 99.0 + 0.0 * times])

    course = SimpleNamespace(states=states, duration=4.0, log=SimpleNamespace(start=np.array([0.0, 1.0])))
    monkeypatch.setattr(SelfExcitedMap, "passage", lambda *_: SimpleNamespace(course=course))
    section = Section(np.zeros(2), np.array([1.0, 0.0]), 4.0)
    map = SelfExcitedMap(belt(), SPEED, 0.2, section=section)
    found = map.phases(0.2, np.array([5.0, 6.0, 4.0]))
    assert np.array(found) == pytest.approx(np.array([[0.0, 11.0, 4.0], [0.0, 13.25, 4.0]]), abs=1e-10)


def test_a_period_far_from_that_of_the_plane_is_lost() -> None:
    section = Section(np.array([0.7, 0.2]), np.array([1.0, 0.0]), 5.0)
    map = SelfExcitedMap(belt(), SPEED, 0.2, section=section)
    for period in (1.24, 20.1):
        with pytest.raises(UnsupportedMotionError, match="too far"):
            map.passage(0.2, np.array([0.7, 0.2, period]))
    for period in (1.26, 19.9):
        assert map.passage(0.2, np.array([0.7, 0.2, period])).start[-1] == period


def test_an_orbit_is_made_to_begin_amid_its_longest_segment() -> None:
    map = SelfExcitedMap(belt(), SPEED, 0.2)
    # It sticks for longer than it slips: orbits begin amid the stick, at x = 0.5.
    # Here 0.1 s after it has begun to slip, which is too near to that.
    after = 0.1
    displacement = 0.5 + 0.5 * math.cos(after) + 0.2 * math.sin(after)
    slipping = np.array([displacement, 0.2 * math.cos(after) - 0.5 * math.sin(after), PERIOD])
    restart = map.passage(0.2, slipping).restart(np.zeros(4))
    assert restart is not None
    other, state = restart.map, restart.state
    assert isinstance(other, SelfExcitedMap)
    assert other.section is not None
    assert state == pytest.approx([0.5, 0.2, PERIOD], abs=1e-9)
    assert other.section.point == pytest.approx([0.5, 0.2], abs=1e-9)
    assert other.passage(0.2, state).restart(np.zeros(4)) is None
    # It passes the plane upwards once in a period, at that state.
    (phase,) = other.phases(0.2, slipping)
    assert phase == pytest.approx([0.5, 0.2, PERIOD], abs=1e-8)
    assert map.phases(0.2, slipping)[0] is slipping
    doubled = map.doubled()
    assert isinstance(doubled, SelfExcitedMap)
    whole = doubled.passage(0.2, slipping).restart(np.zeros(4))
    assert whole is not None
    assert whole.map.single.section is whole.map.section  # type: ignore[union-attr, attr-defined]
    # A plane along the motion is turned.
    section = replace(other.section, normal=other.section.normal[::-1] * [0.0, 1.0] + [0.0, 1.0])
    turned = replace(map, section=section).passage(0.2, state).restart(np.zeros(4))
    assert turned is not None
    assert turned.map.section is not section  # type: ignore[attr-defined]


def starting(duration: float, *starts: float) -> float:
    course = SimpleNamespace(log=SimpleNamespace(start=np.array(starts)), duration=duration)
    return SelfExcitedPassage.better_start.fget(SimpleNamespace(course=course))  # type: ignore[attr-defined, no-any-return]


@pytest.mark.parametrize(
    ("duration", "starts", "time"),
    [
        (10.0, (0.0,), 0.0),
        # Its own segment from 7 over the end to 2: two fifths of it lie behind the beginning.
        (10.0, (0.0, 2.0, 7.0), 0.0),
        # The own one is a fifth of the longest, which is from 1 to 9.5.
        (10.0, (0.0, 1.0, 9.5), 5.25),
        (10.0, (0.0, 1.0, 3.0, 9.5), 6.25),
        # Its beginning is too near to the ends of its own: amid that, if it is the longest.
        (10.0, (0.0, 0.5, 4.5), 7.5),
        (10.0, (0.0, 5.5, 9.5), 2.5),
        (10.0, (0.0, 0.2, 6.0), 3.1),
        # It holds the events of one instant once.
        (10.0, (0.0, 2.0, 2.0, 7.0, 7.0), 0.0),
        (10.0, (0.0, 5.0), 0.0),
        (10.0, (0.0, 9.5), 4.5),
        (10.0, (0.0, 1.0), 6.0),
    ],
)
def test_where_an_orbit_had_better_begin(duration: float, starts: tuple[float, ...], time: float) -> None:
    assert starting(duration, *starts) == pytest.approx(time, rel=1e-12)


def test_sequences_that_are_made_of_like_halves() -> None:
    lists = (
        [],
        [1],
        [1, 2],
        [1, 1],
        [1, 2, 1, 2],
        [1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3],
        [1, 1, 1],
        [1, 2, 2, 1],
    )
    assert [_halvings(each) for each in lists] == [0, 0, 0, 1, 1, 2, 0, 0]
    events = [(0.0, 0, 5), (0.1, 1, 4), (0.2, 0, 5), (0.3, 1, 4), (0.4, 1, 4), (0.5, 1, 4)]
    passage = SimpleNamespace(course=SimpleNamespace(events=events))
    assert SelfExcitedPassage.halvings.fget(passage) == 1  # type: ignore[attr-defined]
    passage.course.events = []
    assert SelfExcitedPassage.halvings.fget(passage) == 0  # type: ignore[attr-defined]


def test_the_multiplier_of_a_shift_in_time_takes_the_place_of_two_zeros() -> None:
    found = with_trivial(np.array([-2.0, 0.5j, 1e-17, 0.0]))
    assert found.tolist() == [-2.0, 1.0, 0.5j]


def test_a_plane_across_a_motion_at_a_time() -> None:
    flow = ExactFlow(linear_oscillator())
    course = flow.course(flow.at(settled_state()), 1)
    time = 0.3
    section = section_at(course, time, 1)
    turn = np.exp(1j * OMEGA * time) * RESPONSE
    assert section.point == pytest.approx([turn.real, (1j * OMEGA * turn).real], rel=1e-10)
    rates = np.array([(1j * OMEGA * turn).real / OMEGA, -OMEGA * turn.real / OMEGA]) / abs(RESPONSE)
    assert section.normal * [1.0, OMEGA] * abs(RESPONSE) == pytest.approx(rates, rel=3e-3)
    assert section_at(course, time, 2).period == pytest.approx(0.5 * section.period, rel=1e-14)
