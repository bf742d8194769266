"""Curves over a map, on curves made by hand: which points they pass, where they meet, what is told."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.curves import special
from tests.trimmer.maps.machines import impact_oscillator
from trimmer.branches.branch import BranchEnd
from trimmer.branches.loci.locus import Locus, LocusEnd, LocusRanges
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.errors import MapError, WrongTypeError
from trimmer.maps import special_work
from trimmer.maps.cells import CellMotion, CellResult
from trimmer.maps.inputs import MapInputs, Settings
from trimmer.maps.result import MotionMap
from trimmer.maps.special_curve import SpecialCurve, SpecialCurves, _passes
from trimmer.maps.special_curves import _points, _Search, _searched, special_curves
from trimmer.maps.special_work import Line, LineWork, SideWork, _reaches, in_order
from trimmer.response.response import MotionKind
from trimmer.runners.processes import ProcessRunner
from trimmer.runners.runner import SerialRunner

PLACES = ("frequency", "stops.wall.gap")
SPANS = np.array([10.0, 4e-5])


def locus(
    values: list[tuple[float, float]],
    states: list[tuple[float, ...]],
    reason: LocusEnd = LocusEnd.LEFT,
    kind: SpecialKind = SpecialKind.FOLD,
    parts: tuple[str, ...] = (),
) -> Locus:
    residual = np.array([np.nan, *np.arange(1.0, len(values))]) * 1e-13
    given = np.array(values, dtype=float), np.array(states, dtype=float)
    return Locus(kind, parts, PLACES, 2, *given, residual, residual, reason, "it ends", ("Hz", "m"))


UP = locus([(3.0, 1e-5), (4.0, 2e-5), (6.0, 3e-5)], [(1.0, 10.0), (2.0, 20.0), (3.0, 30.0)])
DOWN = locus([(3.0, 1e-5), (1.0, 0.5e-5)], [(1.0, 10.0), (0.5, 5.0)])
BOTH = SpecialCurve((UP, DOWN))


def test_both_sides_make_one_curve_from_end_to_end() -> None:
    assert BOTH.values.tolist() == [[1.0, 0.5e-5], [3.0, 1e-5], [4.0, 2e-5], [6.0, 3e-5]]
    assert BOTH.states[:, 0].tolist() == [0.5, 1.0, 2.0, 3.0]
    assert BOTH.ends == (DOWN, UP)
    assert BOTH.residual == 2e-13
    assert (BOTH.kind, BOTH.parts, BOTH.periods, BOTH.name) == (SpecialKind.FOLD, (), 2, "fold")
    upside_down = SpecialCurve((DOWN, UP))
    assert upside_down.values[:, 0].tolist() == [6.0, 4.0, 3.0, 1.0]
    assert upside_down.states[:, 1].tolist() == [30.0, 20.0, 10.0, 5.0]
    assert upside_down.residual == 2e-13
    closed = SpecialCurve((UP,))
    assert closed.values.tolist() == UP.values.tolist()
    assert closed.states.tolist() == UP.states.tolist()
    assert closed.ends == (UP,)
    assert "fold over frequency and stops.wall.gap, 4 points" in str(BOTH)


def test_curves_are_drawn_by_name_and_told_by_kind() -> None:
    grazing = SpecialCurve((replace(DOWN, kind=SpecialKind.GRAZING, parts=("wall",)),))
    found = SpecialCurves((grazing, BOTH, SpecialCurve((UP,))), "here")
    assert [name for name, _ in found.drawn] == ["fold", "fold", "grazing, wall"]
    assert found.drawn[0][1] is BOTH.values
    assert "3 curves: 1 of grazing, 2 of fold" in str(found)
    rows = list(found._table().rows())
    assert rows[0] == (0, SpecialKind.GRAZING, "wall", 2, 3.0, 1e-5)
    assert rows[2] == (1, SpecialKind.FOLD, "", 2, 1.0, 0.5e-5)
    assert len(rows) == 2 + 4 + 3
    assert found._table().units == {
        "curve": "",
        "kind": "",
        "parts": "",
        "drive_periods": "",
        "frequency": "Hz",
        "stops.wall.gap": "m",
    }
    assert next(iter(BOTH._table().rows()))[4:] == (1.0, 0.5e-5)
    nothing = SpecialCurves((), "here")
    assert len(nothing._table().columns) == 4
    assert nothing._axes == (("", ""), ("", ""))
    assert "0 curves" in str(nothing)


def test_a_curve_holds_the_points_that_lie_on_it_with_their_states() -> None:
    # The middle of its piece from (3, 1e-5) to (4, 2e-5), with the states half way.
    assert BOTH.holds(special(3.5, 1.5, 15.0), 1.5e-5, SPANS)
    assert BOTH.holds(special(1.0, 0.5, 5.0), 0.5e-5, SPANS)
    assert BOTH.holds(special(6.0, 3.0, 30.0), 3e-5, SPANS)
    assert not BOTH.holds(special(3.5, 1.5, 15.0, kind=SpecialKind.TORUS), 1.5e-5, SPANS)
    assert not BOTH.holds(special(3.5, 1.5, 15.0, parts=("wall",)), 1.5e-5, SPANS)
    # States: 5 % of the largest, which are 3 and 30.
    assert BOTH.holds(special(3.5, 1.5 + 0.14, 15.0 - 1.4), 1.5e-5, SPANS)
    assert not BOTH.holds(special(3.5, 1.5 + 0.16, 15.0), 1.5e-5, SPANS)
    assert not BOTH.holds(special(3.5, 1.5, 15.0 - 1.6), 1.5e-5, SPANS)
    # Sizes are moduli, however small; what never moves has the size 1.
    small = locus([(3.0, 1e-5), (4.0, 2e-5)], [(-3.0, 0.25, 0.0), (-1.0, -0.5, 0.0)])
    for state, held in (
        ((-2.0, -0.125, 0.0), True),
        ((-2.14, -0.125 + 0.024, 0.049), True),
        ((-2.16, -0.125, 0.0), False),
        ((-2.0, -0.125 + 0.026, 0.0), False),
        ((-2.0, -0.125, 0.051), False),
    ):
        assert SpecialCurve((small,)).holds(special(3.5, *state), 1.5e-5, SPANS) is held
    # Beside the first piece, of direction (2, 0.5e-5) / spans = (0.2, 0.125).
    aside = np.array([-0.125, 0.2]) / np.hypot(0.2, 0.125)
    for away, held in ((4.9e-3, True), (-4.9e-3, True), (5.1e-3, False)):
        at = (np.array([2.0, 0.75e-5]) / SPANS + away * aside) * SPANS
        assert BOTH.holds(special(at[0], 0.75, 7.5), at[1], SPANS) == held
    # Behind the end.
    assert not BOTH.holds(special(6.2, 3.0, 30.0), 3.1e-5, SPANS)


def test_a_piece_of_no_length_passes_its_own_point() -> None:
    values, states = np.array([[0.3, 0.4], [0.3, 0.4]]), np.array([[1.0], [5.0]])
    assert _passes(values, states, np.array([0.3, 0.404]), np.array([1.01]))
    assert not _passes(values, states, np.array([0.3, 0.404]), np.array([5.0]))
    resting = SpecialCurve((replace(UP, states=np.array([(1.0, 0.0)] * 3)),))
    assert resting.holds(special(3.5, 1.0, 0.04), 1.5e-5, SPANS)
    assert not resting.holds(special(3.5, 1.0, 0.06), 1.5e-5, SPANS)


def curve(
    values: list[tuple[float, float]], state: tuple[float, ...] = (1.0, 1.0), reason: LocusEnd = LocusEnd.LEFT
) -> SpecialCurve:
    return SpecialCurve((locus(values, [state] * len(values), reason),))


FLAT = curve([(0.0, 2e-5), (10.0, 2e-5)])


def branch(*points: SpecialPoint, success: bool = True, **others: object) -> SimpleNamespace:
    given = {"special": points, "success": success, "message": "it was lost", "branches": ()}
    return SimpleNamespace(**{**given, **others})


RANGES = LocusRanges((0.0, 10.0), (0.0, 4e-5))


class Searching(_Search):
    """A search whose curves are flat ones through the points that are followed."""

    def __init__(self, runner: object) -> None:
        super().__init__(runner, SideWork(PLACES[1], RANGES), True)  # type: ignore[arg-type]
        self.asked: list[list[float]] = []

    def _followed(self, points):  # type: ignore[no-untyped-def]
        self.asked.append([point.value for _, point in points])
        for _, point in points:
            yield point, curve([(point.value - 0.5, 1e-5), (point.value + 0.5, 1e-5)])


def test_points_are_followed_until_there_are_enough_curves() -> None:
    points = [special(value, 1.0, 1.0) for value in (1.0, 3.0, 3.2, 5.0, 11.0, -1.0, 7.0)]
    line = Line(1e-5, (branch(*points[:4]), branch(*points[4:])))  # type: ignore[arg-type]
    search = Searching(SerialRunner())
    search.add(line, 3)
    # 3.2 lies on the curve of 3; 11 and -1 are outside; one is left.
    assert search.asked == [[1.0], [3.0], [5.0]]
    assert len(search.curves) == 3
    assert search.left == 1
    search.add(line, 4)
    assert search.asked[3:] == [[7.0]]
    assert (len(search.curves), search.left) == (4, 1)
    search.add(line, 9)
    assert not any(search.asked[4:])
    # Several at once; what turns out to lie on the curve before is left out.
    several = Searching(ProcessRunner(5))
    several.add(line, 9)
    assert several.asked == [[1.0, 3.0], [5.0, 7.0]]
    once = Searching(SimpleNamespace())
    once.add(line, 3)
    assert once.asked == [[1.0, 3.0, 3.2], [5.0]]
    assert [each.values[0, 0] for each in once.curves] == [0.5, 2.5, 4.5]
    assert once.left == 1
    at_once = [
        Searching(runner)._at_once for runner in (ProcessRunner(1), ProcessRunner(9), SimpleNamespace())
    ]
    assert at_once == [1, 4, 4]
    elsewhere = SideWork(PLACES[1], LocusRanges((-1.0, 3.0), (2e-5, 6e-5)))
    assert _Search(SerialRunner(), elsewhere, True).spans == pytest.approx([4.0, 4e-5], rel=1e-12)
    assert search.spans == pytest.approx(SPANS, rel=1e-15)
    for value, inside in ((0.0, True), (10.0, True), (-1e-9, False), (10.1, False)):
        assert search._inside(special(value)) == inside


def test_points_of_branches_that_part_come_after_those_of_the_branch() -> None:
    inner = branch(special(3.0))
    outer = branch(
        special(1.0), special(2.0), branches=(inner, branch(special(4.0), branches=(branch(special(5.0)),)))
    )
    line = Line(1e-5, (outer, branch(special(6.0))))  # type: ignore[arg-type]
    assert [point.value for _, point in _points(line)] == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    assert list(_points(line))[2][0] is inner


def map_over(values: tuple[tuple[float, ...], ...]) -> MotionMap:
    inputs = MapInputs(impact_oscillator(), PLACES[: len(values)], values, Settings())
    motion = CellMotion(MotionKind.UNDECIDED)
    return MotionMap(inputs, tuple(CellResult(number, (motion,)) for number in range(inputs.count)))


def test_what_was_searched_names_lines_that_ended_early_or_never_began() -> None:
    lines = [
        Line(1e-5, (branch(special(1.0), special(2.0)), branch(special(3.0), success=False))),  # type: ignore[arg-type]
        Line(2e-5, ()),
    ]
    search = SimpleNamespace(curves=[1, 2], left=3)
    result = map_over(((1.0, 2.0), (1e-5, 2e-5)))
    told = _searched(result, lines, search)  # type: ignore[arg-type]
    assert "at stops.wall.gap = 1e-05, 2e-05: 3 special points, which lie on 2 curves" in told
    assert "; at 2e-05 it settles at neither end of frequency" in told
    assert "; at 1e-05 a branch ends early: it was lost" in told
    assert "; 3 special points more were not followed" in told
    search.left = 0
    plain = _searched(result, [replace(lines[0], branches=lines[0].branches[:1])], search)  # type: ignore[arg-type]
    assert not any(words in plain for words in ("neither", "early", "not followed"))


@pytest.mark.parametrize("values", [((1.0, 1.1),), ((1.0, 1.1), (1e-5,)), ((1.0,), (1e-5, 2e-5))])
def test_curves_need_several_values_of_two_numbers(values: tuple[tuple[float, ...], ...]) -> None:
    with pytest.raises(MapError, match="several values each"):
        special_curves(map_over(values), runner=SerialRunner(), quiet=True)
    with pytest.raises(WrongTypeError, match="result"):
        special_curves(values, runner=SerialRunner(), quiet=True)  # type: ignore[arg-type]


class Recording(SerialRunner):
    """A runner that does nothing with its pieces but keep them, the last first."""

    def __init__(self) -> None:
        self.pieces: list[object] = []

    def results(self, work, pieces):  # type: ignore[no-untyped-def]
        self.pieces += [piece for _, piece in pieces]
        self.work = work.work
        return ((number, Line(piece, ())) for number, piece in reversed(list(pieces)))


def test_lines_are_spread_evenly_inside_the_range_of_the_second_number() -> None:
    runner = Recording()
    found = special_curves(map_over(((2.0, 1.0, 4.0), (6e-5, 2e-5))), lines=4, runner=runner, quiet=True)
    assert runner.pieces == pytest.approx([2.5e-5, 3.5e-5, 4.5e-5, 5.5e-5], rel=1e-12)
    assert runner.work.ranges.both == ((1.0, 4.0), (2e-5, 6e-5))
    assert (found.curves, found.meetings) == ((), ())
    assert "at stops.wall.gap = 2.5e-05, 3.5e-05, 4.5e-05, 5.5e-05" in found.searched


def test_results_come_in_the_order_of_their_pieces() -> None:
    class Backwards:
        def results(self, work, pieces):  # type: ignore[no-untyped-def]
            return map(work, reversed(list(pieces)))

    assert in_order(Backwards(), lambda piece: 10 * piece, [3, 1, 2], "", True) == [30, 10, 20]


def test_a_branch_that_reaches_the_other_end_is_not_followed_back(monkeypatch: pytest.MonkeyPatch) -> None:
    end = np.array([2.0, 0.0, 4e-5])
    point = SimpleNamespace(state=end)
    reached = branch(
        reason=BranchEnd.LEFT_AT_STOP, points=[*[SimpleNamespace(state=9.0 * end)] * 2, point], periods=2
    )
    settled = SimpleNamespace(periods=2, instant=SimpleNamespace(state=end.copy()))
    asked: list[object] = []
    monkeypatch.setattr(special_work, "orbit_from_rest", lambda *given: asked.append(given) or settled)
    assert _reaches(reached, "it")  # type: ignore[arg-type]
    assert asked == [("it", 2000)]
    for change, same in (
        ([1.9e-4, 0.0, 0.0], True),
        ([-2.1e-4, 0.0, 0.0], False),
        ([0.0, 0.9e-4, 0.0], True),
        ([0.0, 1.1e-4, 0.0], False),
        ([0.0, 0.0, 3.9e-9], True),
        ([0.0, 0.0, 4.1e-9], False),
    ):
        settled.instant.state = end + np.array(change)
        assert _reaches(reached, None) is same  # type: ignore[arg-type]
    settled.instant.state, settled.periods = end, 1
    assert not _reaches(reached, None)  # type: ignore[arg-type]
    reached.reason = BranchEnd.TORN
    assert not _reaches(reached, None)  # type: ignore[arg-type]
    reached.reason = BranchEnd.LEFT_AT_STOP
    monkeypatch.setattr(special_work, "orbit_from_rest", lambda mechanism, periods: None)
    assert _reaches(reached, None)  # type: ignore[arg-type]


def test_branches_are_followed_from_both_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    asked, reason = [], BranchEnd.TORN

    def follow(mechanism, place, start, stop, settings):  # type: ignore[no-untyped-def]
        values = mechanism.value("frequency"), mechanism.value("stops.wall.gap")
        asked.append((values, place, start, stop))
        assert settings.quiet
        return branch(reason=reason)

    monkeypatch.setattr(special_work, "follow", follow)
    work = LineWork(impact_oscillator(), PLACES, LocusRanges((1.1, 1.3), (8.0, 10.0)))
    assert len(work(9.0).branches) == 2
    both = [((1.1, 9.0), "frequency", 1.1, 1.3), ((1.3, 9.0), "frequency", 1.3, 1.1)]
    assert asked == both
    monkeypatch.setattr(
        special_work, "_reaches", lambda branch, mechanism: mechanism.value("frequency") == 1.3
    )
    assert len(work(9.0).branches) == 1
    assert asked == [*both, both[0]]
    reason = BranchEnd.NO_START
    assert work(9.0).branches == ()
    assert asked[3:] == both
    assert work(9.0).second == 9.0


def test_each_point_is_followed_up_and_down(monkeypatch: pytest.MonkeyPatch) -> None:
    from trimmer.maps import special_curves as searching

    asked = []

    def follow_special(branch, point, place, stop, ranges, settings):  # type: ignore[no-untyped-def]
        asked.append((branch, point.value, place, stop))
        assert ranges is RANGES
        assert settings.quiet
        reason = LocusEnd.CLOSED if point.value > 4.0 else LocusEnd.LEFT
        return replace(UP if stop > 0.0 else DOWN, reason=reason)

    monkeypatch.setattr(special_work, "follow_special", follow_special)
    monkeypatch.setattr(searching, "bare", lambda branch: ("bare", branch))
    search = _Search(SerialRunner(), SideWork(PLACES[1], RANGES), True)
    made = list(search._followed([("a", special(3.0)), ("b", special(5.0))]))  # type: ignore[list-item]
    assert asked == [
        (("bare", name), value, PLACES[1], stop)
        for name, value in (("a", 3.0), ("b", 5.0))
        for stop in (4e-5, 0.0)
    ]
    assert [point.value for point, _ in made] == [3.0, 5.0]
    assert [len(curve.sides) for _, curve in made] == [2, 1]
    assert made[0][1].sides[0].values is UP.values
