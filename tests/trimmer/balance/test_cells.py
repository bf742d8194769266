"""Boxes of amplitude and frequency, by hand."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer.balance.cells import Cells


def rows(cells: Cells) -> list[tuple[float, ...]]:
    columns = (cells.u_lower, cells.u_upper, cells.x_lower, cells.x_upper)
    return list(zip(*(column.tolist() for column in columns), strict=True))


def boxes(*limits: tuple[float, float, float, float]) -> Cells:
    return Cells(*np.array(limits, float).T)


TWO = boxes((1.0, 3.0, 10.0, 18.0), (2.0, 2.5, -4.0, -1.0))


def test_a_grid_has_its_rows_within_each_column() -> None:
    grid = Cells.grid(np.array([0.0, 1.0, 3.0]), np.array([5.0, 7.0, 8.0]), np.array([7.0, 8.0, 12.0]))
    assert rows(grid) == [
        (0.0, 1.0, 5.0, 7.0),
        (1.0, 3.0, 5.0, 7.0),
        (0.0, 1.0, 7.0, 8.0),
        (1.0, 3.0, 7.0, 8.0),
        (0.0, 1.0, 8.0, 12.0),
        (1.0, 3.0, 8.0, 12.0),
    ]
    assert len(grid) == 6


def test_centres_and_halves() -> None:
    assert TWO.u_half.tolist() == [1.0, 0.25]
    assert TWO.x_half.tolist() == [4.0, 1.5]
    assert TWO.u_centre.tolist() == [2.0, 2.25]
    assert TWO.x_centre.tolist() == [14.0, -2.5]


def test_boxes_are_joined_and_taken() -> None:
    joined = Cells.joined([Cells.none(), TWO, boxes((5.0, 6.0, 7.0, 8.0))])
    assert rows(joined) == [*rows(TWO), (5.0, 6.0, 7.0, 8.0)]
    assert rows(joined.take(np.array([2, 0]))) == [(5.0, 6.0, 7.0, 8.0), (1.0, 3.0, 10.0, 18.0)]
    assert len(Cells.none()) == 0


def test_each_box_is_split_along_its_own_side() -> None:
    assert rows(TWO.split(np.array([True, False]), 2)) == [
        (1.0, 2.0, 10.0, 18.0),
        (2.0, 3.0, 10.0, 18.0),
        (2.0, 2.5, -4.0, -2.5),
        (2.0, 2.5, -2.5, -1.0),
    ]
    assert rows(TWO.split(np.array([False, True]), 2)) == [
        (1.0, 3.0, 10.0, 14.0),
        (1.0, 3.0, 14.0, 18.0),
        (2.0, 2.25, -4.0, -1.0),
        (2.25, 2.5, -4.0, -1.0),
    ]


def test_boxes_are_widened_but_not_beyond_their_limits() -> None:
    wide = boxes((-100.0, 100.0, -100.0, 100.0))
    assert rows(TWO.inflated(2.0, wide)) == [(0.0, 4.0, 6.0, 22.0), (1.75, 2.75, -5.5, 0.5)]
    assert rows(TWO.inflated(2.0, boxes((0.5, 2.7, -5.0, 20.0)))) == [
        (0.5, 2.7, 6.0, 20.0),
        (1.75, 2.7, -5.0, 0.5),
    ]


@pytest.mark.parametrize(
    ("u", "x", "inside"),
    [
        (2.0, 14.0, True),
        (1.0, 10.0, True),
        (3.0, 18.0, True),
        (0.9, 14.0, False),
        (3.1, 14.0, False),
        (2.0, 9.9, False),
        (2.0, 18.1, False),
    ],
)
def test_a_box_contains_its_border(u: float, x: float, inside: bool) -> None:
    first = TWO.take(np.array([0]))
    assert first.contains(np.array([u]), np.array([x])).tolist() == [inside]
    assert first.hold(np.array([u, 2.0]), np.array([x, 14.0])).tolist() == [[inside, True]]


def test_points_are_told_for_their_own_box_or_for_all() -> None:
    u, x = np.array([2.2, 2.2]), np.array([-2.0, 15.0])
    assert TWO.contains(u, x).tolist() == [False, False]
    assert TWO.hold(u, x).tolist() == [[False, True], [True, False]]


def test_a_box_lies_within_one_of_others() -> None:
    others = boxes((0.0, 4.0, 9.0, 20.0), (2.0, 2.5, -4.0, -1.0))
    assert TWO.lie_within(others).tolist() == [True, True]
    assert TWO.lie_within(others.take(np.array([0]))).tolist() == [True, False]
    for beyond in [(1.1, 3.0, 10.0, 18.0), (1.0, 2.9, 10.0, 18.0), (1.0, 3.0, 11.0, 18.0)]:
        assert not TWO.lie_within(boxes(beyond))[0]
    assert not TWO.lie_within(boxes((1.0, 3.0, 10.0, 17.0)))[0]
    # Half in the one and half in the other is not within one.
    assert not TWO.lie_within(boxes((1.0, 2.0, 10.0, 18.0), (2.0, 3.0, 10.0, 18.0)))[0]
    assert TWO.lie_within(Cells.none()).tolist() == [False, False]
