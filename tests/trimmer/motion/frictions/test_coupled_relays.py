"""Relays whose switching functions depend on each other: what belongs to which, by hand."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.motion.hand_made_loop import RING, ring_of_bodies
from trimmer.motion.frictions.coupled_relays import (
    CoupledRelays,
    _dependent,
    attracting,
    direction,
    symmetrizing_scales,
)
from trimmer.motion.interconnection import Interconnection
from trimmer.motion.relay_component import HELD, MINUS, PLUS, RelayComponent

RELAYS = CoupledRelays((1, 3, 4), RING, np.array([1.0, 2.0, 4.0]), np.array([3.0, 5.0, 7.0]))
"""The second, fourth and fifth component of five; their forces are the outputs times the scales."""


def modes(*of_members: int) -> tuple[int, ...]:
    return (PLUS, of_members[0], MINUS, *of_members[1:])


def test_the_members_of_a_ring() -> None:
    system = ring_of_bodies((1.0, 2.0, 4.0))
    found = CoupledRelays.of(system)
    assert found.members == (1, 2, 3)
    assert found.levels.tolist() == [0.3, 0.5, 0.7]
    assert found.scales / found.scales[0] == pytest.approx([1.0, 2.0, 4.0], rel=1e-12)
    assert found.directions.tolist() == [direction(system, k).tolist() for k in (1, 2, 3)]
    assert found.directions[0].tolist() == [1.0, -1.0, *[0.0] * 10, *[0.0] * 12]
    assert [attracting(system, k) for k in range(5)] == [False, True, True, True, True]
    # Where outputs drive what they should brake, none is ever held; nor where none has a counterpart.
    assert CoupledRelays.of(ring_of_bodies(sign=1.0)).members == ()
    assert not any(attracting(ring_of_bodies(sign=1.0), k) for k in range(5))
    assert CoupledRelays.of(ring_of_bodies((1.0, -1.0, 1.0))).members == ()
    assert CoupledRelays.of(ring_of_bodies()).most_event_functions == 3 + 2 * 3
    # Nor where what one does to another is not what that does to it, as forces do.
    system.B[3, 2] = 4.0
    assert all(attracting(system, k) for k in (1, 2, 3))
    none = CoupledRelays.of(system)
    assert (none.members, none.most_event_functions) == ((), 0)
    system.B[:, 4] = 0.0
    assert not attracting(system, 4)


def test_no_members() -> None:
    system = ring_of_bodies((1.0, -1.0, 1.0))
    nothing = CoupledRelays.of(system)
    assert nothing.most_event_functions == 0
    assert nothing.closed((0, HELD, HELD, HELD, HELD)) == (0, HELD, HELD, HELD, HELD)
    assert list(nothing.facets((0, HELD, HELD, HELD, HELD))) == []
    outputs = np.array([1.0, 2.0, 3.0, 4.0, 5.0])
    assert nothing.shared((0, HELD, HELD, HELD, HELD), outputs) is outputs


def test_inputs_and_rates_are_independent() -> None:
    system = ring_of_bodies()
    row = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, *[0.0] * 5, 0.0]
    assert direction(system, 4).tolist() == [*row, *[0.0] * 12]
    of_input = Interconnection(
        **{
            **vars(system),
            "components": (*system.components[:4], RelayComponent(2.0, False)),
            "drive_gain": np.array([1.0, 0, 0, 0, 6.0]),
        }
    )
    assert direction(of_input, 4).tolist() == [*[0.0] * 12, *row[:-1], 6.0]


def test_what_is_held_and_what_follows() -> None:
    assert RELAYS.held(modes(HELD, PLUS, HELD)).tolist() == [True, False, True]
    assert RELAYS.closed(modes(HELD, PLUS, HELD)) == modes(HELD, HELD, HELD)
    assert RELAYS.closed(modes(MINUS, HELD, PLUS)) == modes(MINUS, HELD, PLUS)
    free = modes(MINUS, PLUS, PLUS)
    assert RELAYS.closed(free) is free


def test_facets_of_those_that_are_held() -> None:
    assert list(RELAYS.facets(modes(PLUS, MINUS, PLUS))) == []
    found = [(vector.tolist(), bound) for vector, bound in RELAYS.facets(modes(PLUS, HELD, PLUS))]
    assert found == [([0.0, 1.0, 0.0], 5.0), ([0.0, -1.0, 0.0], 5.0)]
    # Two of them are independent; of all three two slide together, with the sizes of their scales.
    found = [(vector.tolist(), bound) for vector, bound in RELAYS.facets(modes(HELD, PLUS, HELD))]
    assert [vector for vector, _ in found] == [[1.0, 0, 0], [-1.0, 0, 0], [0, 0, 1.0], [0, 0, -1.0]]
    assert [bound for _, bound in found] == [3.0, 3.0, 7.0, 7.0]
    found = list(RELAYS.facets(modes(HELD, HELD, HELD)))
    expected = [([0.5, -1.0, 0.0], 6.5), ([0.25, 0.0, 1.0], 7.75), ([0.0, 0.5, 1.0], 9.5)]
    for (vector, bound), (opposite, same), (wanted, limit) in zip(
        found[::2], found[1::2], expected, strict=True
    ):
        assert vector == pytest.approx(np.array(wanted), rel=1e-12)
        assert opposite.tolist() == (-vector).tolist()
        assert bound == same == pytest.approx(limit, rel=1e-12)


def test_how_held_members_share_a_force() -> None:
    outputs = np.array([11.0, 2.0, 13.0, 1.0, 5.0])
    assert RELAYS.shared(modes(PLUS, PLUS, HELD), outputs) is outputs
    # What the first two take over from the third one is open; their limits are 3, 10 and 28 N.
    limits, forces, free = np.array([3.0, 10.0, 28.0]), np.array([2.0, 2.0, 20.0]), np.array([1.0, 1.0, -1.0])
    least = forces - free * (free @ (forces / limits**2)) / (1 / limits**2).sum()
    given = outputs.copy()
    found = RELAYS.shared(modes(HELD, HELD, HELD), outputs)
    assert found == pytest.approx([11.0, least[0], 13.0, least[1] / 2, least[2] / 4], rel=1e-12)
    assert outputs.tolist() == given.tolist()
    # The third one with 29 N is beyond its limit, so that 1 N must go over.
    found = RELAYS.shared(modes(HELD, HELD, HELD), np.array([11.0, 1.0, 13.0, 1.0, 7.25]))
    assert found == pytest.approx([11.0, 2.0, 13.0, 1.5, 7.0], rel=1e-9)
    # Where no split is within the limits they stay as they are, as where nothing is open.
    beyond = np.array([11.0, 2.5, 13.0, 1.0, 7.25])
    assert RELAYS.shared(modes(HELD, HELD, HELD), beyond).tolist() == beyond.tolist()
    assert RELAYS.shared(modes(HELD, PLUS, HELD), outputs) == pytest.approx(outputs, rel=1e-14)


def test_two_that_repeat_each_other_share_what_they_hold() -> None:
    pair = CoupledRelays((0, 2), np.array([[1.0], [1.0]]), np.ones(2), np.array([1.0, 3.0]))
    # Relative to the limits the forces are as 1 to 3.
    assert pair.shared((HELD, 0, HELD), np.array([2.0, 9.0, 0.0])) == pytest.approx([0.2, 9.0, 1.8])
    assert pair._facets[(0, 1)] is pair._facets[(0, 1)]


def test_relays_that_depend_on_others() -> None:
    rows = [np.array(row) for row in ([1.0, 0, 0, 0], [0, 0, 5.0, 0], [0, 1.0, 0, 0], [-2e3, 3e3, 0, 0])]
    members, directions = _dependent([2, 5, 7, 9], rows)
    assert members == (2, 7, 9)
    assert directions.tolist() == [rows[0].tolist(), rows[2].tolist(), rows[3].tolist()]
    assert _dependent([2, 5, 7], rows[:3])[0] == ()
    assert _dependent([2, 5], [rows[0], -3 * rows[0]])[0] == (2, 5)
    none, nothing = _dependent([], [])
    assert (none, len(nothing)) == ((), 0)


@pytest.mark.parametrize(
    ("influence", "scales"),
    [
        ([[2.0, 3.0], [6.0, 5.0]], [1.0, 0.5]),
        ([[2.0, -3.0], [-6.0, 5.0]], [1.0, 0.5]),
        ([[2.0, 0.0], [0.0, 5.0]], [1.0, 1.0]),
        ([[2.0, 1e-11], [0.0, 5.0]], [1.0, 1.0]),
        ([[1.0, 2.0, 0.0], [4.0, 9.0, 12.0], [0.0, 3.0, 9.0]], [1.0, 0.5, 2.0]),
        ([[1e6, 1e-6], [0.0, 1e6]], [1.0, 1.0]),
        ([[1e6, 10.0], [20.0, 1e6]], [1.0, 0.5]),
        ([[1.0, 2.0, 3.0], [4.0, 9.0, 6.0], [3.0, 3.0, 9.0]], [1.0, 0.5, 1.0]),
        ([[2.0, 3.0], [-6.0, 5.0]], None),
        ([[2.0, 3.0], [0.0, 5.0]], None),
        ([[2.0, 0.0], [3.0, 5.0]], None),
        ([[1.0, 2.0, 3.0], [4.0, 9.0, 6.0], [6.0, 3.0, 9.0]], None),
        ([[1e6, 1e-3], [2e-3, 1e-6]], [1.0, 0.5]),
    ],
)
def test_factors_that_make_an_influence_symmetric(
    influence: list[list[float]], scales: list[float] | None
) -> None:
    found = symmetrizing_scales(np.array(influence))
    if scales is None:
        assert found is None
    else:
        assert found / found[0] == pytest.approx(np.array(scales), rel=1e-9)


def test_nothing_is_symmetric() -> None:
    assert symmetrizing_scales(np.array([])).tolist() == []
