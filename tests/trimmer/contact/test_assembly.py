"""Flow, event functions and hold of modes, against values written out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.contact.assembly import EventFunction, assemble, flow_without_stick, force_of, offset
from trimmer.contact.joint import after_event, decide
from trimmer.contact.machine import Machine, machine_of
from trimmer.contact.statuses import (
    ALWAYS,
    ARRIVED,
    AT_LIMIT,
    BACKWARD,
    BROKEN,
    CONTACT_BROKEN,
    CONTACT_MADE,
    FORWARD,
    FREE,
    JOINTLY,
    LEFT,
    MADE_MINUS,
    MADE_PLUS,
    MINUS,
    NOTHING,
    PLUS,
    RELAXING,
    RELEASED_MINUS,
    RELEASED_PLUS,
    RETURNED,
    STICK,
    STICK_BEGUN,
    STICK_ENDED,
)
from trimmer.contact.transitions import Transition, transition
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Play, Stop

MASS, STIFFNESS, DAMPING, GAP = 0.25, 40.0, 3.0, 6e-2


def one_play(law: ContactLaw) -> Machine:
    """A body of 1/4 kg between a play's walls at +-3 cm; the state is q v (z) 1."""
    play = Play(("ground", "body"), STIFFNESS, DAMPING, GAP, law)
    return machine_of(Mechanism({"body": Body(MASS)}, plays={"slot": play}))[0]


def rows(functions) -> list[tuple[int, int, list[float]]]:
    return [(each.owner, each.action, each.row.tolist()) for each in functions]


def test_a_free_play_meets_either_wall_and_its_spring_brings_them_forward() -> None:
    machine = one_play(ContactLaw.RELAXING)
    free, relaxing = assemble(machine, (FREE,)), assemble(machine, (RELAXING,))
    assert rows(free.functions) == [
        (0, MADE_PLUS, [-1.0, 0.0, 0.0, 0.03]),
        (0, MADE_MINUS, [1.0, 0.0, 0.0, 0.03]),
    ]
    assert rows(relaxing.functions) == [
        (0, MADE_PLUS, [-1.0, 0.0, 1.0, 0.03]),
        (0, MADE_MINUS, [1.0, 0.0, -1.0, 0.03]),
    ]
    assert free.hold.tolist() == np.diag([1.0, 1.0, 0.0, 1.0]).tolist()
    assert relaxing.hold.tolist() == np.eye(4).tolist()
    assert free.flow.tolist() == [[0, 1, 0, 0], [0] * 4, [0] * 4, [0] * 4]
    assert relaxing.flow[2].tolist() == [0.0, 0.0, -STIFFNESS / DAMPING, 0.0]
    assert free.statuses == (FREE,)


@pytest.mark.parametrize(("status", "side"), [(PLUS, 1.0), (MINUS, -1.0)])
def test_in_contact_the_spring_is_the_distance_and_the_force_ends_it(status: int, side: float) -> None:
    mode = assemble(one_play(ContactLaw.RELAXING), (status,))
    force = np.array([STIFFNESS, DAMPING, 0.0, -STIFFNESS * side * 0.03])
    np.testing.assert_allclose(mode.flow[1], -force / MASS, rtol=1e-14)
    assert mode.flow[2].tolist() == [0.0, 1.0, 0.0, 0.0]
    assert mode.hold[2].tolist() == [1.0, 0.0, 0.0, -side * 0.03]
    (function,) = mode.functions
    assert function.action == BROKEN
    np.testing.assert_allclose(function.row, side * force, rtol=1e-14)


@pytest.mark.parametrize(("status", "side"), [(PLUS, 1.0), (MINUS, -1.0)])
def test_a_contact_that_pulls_ends_where_it_began(status: int, side: float) -> None:
    mode = assemble(one_play(ContactLaw.PULLING), (status,))
    assert rows(mode.functions) == [(0, BROKEN, [side, 0.0, -0.03])]
    np.testing.assert_allclose(mode.flow[1], [-160.0, -12.0, 160.0 * side * 0.03], rtol=1e-14)


@pytest.mark.parametrize(("status", "side"), [(RELEASED_PLUS, 1.0), (RELEASED_MINUS, -1.0)])
def test_a_contact_that_was_released_returns_or_is_left(status: int, side: float) -> None:
    mode = assemble(one_play(ContactLaw.TRUNCATED), (status,))
    returned, left = mode.functions
    assert (returned.action, left.action) == (RETURNED, LEFT)
    np.testing.assert_allclose(returned.row, [-side * 40, -side * 3, 40 * 0.03], rtol=1e-14)
    assert left.row.tolist() == [side, 0.0, -0.03]
    assert not mode.flow[1].any()


def test_forces_and_offsets_by_status() -> None:
    machine = one_play(ContactLaw.TRUNCATED)
    statuses = (FREE, PLUS, MINUS, RELEASED_PLUS, RELEASED_MINUS, ALWAYS)
    assert [offset(machine, 0, each) for each in statuses] == [0.0, 0.03, -0.03, 0.03, -0.03, 0.0]
    assert force_of(machine, 0, ALWAYS).tolist() == [40.0, 3.0, 0.0]
    stop = Stop(("ground", "body"), STIFFNESS, 0.0, 0.5)
    only = machine_of(Mechanism({"body": Body(MASS)}, stops={"wall": stop}))[0]
    assert rows(assemble(only, (FREE,)).functions) == [(0, MADE_PLUS, [-1.0, 0.0, 0.5])]
    tight = Play(("ground", "body"), STIFFNESS, DAMPING, 0.0)
    link = assemble(machine_of(Mechanism({"body": Body(MASS)}, plays={"tight": tight}))[0], (ALWAYS,))
    assert link.functions == ()
    assert link.hold[2].tolist() == [1.0, 0.0, 0.0, 0.0]
    np.testing.assert_allclose(link.flow[1], [-160.0, -12.0, 0.0, 0.0], rtol=1e-14)


def rubbing(force: float = 0.0, speed: float = 0.0, wall: float = 0.0) -> tuple[Machine, np.ndarray]:
    """Two bodies of 1/2 and 1/4 kg that rub on each other and on the ground; the state is q1 q2 v1 v2 1."""
    mechanism = Mechanism(
        {"one": Body(0.5), "two": Body(0.25)},
        stops={"wall": Stop(("one", "ground"), 10.0, 0.0, wall)} if wall else {},
        frictions={
            "between": Friction(("one", "two"), 0.6, 0.9),
            "first": Friction(("ground", "one"), 1.0),
            "second": Friction(("two", "ground"), 2.0),
        },
        forces={"push": Force("one", force)},
        start={"one": (0.0, speed)},
    )
    return machine_of(mechanism)[0], np.array([0.0, 0.0, speed, 0.0, 1.0])


def test_sliding_frictions_resist_by_their_kinetic_forces() -> None:
    machine, _ = rubbing(3.0)
    flow = flow_without_stick(machine, (FORWARD, BACKWARD, FORWARD))
    np.testing.assert_allclose(flow[2:4, -1], [(3 + 0.6 + 1) / 0.5, (-0.6 + 2) / 0.25], rtol=1e-14)
    flow = flow_without_stick(machine, (FORWARD, STICK, FORWARD), np.array([0]))
    np.testing.assert_allclose(flow[2:4, -1], [3 / 0.5, 2 / 0.25], rtol=1e-14)
    mode = assemble(machine, (FORWARD, BACKWARD, BACKWARD))
    assert rows(mode.functions) == [
        (0, ARRIVED, [0.0, 0.0, -1.0, 1.0, 0.0]),
        (1, ARRIVED, [0.0, 0.0, -1.0, 0.0, 0.0]),
        (2, ARRIVED, [0.0, 0.0, 0.0, 1.0, 0.0]),
    ]


def test_what_sticks_moves_together_until_its_static_force() -> None:
    machine, _ = rubbing(3.0)
    mode = assemble(machine, (STICK, BACKWARD, FORWARD))
    # Bodies of 3/4 kg together under 3 + 1 + 2 N.
    np.testing.assert_allclose(mode.flow[2:4, -1], [8.0, 8.0], rtol=1e-14)
    np.testing.assert_allclose(mode.hold[2:4, 2:4], [[2 / 3, 1 / 3]] * 2, rtol=1e-14)
    # The second is pulled along by 1/4 kg 8 m/s^2 - 2 N = 0: 0.9 N are left on both sides.
    forward, backward = mode.functions[:2]
    assert (forward.owner, forward.action, forward.signs) == (0, AT_LIMIT, (1, 0, 0))
    assert (backward.owner, backward.action, backward.signs) == (0, AT_LIMIT, (-1, 0, 0))
    np.testing.assert_allclose([forward.row[-1], backward.row[-1]], [0.9, 0.9], rtol=1e-13)
    assert [each.owner for each in mode.functions[2:]] == [1, 2]
    # With the first on the ground pushed by 0.3 N the friction of the ground has 0.7 N left one way.
    alone = assemble(rubbing(0.3)[0], (STICK, STICK, FORWARD))
    left = {(each.owner, each.signs): each.row[-1] for each in alone.functions if each.action == AT_LIMIT}
    assert left == {
        (0, (1, 0, 0)): pytest.approx(0.9 - 2.0),
        (0, (-1, 0, 0)): pytest.approx(0.9 + 2.0),
        (1, (0, 1, 0)): pytest.approx(1.0 - 2.3),
        (1, (0, -1, 0)): pytest.approx(1.0 + 2.3),
    }


def test_in_a_ring_frictions_share_what_they_hold() -> None:
    machine, _ = rubbing(0.3)
    mode = assemble(machine, (STICK, STICK, STICK))
    assert {each.action for each in mode.functions} == {AT_LIMIT}
    np.testing.assert_allclose(mode.flow[2:4], 0.0, atol=1e-14)
    np.testing.assert_allclose(mode.hold[2:4], 0.0, atol=1e-14)
    limits = {each.signs: each.row[-1] for each in mode.functions}
    # One body begins to slide against both its neighbours, or both slide together on the ground.
    assert {tuple(map(abs, signs)) for signs in limits} == {(1, 1, 0), (1, 0, 1), (0, 1, 1)}
    assert all(each.owner == JOINTLY for each in mode.functions)
    assert sorted(limits.values()) == pytest.approx([1.6, 2.2, 2.7, 2.9, 2.9, 3.3])
    # The force of 0.3 N helps the first body to slide forward on the ground.
    assert sorted(left for signs, left in limits.items() if signs[1] == 1) == pytest.approx([1.6, 2.7])


def test_frictions_at_rest_are_decided_together() -> None:
    every = np.arange(3)

    def decided(force: float, statuses=(STICK, STICK, STICK), at_rest=every) -> tuple[int, ...]:
        machine, state = rubbing(force)
        return decide(machine, statuses, state, at_rest)

    assert decided(1.8) == (STICK, STICK, STICK)
    # The static 0.9 N and 1 N give way; then the kinetic 0.6 N are not enough to move the second body.
    assert decided(1.95) == (BACKWARD, FORWARD, STICK)
    assert decided(-1.95) == (FORWARD, BACKWARD, STICK)
    assert decided(9.0) == (BACKWARD, FORWARD, STICK)
    assert decided(-1.5, (FORWARD, STICK, STICK), np.array([1, 2])) == (FORWARD, STICK, STICK)
    assert decided(-1.5, (BACKWARD, STICK, STICK), np.array([1, 2])) == (BACKWARD, BACKWARD, STICK)
    assert decided(0.0, (FORWARD, BACKWARD, FORWARD), np.array([], dtype=np.intp)) == (
        *(FORWARD, BACKWARD, FORWARD),
    )


def test_what_begins_to_slide_at_its_limit() -> None:
    machine, state = rubbing(1.9)
    none = np.zeros(5)
    limit = EventFunction(JOINTLY, AT_LIMIT, none, (-1, 1, 0))
    sticking, every = (STICK, STICK, STICK), np.arange(3)
    # The friction between has a static force: the drop decides what the others do, with one derivative known.
    assert after_event(machine, sticking, state, limit, False, every) == ((BACKWARD, FORWARD, STICK), 1)
    # Without a static force in it nothing drops, and accelerations begin at zero.
    smooth = EventFunction(1, AT_LIMIT, none, (0, 1, 0))
    sliding = (BACKWARD, STICK, STICK)
    assert after_event(machine, sliding, state, smooth, False, np.array([1, 2])) == (
        (BACKWARD, FORWARD, STICK),
        2,
    )
    # A limit that was exceeded at once, or a velocity that came to zero, is decided.
    machine, state = rubbing(9.0)
    assert after_event(machine, sticking, state, smooth, True, every) == ((BACKWARD, FORWARD, STICK), 1)
    machine, state = rubbing(1.0)
    arrived = EventFunction(0, ARRIVED, none)
    assert after_event(machine, (FORWARD, STICK, STICK), state, arrived, False, every) == (sticking, 1)
    # If deciding says that all still hold, the limit says otherwise.
    assert after_event(machine, sticking, state, limit, True, every) == ((BACKWARD, FORWARD, STICK), 1)


CONTACT_CHANGES = [
    (ContactLaw.RELAXING, FREE, MADE_PLUS, False, (PLUS, CONTACT_MADE, BROKEN, 0)),
    (ContactLaw.RELAXING, RELAXING, MADE_MINUS, False, (MINUS, CONTACT_MADE, BROKEN, 0)),
    (ContactLaw.PULLING, FREE, MADE_MINUS, False, (MINUS, CONTACT_MADE, BROKEN, 1)),
    (ContactLaw.RELAXING, PLUS, BROKEN, False, (RELAXING, CONTACT_BROKEN, MADE_PLUS, 2)),
    (ContactLaw.RELAXING, MINUS, BROKEN, True, (RELAXING, CONTACT_BROKEN, MADE_MINUS, 1)),
    (ContactLaw.PULLING, PLUS, BROKEN, False, (FREE, CONTACT_BROKEN, MADE_PLUS, 1)),
    (ContactLaw.PULLING, MINUS, BROKEN, False, (FREE, CONTACT_BROKEN, MADE_MINUS, 1)),
    (ContactLaw.TRUNCATED, PLUS, BROKEN, False, (RELEASED_PLUS, CONTACT_BROKEN, RETURNED, 1)),
    (ContactLaw.TRUNCATED, MINUS, BROKEN, False, (RELEASED_MINUS, CONTACT_BROKEN, RETURNED, 1)),
    (ContactLaw.TRUNCATED, RELEASED_PLUS, RETURNED, False, (PLUS, CONTACT_MADE, BROKEN, 1)),
    (ContactLaw.TRUNCATED, RELEASED_MINUS, RETURNED, False, (MINUS, CONTACT_MADE, BROKEN, 1)),
    (ContactLaw.TRUNCATED, RELEASED_PLUS, LEFT, False, (FREE, NOTHING, MADE_PLUS, 1)),
    (ContactLaw.TRUNCATED, RELEASED_MINUS, LEFT, False, (FREE, NOTHING, MADE_MINUS, 1)),
]


@pytest.mark.parametrize(("law", "status", "action", "jumped", "expected"), CONTACT_CHANGES)
def test_what_follows_an_event_of_a_contact(
    law: ContactLaw, status: int, action: int, jumped: bool, expected: tuple[int, int, int, int]
) -> None:
    after, kind, known, zeros = expected
    machine = one_play(law)
    found = transition(machine, (status,), EventFunction(0, action, np.zeros(3)), jumped)
    assert found == Transition((after,), kind, known, zeros)


def test_what_follows_an_event_of_a_friction() -> None:
    machine, state = rubbing(0.0, wall=0.5)
    assert len(state) == 5

    def follows(statuses, owner: int, action: int, signs=(), jumped: bool = False):
        function = EventFunction(owner, action, np.zeros(5), signs)
        found = transition(machine, (FREE, *statuses), function, jumped)
        return None if found is None else (found.statuses[1:], found.kind, found.action, found.zeros)

    sliding = (FORWARD, BACKWARD, FORWARD)
    assert follows(sliding, 2, ARRIVED) == ((FORWARD, STICK, FORWARD), STICK_BEGUN, -1, 0)
    assert follows((STICK, BACKWARD, FORWARD), 2, ARRIVED) is None
    assert follows((STICK, STICK, STICK), JOINTLY, AT_LIMIT, (1, 1, 0)) is None
    second = (FORWARD, STICK, FORWARD)
    assert follows(second, 2, AT_LIMIT, (0, 1, 0)) == (
        (FORWARD, FORWARD, FORWARD),
        STICK_ENDED,
        ARRIVED,
        2,
    )
    assert follows(second, 2, AT_LIMIT, (0, -1, 0), True) == (sliding, STICK_ENDED, ARRIVED, 1)
    assert follows((STICK, FORWARD, FORWARD), 1, AT_LIMIT, (1, 0, 0))[2:] == (ARRIVED, 1)
    assert follows((STICK, STICK, FORWARD), 2, AT_LIMIT, (0, 1, 0))[2:] == (ARRIVED, 2)
    assert follows((STICK, STICK, FORWARD), 2, AT_LIMIT, (0, 1, 0), True) is None
    assert follows((STICK, STICK, FORWARD), 1, AT_LIMIT, (1, 0, 0)) is None
