"""Which boxes are left of a grid, and how columns are cut, with responses that are known by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.balance.loops import THIRD_ORDER, s
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve, GainDisks, GainTable
from trimmer.balance.exclusion import (
    EnclosedCells,
    _blocks,
    _boxes,
    _Columns,
    _columns,
    _cut,
    disks_meet,
    first_grid,
    sizes_meet,
)
from trimmer.balance.inverse_response import ConstantResponse, Enclosure, InverseResponse
from trimmer.balance.search import Problem
from trimmer.balance.vanishing import EmptyInterval
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.linear.zero_pole_gain import ZeroPoleGain

CURVE = ElementCurve(FrictionBacklash(4e-5))


def enclosure(centre: complex, radius: float = 0.0, smallest: float = 0.0, largest: float = 1.0) -> Enclosure:
    values = (centre, 0.0, radius, 0.0, smallest, largest)
    return Enclosure(*(np.array([value]) for value in values))


def disks(centre: complex, radius: float, exists: bool = True) -> GainDisks:
    return GainDisks(np.array([centre]), np.array([radius]), np.array([0.5 * radius]), np.array([exists]))


def problem(G, x_breaks: np.ndarray, curve: ElementCurve = CURVE, **rest) -> Problem:
    response = InverseResponse.of(ZeroPoleGain.of(G))
    return Problem(response, curve, GainTable.of(curve, x_breaks), rest.pop("smallest_gain", 0.0), **rest)


def test_disks_meet_if_n_and_the_negative_of_the_inverse_can_be_equal() -> None:
    # |N - (-1/G)| = |3 + 4j| = 5.
    assert disks_meet(disks(1 + 1j, 2.0), enclosure(2 + 3j, 3.0)).tolist() == [True]
    assert disks_meet(disks(1 + 1j, 2.0), enclosure(2 + 3j, 2.99)).tolist() == [False]
    assert disks_meet(disks(1 + 1j, 2.0, exists=False), enclosure(2 + 3j, 3.0)).tolist() == [False]
    assert disks_meet(disks(1 + 1j, 2.0), enclosure(np.nan, 1.0)).tolist() == [True]


def test_sizes_meet_up_to_equality_and_where_a_bound_is_missing() -> None:
    given = enclosure(0.0, smallest=2.0, largest=3.0)
    assert [sizes_meet(given, *each)[0] for each in [(0.0, 1.9), (0.0, 2.0), (3.0, 9.0), (3.1, 9.0)]] == [
        False,
        True,
        True,
        False,
    ]
    assert sizes_meet(enclosure(0.0, smallest=np.nan, largest=np.nan), 1.0, 2.0)[0]


def test_a_box_is_open_if_both_its_disks_and_its_sizes_meet() -> None:
    def left(centre: complex, smallest_gain: float, largest: float = 9.0, smallest: float = 3.0) -> int:
        one = Cells(*(np.array([each]) for each in (0.1, 0.2, 1.0, 2.0)))
        # |N| is between 4 and 6, and 1/G reaches far.
        given = EnclosedCells(one, disks(3 + 4j, 1.0), enclosure(centre, 1.0, smallest, largest))
        return len(given.open(smallest_gain))

    assert left(-3 - 4j, 0.0) == 1
    assert left(3 + 4j, 0.0) == 0
    assert left(-3 - 4j, 9.5) == 0
    assert left(-3 - 4j, 0.0, largest=3.9) == 0
    assert left(-3 - 4j, 0.0, largest=4.1) == 1
    assert left(-3 - 4j, 0.0, smallest=5.9) == 1
    assert left(-3 - 4j, 0.0, smallest=6.1) == 0


def test_disks_are_refined_to_the_boxes_themselves() -> None:
    boxes = Cells(*(np.array([each]) for each in (0.5, 0.6, 1.0, 2.0)))
    rough = EnclosedCells(boxes, disks(9.0, 99.0), enclosure(1.0))
    fine = rough.refined(CURVE)
    assert fine.disks.centre == pytest.approx(CURVE.value(np.array([0.55]), np.array([1.5])))
    assert fine.disks.radius == pytest.approx(CURVE.disks(boxes).radius)
    assert fine.enclosure is rough.enclosure
    assert fine.cells is boxes


def test_a_column_is_cut_until_the_inverse_changes_by_a_twentieth() -> None:
    # Of radius r about c, ln(1 + r/|c|)/0.05 parts, from 1 to 32.
    radius = np.array([2.0, 10.0, 0.3, 0.2, 1e9])
    centre = np.array([3 + 4j, 3 - 4j, 5.0, 5j, 1.0])
    zeros = np.zeros(5)
    lower = np.arange(5.0)
    columns = _Columns(
        lower, lower + 0.5, Enclosure(centre, centre, radius, zeros, zeros, zeros), np.arange(5)
    )
    assert columns.parts.tolist() == [7, 22, 2, 1, 32]
    narrow = _Columns(lower, lower + 1e-12, columns.enclosure, columns.block)
    assert narrow.parts.tolist() == [1, 1, 1, 1, 1]
    for width, parts in ((1.9e-12, 1), (2.1e-12, 32)):
        least = _Columns(zeros, zeros + width, columns.enclosure, columns.block)
        assert least.parts.tolist()[4] == parts


def test_too_many_columns_are_left_as_they_are() -> None:
    count = 50_001
    one, nothing = np.ones(count), np.zeros(count)
    bounds = Enclosure(one + 0j, one + 0j, 9.0 * one, nothing, nothing, nothing)
    assert _Columns(nothing, one, bounds, nothing.astype(int)).parts.max() == 1
    fewer = _Columns(nothing[1:], one[1:], bounds.take(np.arange(count - 1)), nothing[1:].astype(int))
    assert fewer.parts.tolist()[0] == math.ceil(math.log(10.0) / 0.05) - 15 == 32


def test_columns_are_cut_into_equal_parts_and_keep_their_block() -> None:
    given = problem(4 * THIRD_ORDER, np.array([-3.0, -1.0, 0.5]))
    columns = _columns(given, np.array([-1.0, 0.0, 0.25]), np.array([0.0, 0.25, 0.5]), np.array([4, 7, 9]))
    assert columns.block.tolist() == [4, 7]  # from e**0.25 on |1/G| is 1.24, beyond the largest |N|
    cut = _cut(given, columns, np.array([4, 0]))
    assert cut.lower.tolist() == [-1.0, -0.75, -0.5, -0.25]
    assert cut.upper.tolist() == [-0.75, -0.5, -0.25, 0.0]
    assert cut.block.tolist() == [4, 4, 4, 4]
    assert cut.enclosure.centre == pytest.approx(given.response.value(0.5 * (cut.lower + cut.upper)))
    both = _cut(given, columns, np.array([1, 2]))
    assert both.lower.tolist() == [-1.0, 0.0, 0.125]
    assert both.upper.tolist() == [0.0, 0.125, 0.25]
    assert both.block.tolist() == [4, 7, 7]


def test_columns_with_a_response_below_the_smallest_gain_are_left_out() -> None:
    lower, upper = np.array([-3.0, -2.0, -1.0]), np.array([-2.0, -1.0, 0.0])
    breaks = np.array([-3.0, 0.0])
    assert _columns(problem(THIRD_ORDER, breaks), lower, upper, np.arange(3)).block.tolist() == [0, 1, 2]
    # |1/G| is 2 omega and a little more: at e**-2 0.27 or, with its bound, less than 0.5; at e**-1 0.83.
    left = _columns(problem(THIRD_ORDER, breaks, smallest_gain=0.5), lower, upper, np.arange(3))
    assert left.block.tolist() == [1, 2]


def test_blocks_within_an_empty_interval_are_left_out() -> None:
    breaks = np.array([0.0, 1.0, 2.0, 3.0, 4.0])
    empty = (EmptyInterval(-math.inf, 1.0, 0.1), EmptyInterval(2.0, 3.5, 0.1))
    assert _blocks(problem(THIRD_ORDER, breaks, empty=empty)).tolist() == [1, 3]
    assert _blocks(problem(THIRD_ORDER, breaks)).tolist() == [0, 1, 2, 3]
    assert _blocks(problem(THIRD_ORDER, breaks, empty=(EmptyInterval(0.5, 3.0, 0.1),))).tolist() == [0, 3]


def test_boxes_are_those_of_their_row_and_column() -> None:
    curve = ElementCurve(ViscousBacklash(1.0, 1.0))
    given = problem(THIRD_ORDER, np.array([-3.0, -1.0, 0.5]), curve)
    columns = _Columns(
        np.array([-2.0, 0.0]),
        np.array([-1.5, 0.25]),
        given.response.enclose(np.array([-2.0, 0.0]), np.array([-1.5, 0.25])),
        np.array([0, 1]),
    )
    flags = np.zeros((32, 2), dtype=bool)
    flags[3, 1] = flags[5, 0] = True
    boxes = _boxes(given, columns, flags)
    step = given.table.u_breaks[1]
    assert boxes.cells.u_lower == pytest.approx([3 * step, 5 * step])
    assert boxes.cells.x_lower.tolist() == [0.0, -2.0]
    assert boxes.cells.x_upper.tolist() == [0.25, -1.5]
    assert boxes.disks.centre.tolist() == [given.table.disks.centre[3, 1], given.table.disks.centre[5, 0]]
    assert boxes.enclosure.centre.tolist() == columns.enclosure.centre[::-1].tolist()


def test_the_first_grid_holds_the_solution_and_counts_what_it_compared() -> None:
    # A constant 1/G needs no cut: every row of every block is compared once.
    u = 0.7
    inverse = -complex(CURVE.value(np.array([u]), np.zeros(1))[0])
    table = GainTable.of(CURVE, np.array([0.0, 1.0, 2.0]))
    boxes, size = first_grid(Problem(ConstantResponse(inverse), CURVE, table, 0.0))
    assert size == 64 * 2
    assert 0 < len(boxes) < 32
    assert boxes.cells.hold(np.array([u]), np.array([0.5])).any()
    assert boxes.cells.hold(np.array([u]), np.array([1.5])).any()
    sides = {*zip(boxes.cells.x_lower.tolist(), boxes.cells.x_upper.tolist(), strict=True)}
    assert sides == {(0.0, 1.0), (1.0, 2.0)}
    none, size = first_grid(Problem(ConstantResponse(5j), CURVE, table, 0.0))
    assert len(none) == 0
    assert size == 0


class Widening:
    """1/G = -N(0.7), within 12.7 % of it times the width, below x = 1; N(0.7) beyond, which N never meets."""

    def enclose(self, lower: np.ndarray, upper: np.ndarray) -> Enclosure:
        gain = complex(CURVE.value(np.array([0.7]), np.zeros(1))[0])
        centre = np.where(lower < 1.0, -gain, gain)
        radius = np.where(lower < 1.0, math.expm1(0.12) * abs(gain) * (upper - lower), 0.0)
        return Enclosure(centre, 0.0 * centre, radius, radius, abs(gain) - radius, abs(gain) + radius)


def test_only_columns_with_a_possible_row_are_cut_and_compared_again() -> None:
    """One of two is cut into ceil(0.12 / 0.05) = 3 parts, which need no further cut."""
    table = GainTable.of(CURVE, np.array([0.0, 1.0, 2.0]))
    boxes, size = first_grid(Problem(Widening(), CURVE, table, 0.0))
    assert size == 64 * (2 + 3)
    assert np.unique(boxes.cells.x_lower) == pytest.approx([0.0, 1.0 / 3.0, 2.0 / 3.0])
    assert np.unique(boxes.cells.x_upper) == pytest.approx([1.0 / 3.0, 2.0 / 3.0, 1.0])


def test_cut_columns_are_counted_again() -> None:
    given = problem(4 / (s * (s + 1)), np.array([math.log(0.5), math.log(1.5)]))
    boxes, size = first_grid(given)
    assert size % 64 == 0
    assert size > 64
    # The parts of a column, at most 32, are cut to a twentieth.
    assert (boxes.enclosure.radius <= np.expm1(0.05) * np.abs(boxes.enclosure.centre)).all()
