"""The border along which the winding number is counted, its pieces, and where it lies for a relay."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from tests.trimmer.balance.loops import FRICTION, THIRD_ORDER, s
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.loop import LoopEquation, loop_equation
from trimmer.balance.winding_number import (
    _border,
    _is_seen_narrowly,
    _largest_u,
    _Pieces,
    _turns,
    _u,
    winding_number,
)
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.elements.relay import Relay


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
    assert _u(play, v, np.zeros(3), math.inf) == pytest.approx([0.0, 1.0, 2.0], rel=1e-12)
    assert _u(play, v, np.zeros(3), math.inf)[2] < 2.0
    assert _u(ElementCurve(Relay(2.0)), v, np.zeros(3), 5.0) == pytest.approx([0.0, 2.5, 5.0])
    carried = ElementCurve(ViscousBacklash(1.0, 2.0))
    x = np.array([-1.0, 0.0, 1.0])
    assert _u(carried, v, x, math.inf) == pytest.approx(v * carried.edge(x))


def test_beyond_the_largest_u_a_relay_exceeds_the_inverse_response() -> None:
    # 1/G = s + 7, at most |7 + 3j| up to 3 rad/s; N = 4 level/(pi A) = c u.
    loop = loop_equation(1 / (s + 7), Relay(2.0))
    slope = abs(loop.curve.value(np.ones(1), np.zeros(1))[0])
    border = _border(loop.response, math.log(0.5), math.log(3.0))
    largest = _largest_u(loop, border)
    exact = 2.0 * abs(7 + 3j) / slope
    assert exact <= largest < 1.2 * exact
    assert _largest_u(loop_equation(1 / (s + 7), FRICTION), border) == math.inf


def test_a_relay_has_no_largest_u_where_the_inverse_is_infinite() -> None:
    loop = loop_equation((s**2 + 4) / (s + 1) ** 3, Relay(1.0))
    assert _largest_u(loop, _border(loop.response, math.log(1.0), math.log(8.0))) is None
    # Pieces at the zero itself doubled until memory ran out.
    assert winding_number(loop, (1.0, 8.0)) is None
    assert winding_number(loop, (3.0, 8.0)) is not None


def test_turns_are_those_of_the_phase_of_the_sum() -> None:
    # A relay in 1/(s(s+1)(s+2)): once round the solution at √2 rad/s with N = 6.
    loop = loop_equation(THIRD_ORDER, Relay(1.0))
    u = 6.0 / abs(loop.curve.value(np.ones(1), np.zeros(1))[0])
    low, high = math.log(1.2), math.log(1.6)

    def turns(v_from: float, v_to: float, backwards: bool = False) -> int | None:
        corners = [(v_to, low), (v_from, low), (v_from, high), (v_to, high), (v_to, low)]
        steps = 64
        path = np.concatenate([np.linspace(*ends, steps, endpoint=False) for ends in pairwise(corners)])
        closed = np.vstack([path, corners[:1]])
        given = _Pieces(closed[:-1, 0], closed[1:, 0], closed[:-1, 1], closed[1:, 1])
        if backwards:
            given = _Pieces(given.v_end[::-1], given.v_start[::-1], given.x_end[::-1], given.x_start[::-1])
        return _turns(loop, given, 2.0 * u)

    assert turns(0.3, 0.8) == 1
    assert turns(0.3, 0.8, backwards=True) == -1
    assert turns(0.6, 0.8) == 0


def test_a_piece_is_seen_narrowly_if_the_disk_is_small_beside_its_distance() -> None:
    loop = LoopEquation(loop_equation(THIRD_ORDER, FRICTION).response, ElementCurve(FRICTION))
    short = pieces((0.5, 0.501, 1.0, 1.0), (0.501, 0.5, 1.0, 1.0), (0.5, 0.5, 1.001, 1.0))
    assert _is_seen_narrowly(loop, short, math.inf).tolist() == [True, True, True]
    long = pieces((0.1, 0.9, -2.0, -2.0), (0.9, 0.1, -2.0, -2.0), (0.5, 0.5, 1.0, -2.0))
    assert _is_seen_narrowly(loop, long, math.inf).tolist() == [False, False, False]


def test_ninety_degrees_are_the_limit() -> None:
    loop = loop_equation(1 / s, Relay(1.0))
    slope = abs(loop.curve.value(np.ones(1), np.zeros(1))[0])
    for radius, seen in ((0.70, True), (0.714, False)):
        # N from 0 to 2 r lies in a disk of the radius r about r, and |r + j omega| = 1: sin 45° = 0.707.
        x = 0.5 * math.log(1.0 - radius**2)
        assert _is_seen_narrowly(loop, pieces((0.0, 1.0, x, x)), 2.0 * radius / slope).tolist() == [seen]
