"""The border along which the winding number is counted, and its pieces."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from tests.trimmer.balance.loops import FRICTION, GAP, THESIS_LOOP, THIRD_ORDER
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.loop import LoopEquation, loop_equation
from trimmer.balance.solve import limit_cycles
from trimmer.balance.winding_number import (
    _border,
    _is_seen_narrowly,
    _Pieces,
    _turns,
    _u,
)
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash


def pieces(*ends: tuple[float, float, float, float]) -> _Pieces:
    return _Pieces(*np.array(ends, float).T)


def rows(given: _Pieces) -> list[tuple[float, ...]]:
    columns = (given.v_start, given.v_end, given.x_start, given.x_end)
    return list(zip(*(column.tolist() for column in columns), strict=True))


def test_the_border_is_closed_and_runs_once_round_with_the_region_to_the_left() -> None:
    response = loop_equation(THIRD_ORDER, FRICTION).response
    border = _border(response, -2.0, 1.0)
    assert np.roll(border.v_start, -1).tolist() == border.v_end.tolist()
    assert np.roll(border.x_start, -1).tolist() == border.x_end.tolist()
    assert (border.v_start[0], border.x_start[0]) == (1.0, -2.0)
    corners = [(1.0, -2.0), (0.0, -2.0), (0.0, 1.0), (1.0, 1.0)]
    at = [rows(border).index(next(row for row in rows(border) if row[::2] == corner)) for corner in corners]
    assert at == sorted(at)
    # In v and x it runs so that the area v dx is that below v = 1, with the sign of dv dx reversed.
    area = float((0.5 * (border.v_start + border.v_end) * (border.x_end - border.x_start)).sum())
    assert area == pytest.approx(-3.0)
    assert np.unique(border.v_start).tolist() == (np.arange(17) / 16).tolist()
    assert set(border.x_start) == set(response.breaks(-2.0, 1.0))


def test_pieces_are_joined_taken_and_halved() -> None:
    given = pieces((0.0, 1.0, 2.0, 2.0), (1.0, 1.0, 2.0, 6.0))
    assert rows(_Pieces.joined([given, given.take(np.array([False, True]))])) == [
        *rows(given),
        (1.0, 1.0, 2.0, 6.0),
    ]
    assert rows(given.halves(np.array([True, True]))) == [
        (0.0, 0.5, 2.0, 2.0),
        (1.0, 1.0, 2.0, 4.0),
        (0.5, 1.0, 2.0, 2.0),
        (1.0, 1.0, 4.0, 6.0),
    ]
    assert rows(given.halves(np.array([False, True]))) == [(1.0, 1.0, 2.0, 4.0), (1.0, 1.0, 4.0, 6.0)]


def test_u_is_a_share_of_the_largest_one_just_inside_the_domain() -> None:
    play, v = ElementCurve(FrictionBacklash(3.0)), np.array([0.0, 0.5, 1.0])
    assert _u(play, v, np.zeros(3)) == pytest.approx([0.0, 1.0, 2.0], rel=1e-12)
    assert _u(play, v, np.zeros(3))[2] < 2.0
    carried = ElementCurve(ViscousBacklash(1.0, 2.0))
    x = np.array([-1.0, 0.0, 1.0])
    assert _u(carried, v, x) == pytest.approx(v * carried.edge(x))


def test_turns_are_those_of_the_phase_of_the_sum() -> None:
    # Once round each of the limit cycles of the thesis's trimmer, of which one obeys Loeb's criterion.
    loop = loop_equation(THESIS_LOOP, FRICTION)
    for cycle in limit_cycles(THESIS_LOOP, FRICTION):
        share = 0.5 * GAP / cycle.amplitude
        low, high = (math.log(cycle.omega * side) for side in (0.99, 1.01))

        def turns(v_from: float, v_to: float, backwards: bool = False, low=low, high=high) -> int | None:
            corners = [(v_to, low), (v_from, low), (v_from, high), (v_to, high), (v_to, low)]
            path = np.concatenate([np.linspace(*ends, 64, endpoint=False) for ends in pairwise(corners)])
            closed = np.vstack([path, corners[:1]])
            given = _Pieces(closed[:-1, 0], closed[1:, 0], closed[:-1, 1], closed[1:, 1])
            if backwards:
                given = _Pieces(
                    given.v_end[::-1], given.v_start[::-1], given.x_end[::-1], given.x_start[::-1]
                )
            return _turns(loop, given)

        around = (0.9 * share, min(1.1 * share, 0.5 + 0.5 * share))
        assert turns(*around) == cycle.index
        assert turns(*around, backwards=True) == -cycle.index
        assert turns(0.2 * share, 0.3 * share) == 0


def test_a_piece_is_seen_narrowly_if_the_disk_is_small_beside_its_distance() -> None:
    loop = LoopEquation(loop_equation(THIRD_ORDER, FRICTION).response, ElementCurve(FRICTION))
    short = pieces((0.5, 0.501, 1.0, 1.0), (0.501, 0.5, 1.0, 1.0), (0.5, 0.5, 1.001, 1.0))
    assert _is_seen_narrowly(loop, short).tolist() == [True, True, True]
    long = pieces((0.1, 0.9, -2.0, -2.0), (0.9, 0.1, -2.0, -2.0), (0.5, 0.5, 1.0, -2.0))
    assert _is_seen_narrowly(loop, long).tolist() == [False, False, False]
