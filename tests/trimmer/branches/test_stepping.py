"""Stepping along a branch, and what is asked before and after a step."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.curves import OnCurve, parabola
from tests.trimmer.branches.maps import Bent, Cubic, Failing, Given, Logistic, Torn
from trimmer.branches.branch import Branch, BranchEnd, BranchPoint
from trimmer.branches.continuation import _by_modulus, _first_front, _interval, continuation
from trimmer.branches.corner import _tangents, is_torn, turned
from trimmer.branches.joining import front_beyond, joint
from trimmer.branches.known import Known
from trimmer.branches.orbit import Problem
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.branches.step import Front, begun
from trimmer.branches.stepping import (
    Interval,
    Limits,
    _closed,
    _obstacle,
    _passed,
    _rescaled,
    _restarted,
    longest_step,
    scales,
)
from trimmer.branches.switching import _critical, _first, parted_fronts
from trimmer.errors import WrongTypeError

ALONG = np.array([0.0, 0.0, 1.0])
ALONE = FollowSettings(switches=0, quiet=True)


def front_at(map: OnCurve, value: float, problem: Problem | None = None) -> Front:
    place = map.at(value, problem)
    tangent = place.tangent(ALONG)
    assert tangent is not None
    return begun(place.problem, place, tangent)


def line_front(map: object, value: float, state: float, sign: float = 1.0) -> Front:
    problem = Problem(map, 1.0, np.ones(1))  # type: ignore[arg-type]
    place = problem.correct(np.array([state, value]), np.array([0.0, 1.0]), value)
    assert place is not None
    tangent = place.tangent(np.array([0.0, sign]))
    assert tangent is not None
    return begun(problem, place, tangent)


def test_an_interval_holds_what_is_inside_and_not_its_ends() -> None:
    interval = Interval(500.0, -200.0)
    assert interval.span == 700.0
    assert interval.ends == pytest.approx((500.0 / 700.0, -200.0 / 700.0), rel=1e-15)
    held = [interval.holds(value) for value in (500.0, 500.0 - 6e-10, 499.0, -199.0, -200.0 + 6e-10, -200.0)]
    assert held == [False, False, True, True, False, False]


@pytest.mark.parametrize(
    ("start", "stop", "bounds", "expected"),
    [
        (1.0, 3.0, None, (1.0, 3.0)),
        (3.0, 1.0, None, (3.0, 1.0)),
        (1.0, 3.0, (0.5, 4.0), (0.5, 4.0)),
        (1.0, 3.0, (4.0, 0.5), (0.5, 4.0)),
        (3.0, 1.0, (0.5, 4.0), (4.0, 0.5)),
        (1.0, 3.0, (1.0, 1.5), (1.0, 1.5)),
        (1.0, 3.0, (0.5, 1.0), (0.5, 1.0)),
    ],
)
def test_bounds_take_the_place_of_start_and_stop_in_the_direction_of_travel(
    start: float, stop: float, bounds: tuple[float, float] | None, expected: tuple[float, float]
) -> None:
    interval = _interval(start, stop, bounds)
    assert (interval.start, interval.stop) == expected


@pytest.mark.parametrize("bounds", [(1.0, 1.0), (0.0, 0.9), (1.1, 2.0)])
def test_bounds_that_do_not_hold_the_start_are_refused(bounds: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match="around start"):
        _interval(1.0, 2.0, bounds)


@pytest.mark.parametrize(
    ("name", "value", "error"),
    [
        ("most_points", 1, ValueError),
        ("switches", -1, ValueError),
        ("most_periods", 0, ValueError),
        ("largest_step", 1.01, ValueError),
        ("largest_step", 0.0, ValueError),
        ("bounds", (0.0, math.inf), ValueError),
        ("bounds", ("a", 1.0), WrongTypeError),
    ],
)
def test_settings_out_of_range_are_refused(name: str, value: object, error: type[Exception]) -> None:
    with pytest.raises(error, match=name):
        FollowSettings(**{name: value})  # type: ignore[arg-type]


def test_the_smallest_settings_are_taken() -> None:
    settings = FollowSettings(2, 1.0, 0, (3.0, 1.0), 1)
    assert (settings.most_points, settings.largest_step, settings.switches) == (2, 1.0, 0)
    default = FollowSettings()
    assert (default.largest_step, default.switches, default.bounds, default.quiet) == (0.01, 1, None, False)


def test_scales_are_those_of_the_passage_and_a_share_of_the_largest_before() -> None:
    place = SimpleNamespace(passage=SimpleNamespace(sizes=np.array([-3.0, 0.0, 2e-4, 5.0])))
    assert scales(place, None).tolist() == [3.0, 1.0, 2e-4, 5.0]  # type: ignore[arg-type]
    before = np.array([700.0, 0.0, 1.0, 8.0])
    assert scales(place, before) == pytest.approx([7.0, 1.0, 1e-2, 5.0], rel=1e-15)  # type: ignore[arg-type]


def test_a_front_in_the_scale_of_its_orbit_is_the_same_front() -> None:
    map = parabola()
    problem = Problem(map, 7.0, np.array([3.0, 50.0]))
    earlier = map.at(1.9, problem)
    place = map.at(2.0, problem)
    tangent = place.tangent(ALONG)
    assert tangent is not None
    front = Front(problem, place, tangent, 1.0, earlier)
    found, largest = _rescaled(front, np.array([900.0, 1.0]))
    assert found.problem.sizes == pytest.approx([9.0, 6.0], rel=1e-12)
    assert largest == pytest.approx([900.0, 6.0], rel=1e-12)
    assert found.place.position == pytest.approx([4.0 / 9.0, 1.0, 2.0 / 7.0], rel=1e-12)
    assert found.before is not None
    assert found.before.position == pytest.approx([1.9**2 / 9.0, 5.7 / 6.0, 1.9 / 7.0], rel=1e-12)
    wanted = np.array([4.0 / 9.0, 3.0 / 6.0, 1.0 / 7.0])
    assert found.tangent == pytest.approx(wanted / np.linalg.norm(wanted), rel=1e-12)
    assert found.turn == front.turn
    alone, _ = _rescaled(replace(front, before=None), np.zeros(2))
    assert alone.before is None


@pytest.mark.parametrize(("largest", "length"), [(0.02, 0.02), (1.0, 0.1)])
def test_a_step_is_no_longer_than_it_may_be(largest: float, length: float) -> None:
    straight = OnCurve(lambda p: np.array([0.0, 1.0]), lambda p: np.zeros(2))
    front = front_at(straight, 0.5)
    limits = Limits(Interval(0.0, 1.0), FollowSettings(largest_step=largest))
    made, following = longest_step(front, 5.0, limits)
    assert made is not None
    assert made.front.place.position[-1] == pytest.approx(0.5 + length, rel=1e-12)
    # A straight branch bears a step of twice the length.
    assert following == pytest.approx(2.0 * length, rel=1e-12)


def test_a_step_on_a_branch_that_is_not_along_the_values_is_longer_in_all_coordinates() -> None:
    front = front_at(parabola(), 0.5)
    limits = Limits(Interval(0.0, 1.0), FollowSettings(largest_step=0.01))
    made, following = longest_step(front, 5.0, limits)
    assert made is not None
    assert made.front.place.position[-1] == pytest.approx(0.51, rel=1e-12)
    length = 0.01 * math.sqrt(11.0)
    assert following == pytest.approx(length * min(max(0.15 / made.bend, 0.5), 2.0), rel=1e-9)


def test_the_next_step_is_shorter_after_a_bend() -> None:
    sharp = OnCurve(lambda p: np.array([0.0, 40.0 * p * p]), lambda p: np.array([0.0, 80.0 * p]))
    made, following = longest_step(front_at(sharp, 0.0), 0.01, Limits(Interval(-1.0, 1.0), ALONE))
    assert made is not None
    value = made.front.place.position[-1]
    assert made.bend == pytest.approx(math.atan(80.0 * value), rel=1e-9)
    assert following == pytest.approx(value * max(0.15 / made.bend, 0.5), rel=1e-9)


def test_a_step_that_finds_no_orbit_is_halved() -> None:
    ending = parabola(ends=0.513)
    front = front_at(ending, 0.5)
    made, _ = longest_step(front, 0.1, Limits(Interval(0.0, 1.0), FollowSettings(largest_step=0.02)))
    assert made is not None
    assert made.front.place.position[-1] == pytest.approx(0.51, rel=1e-12)
    nothing, length = longest_step(front, 0.1, Limits(Interval(0.0, 1.0), ALONE), 0.08)
    assert (nothing, length) == (None, 1e-3)


def test_an_obstacle_is_torn_neutral_or_only_an_end() -> None:
    assert _obstacle(line_front(Torn(), -1e-11, -2e-11)) is BranchEnd.TORN
    assert _obstacle(line_front(Failing(), 0.5 - 1e-12, 1.0)) is BranchEnd.STEP_TOO_SMALL
    # At the middle of the fork a multiplier is 1.
    flat = Cubic(mirrored=False)
    problem = Problem(flat, 1.0, np.ones(1))
    place = problem.place(np.array([0.0, 0.0]))
    assert place is not None
    stuck = Front(problem, place, np.array([0.0, 1.0]), 1.0)
    assert _obstacle(stuck) is BranchEnd.NOT_ISOLATED
    assert not is_torn(stuck)


def test_a_corner_is_passed_or_turned_at() -> None:
    # Beyond x = 0 the fixed points are p / (1 - slope): behind, if the slope is above 1.
    for slope, ahead in ((-0.5, 1.0), (2.0, -1.0)):
        front = line_front(Bent(0.5, slope), -1e-11, -2e-11)
        made = turned(front)
        assert made is not None
        wanted = np.array([ahead / (1.0 - slope), ahead])
        assert made.front.tangent == pytest.approx(wanted / np.linalg.norm(wanted), rel=1e-9)
        kinds = [point.kind for point in made.special]
        assert kinds == [SpecialKind.GRAZING, SpecialKind.FOLD][: 1 + (ahead < 0.0)]
        old = np.array([2.0, 1.0]) / math.sqrt(5.0)
        assert made.bend == pytest.approx(math.acos(made.front.tangent @ old), rel=1e-6)
        assert made.switches == ()
        assert 0.0 < abs(made.front.place.position[1]) < 1e-9
    assert turned(line_front(Bent(0.5, 2.0), -0.5, -1.0)) is None
    assert turned(line_front(Failing(), 0.5 - 1e-12, 1.0)) is None


def test_behind_a_corner_the_direction_with_the_same_turn_comes_first() -> None:
    front = line_front(Bent(0.5, 2.0), -1e-11, -2e-11)
    beyond = front.problem.place(np.array([1e-9, 1e-9]))
    assert beyond is not None
    first, second = _tangents(front, beyond)
    assert np.sign(beyond.orientation(first)) == front.turn
    assert first.tolist() == (-second).tolist()
    other = _tangents(replace(front, turn=-front.turn), beyond)
    assert other[0].tolist() == second.tolist()
    assert len(_tangents(replace(front, turn=0.0), beyond)) == 2


def test_a_branch_closes_where_it_passes_its_first_orbit() -> None:
    map = parabola()
    before, after = front_at(map, 0.5), front_at(map, 0.6)
    middle = map.at(0.56)
    assert _passed(middle.position, before, after)
    assert _passed(after.place.position, before, after)
    for value in (0.5, 0.48, 0.61):
        assert not _passed(map.at(value).position, before, after)
    # Beside the chord, and beside the branch though near the chord.
    assert not _passed(middle.position + np.array([0.05, 0.0, 0.0]), before, after)
    assert not _passed(middle.position + np.array([1e-5, 0.0, 0.0]), before, after)
    assert _closed(front_at(map, 0.56), before, after)
    touching = parabola(signature=lambda p: {("stop", None): int(p == 0.56)})  # type: ignore[dict-item]
    assert not _closed(front_at(touching, 0.56), before, after)


@dataclass(frozen=True)
class Restarting(Logistic):
    """A map that changes to another one whose orbits are those mirrored, x -> 1 - x."""

    mirrored_states: bool = False
    lost: bool = False

    def passage(self, value: float, state: np.ndarray) -> Given:
        x = 1.0 - state if self.mirrored_states else state
        found = super().passage(value, x)
        if not self.mirrored_states:
            return found
        return replace(found, end=1.0 - found.end, by_value=-found.by_value)

    def restarted(self, value: float, state: np.ndarray) -> tuple[Restarting, np.ndarray]:
        if self.mirrored_states:
            return self, state
        return Restarting(mirrored_states=True), np.array([np.nan]) if self.lost else 1.0 - state + 1e-9


def test_a_front_begins_where_its_map_says() -> None:
    front = line_front(Logistic(), 2.5, 0.6)
    assert _restarted(front) is front
    for sign in (1.0, -1.0):
        front = line_front(Restarting(), 2.5, 0.6, sign)
        other = _restarted(front)
        assert other.problem.map.mirrored_states  # type: ignore[attr-defined]
        x = 1.0 - 1.0 / other.place.position[1]
        assert other.place.position[0] == pytest.approx(1.0 - x, rel=1e-12)
        assert np.sign(other.tangent[1]) == sign
        assert other.tangent[0] == pytest.approx(-front.tangent[0], rel=1e-6)
    lost = line_front(Restarting(lost=True), 2.5, 0.6)
    assert _restarted(lost) is lost


def test_multipliers_come_by_falling_modulus() -> None:
    found = _by_modulus(np.array([0.1 + 0.0j, -2.0, 0.5j]))
    assert found.tolist() == [-2.0, 0.5j, 0.1]


def test_the_first_front_is_exact_and_leads_towards_the_other_end() -> None:
    for start, stop in ((2.5, 2.9), (2.9, 2.5)):
        front = _first_front(Logistic(), np.array([0.61]), start, Interval(start, stop))
        assert isinstance(front, Front)
        assert front.problem.span == pytest.approx(0.4)
        assert front.problem.value(front.place.position) == pytest.approx(start, rel=1e-15)
        assert front.problem.state(front.place.position) == pytest.approx([1.0 - 1.0 / start], rel=1e-12)
        assert np.sign(front.tangent[-1]) == math.copysign(1.0, stop - start)
        assert front.problem.sizes == pytest.approx([1.0 - 1.0 / start], rel=1e-12)
    # Where the tangent is not single, and where no orbit is near.
    assert _first_front(Cubic(), np.array([0.0]), 0.0, Interval(0.0, 1.0)) is BranchEnd.NOT_ISOLATED
    assert _first_front(Failing(), np.array([0.0]), 0.7, Interval(0.7, 1.0)) is None


def test_a_branch_of_points_has_tangents_in_the_units_of_the_file() -> None:
    branch = continuation(Logistic(), np.array([0.6]), 2.5, 2.9, ALONE)
    for point in branch.points[:: len(branch.points) // 3]:
        assert point.tangent[0] / point.tangent[1] == pytest.approx(1.0 / point.value**2, rel=1e-9)
        assert point.tangent[1] > 0.0
        assert (point.events, point.signature) == (0, {})
    assert branch.message == f"{BranchEnd.LEFT_AT_STOP.value}, at 2.9"
    assert (branch.doublings, branch.parted) == (0, None)
    mirrored = continuation(Cubic(mirrored=True), np.array([0.0]), -0.5, -0.2, ALONE)
    # The whole period is two passages.
    assert [point.multipliers[0] for point in mirrored.points] == pytest.approx(
        [(1.0 + point.value) ** 2 for point in mirrored.points], rel=1e-12
    )


def of_value(value: float, state: float) -> BranchPoint:
    return BranchPoint(value, np.array([state]), np.array([0.5 + 0j]), np.zeros(2), {}, 0)


@pytest.mark.parametrize(
    ("reason", "first", "ends", "rejoined"),
    [
        (BranchEnd.LEFT_AT_STOP, True, 2, 0),
        (BranchEnd.LEFT_AT_START, False, 1, 0),
        (BranchEnd.CLOSED, True, 1, 0),
        (BranchEnd.TORN, True, 1, 0),
        (BranchEnd.REJOINED, True, 1, 1),
        (BranchEnd.REJOINED, False, 0, 1),
        (BranchEnd.STEP_TOO_SMALL, True, 0, 0),
        (BranchEnd.MOST_POINTS, True, 0, 0),
        (BranchEnd.NOT_ISOLATED, True, 0, 0),
    ],
)
def test_what_is_known_of_a_branch_depends_on_how_it_ends(
    reason: BranchEnd, first: bool, ends: int, rejoined: int
) -> None:
    known = Known(0)
    begin, last = of_value(1.0, 0.2), of_value(2.0, 0.3)
    known.add(3, begin if first else None, last, reason)
    assert (len(known.ends), len(known.rejoined)) == (ends, rejoined)
    assert all(number == 3 for number, _ in (*known.ends, *known.rejoined))
    if ends == 2:
        assert [point for _, point in known.ends] == [begin, last]
    if rejoined:
        assert known.rejoined[0][1] is last


def test_an_end_is_known_if_value_state_and_doublings_agree() -> None:
    known = Known(0, ends=[(0, of_value(3.3, 0.7))])
    problem = Problem(Logistic(), 2.0, np.array([0.5]))
    assert known.holds(problem, of_value(3.3, 0.7))
    assert known.holds(problem, of_value(3.3 + 1e-6, 0.7 + 4e-7))
    assert not known.holds(problem, of_value(3.3 + 3e-6, 0.7))
    assert not known.holds(problem, of_value(3.3, 0.7 + 6e-7))
    assert not known.holds(Problem(Logistic().doubled(), 2.0, np.array([0.5])), of_value(3.3, 0.7))
    assert not Known(0).holds(problem, of_value(3.3, 0.7))


def test_an_orbit_a_period_apart_is_the_same() -> None:
    value, root = 3.3, math.sqrt(0.3 * 4.3)
    low, high = ((value + 1.0 + sign * root) / (2.0 * value) for sign in (-1.0, 1.0))
    problem = Problem(Logistic().doubled(), 1.0, np.ones(1))
    assert Known(0, ends=[(1, of_value(value, low))]).holds(problem, of_value(value, high))
    assert not Known(0, ends=[(1, of_value(value, 0.5))]).holds(problem, of_value(value, high))


def test_a_branch_that_joined_is_known_at_the_bifurcation() -> None:
    problem = Problem(Logistic(), 2.0, np.array([0.5]))
    place = problem.place(problem.position(3.0, np.array([2.0 / 3.0])))
    assert place is not None
    bifurcation = SimpleNamespace(place=place)

    def joined(doublings: int, value: float, state: float) -> bool:
        known = Known(0, rejoined=[(doublings, of_value(value, state))])
        return known.is_joined(problem, bifurcation, 0.01)  # type: ignore[arg-type]

    assert joined(1, 3.0, 0.7)
    assert joined(1, 3.019, 0.7)
    assert not joined(1, 3.021, 0.7)
    assert not joined(0, 3.0, 0.7)
    assert not joined(1, 3.0, 2.0 / 3.0 + 0.051)
    assert joined(1, 3.0, 2.0 / 3.0 - 0.049)


def test_the_branch_of_single_orbits_goes_on_to_both_sides_of_a_joint() -> None:
    problem = Problem(Logistic().doubled(), 1.0, np.ones(1))
    across = np.array([0.0, 1.0])
    near = problem.correct(np.array([0.63, 3.01]), across, 3.01)
    far = problem.correct(np.array([0.665, 2.995]), across, 2.995)
    assert near is not None and far is not None
    tangent = near.tangent(-across)
    assert tangent is not None
    front = begun(problem, near, tangent)
    meeting = joint(front, far)
    assert meeting is not None
    assert meeting.switches
    assert meeting.point.kind is SpecialKind.PERIOD_DOUBLING
    assert meeting.point.state == pytest.approx([2.0 / 3.0], rel=1e-12)
    assert meeting.place.position == pytest.approx([2.0 / 3.0, 3.0], rel=1e-12)
    for sign in (1.0, -1.0):
        beyond = front_beyond(meeting, sign)
        assert beyond is not None
        value = 3.0 + sign * 1e-6
        assert beyond.place.position == pytest.approx([1.0 - 1.0 / value, value], rel=1e-12)
        assert np.sign(beyond.tangent[-1]) == sign
    # Far away from where the doubled orbits show it there is none, nor of a map that was not doubled.
    aside = problem.correct(np.array([0.62, 2.9]), across, 2.9)
    assert aside is not None
    assert joint(Front(problem, aside, tangent, 1.0), aside) is None
    assert joint(Front(Problem(Logistic(), 1.0, np.ones(1)), near, tangent, 1.0), far) is None


def test_a_branch_of_twice_the_period_parts_along_the_critical_direction() -> None:
    problem = Problem(Logistic(), 1.0, np.ones(1))
    place = problem.correct(np.array([0.66, 3.0]), np.array([0.0, 1.0]), 3.0)
    assert place is not None
    bifurcation = SimpleNamespace(place=place)
    (front,) = parted_fronts(problem, bifurcation)  # type: ignore[arg-type]
    assert front.problem.map.doublings == 1
    away = front.place.position - place.position
    assert abs(away[0]) == pytest.approx(3e-5, rel=1e-9)
    # The doubled orbits x = (r + 1 - sqrt((r - 3) (r + 1))) / (2 r) and its other half.
    value = front.place.position[1]
    halves = [
        (value + 1.0 + sign * math.sqrt((value - 3.0) * (value + 1.0))) / (2.0 * value) for sign in (-1, 1)
    ]
    assert min(abs(front.place.position[0] - each) for each in halves) < 1e-9
    assert value > 3.0


def test_where_branches_cross_one_parts_on_each_side() -> None:
    problem = Problem(Cubic(), 1.0, np.ones(1))
    place = problem.place(np.array([0.0, 0.0]))
    assert place is not None
    fronts = parted_fronts(problem, SimpleNamespace(place=place))  # type: ignore[arg-type]
    assert sorted(front.place.position[0] for front in fronts) == pytest.approx([-3e-5, 3e-5], rel=1e-9)
    assert all(front.problem is problem for front in fronts)


def test_the_critical_direction_is_the_eigenvector_of_the_multiplier() -> None:
    turn = np.array([[1.0, 0.5], [0.25, 1.0]])
    place = parabola(matrix=lambda p: turn @ np.diag([-1.0, 0.4]) @ np.linalg.inv(turn)).at(0.5)
    found = _critical(place, -1.0)
    wanted = np.append(turn[:, 0] / np.linalg.norm(turn[:, 0]), 0.0)
    assert found * np.sign(found[0]) == pytest.approx(wanted, abs=1e-12)


@dataclass(frozen=True)
class Near(OnCurve):
    """Orbits that are not found within a distance of the value 0.5."""

    hole: float = 0.0

    def passage(self, value: float, state: np.ndarray) -> Given:
        found = super().passage(value, state)
        return replace(found, end=found.end + 1.0) if abs(value - 0.5) < self.hole else found


@pytest.mark.parametrize(("hole", "distance"), [(0.0, 3e-5), (5e-5, 1e-4), (5e-4, 1e-3), (5e-3, 1e-2)])
def test_the_first_orbit_is_sought_farther_away_where_it_is_not_found(hole: float, distance: float) -> None:
    map = Near(lambda p: np.zeros(2), lambda p: np.zeros(2), hole=hole)
    problem = Problem(map, 1.0, np.ones(2))
    front = _first(problem, np.array([0.0, 0.0, 0.5]), ALONG)
    assert front is not None
    assert front.place.position[-1] == pytest.approx(0.5 + distance, rel=1e-12)
    beyond = Near(lambda p: np.zeros(2), lambda p: np.zeros(2), hole=0.1)
    assert _first(Problem(beyond, 1.0, np.ones(2)), np.array([0.0, 0.0, 0.5]), ALONG) is None
    aside = Near(lambda p: np.array([0.1, 0.0]), lambda p: np.zeros(2))
    assert _first(Problem(aside, 1.0, np.ones(2)), np.array([0.0, 0.0, 0.5]), ALONG) is None


def test_which_ends_are_successes_and_which_orbits_are_stable() -> None:
    failures = {each for each in BranchEnd if not each.is_success}
    assert failures == {
        BranchEnd.NOT_ISOLATED,
        BranchEnd.STEP_TOO_SMALL,
        BranchEnd.MOST_POINTS,
        BranchEnd.NO_START,
    }
    assert Branch((), (), BranchEnd.TORN, "").success
    assert not Branch((), (), BranchEnd.NO_START, "").success
    for multipliers, stable in (([0.9, -0.5], True), ([0.9, -1.0], False), ([0.3, 1.0 - 1e-10], False)):
        point = BranchPoint(0.0, np.zeros(1), np.array(multipliers, dtype=complex), np.zeros(2), {}, 0)
        assert point.stable is stable


def test_a_special_point_tells_its_parts() -> None:
    point = SpecialPoint(SpecialKind.STICK, 1.0 / 3.0, np.zeros(1), ("blade", "comb"))
    assert "stick of blade and comb at 0.333333333" in str(point)
    assert " of " not in str(SpecialPoint(SpecialKind.FOLD, 2.0, np.zeros(1)))


def test_a_doubled_map_joins_both_passages() -> None:
    map = Logistic().doubled()
    first, second = Logistic().passage(3.2, np.array([0.3])), None
    second = Logistic().passage(3.2, first.end)
    passage = map.passage(3.2, np.array([0.3]))
    assert passage.end == second.end
    assert passage.middle == first.end
    assert passage.jacobian == pytest.approx(second.jacobian * first.jacobian, rel=1e-15)
    assert passage.monodromy == pytest.approx(second.jacobian * first.jacobian, rel=1e-15)
    assert passage.sizes == max(first.sizes, second.sizes)
    step = 1e-6
    ends = [map.passage(3.2 + sign * step, np.array([0.3])).end for sign in (1.0, -1.0)]
    assert passage.rate() == pytest.approx((ends[0] - ends[1]) / (2.0 * step), rel=1e-8)
    shortest = (SimpleNamespace(shortest=lambda *_: 3e-3), SimpleNamespace(shortest=lambda *_: 2e-3))
    assert replace(passage, first=shortest[0], second=shortest[1]).shortest("a", None) == 2e-3  # type: ignore[arg-type]
    assert map.doubled().doublings == 2
    assert map.size == 1
    counted = replace(
        passage,
        first=SimpleNamespace(signature={"a": 1, "b": 2}, events=3),  # type: ignore[arg-type]
        second=SimpleNamespace(signature={"b": 1}, events=5),  # type: ignore[arg-type]
    )
    assert counted.signature == {"a": 1, "b": 3}
    assert counted.events == 8
