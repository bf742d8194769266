"""What the integration of exact motion leaves to decide, step by step: two bodies with frictions, by hand."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from trimmer.contact.advance import MOST_STEPS, Ending, _Progress
from trimmer.contact.flow import ExactFlow
from trimmer.contact.integration import Place
from trimmer.contact.statuses import (
    ARRIVED,
    AT_LIMIT,
    BACKWARD,
    FORWARD,
    FREE,
    JOINTLY,
    KINDS,
    MADE_PLUS,
    NOTHING,
    REVERSED,
    STICK,
    STICK_BEGUN,
    STICK_ENDED,
)
from trimmer.contact.step_event import NO_EVENT
from trimmer.contact.tabulated_change import AT_REST
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force, Friction, Pin, Stop


def bodies(push: float = 0.0, static: float = 0.8) -> ExactFlow:
    """Two bodies, 0.5 and 2 kg, each with friction on the ground, and a wall far away before the first."""
    return ExactFlow(
        Mechanism(
            {"one": Body(0.5), "two": Body(2.0)},
            frequency=4.0,
            pins={"belt": Pin("ground", velocity=0.25)},
            stops={"far": Stop(("belt", "one"), 1.0, 0.0, 99.0)},
            frictions={
                "first": Friction(("ground", "one"), 0.8, static, viscous=0.3),
                "second": Friction(("ground", "two"), 0.6),
            },
            forces={"push": Force("one", push, 1.0)},
        )
    )


def progress(flow: ExactFlow, statuses: tuple[int, int], *velocities: float, periods: int = 2) -> _Progress:
    instant = flow.rest()
    state = np.array([0.0, 0.0, *velocities])
    instant = replace(instant, state=state, statuses=(FREE, *statuses), known_zeros=0 * instant.known_zeros)
    found = _Progress(flow.modes, instant, periods, flow.period, True)
    found.work.state[4:] = flow.modes.layout.forcing_at(0.0)
    return found


def event(at: _Progress, action: int, owner: int, jumped: bool = False, row: int = 3) -> Place:
    """Return the place at which an event function of the present mode has fallen to zero."""
    functions = at.modes[at.mode].functions
    fired = next(k for k, each in enumerate(functions) if (each.action, each.owner) == (action, owner))
    return Place(1, row, at.mode, 0.125, 77, fired, jumped)


def test_it_begins_with_what_an_instant_holds() -> None:
    flow = bodies()
    instant = replace(
        flow.rest({"one": (0.1, 0.2), "two": (0.3, 0.4)}),
        periods=3,
        phase=0.05,
        known_zeros=np.array([1, 2, 3]),
        known_action=np.array([4, 5, 6]),
        negligible=np.array([7e-17]),
    )
    begun = _Progress(flow.modes, instant, 2, flow.period, False)
    assert begun.work.state[:4].tolist() == begun.states[0].tolist() == [0.1, 0.3, 0.2, 0.4]
    assert begun.work.known_zeros.tolist() == [1, 2, 3]
    assert begun.work.known_action.tolist() == [4, 5, 6]
    assert begun.work.negligible.tolist() == [7e-17]
    assert begun.states.shape == (3, 4)
    assert begun.counts.tolist() == [[0] * KINDS] * 2
    assert (begun.begin, begun.length, begun.keeps) == (0.05, 0.25, False)
    # Sine, cosine, the time of the belt since the start, and one.
    angle = 2 * np.pi * 4.0 * 0.05
    assert begun._forcing() == pytest.approx([np.sin(angle), np.cos(angle), 3 * 0.25 + 0.05, 1.0])


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_frictions_whose_velocities_are_rounding_are_at_rest(side: float) -> None:
    there = FORWARD if side > 0 else BACKWARD
    at = progress(bodies(), (there, there), side * 0.1, side * 0.2)
    assert at._at_rest(None).tolist() == []
    assert at._at_rest(2).tolist() == [1]
    at.work.known_zeros[1] = 2
    assert at._at_rest(None).tolist() == [0]
    assert at._at_rest(2).tolist() == [0, 1]
    assert progress(bodies(), (STICK, there), 0.0, side)._at_rest(None).tolist() == [0]
    assert progress(bodies(), (there, STICK), 0.0, 0.0)._at_rest(None).tolist() == [0, 1]
    # A velocity with the other sign is none of rest.
    assert progress(bodies(), (there, there), -0.1, -0.2)._at_rest(None).tolist() == []
    # The friction of 0.6 N changes the velocity of 2 kg by 0.3 m/s in a second.
    at = progress(bodies(), (there, there), 0.1, 0.0)
    change = AT_REST * 0.3 * at.modes.tables.step[at.mode]
    for share, rests in ((0.9, [1]), (1.1, [])):
        at.work.state[3] = share * side * change
        assert at._at_rest(None).tolist() == rests
    # The first one has a damper too, which is not counted: it acts in the second derivative.
    change = AT_REST * 0.8 / 0.5 * at.modes.tables.step[at.mode]
    at.work.state[2:4], at.work.state[4:6] = (1.01 * side * change, 1.0), (0.0, 0.0)
    assert at._at_rest(None).tolist() == []
    at.work.state[2] = 0.99 * side * change
    assert at._at_rest(None).tolist() == [0]


def changed(at: _Progress, after: tuple[int, int], zeros: int = 1) -> int:
    before = at.modes[at.mode].statuses
    place = Place(1, 3, at.mode, 0.125, 77, 5)
    return at._change_together(place, (before, (FREE, *after)), zeros, np.array([0, 1]))


def test_each_part_that_changes_gets_a_row() -> None:
    at = progress(bodies(), (STICK, FORWARD), 1e-17, 1e-17)
    at.work.known_zeros[:] = 9
    assert changed(at, (FORWARD, STICK)) == 5
    assert at.modes[at.mode].statuses == (FREE, FORWARD, STICK)
    assert at.work.state[2:4].tolist() == [1e-17, 0.0]
    assert at.log.start[3:5].tolist() == [0.125, 0.125]
    assert at.log.mode[3:5].tolist() == [at.mode] * 2
    assert (at.log.state[3:5] == at.work.state).all()
    assert at.log.part[3:5].tolist() == [1, 2]
    assert at.log.kind[3:5].tolist() == [STICK_ENDED, STICK_BEGUN]
    assert at.log.function[3:5].tolist() == [5, NO_EVENT]
    assert at.counts[0].sum() == 0
    assert at.counts[1, [STICK_ENDED, STICK_BEGUN]].tolist() == [1, 1]
    assert at.counts.sum() == 2
    assert at.work.known_zeros.tolist() == [9, 1, 0]
    assert at.work.known_action[1] == ARRIVED


def test_what_is_known_of_those_at_rest() -> None:
    for zeros, known in ((1, [9, 1, 1]), (2, [9, 2, 9])):
        at = progress(bodies(), (STICK, FORWARD), 0.0, 0.0)
        at.work.known_zeros[:], at.work.known_action[:] = 9, 8
        assert changed(at, (BACKWARD, FORWARD), zeros) == 4
        assert at.work.known_zeros.tolist() == known
        assert at.work.known_action.tolist() == [8, ARRIVED, ARRIVED if zeros == 1 else 8]
    at = progress(bodies(), (FORWARD, FORWARD), 0.0, 0.0)
    assert changed(at, (BACKWARD, FORWARD)) == 4
    assert at.counts[1, REVERSED] == 1


def test_no_change_is_a_row_as_well() -> None:
    at = progress(bodies(), (FORWARD, FORWARD), 0.0, 0.0)
    assert changed(at, (FORWARD, FORWARD)) == 4
    assert (at.log.part[3], at.log.kind[3], at.log.function[3]) == (-1, NOTHING, 5)
    assert at.counts[1].tolist() == [int(kind == NOTHING) for kind in range(KINDS)]


def test_what_the_statuses_decide_is_only_tabulated() -> None:
    contact = progress(bodies(), (STICK, STICK), 0.0, 0.0)
    place = event(contact, MADE_PLUS, 0)
    assert contact._decided(place) is place
    arrived = progress(bodies(), (FORWARD, FORWARD), 0.0, 0.4)
    place = event(arrived, ARRIVED, 1)
    assert arrived._decided(place) is place
    target = int(arrived.modes.tables.target[arrived.mode, place.fired, 0])
    assert arrived.modes[target].statuses == (FREE, STICK, FORWARD)
    # Its limit is reached while the other one sticks: it slides, and nothing else changes.
    limit = progress(bodies(0.8), (STICK, STICK), 0.0, 0.0)
    place = event(limit, AT_LIMIT, 1)
    assert limit._decided(place) is place


def test_what_several_at_rest_decide_together() -> None:
    at = progress(bodies(2.0), (BACKWARD, FORWARD), 0.0, 0.0)
    found = at._decided(event(at, ARRIVED, 1))
    assert (found.row, found.fired, found.jumped, found.mode) == (5, NO_EVENT, False, at.mode)
    assert (found.done, found.time, found.steps_left) == (1, 0.125, 77)
    assert at.modes[at.mode].statuses == (FREE, FORWARD, STICK)
    assert at.log.kind[3:5].tolist() == [REVERSED, STICK_BEGUN]
    # A limit that was exceeded at once.
    at = progress(bodies(2.0), (STICK, STICK), 0.0, 0.0)
    found = at._decided(event(at, AT_LIMIT, 1, jumped=True))
    assert (found.row, found.fired, found.jumped) == (4, NO_EVENT, False)
    assert at.modes[at.mode].statuses == (FREE, FORWARD, STICK)
    # One with a static force that drops, beside another one that sticks.
    at = progress(bodies(1.0, static=1.0), (STICK, STICK), 0.0, 0.0)
    found = at._decided(event(at, AT_LIMIT, 1))
    assert (found.row, found.fired) == (4, NO_EVENT)
    assert at.work.known_zeros[1] == 1


def test_there_is_room_for_all_that_change() -> None:
    at = progress(bodies(2.0), (BACKWARD, FORWARD), 0.0, 0.0)
    rows = len(at.log.start)
    assert at._decided(event(at, ARRIVED, 1, row=rows)).row == rows + 2
    assert at.log.kind[rows : rows + 2].tolist() == [REVERSED, STICK_BEGUN]


def test_modes_with_more_event_functions_find_room() -> None:
    # Three bodies that rub on each other and on the ground: seven of their cuts can slide, to both sides.
    ends = ["ground", "a", "b", "c"]
    pairs = [(start, end) for place, end in enumerate(ends) for start in ends[:place]]
    mechanism = Mechanism(
        {name: Body(1.0) for name in "abc"},
        frictions={f"{start} {end}": Friction((start, end), 0.1) for start, end in pairs},
        start={"a": (0.0, 0.1), "b": (0.0, 0.2), "c": (0.0, 0.4)},
    )
    flow = ExactFlow(mechanism)
    at = _Progress(flow.modes, flow.rest(), 1, 9.0, True)
    begun = flow.modes.tables.screen.shape[2]
    stretch = at.run(MOST_STEPS)
    assert stretch.ending is Ending.REACHED_END
    assert stretch.end.statuses == (STICK,) * 6
    assert not stretch.end.state[3:].any()
    assert {each.owner for each in flow.modes[at.mode].functions} == {JOINTLY}
    assert len(flow.modes[at.mode].functions) == 14
    assert len(at.work.screened) == flow.modes.tables.screen.shape[2] > begun


@pytest.mark.parametrize(
    ("begin", "length", "done", "time", "expected"),
    [
        (0.25, 0.25, 1, 0.0, (1, 0.0)),
        (0.25, 0.25, 0, 0.125, (0, 0.375)),
        (0.25, 0.5, 3, 0.125, (3, 0.375)),
        (0.25, 0.375, 1, 0.0, (1, 0.125)),
    ],
)
def test_periods_and_phase(
    begin: float, length: float, done: int, time: float, expected: tuple[int, float]
) -> None:
    layout = SimpleNamespace(layout=SimpleNamespace(period=0.5))
    at: Any = SimpleNamespace(modes=layout, begin=begin, length=length)
    assert _Progress._reached(at, done, time) == expected
    layout.layout.period = 0.0
    assert _Progress._reached(at, done, time) == (0, begin + done * length + time)
