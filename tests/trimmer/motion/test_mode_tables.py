"""The tables of a loop's modes against the matrices and the laws that they are made of."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import scipy.linalg

from tests.trimmer.motion.hand_made_loop import GAP, LEVEL, TAU, one_body, ring_of_bodies
from trimmer.errors import UnsupportedMotionError
from trimmer.motion.backlash_component import FREE, LOWER, RESTING, UPPER, BacklashComponent
from trimmer.motion.mode_tables import UNKNOWN, ModeTables
from trimmer.motion.relay_component import HELD, MINUS, PLUS, RelayComponent
from trimmer.motion.taylor import DEGREE

SIZE = 8
X, V, LOAD, SPEED, SHARE, SINE, COSINE, ONE = np.eye(SIZE)


def test_modes_by_number() -> None:
    tables = ModeTables(one_body())
    assert tables.shape == (4, 3)
    numbers = [tables.number((first, second)) for first in range(4) for second in range(3)]
    assert numbers == list(range(12))
    assert [tables.component_modes(number) for number in (0, 5, 11)] == [(0, 0), (1, 2), (3, 2)]
    assert tables.mode(5) is tables.mode(5)
    assert tables.mode(5).component_modes == (UPPER, HELD)


def test_the_most_modes() -> None:
    def with_relays(count: int) -> Any:
        return SimpleNamespace(components=(BacklashComponent(1.0, 0.0), *[RelayComponent(1.0, True)] * count))

    assert len(ModeTables(with_relays(6)).shape) == 7
    with pytest.raises(UnsupportedMotionError, match="8 components have more than 2916 modes together"):
        ModeTables(with_relays(7))


def test_the_sizes_of_the_tables() -> None:
    tables = ModeTables(one_body()).tables
    assert tables.series.shape == (12, SIZE, (DEGREE + 1) * SIZE)
    assert tables.taylor.shape == tables.sizes.shape == tables.bernstein.shape == (12, 6, SIZE, DEGREE + 1)
    assert tables.zeros.shape == (12, 6, 2, 3)
    assert tables.held.shape == (12, 2)
    assert not tables.known.any()
    # Of a backlash and a friction alone 3 each, of three in a ring 3 and both sides of three facets.
    of_ring = ModeTables(ring_of_bodies()).tables
    assert of_ring.taylor.shape[:2] == (4 * 3**4, 3 + 3 + 9)
    assert of_ring.zeros.shape[1:] == (15, 2, 4)


@pytest.mark.parametrize("modes", [(FREE, PLUS), (UPPER, HELD)])
def test_the_flow_over_a_step(modes: tuple[int, int]) -> None:
    tables = ModeTables(one_body())
    number = tables.number(modes)
    tables.tabulate(number)
    filled, mode = tables.tables, tables.mode(number)
    step = filled.step[number]
    whole = scipy.linalg.expm(mode.matrix * step)
    np.testing.assert_allclose(filled.whole[number].T, whole, rtol=1e-11, atol=1e-13)
    terms = filled.series[number].reshape(SIZE, DEGREE + 1, SIZE)
    np.testing.assert_allclose(terms[:, 1].T, mode.matrix * step, rtol=1e-13)
    np.testing.assert_allclose(
        terms[:, 2].T, (mode.matrix * step) @ (mode.matrix * step) / 2, rtol=1e-12, atol=1e-15
    )
    assert filled.event_count[number] == len(mode.event_functions)
    for place, each in enumerate(mode.event_functions):
        assert filled.event_rows[number, place].tolist() == each.row.tolist()
        np.testing.assert_allclose(
            filled.taylor[number, place, :, 1], each.row @ terms[:, 1].T, rtol=1e-12, atol=1e-18
        )
        np.testing.assert_allclose(
            filled.sizes[number, place, :, 1], abs(each.row) @ abs(terms[:, 1].T), rtol=1e-12
        )
        ends = filled.bernstein[number, place][:, [0, -1]].T
        np.testing.assert_allclose(ends, [each.row, each.row @ whole], rtol=1e-9, atol=1e-14)
    assert filled.known.tolist() == [each == number for each in range(12)]
    assert filled.terms[number, 0] > filled.terms[number, -1] >= 1


def test_what_ends_free_flight_and_sliding() -> None:
    tables = ModeTables(one_body())
    number = tables.number((FREE, PLUS))
    tables.tabulate(number)
    filled = tables.tables
    assert filled.event_count[number] == 4
    play = 3e-4 * SINE - X - LOAD
    expected = [GAP / 2 * ONE - play, GAP / 2 * ONE + play, SHARE - 2.0**-60 * ONE, V]
    np.testing.assert_allclose(filled.event_rows[number, :4], expected, rtol=1e-14)
    assert filled.component[number, :4].tolist() == [0, 0, 0, 1]
    assert filled.number[number, :4].tolist() == [0, 1, 2, 0]
    assert filled.continuous[number, :4].tolist() == [1, 1, 0, 1]
    assert filled.relay[number, :4].tolist() == [-1, -1, -1, 1]
    assert filled.held[number].tolist() == [False, False]
    after = [(UPPER, PLUS), (LOWER, PLUS), (RESTING, PLUS)]
    assert filled.target[number, :3].tolist() == [[tables.number(each)] * 2 for each in after]
    assert filled.target[number, 3].tolist() == [tables.number((FREE, HELD)), tables.number((FREE, MINUS))]
    stopped = np.array([X, V, LOAD, 0 * X, 0 * X, SINE, COSINE, ONE])
    rested = stopped.copy()
    rested[2] = LOAD + TAU * SPEED
    for place, reset in enumerate((stopped, stopped, rested)):
        np.testing.assert_allclose(filled.reset[number, place].T, reset, rtol=1e-14)
    # Once it sticks the body has no velocity, whatever rounding says.
    stuck = np.eye(SIZE)
    stuck[1, 1] = 0.0
    assert filled.reset[number, 3].tolist() == stuck.tolist()
    assert filled.zeros[number, :4].tolist() == [
        *([[0, 0, 0]] * 2, [[0, 0, 0]] * 2, [[0, 0, 0]] * 2),
        [[0, 0, 0], [0, 0, 0]],
    ]


def test_what_ends_contact_and_stick() -> None:
    tables = ModeTables(one_body())
    number = tables.number((UPPER, HELD))
    tables.tabulate(number)
    filled = tables.tables
    assert filled.event_count[number] == 3
    assert filled.held[number].tolist() == [False, True]
    assert filled.component[number, :3].tolist() == [0, 1, 1]
    assert filled.number[number, :3].tolist() == [0, 0, 1]
    assert filled.relay[number, :3].tolist() == [-1, -1, -1]
    after = [(FREE, HELD), (UPPER, PLUS), (UPPER, MINUS)]
    assert filled.target[number, :3].tolist() == [[tables.number(each)] * 2 for each in after]
    assert filled.zeros[number, 0].tolist() == [[3, 0, 0], [2, 0, 0]]
    assert filled.zeros[number, 1].tolist() == filled.zeros[number, 2].tolist() == [[2, 0, 0], [1, 0, 0]]
    # The load leaves with the place and the velocity of the pin, which does not move but by the drive.
    reset = filled.reset[number, 0].T
    np.testing.assert_allclose(reset[2], 3e-4 * SINE - X - GAP / 2 * ONE, rtol=1e-14)
    np.testing.assert_allclose(reset[3], 3e-4 * 691.0 * COSINE, rtol=1e-13)
    assert reset[4].tolist() == ONE.tolist()
    assert reset[1].tolist() == [0.0] * SIZE
    # The force that holds x'' = -9 x - 0.2 v + 5 u - 2 f is what it takes, at most the level.
    held = 0.5 * (-9.0 * X - 0.2 * V + 5.0 * (3e-4 * SINE - X - GAP / 2 * ONE))
    rows = filled.event_rows[number, 1:3]
    state = np.array([0.3, 0.0, 0, 0, 0, 0.6, 0.8, 1.0])
    assert rows @ state == pytest.approx([LEVEL - held @ state, LEVEL + held @ state], rel=1e-13)


def test_what_is_at_rest_before_or_after() -> None:
    tables = ModeTables(one_body())
    stuck = np.eye(SIZE)
    stuck[1, 1] = 0.0
    sliding, held = (tables.mode(tables.number((FREE, each))) for each in (PLUS, HELD))
    assert tables.at_rest(sliding, (UPPER, MINUS)).tolist() == np.eye(SIZE).tolist()
    # The number of a contact is that of a hold, which is a matter of relays alone.
    assert HELD == LOWER
    assert tables.at_rest(sliding, (LOWER, MINUS)).tolist() == np.eye(SIZE).tolist()
    for mode, after in ((sliding, HELD), (held, PLUS), (held, HELD)):
        assert tables.at_rest(mode, (FREE, after)).tolist() == stuck.tolist()


def test_known_zeros_of_coupled_relays() -> None:
    tables = ModeTables(ring_of_bodies())
    number = tables.number((FREE, HELD, HELD, HELD, PLUS))
    tables.tabulate(number)
    filled, mode = tables.tables, tables.mode(number)
    facets = [k for k, each in enumerate(mode.event_functions) if each.number == 3]
    assert len(facets) == 6
    assert {int(filled.component[number, k]) for k in facets} == {1}
    for k in facets:
        sliding = {change.component for change in mode.event_functions[k].reached}
        for flavour, known in ((0, 2), (1, 1)):
            expected = [known if member in sliding else UNKNOWN for member in (1, 2, 3)]
            assert filled.zeros[number, k, flavour].tolist() == [*expected, UNKNOWN]
    assert filled.held[number].tolist() == [False, True, True, True, False]
    # The friction outside the ring keeps its own zeros.
    (alone,) = (k for k, each in enumerate(mode.event_functions) if each.owner == 4)
    assert filled.zeros[number, alone].tolist() == [[0, 0, 0, 0]] * 2
    # Where the last of them comes to rest too, nothing is known of the others.
    sliding = tables.number((FREE, HELD, PLUS, MINUS, PLUS))
    tables.tabulate(sliding)
    functions = tables.mode(sliding).event_functions
    (stick,) = (k for k, each in enumerate(functions) if (each.owner, each.number) == (1, 1))
    assert tables.component_modes(int(filled.target[sliding, stick, 0])) == (FREE, HELD, HELD, HELD, PLUS)
    assert filled.zeros[sliding, stick, 0].tolist() == [UNKNOWN] * 4
    assert tables.component_modes(int(filled.target[sliding, stick, 1])) == (FREE, HELD, MINUS, MINUS, PLUS)
    assert filled.zeros[sliding, stick, 1].tolist() == [UNKNOWN, 0, UNKNOWN, UNKNOWN]
    assert filled.relay[sliding, stick] == 2
