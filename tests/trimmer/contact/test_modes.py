"""The modes of a mechanism by number, and the tables that they are written into."""

from __future__ import annotations

from itertools import combinations, product

import numpy as np
import pytest
import scipy.linalg

from trimmer.contact import tables as module
from trimmer.contact.machine import machine_of
from trimmer.contact.statuses import (
    ARRIVED,
    BACKWARD,
    BROKEN,
    CONTACT_MADE,
    FORWARD,
    FREE,
    MADE_MINUS,
    MADE_PLUS,
    MINUS,
    PLUS,
    RELAXING,
    STICK,
)
from trimmer.contact.tables import JOINT, UNKNOWN, Modes
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Friction, Link, Play, Stop
from trimmer.motion.taylor import DEGREE

BETWEEN = ("ground", "body")
AT_REST, RELAXED = (RELAXING, FREE, FORWARD), (FREE, FREE, FORWARD)


def modes_of(frictions: int = 1) -> Modes:
    """A body of 2 kg in a slot of 6 cm, before a stop at 0.5 m, on some floors; the state is q, v, z, 1."""
    return Modes(
        *machine_of(
            Mechanism(
                {"body": Body(2.0)},
                plays={"slot": Play(BETWEEN, 40.0, 3.0, 0.06)},
                stops={"wall": Stop(BETWEEN, 5.0, 0.0, 0.5)},
                frictions={f"floor {i}": Friction(BETWEEN, 1.0 + i) for i in range(frictions)},
            )
        )
    )


def test_a_mode_is_numbered_once_after_the_one_it_relaxes_to() -> None:
    modes = modes_of()
    assert (modes.number(AT_REST), modes.number(RELAXED), modes.number(AT_REST)) == (1, 0, 1)
    assert modes.number((PLUS, FREE, FORWARD)) == 2
    tables = modes.tables
    assert tables.settled[:4].tolist() == [0, 0, 2, UNKNOWN]
    assert tables.statuses[:3].tolist() == [list(RELAXED), list(AT_REST), [PLUS, FREE, FORWARD]]
    assert [modes[number].statuses for number in range(2)] == [RELAXED, AT_REST]
    np.testing.assert_allclose(tables.relaxation[:3], [[0, 0], [40 / 3, 0], [0, 0]], rtol=1e-15)
    assert tables.gap.tolist() == [0.03, 0.5]
    assert tables.relaxing_state.tolist() == [2, -1]


def test_the_tables_of_a_mode() -> None:
    modes = modes_of()
    modes.number(RELAXED)
    number = modes.number((PLUS, FREE, FORWARD))
    tables, state = modes.tables, np.array([0.05, 0.7, 9.0, 1.0])
    assert tables.function_count[:3].tolist() == [4, 3, UNKNOWN]
    assert tables.owner[0].tolist() == [0, 0, 1, 2, UNKNOWN, UNKNOWN]
    assert tables.action[0].tolist() == [MADE_PLUS, MADE_MINUS, MADE_PLUS, ARRIVED, UNKNOWN, UNKNOWN]
    # In contact the spring is as long as the body is beyond the slot.
    np.testing.assert_allclose(state @ tables.hold[number], [0.05, 0.7, 0.02, 1.0], rtol=1e-14)
    # 2 q'' = -40 (q - 0.03) - 3 q' - 1, and z' = q'.
    flow = np.array([[0, 1, 0, 0], [-20, -1.5, 0, 0.1], [0, 1, 0, 0], [0, 0, 0, 0]])
    np.testing.assert_allclose(modes[number].flow, flow, rtol=1e-14, atol=1e-15)
    whole = scipy.linalg.expm(flow * tables.step[number])
    np.testing.assert_allclose(tables.screen[number, :, :4], whole.T, rtol=1e-11, atol=1e-13)
    rows = [state @ tables.taylor[0, function, :, 0] for function in range(4)]
    assert rows == pytest.approx([-0.02, 0.08, 0.45, 0.7], rel=1e-13)


def test_there_is_room_for_more_modes_and_what_was_known_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "CAPACITY", 2)
    modes, roomy = modes_of(), modes_of()
    listed = [RELAXED, AT_REST, (PLUS, FREE, FORWARD), (MINUS, FREE, STICK), (FREE, PLUS, FORWARD)]
    capacities = []
    for statuses in listed:
        modes.number(statuses)
        capacities.append(len(modes.tables.step))
        if statuses == AT_REST:
            modes.follow(0, 0, False)
    assert capacities == [2, 2, 4, 4, 8]
    assert modes.tables.target[0, 0].tolist() == [2, UNKNOWN]
    monkeypatch.setattr(module, "CAPACITY", 12)
    for statuses in listed:
        roomy.number(statuses)
    for name in ("statuses", "settled", "step", "terms", "series", "hold", "owner", "relaxation"):
        np.testing.assert_array_equal(
            getattr(modes.tables, name)[:5], getattr(roomy.tables, name)[:5], err_msg=name
        )
    for number, count in enumerate(modes.tables.function_count[:5]):
        for name in ("taylor", "sizes"):
            of_both = (getattr(each.tables, name)[number, :count] for each in (modes, roomy))
            np.testing.assert_array_equal(*of_both, err_msg=name)
        width = 4 + count * (DEGREE + 1)
        np.testing.assert_array_equal(*(each.tables.screen[number, :, :width] for each in (modes, roomy)))


def test_there_is_no_more_room_than_needed() -> None:
    modes = modes_of()
    tables = modes.tables
    assert tables.taylor.shape[:2] == (12, 6)
    for statuses in product((FREE, PLUS, MINUS, RELAXING), (FREE, PLUS), (FORWARD, STICK)):
        if len(modes._known) < 12:
            modes.number(statuses)
            assert modes.tables is tables
    assert len(modes._known) == 12
    modes.number((MINUS, PLUS, BACKWARD))
    assert modes.tables.taylor.shape[:2] == (24, 6)
    linear = Mechanism({"body": Body(2.0)}, links={"spring": Link(BETWEEN, 1.0)})
    assert Modes(*machine_of(linear)).tables.taylor.shape[:2] == (12, 0)


def test_a_preload_has_the_size_of_its_gap() -> None:
    stops = {"preload": Stop(BETWEEN, 5.0, 1.0, -0.5)}
    assert Modes(*machine_of(Mechanism({"body": Body(2.0)}, stops=stops))).tables.gap.tolist() == [0.5]


def test_there_is_room_for_the_limits_of_rings() -> None:
    # Three bodies and the ground, each on each: 7 ways to part them, to either side, and 6 frictions.
    ends = ["ground", "one", "two", "three"]
    frictions = {f"{a} {b}": Friction((a, b), 1.0) for a, b in combinations(ends, 2)}
    modes = Modes(*machine_of(Mechanism({name: Body(1.0) for name in ends[1:]}, frictions=frictions)))
    modes.number((FORWARD,) * 6)
    assert modes.tables.taylor.shape[:2] == (12, 12)
    number = modes.number((STICK,) * 6)
    assert modes.tables.taylor.shape[:2] == (24, 14)
    assert modes.tables.function_count[:2].tolist() == [6, 14]
    assert len(modes[number].functions) == 14
    assert modes.tables.owner[0].tolist() == [*range(6), *[UNKNOWN] * 8]


def test_what_follows_an_event_is_tabulated() -> None:
    modes = modes_of()
    modes.number(RELAXED)
    modes.follow(0, 0, False)
    modes.follow(0, 1, True)
    tables, plus = modes.tables, modes.number((PLUS, FREE, FORWARD))
    minus = modes.number((MINUS, FREE, FORWARD))
    assert tables.target[0, :3].tolist() == [[plus, UNKNOWN], [UNKNOWN, minus], [UNKNOWN, UNKNOWN]]
    assert tables.kind[0, :2].tolist() == [[CONTACT_MADE, UNKNOWN], [UNKNOWN, CONTACT_MADE]]
    assert tables.known_action[0, 0].tolist() == [BROKEN, UNKNOWN]
    assert tables.known_zeros[0, 0].tolist() == [0, UNKNOWN]
    modes.follow(0, 2, False)
    assert tables.known_zeros[0, 2].tolist() == [1, UNKNOWN]
    # Beside a friction that sticks, another one that comes to rest is no matter of statuses alone.
    pair = modes_of(2)
    number = pair.number((FREE, FREE, FORWARD, STICK))
    function = [each.action for each in pair[number].functions].index(ARRIVED)
    pair.follow(number, function, False)
    assert pair.tables.target[number, function].tolist() == [JOINT, UNKNOWN]
    assert pair.tables.kind[number, function].tolist() == [UNKNOWN, UNKNOWN]
