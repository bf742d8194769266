"""What a locus over two numbers is made of: its search, its points, and what is told, with stand-ins."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.branches.curves import special
from tests.trimmer.branches.loci.test_pieces import FOLD
from tests.trimmer.branches.test_self_excited_map import SPEED, belt
from tests.trimmer.maps.machines import impact_oscillator
from trimmer.branches.branch import BranchEnd
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.loci import follow_special as results
from trimmer.branches.loci.locus import LocusEnd, LocusRanges
from trimmer.branches.loci.relocation import Relocated, Sought
from trimmer.branches.loci.search import Point, Search, Track, found_again
from trimmer.branches.period_maps.mechanism_map import MechanismMap
from trimmer.branches.period_maps.self_excited_map import SelfExcitedMap
from trimmer.branches.special import SpecialKind
from trimmer.errors import MechanismError, UnsupportedMotionError, WrongTypeError

GAP = "stops.wall.gap"


def search(kind: SpecialKind = SpecialKind.FOLD) -> Search:
    map = MechanismMap(impact_oscillator(), "frequency", 1.5, 2)
    maps = map, replace(map, place=GAP, scale=12.0)
    return Search(maps, Sought(kind, ()), LocusRanges((1.0, 1.5), (8.0, 12.0)))


def test_the_map_over_one_number_holds_the_other() -> None:
    held_gap, held_frequency = search().map_at(1, 9.0), search().map_at(0, 1.25)
    assert (held_gap.place, held_gap.mechanism.value(GAP), held_gap.scale) == ("frequency", 9.0, 1.5)
    assert (held_frequency.place, held_frequency.scale) == (GAP, 12.0)
    assert held_frequency.mechanism.value("frequency") == 1.25
    assert held_frequency.mechanism.value(GAP) == 10.0


@pytest.mark.parametrize("held", [0, 1])
def test_a_point_that_is_found_again_has_shares_of_the_ranges(
    monkeypatch: pytest.MonkeyPatch, held: int
) -> None:
    from trimmer.branches.loci import search as searching

    asked: list[Any] = []
    free = 1 - held
    other, sizes = special(3.0), np.array([4e-5, 691.0])
    answer: list[Relocated | None] = []

    def relocate(map: Any, span: float, sought: Sought, value: float, state: Any, reach: float) -> Any:
        asked.append((map.place, span, sought, value, state, reach))
        return answer[-1]

    monkeypatch.setattr(searching, "relocated", relocate)
    track = Track([], [special(9.0)])
    given, state = np.array([0.5, 0.25]), np.array([1.0, 2.0])
    answer.append(None)
    assert found_again(search(), track, held, given, state, 0.07) is None
    assert [each.value for each in track.others] == [9.0]
    numbers = (1.25, 9.0)
    place, span = (("frequency", 0.5), (GAP, 4.0))[free]
    assert asked == [(place, span, FOLD, numbers[free], state, 0.07)]
    problem: Any = SimpleNamespace(sizes=sizes)
    answer.append(Relocated(None, (other,), problem))
    assert found_again(search(), track, held, given, state, 0.07) is None
    assert track.others == [other]
    answer.append(Relocated(special((1.3, 11.0)[free], 5.0, 6.0), (), problem))
    found = found_again(search(), track, held, given, state, 0.07)
    assert found is not None
    wanted = given.copy()
    wanted[free] = (0.6, 0.75)[free]
    assert found.values == pytest.approx(wanted, rel=1e-12)
    assert (found.state.tolist(), found.sizes is sizes, track.others) == ([5.0, 6.0], True, [])
    assert given.tolist() == [0.5, 0.25]


def test_a_locus_is_made_of_its_points(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Any] = []

    def place(search: Search, numbers: Any, point: Point) -> Any:
        asked.append((numbers.tolist(), point))
        multipliers = np.array([1.0 + 0.25 * len(asked), -3.0])
        return None if len(asked) == 2 else SimpleNamespace(error=1e-13 * len(asked), multipliers=multipliers)

    monkeypatch.setattr(results, "_place", place)
    points = [
        Point(np.array(values), np.array(values), np.ones(2), np.array(values) + 1.0)
        for values in ((0, 1), (0.5, 0.25), (1, 0))
    ]
    found = results._locus(search(), Track(points), LocusEnd.LEFT)
    assert found.values == pytest.approx(np.array([[1.0, 12.0], [1.25, 9.0], [1.5, 8.0]]), rel=1e-12)
    assert [each[0] for each in asked] == [pytest.approx(row, rel=1e-12) for row in found.values.tolist()]
    assert [each[1] for each in asked] == points
    assert found.states.tolist() == [[1.0, 2.0], [1.5, 1.25], [2.0, 1.0]]
    np.testing.assert_allclose(found.residual, [1e-13, np.nan, 3e-13], rtol=1e-12)
    np.testing.assert_allclose(found.distance, [0.25, np.nan, 0.75], rtol=1e-12)
    assert (found.kind, found.parts, found.places, found.periods) == (
        SpecialKind.FOLD,
        (),
        ("frequency", GAP),
        2,
    )
    assert (found.reason, found.units) == (LocusEnd.LEFT, ("Hz", "m"))
    assert found.message == f"{LocusEnd.LEFT.value}, at frequency = 1.5 and {GAP} = 8"


def test_the_orbit_of_a_point_is_that_of_both_numbers() -> None:
    omega, sizes = 7.5, np.array([5.0, 30.0])
    response = 100.0 / (40.0 - omega**2 + 0.1j * math.sqrt(40.0) * omega)
    state = np.array([response.real, (1j * omega * response).real])
    numbers = np.array([omega / (2.0 * math.pi), 11.0])
    place = results._place(search(), numbers, Point(np.zeros(2), state, sizes, state))
    assert place is not None
    # Below the gap the motion is linear, and the orbit known.
    assert place.error < 1e-12
    assert place.position == pytest.approx([*(state / sizes), numbers[0]], rel=1e-14)
    assert place.problem.map.mechanism.value(GAP) == 11.0  # type: ignore[attr-defined]


@pytest.mark.parametrize("symmetric", [False, True])
def test_a_search_is_over_the_shortest_period_in_the_scales_of_the_ranges(
    monkeypatch: pytest.MonkeyPatch, symmetric: bool
) -> None:
    asked: list[Any] = []

    def shortest(map: MechanismMap, value: float, state: Any) -> MechanismMap:
        asked.append((map, value, state))
        return replace(map, periods=3)

    monkeypatch.setattr(results, "shortest_map", shortest)
    monkeypatch.setattr(results, "is_symmetric", lambda *given: asked.append(given) or symmetric)
    doubled = MechanismMap(impact_oscillator(), "frequency", 9.0).doubled()
    branch: Any = SimpleNamespace(map=doubled)
    point = special(1.25, 0.5, 0.75, kind=SpecialKind.GRAZING, parts=("wall",))
    ranges = LocusRanges((-2.0, 1.5), (8.0, 12.0))
    found = results._search(branch, point, GAP, ranges)
    assert (found.sought, found.ranges) == (Sought(SpecialKind.GRAZING, ("wall",)), ranges)
    first, second = found.maps
    assert [(each.place, each.scale, each.periods, each.mirrored) for each in (first, second)] == [
        ("frequency", 2.0, 3, symmetric),
        (GAP, 12.0, 3, symmetric),
    ]
    (begun, value, state), (again, *rest) = asked
    assert (begun.single, begun.periods, value, state is point.state) == (None, 2, 1.25, True)
    assert begun.mechanism.value("frequency") == 1.25
    assert (again.periods, rest[0], rest[1] is point.state) == (3, 1.25, True)
    assert first.mechanism is second.mechanism is begun.mechanism


@pytest.mark.parametrize(("stop", "sign"), [(12.0, 1.0), ("8 m", -1.0)])
def test_a_locus_goes_towards_the_value_that_is_given(
    monkeypatch: pytest.MonkeyPatch, stop: float | str, sign: float
) -> None:
    fold = special(1.25, 1.0, 2.0)
    points: Any = tuple(SimpleNamespace(value=value) for value in (1.0, 1.5))
    map = MechanismMap(impact_oscillator(), "frequency", 1.5)
    branch = FollowedBranch(map, points, (fold,), BranchEnd.LEFT_AT_STOP, "")
    asked: list[Any] = []

    def followed(search: Search, track: Track, sign: float, settings: Any) -> LocusEnd:
        asked.append((search.ranges.both, [point.values.tolist() for point in track.points], sign, settings))
        return LocusEnd.LOST

    monkeypatch.setattr(results, "followed", followed)
    found = results.follow_special(branch, fold, GAP, stop)
    ((ranges, begun, towards, settings),) = asked
    assert towards == sign
    assert settings is results.DEFAULT
    assert ranges == ((1.0, 1.5), (10.0, 12.0) if sign > 0.0 else (8.0, 10.0))
    assert begun == [pytest.approx([0.5, 0.5 - 0.5 * sign], rel=1e-12)]
    assert (found.reason, len(found.values)) == (LocusEnd.LOST, 1)
    assert found.values[0] == pytest.approx([1.25, 10.0], rel=1e-12)


def test_wrong_numbers_and_types_are_refused() -> None:
    fold = special(1.25, 1.0, 2.0)
    points: Any = tuple(SimpleNamespace(value=value) for value in (1.0, 1.5))
    map = MechanismMap(impact_oscillator(), "frequency", 1.5)
    branch = FollowedBranch(map, points, (fold,), BranchEnd.LEFT_AT_STOP, "")
    for place in ("frequency", "forces.push.order"):
        with pytest.raises(MechanismError, match="a second number"):
            results.follow_special(branch, fold, place, 2)
    with pytest.raises(ValueError, match="is 10 already"):
        results.follow_special(branch, fold, GAP, "10 m")
    for ranges in (LocusRanges((1.3, 1.5), (9.0, 11.0)), LocusRanges((1.0, 1.5), (10.5, 11.0))):
        with pytest.raises(ValueError, match=r"do not hold the point, at 1\.25 and 10"):
            results.follow_special(branch, fold, GAP, 11.0, ranges=ranges)
    with pytest.raises(WrongTypeError, match="branch"):
        results.follow_special(map, fold, GAP, 11.0)  # type: ignore[arg-type]
    with pytest.raises(WrongTypeError, match="special"):
        results.follow_special(branch, 1.25, GAP, 11.0)  # type: ignore[arg-type]
    driven = replace(branch, map=SelfExcitedMap(belt(), SPEED, 1.0))
    with pytest.raises(UnsupportedMotionError, match="driven motions only"):
        results.follow_special(driven, fold, GAP, 11.0)
