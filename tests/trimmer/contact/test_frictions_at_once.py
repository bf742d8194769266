"""Small mechanisms in which several frictions change at one instant, each with an answer on paper.

Two frictions between the same ends are one friction with the sums of their forces; they begin and end to
stick together. What changes at one instant counts once for each part, from what it was to what it is after.
"""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.brute_force import EventKind
from tests.trimmer.contact.exact import ExactMotion, exact_motion
from trimmer import Body, Force, Friction, Mechanism, Pin, Stop
from trimmer.mechanism import Wall

GROUND_TO_BODY = ("ground", "body")


def sliding_body(frictions: dict[str, Friction], **changes) -> Mechanism:
    """A body of 1 kg under a force of 1 Hz."""
    drive = changes.pop("drive", Force("body", amplitude=1.5, phase=1.0))
    start = {"body": (0.0, changes.pop("speed", 1.0))}
    return Mechanism(
        {"body": Body(1.0)}, 1.0, frictions=frictions, forces={"drive": drive}, start=start, **changes
    )


def pair(first: tuple[float, float], second: tuple[float, float]) -> dict[str, Friction]:
    """Two frictions side by side, by their kinetic and static forces."""
    return {
        name: Friction(GROUND_TO_BODY, *forces) for name, forces in (("first", first), ("second", second))
    }


def together(frictions: dict[str, Friction]) -> dict[str, Friction]:
    """The one friction that two are."""
    kinetic = sum(friction.force for friction in frictions.values())
    static = sum(friction.static_force for friction in frictions.values())
    return {"both": Friction(GROUND_TO_BODY, kinetic, static)}


def counted(motion: ExactMotion) -> list[tuple[float, str, EventKind]]:
    return [(round(event.time, 9), event.part, event.kind) for event in motion.events]


PAIRS = {
    "one stops the body alone": pair((1.0, 1.0), (0.6, 0.6)),
    "both are needed": pair((0.8, 0.8), (0.8, 0.8)),
    "the first has a static force": pair((1.0, 1.5), (0.3, 0.3)),
    "the second has a static force": pair((0.5, 0.5), (1.0, 1.3)),
}


@pytest.mark.parametrize("speed", [1.0, 1.7])
@pytest.mark.parametrize("name", list(PAIRS))
def test_two_frictions_side_by_side_stick_together(name, speed):
    frictions = PAIRS[name]
    motion = exact_motion(sliding_body(frictions, speed=speed), 3.0)
    single = exact_motion(sliding_body(together(frictions), speed=speed), 3.0)
    times = np.linspace(0, 3, 31)
    assert motion.states(times) == pytest.approx(single.states(times), abs=1e-12)
    wanted = [(time, part, kind) for time, _, kind in counted(single) for part in frictions]
    assert sorted(counted(motion), key=str) == sorted(wanted, key=str)


def test_a_body_stays_where_two_static_forces_hold_it():
    """1.2 N brings it to rest; a kinetic 1.0 N would let it go back, a static 1.5 N holds it."""
    frictions = pair((0.5, 1.0), (0.5, 0.5))
    mechanism = sliding_body(frictions, drive=Force("body", constant=-1.2))
    motion = exact_motion(mechanism, 2.0)
    assert motion.states(np.array([0.6, 2.0])) == pytest.approx(
        np.array([[0.5 / 2.2, 0.0], [0.5 / 2.2, 0.0]]), abs=1e-14
    )
    assert counted(motion) == [(round(1 / 2.2, 9), name, EventKind.STICK_BEGUN) for name in frictions]


@pytest.mark.parametrize("first", ["between", "on ground", "wall on ground"])
def test_a_body_stays_where_the_ground_and_a_wall_at_rest_hold_it(first):
    """The same, with one of the frictions on a second body that sticks; in any order of the file."""
    frictions = {
        "between": Friction(("wall", "body"), 0.5, 1.0),
        "on ground": Friction(("body", "ground"), 0.5),
        "wall on ground": Friction(("ground", "wall"), 10.0),
    }
    mechanism = Mechanism(
        {"body": Body(1.0), "wall": Body(1.0)},
        1.0,
        frictions={first: frictions[first]} | frictions,
        forces={"pull": Force("body", -1.2)},
        start={"body": (0.0, 1.0)},
    )
    motion = exact_motion(mechanism, 2.0)
    assert motion.states(np.array([2.0]))[0, :2] == pytest.approx([0.5 / 2.2, 0.0], abs=1e-14)
    stopped = round(1 / 2.2, 9)
    assert sorted(counted(motion), key=str) == [
        (stopped, name, EventKind.STICK_BEGUN) for name in ("between", "on ground")
    ]


def test_a_pair_begins_to_slide_beside_two_stops_that_are_far_away():
    far = Stop(GROUND_TO_BODY, 1.0, 0.0, 100.0)
    drive = Force("body", amplitude=2.0)
    mechanism = sliding_body(
        pair((0.5, 0.5), (0.5, 0.5)),
        drive=drive,
        speed=0.0,
        stops={"far": far, "farther": replace(far, gap=200.0)},
    )
    motion = exact_motion(mechanism, 0.2)
    released = round(math.asin(0.5) / (2 * math.pi), 9)
    assert counted(motion) == [(released, name, EventKind.STICK_ENDED) for name in ("first", "second")]


def test_a_body_that_sticks_to_the_ground_while_a_table_turns_back():
    """The table's friction cannot move the body: it reverses whenever the table does."""
    mechanism = Mechanism(
        {"body": Body(1.0)},
        1.0,
        pins={"table": Pin("ground", 0.01, 0.3)},
        frictions={"on table": Friction(("table", "body"), 0.2), "on ground": Friction(GROUND_TO_BODY, 1.0)},
    )
    motion = exact_motion(mechanism, 2.0)
    turns = [(math.pi * (place + 0.5) - 0.3) / (2 * math.pi) for place in range(4)]
    assert counted(motion) == [(round(t, 9), "on table", EventKind.SLIDING_REVERSED) for t in turns]
    assert np.all(motion.states(np.linspace(0, 2, 21)) == 0)


def test_a_body_on_a_table_and_on_the_ground_from_rest_of_both():
    """At t = 0 the table is at rest as well; only its acceleration tells which friction slides."""
    mechanism = Mechanism(
        {"body": Body(1.0)},
        1.0,
        pins={"table": Pin("ground", 0.01, math.pi / 2)},
        frictions={"on table": Friction(("table", "body"), 0.2), "on ground": Friction(GROUND_TO_BODY, 1.0)},
    )
    motion = exact_motion(mechanism, 1.2)
    assert counted(motion) == [(t, "on table", EventKind.SLIDING_REVERSED) for t in (0.5, 1.0)]


def test_a_body_is_pulled_off_the_ground_when_the_table_turns_back():
    """It sticks to the ground with the table's help; when that turns, both frictions change at once."""
    mechanism = Mechanism(
        {"body": Body(1.0)},
        1.0,
        pins={"table": Pin("ground", 0.01, 1.48)},
        frictions={
            "on table": Friction(("body", "table"), 0.142),
            "on ground": Friction(("body", "ground"), 0.725),
        },
        forces={"drive": Force("body", -0.322, 1.061, 4.4126)},
    )
    turned = round((1.5 * math.pi - 1.48) / (2 * math.pi), 9)
    events = [event for event in counted(exact_motion(mechanism, 1.0)) if event[0] == turned]
    assert events == [
        (turned, "on table", EventKind.SLIDING_REVERSED),
        (turned, "on ground", EventKind.STICK_ENDED),
    ]


@pytest.mark.parametrize("wall", [None, 0.1])
def test_stick_lasts_beside_a_friction_that_turns_back_within_its_kinetic_force(wall):
    """The slider never rests, so that its static force, which would tear the block off, is never there.

    On the block: 1.2 of the load, 0.8 of the slider one way and then the other, and so 2.0 of 2.2 held.
    A wall without rebound may turn the slider back before.
    """
    mechanism = Mechanism(
        {"block": Body(1.0), "slider": Body(1.0)},
        frictions={
            "table": Friction(("ground", "block"), 1.4, 2.2),
            "back": Friction(("block", "slider"), 0.8, 1.1),
        },
        walls={} if wall is None else {"wall": Wall(("ground", "slider"), 0.0, wall)},
        forces={"load": Force("block", constant=-1.2), "pull": Force("slider", constant=-2.0)},
        start={"slider": (0.0, 1.0)},
    )
    motion = exact_motion(mechanism, 1.0)
    turns = 1.0 / 2.8 if wall is None else (1.0 - math.sqrt(1.0 - 5.6 * wall)) / 2.8
    after, events = 1.0 - turns, [event for event in motion.events if event.part != "wall"]
    assert [(event.part, event.kind) for event in events] == [("back", EventKind.SLIDING_REVERSED)]
    assert events[0].time == pytest.approx(turns, rel=1e-12)
    expected = [0.0, turns - 1.4 * turns**2 - 0.6 * after**2, 0.0, -1.2 * after]
    assert motion.states(np.array([1.0])).ravel() == pytest.approx(expected, rel=1e-12, abs=1e-15)
