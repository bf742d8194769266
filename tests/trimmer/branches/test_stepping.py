"""Stepping along a branch, and what is asked before and after a step."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.curves import OnCurve, line_front, parabola
from tests.trimmer.branches.maps import Cubic, Failing, Given, Logistic, Torn
from trimmer.branches.branch import BranchEnd
from trimmer.branches.continuation import _by_modulus, _first_front, _interval, continuation
from trimmer.branches.corner import is_torn
from trimmer.branches.orbit import Problem
from trimmer.branches.settings import FollowSettings
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
from trimmer.errors import WrongTypeError

ALONG = np.array([0.0, 0.0, 1.0])
ALONE = FollowSettings(switches=0, quiet=True)


def front_at(map: OnCurve, value: float, problem: Problem | None = None) -> Front:
    place = map.at(value, problem)
    tangent = place.tangent(ALONG)
    assert tangent is not None
    return begun(place.problem, place, tangent)


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
