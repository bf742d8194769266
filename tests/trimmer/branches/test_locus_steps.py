"""Stepping along a locus, on points made by hand: predictions, borders, ends."""

from __future__ import annotations

import math
from collections.abc import Sequence
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure

from tests.trimmer import results
from tests.trimmer.branches.curves import parabola
from tests.trimmer.branches.maps import Henon
from trimmer.branches.loci import steps as stepping
from trimmer.branches.loci.follow_special import _distance, _message, _ranges_of
from trimmer.branches.loci.locus import Locus, LocusEnd, LocusRanges, LocusSettings
from trimmer.branches.loci.relocation import Sought, _centre, relocated
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
from trimmer.errors import MechanismError

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


def test_settings_and_ranges_out_of_bounds_are_refused() -> None:
    for wrong in ({"most_points": 1}, {"largest_step": 1.5}, {"smallest_step": 0.04}, {"smallest_step": 0.0}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            LocusSettings(**wrong)  # type: ignore[arg-type]
    assert LocusSettings(2, 1.0, 1.0).smallest_step == 1.0
    assert not LocusSettings().quiet
    with pytest.raises(ValueError, match="second must be a lower"):
        LocusRanges((0.0, 1.0), (2.0, 2.0))
    ranges = LocusRanges((-1.0, 3.0), (2e-5, 6e-5))
    search = Search(None, None, ranges)  # type: ignore[arg-type]
    assert search.spans == pytest.approx([4.0, 4e-5], rel=1e-12)
    assert search.lowest.tolist() == [-1.0, 2e-5]
    assert search.inside(np.array([0.0, 1.0]))
    for values in ([-1e-9, 0.5], [0.5, 1.0 + 1e-9], [1.1, 0.5], [0.5, -0.1]):
        assert not search.inside(np.array(values))


def test_ranges_hold_the_points_of_the_branch_and_the_way_to_go() -> None:
    branch = SimpleNamespace(points=[SimpleNamespace(value=value) for value in (3.0, 7.0, 4.0)])
    special = SpecialPoint(SpecialKind.FOLD, 8.0, np.zeros(1))
    assert _ranges_of(branch, special, 5e-5, 2e-5).both == ((3.0, 8.0), (2e-5, 5e-5))  # type: ignore[arg-type]
    inner = SpecialPoint(SpecialKind.FOLD, 5.0, np.zeros(1))
    assert _ranges_of(branch, inner, 2e-5, 5e-5).both == ((3.0, 7.0), (2e-5, 5e-5))  # type: ignore[arg-type]


TURN = np.exp(0.7j)


@pytest.mark.parametrize(
    ("kind", "mirrored", "distance"),
    [
        (SpecialKind.FOLD, False, 0.25),
        (SpecialKind.FOLD, True, 0.25),
        (SpecialKind.PERIOD_DOUBLING, False, 0.125),
        (SpecialKind.SYMMETRY_BREAKING, False, 0.25),
        (SpecialKind.SYMMETRY_BREAKING, True, 0.125),
        (SpecialKind.TORUS, False, 0.0625),
        (SpecialKind.GRAZING, False, math.nan),
        (SpecialKind.STICK, False, math.nan),
    ],
)
def test_the_distance_is_of_the_multiplier_that_the_kind_speaks_of(
    kind: SpecialKind, mirrored: bool, distance: float
) -> None:
    multipliers = np.array([1.25, -1.125, 0.9375 * TURN, 0.9375 / TURN, 0.3 * TURN, 0.3 / TURN])
    search = SimpleNamespace(sought=Sought(kind, ()), maps=(SimpleNamespace(mirrored=mirrored),))
    place = SimpleNamespace(multipliers=multipliers)
    assert _distance(search, place) == pytest.approx(distance, rel=1e-12, nan_ok=True)  # type: ignore[arg-type]
    assert math.isnan(_distance(search, None))  # type: ignore[arg-type]
    real = SimpleNamespace(multipliers=np.array([0.9 + 0j, -0.5]))
    if kind is SpecialKind.TORUS:
        assert math.isnan(_distance(search, real))  # type: ignore[arg-type]


def test_the_message_names_what_is_beside_a_locus_that_changes() -> None:
    maps = (SimpleNamespace(place="frequency"), SimpleNamespace(place="plays.bridge.gap"))
    search = SimpleNamespace(maps=maps)
    track = Track([], [SpecialPoint(kind, 0.0, np.zeros(1)) for kind in (SpecialKind.FOLD, SpecialKind.FOLD)])
    numbers = np.array([110.0, 4e-5])
    at = "at frequency = 110 and plays.bridge.gap = 4e-05"
    changed = _message(search, track, LocusEnd.CHANGED, numbers)  # type: ignore[arg-type]
    assert changed == f"{LocusEnd.CHANGED.value}, {at}; beside it: fold"
    assert _message(search, track, LocusEnd.LOST, numbers) == f"{LocusEnd.LOST.value}, {at}"  # type: ignore[arg-type]


def test_a_fold_is_found_again_near_a_guess_and_nothing_else_is() -> None:
    # Hénon's fold is at a = -(1 - b)² / 4 and x = (1 - b) / (-2 a).
    fold, x = -0.1225, 0.7 / (2 * 0.1225)
    sought = Sought(SpecialKind.FOLD, ())
    guess = np.array([x + 0.01, 0.3 * x])
    found = relocated(Henon(), 0.5, sought, fold + 1e-4, guess, 0.05)
    assert found is not None
    assert found.point is not None
    assert found.point.value == pytest.approx(fold, rel=1e-11)
    assert found.point.state == pytest.approx([x, 0.3 * x], rel=1e-5)
    assert found.others == ()
    assert found.problem.span == 0.5
    assert found.problem.sizes == pytest.approx(abs(guess))
    doubling = relocated(Henon(), 0.5, Sought(SpecialKind.PERIOD_DOUBLING, ()), fold + 1e-4, guess, 0.05)
    assert doubling is not None
    assert doubling.point is None
    assert [each.kind for each in doubling.others] == [SpecialKind.FOLD]
    assert doubling.others[0].value == pytest.approx(fold, rel=1e-11)
    # Away from it the piece ends before it: nothing is there.
    away = relocated(Henon(), 0.5, sought, 0.1, np.array([0.9, 0.27]), 1e-3)
    assert away is not None
    assert (away.point, away.others) == (None, ())
    assert relocated(Henon(), 0.5, sought, -3.0, np.array([5.0, 1.0]), 1e-3) is None
    assert relocated(Henon(), 0.5, sought, 0.1, np.array([np.nan, 0.27]), 1e-3) is None


def test_what_is_sought_has_its_kind_and_parts() -> None:
    sought = Sought(SpecialKind.GRAZING, ("stop",))
    assert sought.fits(SpecialPoint(SpecialKind.GRAZING, 0.0, np.zeros(1), ("stop",)))
    assert not sought.fits(SpecialPoint(SpecialKind.GRAZING, 0.0, np.zeros(1), ("play",)))
    assert not sought.fits(SpecialPoint(SpecialKind.STICK, 0.0, np.zeros(1), ("stop",)))


def test_the_middle_of_a_piece_is_the_orbit_beside_the_guess() -> None:
    map = parabola()
    exact = map.at(0.5)
    tangent = np.array([1.0, 3.0, 1.0]) / math.sqrt(11.0)
    aside = np.array([3.0, -1.0, 0.0]) / math.sqrt(10.0)
    guess = exact.problem.place(exact.position + 1e-4 * aside)
    assert guess is not None
    centre = _centre(guess)
    assert centre is not None
    assert centre.position == pytest.approx(exact.position, abs=1e-7)
    assert abs(tangent @ (centre.position - guess.position)) < 1e-7


def test_a_locus_tells_its_points() -> None:
    locus = results.locus()
    assert locus.first.tolist() == [1.0, 1.2, 1.4]
    assert locus.second.tolist() == [8e-6, 9e-6, 12e-6]
    assert locus.success
    assert locus.name == "fold"
    assert "fold over frequency and stops.wall.gap, 3 points" in str(locus)
    table = locus._table()
    rows = [list(row) for row in table.rows()]
    assert rows == [[*locus.values[number], 0.0, 0.0] for number in range(3)]
    both = Locus(
        SpecialKind.STICK,
        ("a", "b"),
        *[
            getattr(locus, name)
            for name in ("places", "periods", "values", "states", "residual", "distance", "reason", "message")
        ],
    )
    assert both.name == "stick, a and b"
    assert both.units == ("", "")
    assert both.plot(Figure().add_subplot()).get_xlabel() == "frequency"
    ends = {each for each in LocusEnd if each.is_success}
    assert ends == {LocusEnd.LEFT, LocusEnd.CLOSED}


def test_a_value_that_a_number_cannot_have_ends_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    from trimmer.branches.loci.search import found_again

    search = Search((None, None), None, LocusRanges((0.0, 1.0), (0.0, 2.0)))  # type: ignore[arg-type]

    def refused(self: Search, held: int, value: float) -> None:
        assert (held, value) == (1, 1.0)
        raise MechanismError("it cannot have that value")

    monkeypatch.setattr(Search, "map_at", refused)
    values = np.array([0.25, 0.5])
    assert found_again(search, Track([]), 1, values, np.zeros(2), 0.1) is None
