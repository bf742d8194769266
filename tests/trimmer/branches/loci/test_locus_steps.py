"""Steps along a locus, on points made by hand."""

from __future__ import annotations

import math
from collections.abc import Sequence
from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.branches.loci import steps as stepping
from trimmer.branches.loci.locus import LocusEnd, LocusRanges, LocusSettings
from trimmer.branches.loci.relocation import Sought
from trimmer.branches.loci.search import Point, Search, Track, apart, first_point
from trimmer.branches.loci.steps import (
    _at_border,
    _closed,
    _next_length,
    _obstacle,
    _predicted,
    _rooms,
    followed,
)
from trimmer.branches.special import SpecialKind, SpecialPoint

SIZES = np.array([2.0, 4e-5])


QUIET = LocusSettings(quiet=True)


def point(first: float, second: float, *state: float) -> Point:
    return Point(np.array([first, second]), np.array(state or (0.0, 0.0)), SIZES)


def test_the_distance_of_points_is_in_ranges_and_sizes() -> None:
    away = apart(point(0.3, 0.1, 4.0, 8e-5), np.array([0.0, 0.5]), np.array([0.0, 4e-5]))
    assert away == pytest.approx(math.sqrt(0.09 + 0.16 + 4.0 + 1.0), rel=1e-14)


def test_the_first_point_has_shares_of_the_ranges_and_sizes_of_what_moves() -> None:
    asked = []

    def map_at(held: int, number: float) -> SimpleNamespace:
        def passage(value: float, state: np.ndarray) -> SimpleNamespace:
            asked.append((held, number, value, state.tolist()))
            return SimpleNamespace(sizes=np.array([4e-5, 0.0, 691.0]))

        return SimpleNamespace(passage=passage)

    ranges = Search((None, None), None, LocusRanges((2.0, 6.0), (-1.0, 9.0)))  # type: ignore[arg-type]
    search = SimpleNamespace(map_at=map_at, lowest=ranges.lowest, spans=ranges.spans)
    found = first_point(search, np.array([3.0, 7.0]), np.array([1.0, 2.0, 3.0]))  # type: ignore[arg-type]
    assert found.values == pytest.approx([0.25, 0.8], rel=1e-14)
    assert found.state.tolist() == [1.0, 2.0, 3.0]
    assert found.sizes.tolist() == [4e-5, 1.0, 691.0]
    assert asked == [(1, 7.0, 3.0, [1.0, 2.0, 3.0])]
    assert ranges.inside(np.array([0.0, 1.0]))
    assert not ranges.inside(np.array([-1e-9, 0.5]))
    assert not ranges.inside(np.array([0.5, 1.0 + 1e-9]))


def test_a_point_is_predicted_on_the_curve_through_the_last_three() -> None:
    # Along a straight line of equal steps of 0.5: (0.3, 0.4) per length of 0.5; the state stays.
    line = [point(0.3 * k, 0.4 * k, 1.0, 3e-5) for k in (0.0, 1.0, 2.0)]
    values, state = _predicted(line, 0.25)
    assert values == pytest.approx([0.75, 1.0], rel=1e-12)
    assert state == pytest.approx([1.0, 3e-5], rel=1e-12)
    assert _predicted(line[:2], 0.25)[0] == pytest.approx([0.45, 0.6], rel=1e-12)
    # By Lagrange's formula, with the distances along the chords.
    bent = [point(0.0, 0.0), point(0.1, 0.0), point(0.1, 0.3), point(0.5, 0.3)]
    at = [0.0, 0.3, 0.7]
    shares = [np.prod([(0.9 - b) / (a - b) for b in at if b != a]) for a in at]
    wanted = sum(share * each.values for share, each in zip(shares, bent[1:], strict=True))
    assert _predicted(bent, 0.2)[0] == pytest.approx(wanted, rel=1e-12)


def test_room_is_how_much_of_a_step_leads_to_the_border() -> None:
    rooms = _rooms(np.array([0.9, 0.2]), np.array([0.2, -0.4]))
    assert rooms == pytest.approx([0.5, 0.5], rel=1e-12)
    assert _rooms(np.array([0.9, 0.2]), np.array([-0.3, 0.1])) == pytest.approx([3.0, 8.0], rel=1e-12)
    assert _rooms(np.array([0.9, 0.2]), np.array([0.0, 0.1]))[0] > 1e200
    assert _at_border(point(0.0, 0.4))
    assert _at_border(point(0.4, 1.0))
    assert not _at_border(point(1e-9, 1.0 - 1e-9))


def test_a_step_changes_the_numbers_no_more_than_it_may() -> None:
    # Of a step of 5 in all coordinates 3 is in the values.
    points = [point(0.0, 0.0, 0.0, 0.0), point(0.0, 3.0, 8.0, 0.0)]
    settings = LocusSettings(largest_step=0.06)
    assert _next_length(points, 9.0, settings) == pytest.approx(0.1, rel=1e-12)
    assert _next_length(points, 0.05, settings) == 0.05
    assert _next_length([points[0], point(0.0, 0.0, 8.0, 0.0)], 9.0, settings) == 0.2


@pytest.mark.parametrize(
    ("before", "last", "closed"),
    [
        ((0.1, 0.5), (0.3, 0.5), True),
        ((0.1, 0.5), (0.2, 0.5), True),
        ((0.2, 0.5), (0.3, 0.5), False),
        ((0.0, 0.5), (0.19, 0.5), False),
        ((0.1, 0.519), (0.3, 0.519), True),
        ((0.1, 0.522), (0.3, 0.522), False),
    ],
)
def test_a_locus_closes_where_a_step_passes_its_first_point(
    before: tuple[float, float], last: tuple[float, float], closed: bool
) -> None:
    points = [point(0.2, 0.5), point(0.4, 0.6), point(*before), point(*last)]
    assert _closed(points) is closed
    assert not _closed(points[1:] if closed else points[:3])
    elsewhere = [points[0], points[1], point(*before, 1.0, 0.0), point(*last, 1.0, 0.0)]
    assert not _closed(elsewhere)
    assert not _closed([points[0], *points[2:]])


@pytest.mark.parametrize(
    ("moved", "others", "reason"),
    [
        (0.04, 0, LocusEnd.CUSP),
        (0.06, 0, LocusEnd.LOST),
        (0.06, 1, LocusEnd.CHANGED),
        (0.04, 1, LocusEnd.CUSP),
    ],
)
def test_a_locus_that_is_lost_ends_in_a_cusp_where_its_numbers_hardly_move(
    moved: float, others: int, reason: LocusEnd
) -> None:
    other = SpecialPoint(SpecialKind.FOLD, 0.0, np.zeros(2))
    track = Track([point(0.2, 0.5), point(0.3, 0.5), point(0.3 + moved, 0.5, 2.0, 0.0)], [other] * others)
    assert _obstacle(track) is reason
    short = Track(track.points[1:], track.others)
    assert _obstacle(short) is (LocusEnd.CHANGED if others else LocusEnd.LOST)


class OnCircle:
    """Finds the points of a circle around the middle of the ranges again, in place of a search."""

    def __init__(self, radius: float, near: float = 1.0) -> None:
        self.radius, self.near, self.held = radius, near, list[int]()
        self.sought = Sought(SpecialKind.FOLD, ())

    def inside(self, values: np.ndarray) -> bool:
        return bool((abs(values - 0.5) <= 0.5).all())

    def again(
        self, _: object, track: Track, held: int, values: np.ndarray, state: np.ndarray, reach: float
    ) -> Point | None:
        self.held.append(held)
        aside = self.radius**2 - (values[held] - 0.5) ** 2
        if aside < 0.0 or track.points[-1].values[0] > self.near:
            return None
        found = values.copy()
        found[1 - held] = 0.5 + math.copysign(math.sqrt(aside), values[1 - held] - 0.5)
        away = abs(found - values).max()
        return Point(found, np.zeros(2), SIZES) if away <= reach else None


def went(
    monkeypatch: pytest.MonkeyPatch, circle: OnCircle, start: Sequence[float], sign: float, **settings: float
) -> tuple[Track, LocusEnd]:
    monkeypatch.setattr(stepping, "found_again", circle.again)
    track = Track([point(*start)])
    chosen = LocusSettings(quiet=True, **settings)  # type: ignore[arg-type]
    return track, followed(circle, track, sign, chosen)  # type: ignore[arg-type]


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_closed_locus_is_followed_around(monkeypatch: pytest.MonkeyPatch, sign: float) -> None:
    circle = OnCircle(0.3)
    track, reason = went(monkeypatch, circle, (0.8, 0.5), sign)
    assert reason is LocusEnd.CLOSED
    values = np.array([each.values for each in track.points])
    assert np.hypot(*(values - 0.5).T) == pytest.approx(np.full(len(values), 0.3), rel=1e-12)
    assert values[1, 1] == pytest.approx(0.5 + sign * 2e-3, rel=1e-12)
    lengths = np.linalg.norm(np.diff(values, axis=0), axis=1)
    # Steps grow to the largest that is allowed, once the curve is known: 63 of them would go around.
    assert lengths.max() < 0.0305
    assert 63 <= len(values) <= 75
    # The number that changes more is held.
    assert {*circle.held} == {0, 1}


def test_a_locus_ends_on_the_border_exactly(monkeypatch: pytest.MonkeyPatch) -> None:
    for sign in (1.0, -1.0):
        start = (0.5 + sign * 0.4, 0.5 + math.sqrt(0.36 - 0.16))
        track, reason = went(monkeypatch, OnCircle(0.6), start, 1.0)
        assert reason is LocusEnd.LEFT
        end = track.points[-1].values
        assert end == pytest.approx([0.5 + sign * math.sqrt(0.36 - 0.25), 1.0], rel=1e-12)
        assert end[1] == 1.0


def test_a_locus_that_is_not_found_any_more_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    track, reason = went(monkeypatch, OnCircle(0.3, near=0.6), (0.5, 0.2), 1.0)
    assert reason is LocusEnd.LOST
    assert track.points[-1].values[0] > 0.6 or len(track.points) == 1
    circle = OnCircle(0.3, near=0.0)
    track, reason = went(monkeypatch, circle, (0.8, 0.5), 1.0, smallest_step=5e-4)
    assert (reason, len(track.points)) == (LocusEnd.LOST, 1)
    # Three reaches, at lengths of 2e-3, 1e-3 and 5e-4.
    assert circle.held == [1] * 9


def test_as_many_points_as_were_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    track, reason = went(monkeypatch, OnCircle(0.3), (0.8, 0.5), 1.0, most_points=4)
    assert (reason, len(track.points)) == (LocusEnd.MOST_POINTS, 4)
