"""Stepping along a branch, and what is asked before and after a step."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.curves import Curve, OnCurve, line_front, parabola
from tests.trimmer.branches.maps import Cubic, Failing, Given, Logistic, Torn
from trimmer.branches import stepping
from trimmer.branches.branch import BranchEnd
from trimmer.branches.corner import is_torn
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_maps.strobe import Restart
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
    steps,
)

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


def test_scales_are_those_of_the_passage_and_a_share_of_the_largest_before() -> None:
    place = SimpleNamespace(passage=SimpleNamespace(sizes=np.array([3.0, 0.0, 2e-4, 5.0])))
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


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(("largest", "length"), [(0.02, 0.02), (1.0, 0.1)])
def test_a_step_is_no_longer_than_it_may_be(largest: float, length: float, sign: float) -> None:
    straight = OnCurve(lambda p: np.array([0.0, 1.0]), lambda p: np.zeros(2))
    front = front_at(straight, 0.5)
    front = begun(front.problem, front.place, sign * front.tangent)
    limits = Limits(Interval(0.0, 1.0), FollowSettings(largest_step=largest))
    made, following = longest_step(front, 5.0, limits)
    assert made is not None
    assert made.front.place.position[-1] == pytest.approx(0.5 + sign * length, rel=1e-12)
    # A straight branch bears a step of twice the length.
    assert following == pytest.approx(2.0 * length, rel=1e-12)
    # One of exactly the least length is tried, and none below it.
    assert longest_step(front, length, limits, length)[0] is not None
    assert longest_step(front, length, limits, 1.01 * length) == (None, 1e-3)


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


class Stepping:
    """Stands in for the parts of ``steps``: each front has a number, which is that of its step."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, *made: SimpleNamespace | None) -> None:
        self.made, self.asked, self.closes = list(made), list[object](), -1
        for name in ("rescaled", "closed", "obstacle"):
            monkeypatch.setattr(stepping, f"_{name}", getattr(self, name))
        monkeypatch.setattr(stepping, "longest_step", self.longest_step)

    def rescaled(self, front: SimpleNamespace, largest: np.ndarray) -> tuple[SimpleNamespace, np.ndarray]:
        self.asked.append(largest.tolist())
        return numbered(front.number, f"scaled {front.number}"), largest + 1.0

    def longest_step(
        self, front: SimpleNamespace, length: float, limits: Limits
    ) -> tuple[SimpleNamespace | None, float]:
        self.asked.append((front.problem.name, length))
        return self.made.pop(0), 0.5 * length

    def closed(self, first: SimpleNamespace, before: SimpleNamespace, after: SimpleNamespace) -> bool:
        self.asked.append((first.problem.name, before.problem.name, after.problem.name))
        return bool(after.number == self.closes)

    def obstacle(self, front: SimpleNamespace) -> str:
        return f"obstacle at {front.problem.name}"


def numbered(number: int, name: str) -> SimpleNamespace:
    return SimpleNamespace(number=number, problem=SimpleNamespace(name=name, map=SimpleNamespace(size=2)))


def made(number: int, ended: BranchEnd | None = None) -> SimpleNamespace:
    return SimpleNamespace(front=numbered(number, f"raw {number}"), ended=ended)


def test_each_step_is_made_in_the_scale_of_its_orbit_with_the_length_that_the_last_one_says(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    stand_in = Stepping(monkeypatch, made(1), made(2), None)
    limits = Limits(Interval(0.0, 1.0), FollowSettings(most_points=9))
    first, second, end = steps(numbered(0, "first"), limits, 4)  # type: ignore[arg-type]
    assert [(each[0].front.number, each[1].name) for each in (first, second)] == [  # type: ignore[index, union-attr]
        (1, "scaled 0"),
        (2, "scaled 1"),
    ]
    assert end == "obstacle at scaled 2"
    assert stand_in.asked == [
        *([0.0, 0.0], ("scaled 0", 1e-3)),
        *([1.0, 1.0], ("scaled 1", 5e-4), ("first", "scaled 1", "raw 2")),
        *([2.0, 2.0], ("scaled 2", 2.5e-4)),
    ]


def test_steps_end_by_themselves_where_the_branch_closes_or_at_most_points(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    limits = Limits(Interval(0.0, 1.0), FollowSettings(most_points=9))

    def ends(count: int, closes: int, *given: SimpleNamespace) -> list[object]:
        Stepping(monkeypatch, *given).closes = closes
        found = steps(numbered(0, "first"), limits, count)  # type: ignore[arg-type]
        return [each if isinstance(each, BranchEnd) else each[0].front.number for each in found]  # type: ignore[attr-defined]

    left = BranchEnd.LEFT_AT_STOP
    assert ends(3, -1, made(1), made(2, left), made(3)) == [1, 2, left]
    assert ends(3, 2, made(1), made(2), made(3)) == [1, 2, BranchEnd.CLOSED]
    # The first step begins at the first orbit, and does not pass it.
    assert ends(6, 1, made(1), made(2), made(3), made(4)) == [1, 2, 3]
    assert ends(9, -1, made(1)) == []


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


def test_one_neutral_multiplier_of_several_is_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stepping, "is_torn", lambda front: False)
    for multipliers, end in (
        ([1.0 - 9e-10, 0.3], BranchEnd.NOT_ISOLATED),
        ([-0.5, 1.0 + 9e-10], BranchEnd.NOT_ISOLATED),
        ([1.0 - 2e-9, 0.3], BranchEnd.STEP_TOO_SMALL),
        ([-1.0, 0.3], BranchEnd.STEP_TOO_SMALL),
    ):
        place = SimpleNamespace(multipliers=np.array(multipliers))
        assert _obstacle(SimpleNamespace(place=place)) is end  # type: ignore[arg-type]


@dataclass(frozen=True)
class Several(OnCurve):
    """A map whose orbits begin at states that are some distances aside."""

    def __init__(self, curve: Curve, rate: Curve, aside: tuple[float, ...]) -> None:
        super().__init__(curve, rate)
        object.__setattr__(self, "aside", aside)

    def phases(self, value: float, state: np.ndarray) -> list[np.ndarray]:
        return [state + each for each in vars(self)["aside"]]


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
    across = np.array([3.0, -1.1, 0.0]) / math.hypot(3.0, 1.1)
    assert _passed(middle.position + 0.9e-6 * across, before, after)
    assert not _passed(middle.position + 1.3e-6 * across, before, after)
    assert not _passed(middle.position - 1.3e-6 * across, before, after)
    # A tenth of the chord is the most: of a chord of 10 the curve may lie 1 aside.
    wide = OnCurve(
        lambda p: np.array([1.0 - (p - 5.0) ** 2 / 25.0, 0.0]), lambda p: np.array([0.4 - 0.08 * p, 0.0])
    )
    assert _passed(wide.at(5.0).position, front_at(wide, 0.0), front_at(wide, 10.0))
    assert _closed(front_at(map, 0.56), before, after)
    # An orbit may begin at several of its states.
    for others in ([9.0, 0.0], [0.0, 9.0], [0.0, 0.0]):
        several = replace(
            before, problem=replace(before.problem, map=Several(map.curve, map.rate, tuple(others)))
        )
        assert _closed(front_at(map, 0.56), several, after) is (0.0 in others)
    far = replace(before, problem=replace(before.problem, map=Several(map.curve, map.rate, (9.0,))))
    assert not _closed(front_at(map, 0.56), far, after)
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
        if self.mirrored_states:
            return replace(found, end=1.0 - found.end, by_value=-found.by_value)
        begin = np.array([np.nan]) if self.lost else 1.0 - state + 1e-9
        return Moved(**vars(found), begin=begin)


@dataclass(frozen=True, eq=False, kw_only=True)
class Moved(Given):
    """A passage that had better begin elsewhere."""

    begin: np.ndarray

    def restart(self, tangent: np.ndarray) -> Restart:
        return Restart(Restarting(mirrored_states=True), self.begin, tangent * [-1.0, 1.0])


def test_a_front_without_a_tangent_stays_where_it_begins(monkeypatch: pytest.MonkeyPatch) -> None:
    front = line_front(Restarting(), 2.5, 0.6)
    monkeypatch.setattr(Place, "tangent", lambda self, reference: None)
    assert _restarted(front) is front


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
