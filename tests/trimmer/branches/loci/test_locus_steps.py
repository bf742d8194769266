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
    _step,
    followed,
)
from trimmer.branches.special import SpecialKind, SpecialPoint

SIZES = np.array([2.0, 4e-5])


QUIET = LocusSettings(quiet=True)


def point(first: float, second: float, *state: float) -> Point:
    begin = np.array(state or (0.0, 0.0))
    return Point(np.array([first, second]), begin, SIZES, begin)


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
    if before == (0.1, 0.5) and last == (0.3, 0.5):
        # Half way the state is that of the first point.
        assert _closed([*points[:2], point(*before, -1.0, 2e-5), point(*last, 1.0, -2e-5)])
        assert not _closed([*points[:2], point(*before, -1.0, 2e-5), point(*last, 0.9, -2e-5)])
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
        return Point(found, np.zeros(2), SIZES, np.zeros(2)) if away <= reach else None


def went(
    monkeypatch: pytest.MonkeyPatch, circle: OnCircle, start: Sequence[float], sign: float, **settings: float
) -> tuple[Track, LocusEnd]:
    monkeypatch.setattr(stepping, "found_again", circle.again)
    monkeypatch.setattr(stepping, "restart", lambda search, track: None)
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


class Answering:
    """Gives points in place of a search, and keeps what it is asked."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.answers, self.asked = list[Point | None](), list[tuple[int, list[float], list[float], float]]()
        monkeypatch.setattr(stepping, "found_again", self.again)

    def again(
        self, _: object, track: Track, held: int, values: np.ndarray, state: np.ndarray, reach: float
    ) -> Point | None:
        self.asked.append((held, values.tolist(), state.tolist(), reach))
        return self.answers.pop(0)


def steady(*steps: float) -> Track:
    """Points along (0.3, -0.4) at some distances, with the state (1, 3e-5)."""
    return Track([point(0.1 + 0.6 * each, 0.9 - 0.8 * each, 1.0, 3e-5) for each in steps])


def test_a_step_holds_the_number_that_changes_more_first_and_tells_its_error(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    answering = Answering(monkeypatch)
    track = steady(0.0, 0.1, 0.2)
    predicted = [0.1 + 0.6 * 0.25, 0.9 - 0.8 * 0.25]
    good = point(predicted[0] + 0.006, predicted[1], 1.0, 3e-5)
    answering.answers += [None, good]
    made = _step(None, track, 1.0, 0.05)  # type: ignore[arg-type]
    assert made is not None
    assert made[0] is good
    assert made[1] == pytest.approx(0.006 / 0.05, rel=1e-9)
    assert [each[0] for each in answering.asked] == [1, 0]
    for _, values, state, reach in answering.asked:
        assert values == pytest.approx(predicted, rel=1e-12)
        assert state == pytest.approx([1.0, 3e-5], rel=1e-12)
        assert reach == pytest.approx(0.025, rel=1e-9)
    answering.answers += [None, None]
    assert _step(None, track, 1.0, 0.05) is None  # type: ignore[arg-type]
    # However short the step is, the point is looked for at some distance.
    answering.answers += [None, None]
    assert _step(None, track, 1.0, 1e-5) is None  # type: ignore[arg-type]
    assert answering.asked[-1][3] == 2e-5


@pytest.mark.parametrize(
    ("length", "share", "good"),
    [(0.05, 0.19, True), (0.05, 0.21, False), (0.009, 0.21, True), (0.009, 0.49, True), (0.009, 0.51, False)],
)
def test_after_a_much_longer_step_a_prediction_may_be_worse(
    monkeypatch: pytest.MonkeyPatch, length: float, share: float, good: bool
) -> None:
    answering = Answering(monkeypatch)
    along = 0.2 + length
    away = point(0.1 + 0.6 * along + share * length, 0.9 - 0.8 * along, 1.0, 3e-5)
    answering.answers += [away, None]
    made = _step(None, steady(0.0, 0.1, 0.2), 1.0, length)  # type: ignore[arg-type]
    assert (made is not None) is good
    if made is not None:
        assert made[1] == pytest.approx(share, rel=1e-6)


@pytest.mark.parametrize("upwards", [True, False])
def test_a_step_that_would_leave_the_ranges_ends_on_their_border(
    monkeypatch: pytest.MonkeyPatch, upwards: bool
) -> None:
    answering = Answering(monkeypatch)
    # The first number is 0.03 from its border, and the second one 0.06: a step of 0.1 would pass both.
    ends = [[0.91, 0.18], [0.94, 0.12], [0.97, 0.06]]
    if not upwards:
        ends = [[1.0 - first, 1.0 - second] for first, second in ends]
    at_border = point(1.0 if upwards else 0.0, 0.0 if upwards else 1.0)
    answering.answers.append(at_border)
    track = Track([point(*each) for each in ends])
    found = _step(None, track, 1.0, 0.1)  # type: ignore[arg-type]
    ((held, values, _, reach),) = answering.asked
    assert held == 0
    assert values[0] == (1.0 if upwards else 0.0)
    assert values[1] == pytest.approx(0.0 if upwards else 1.0, abs=1e-12)
    move = math.hypot(0.03, 0.06)
    assert reach == pytest.approx(0.5 * move, rel=1e-9)
    assert found is not None and found[1] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("second", "sign", "expected"), [(0.5, 1.0, 0.7), (0.5, -1.0, 0.3), (0.9, 1.0, 1.0), (0.1, -1.0, 0.0)]
)
def test_the_second_point_is_looked_for_beside_the_first_inside_the_ranges(
    monkeypatch: pytest.MonkeyPatch, second: float, sign: float, expected: float
) -> None:
    answering = Answering(monkeypatch)
    found = point(0.4, 0.4)
    answering.answers += [None, None, found]
    made = _step(None, Track([point(0.3, second, 1.0, 3e-5)]), sign, 0.2)  # type: ignore[arg-type]
    assert made == (found, 0.0)
    assert [(held, reach) for held, _, _, reach in answering.asked] == [(1, 1e-2), (1, 1e-3), (1, 1e-1)]
    for _, values, state, _ in answering.asked:
        assert values == pytest.approx([0.3, expected], rel=1e-12, abs=1e-15)
        assert state == [1.0, 3e-5]


def test_steps_grow_twofold_where_predictions_are_good_and_are_halved_where_none_is_made(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    errors, lengths = [0.0, 0.029, 0.031, None, None, 0.0, 0.5], list[float]()

    def step(search: object, track: Track, sign: float, length: float) -> tuple[Point, float] | None:
        lengths.append(length)
        error = errors.pop(0)
        before = track.points[-1].values
        return None if error is None else (point(before[0] + length, before[1]), error)

    monkeypatch.setattr(stepping, "_step", step)
    monkeypatch.setattr(stepping, "restart", lambda search, track: None)
    search = OnCircle(0.3)
    settings = LocusSettings(most_points=6, quiet=True)
    assert followed(search, Track([point(0.3, 0.5)]), 1.0, settings) is LocusEnd.MOST_POINTS  # type: ignore[arg-type]
    assert lengths == pytest.approx([2e-3, 4e-3, 8e-3, 8e-3, 4e-3, 2e-3, 4e-3], rel=1e-12)
    errors[:], lengths[:] = [None] * 3, []
    hasty = LocusSettings(largest_step=1e-3, smallest_step=2.5e-4, quiet=True)
    assert followed(search, Track([point(0.3, 0.5)]), 1.0, hasty) is LocusEnd.LOST  # type: ignore[arg-type]
    assert lengths == [1e-3, 5e-4, 2.5e-4]
