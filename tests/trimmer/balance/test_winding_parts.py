"""The border that a winding number goes round, by hand: its pieces, its largest u, and what is narrow."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.balance.loops import s
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve, GainDisks
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.loop import LoopEquation
from trimmer.balance.winding_number import _border, _is_seen_narrowly, _largest_u, _Pieces, _turns, _u
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.relay import Relay
from trimmer.linear.zero_pole_gain import ZeroPoleGain

SQUARE = InverseResponse.of(ZeroPoleGain.of(5 / s**2))
"""1/G = -omega²/5, which its bounds enclose exactly."""


def pieces(*ends: tuple[float, float, float, float]) -> _Pieces:
    return _Pieces(*np.array(ends, float).T)


def rows(given: _Pieces) -> list[tuple[float, ...]]:
    return list(zip(*(each.tolist() for each in vars(given).values()), strict=True))


def test_pieces_are_halved_joined_and_taken() -> None:
    two = pieces((0.0, 1.0, 5.0, 7.0), (1.0, 0.5, 3.0, 3.0))
    assert rows(two.halves(np.array([True, True]))) == [
        (0.0, 0.5, 5.0, 6.0),
        (1.0, 0.75, 3.0, 3.0),
        (0.5, 1.0, 6.0, 7.0),
        (0.75, 0.5, 3.0, 3.0),
    ]
    assert rows(two.halves(np.array([False, True]))) == [(1.0, 0.75, 3.0, 3.0), (0.75, 0.5, 3.0, 3.0)]
    assert rows(_Pieces.joined([two, two.take(np.array([False, True]))])) == [*rows(two), rows(two)[1]]


def test_the_border_falls_in_u_at_the_lowest_frequency_and_closes() -> None:
    border = _border(SQUARE, -1.0, 3.0)
    corners = [(0, 1.0, -1.0), (16, 0.0, -1.0), (32, 0.0, 3.0), (48, 1.0, 3.0)]
    assert border.v_start.size == 64
    for place, v, x in corners:
        assert (border.v_start[place], border.x_start[place]) == (v, x)
    assert border.v_end.tolist() == np.roll(border.v_start, -1).tolist()
    assert border.x_end.tolist() == np.roll(border.x_start, -1).tolist()
    assert border.v_start[:17] == pytest.approx(np.linspace(1.0, 0.0, 17))
    assert border.x_start[16:33] == pytest.approx(np.linspace(-1.0, 3.0, 17))
    assert border.v_start[32:49] == pytest.approx(np.linspace(0.0, 1.0, 17))
    assert border.x_start[48:] == pytest.approx(np.linspace(3.0, -1.0, 17)[:-1])


def test_u_runs_up_to_the_edge_or_to_the_largest() -> None:
    v, x = np.array([0.5, 1.0]), np.zeros(2)
    assert _u(ElementCurve(FrictionBacklash(1.0)), v, x, math.inf) == pytest.approx([1.0, 2.0], rel=2e-13)
    assert (_u(ElementCurve(FrictionBacklash(1.0)), v, x, math.inf) < [1.0, 2.0]).all()
    assert _u(ElementCurve(Relay(1.0)), v, x, 30.0) == pytest.approx([15.0, 30.0], rel=2e-13)


@pytest.mark.parametrize(("x_lower", "x_upper"), [(0.0, 2.0), (-14.0, 14.0)])
def test_beyond_twice_the_largest_inverse_a_proportional_n_is_larger(x_lower: float, x_upper: float) -> None:
    """Pieces of 1.75 in x are too wide for the bounds, and are halved."""
    border = _border(SQUARE, x_lower, x_upper)
    found = _largest_u(LoopEquation(SQUARE, ElementCurve(Relay(3.0))), border)
    assert found == pytest.approx(2.0 * math.exp(2.0 * x_upper) / 5.0 / (4.0 / math.pi), rel=1e-9)
    assert _largest_u(LoopEquation(SQUARE, ElementCurve(FrictionBacklash(1.0))), border) == math.inf


def test_at_a_zero_of_g_no_n_is_larger() -> None:
    notch = InverseResponse.of(ZeroPoleGain.of((s**2 + 4) / (s + 1) ** 3))
    loop = LoopEquation(notch, ElementCurve(Relay(1.0)))
    with np.errstate(all="ignore"):
        assert _largest_u(loop, _border(notch, 0.0, 1.5)) is None


@pytest.mark.parametrize(("radius", "narrow"), [(2.03, True), (2.04, False)])
def test_a_disk_is_narrow_if_its_radius_is_below_its_distance_over_the_root_of_two(
    radius: float, narrow: bool
) -> None:
    """N + 1/G is within radius + 1.5 about 3 + 4j, and 5/sqrt(2) is 3.536."""
    asked: list[Cells] = []

    def disks(cells: Cells) -> GainDisks:
        asked.append(cells)
        return GainDisks(np.array([1.0 + 6.0j]), np.array([radius]), np.zeros(1), np.array([True]))

    def enclose(lower: np.ndarray, upper: np.ndarray) -> SimpleNamespace:
        assert (lower.tolist(), upper.tolist()) == ([3.0], [5.0])
        return SimpleNamespace(centre=np.array([2.0 - 2.0j]), radius=np.array([1.5]))

    curve = SimpleNamespace(edge=lambda x: np.full(x.shape, 4.0), disks=disks)
    loop = SimpleNamespace(curve=curve, response=SimpleNamespace(enclose=enclose))
    for ends in ((0.25, 0.5, 3.0, 5.0), (0.5, 0.25, 5.0, 3.0)):
        assert _is_seen_narrowly(loop, pieces(ends), math.inf).tolist() == [narrow]
    for cells in asked:
        assert (cells.u_lower[0], cells.u_upper[0]) == pytest.approx((1.0, 2.0), rel=1e-12)
        assert (cells.x_lower[0], cells.x_upper[0]) == (3.0, 5.0)


def test_turns_are_added_from_end_to_end() -> None:
    """N = u exp(2j pi x) round zero, at u = 0.5 in steps of a sixth of a turn."""
    curve = SimpleNamespace(edge=lambda x: np.ones(x.shape), value=lambda u, x: u * np.exp(2j * np.pi * x))
    loop = SimpleNamespace(
        curve=curve, response=SimpleNamespace(value=lambda x: np.full(x.shape, 0.1 + 0.1j))
    )
    steps = np.arange(12) / 6.0
    half = np.full(12, 0.5)
    round_twice = _Pieces(half, half, steps, steps + 1.0 / 6.0)
    assert _turns(loop, round_twice, math.inf) == 2
    assert _turns(loop, _Pieces(half, half, steps + 1.0 / 6.0, steps), math.inf) == -2
    assert _turns(loop, _Pieces(0.2 * half, 0.2 * half, steps, steps + 1.0 / 6.0), math.inf) == 0
    loop.response = SimpleNamespace(value=lambda x: np.full(x.shape, np.nan))
    with np.errstate(invalid="ignore"):
        assert _turns(loop, round_twice, math.inf) is None
