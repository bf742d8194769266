"""Legs of a branch one after the other: what is recorded of them, and what is followed from their ends."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.branches.maps import Cubic, Given, Logistic
from trimmer.branches import continuation as legs
from trimmer.branches.branch import Branch, BranchEnd, BranchPoint
from trimmer.branches.continuation import (
    _branch_point,
    _first_front,
    _follow_leg,
    _followed,
    _joined,
    _Leg,
    _parted,
    _Record,
    continuation,
)
from trimmer.branches.known import Known
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.branches.step import Front
from trimmer.branches.stepping import Interval, Limits

LIMITS = Limits(Interval(2.0, 5.0), FollowSettings(most_points=9, largest_step=0.03, quiet=True))
MAP = SimpleNamespace(doublings=2, mirrored=False)


def front(value: float, map: object = MAP) -> Any:
    return SimpleNamespace(value=value, problem=SimpleNamespace(map=map, name=f"from {value}"))


def special(value: float) -> SpecialPoint:
    return SpecialPoint(SpecialKind.PERIOD_DOUBLING, value, np.zeros(1))


def bifurcation(value: float, mirrored: bool = False) -> Any:
    place = SimpleNamespace(problem=SimpleNamespace(map=SimpleNamespace(mirrored=mirrored)))
    return SimpleNamespace(point=special(value), place=place)


def point(front: Any, *, stable: bool = True) -> BranchPoint:
    multipliers = np.array([0.5 if stable else 2.0], dtype=complex)
    return BranchPoint(front.value, np.zeros(1), multipliers, {}, 0)


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What ``steps`` yields, from fronts that stand in; the count it was given comes last."""
    found: list[Any] = []

    def steps(front: Any, limits: Limits, count: int) -> Iterator[Any]:
        found.append(count)
        yield from found[:-1]

    monkeypatch.setattr(legs, "steps", steps)
    monkeypatch.setattr(legs, "_branch_point", point)
    return found


def step(value: float, *points: SpecialPoint, switches: tuple[Any, ...] = (), beyond: Any = None) -> Any:
    return SimpleNamespace(front=front(value), special=points, switches=switches, beyond=beyond)


def test_a_leg_is_recorded_step_by_step(made: list[Any]) -> None:
    switch = bifurcation(3.5)
    made += [
        (step(3.0, special(2.5), special(2.0)), "first"),
        (step(5.0, special(5.0), special(3.5), switches=(switch,)), "second"),
        BranchEnd.CLOSED,
        (step(9.0), "never"),
    ]
    record = _Record([point(front(2.0)), point(front(2.1))])
    leg = _follow_leg(front(2.1), LIMITS, record)
    assert made[-1] == 2
    assert (leg.reason, leg.joint, leg.front.value) == (BranchEnd.CLOSED, None, 5.0)
    assert [each.value for each in record.points] == [2.0, 2.1, 3.0, 5.0]
    # What lies at an end of the interval is left out.
    assert [each.value for each in record.special] == [2.5, 3.5]
    assert record.switches == [("second", switch)]


def test_a_leg_ends_with_its_points_or_where_it_joins(
    made: list[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    made.append((step(3.0), "first"))
    ended = _follow_leg(front(2.0), LIMITS, _Record([point(front(2.0))]))
    assert (ended.reason, ended.front.value, ended.joint) == (BranchEnd.MOST_POINTS, 3.0, None)
    monkeypatch.setattr(legs, "joint", lambda front, beyond: ("joint", front.value, beyond))
    made[:] = [(step(3.0), "first"), (step(4.0, special(3.7), beyond="there"), "second")]
    record = _Record([point(front(2.0))])
    ended = _follow_leg(front(2.0), LIMITS, record)
    assert (ended.reason, ended.front.value) == (BranchEnd.REJOINED, 4.0)
    assert ended.joint == ("joint", 4.0, "there")  # type: ignore[comparison-overlap]
    assert [each.value for each in record.points] == [2.0, 3.0]
    assert record.special == []


@dataclass
class Followed:
    """Stands in for legs and branches that part: gives what it is told to, and keeps what it is asked."""

    legs: list[_Leg]
    behind: list[Any]
    parted: list[Any]
    asked: list[Any]

    def leg(self, begun: Any, limits: Limits, record: _Record) -> _Leg:
        leg = self.legs.pop(0)
        record.points += [point(front(leg.front.value - 0.25)), point(leg.front)]
        return leg

    def joined(self, leg: _Leg, at: Any, limits: Limits, record: _Record) -> tuple[_Leg, list[Any]]:
        self.asked.append(("joined", leg.front.value, at.point.value))
        record.points.append(point(front(4.5)))
        return _Leg(front(4.5, SimpleNamespace(doublings=1)), BranchEnd.LEFT_AT_STOP), self.behind

    def parts(self, record: _Record, limits: Limits, switches: int, known: Known) -> Iterator[Any]:
        self.asked.append(("parted", switches))
        yield from self.parted


@pytest.fixture
def follower(made: list[Any], monkeypatch: pytest.MonkeyPatch) -> Followed:
    found = Followed([], [], [], [])
    monkeypatch.setattr(legs, "_follow_leg", found.leg)
    monkeypatch.setattr(legs, "_joined", found.joined)
    monkeypatch.setattr(legs, "_parted", found.parts)
    return found


def test_a_branch_that_joins_goes_on_and_both_are_known(follower: Followed) -> None:
    meeting = bifurcation(4.0)
    follower.legs += [_Leg(front(4.0), BranchEnd.REJOINED, meeting), _Leg(front(3.0), BranchEnd.TORN)]
    follower.behind = [front(4.1, SimpleNamespace(doublings=1))]
    other = Branch((), (), BranchEnd.CLOSED, "")
    follower.parted = [None, other]
    known = Known(2)
    parted = special(2.0)
    branch = _followed(front(2.0), LIMITS, 1, parted, known)
    assert branch is not None
    assert known.lowest == 1
    assert [each.value for each in branch.points] == [2.0, 3.75, 4.0, 4.5]
    assert branch.special == (meeting.point,)
    assert (branch.reason, branch.doublings) == (BranchEnd.LEFT_AT_STOP, 2)
    assert branch.message == f"{BranchEnd.LEFT_AT_STOP.value}, at 4.5"
    assert branch.parted is parted
    behind, last = branch.branches
    assert last is other
    assert behind.parted is meeting.point
    assert (behind.reason, behind.doublings) == (BranchEnd.TORN, 1)
    assert follower.asked == [("joined", 4.0, 4.0), ("parted", 1)]
    # The first orbit, the one at which it joined, and the end of what went on.
    assert [(number, each.value) for number, each in known.ends] == [(2, 2.0), (1, 4.5)]
    assert [(number, each.value) for number, each in known.rejoined] == [(2, 4.0)]


def test_a_branch_that_joins_one_that_was_followed_ends_there(follower: Followed) -> None:
    follower.legs.append(_Leg(front(4.0), BranchEnd.REJOINED, bifurcation(4.0)))
    known = Known(1)
    branch = _followed(front(2.5), LIMITS, 1, None, known)
    assert branch is not None
    assert (branch.reason, branch.special, branch.branches) == (BranchEnd.REJOINED, (), ())
    assert known.lowest == 1
    assert [each.value for each in branch.points] == [2.5, 3.75, 4.0]
    assert follower.asked == [("parted", 1)]
    # It has begun inside of the interval.
    assert (known.ends, len(known.rejoined)) == ([], 1)


def test_without_switches_nothing_that_parts_is_followed(follower: Followed) -> None:
    follower.legs.append(_Leg(front(4.0), BranchEnd.REJOINED, bifurcation(4.0)))
    follower.behind = [front(4.1)]
    branch = _followed(front(2.0), LIMITS, 0, None, Known(2))
    assert branch is not None
    assert branch.branches == ()
    assert follower.asked == [("joined", 4.0, 4.0)]


@pytest.mark.parametrize(
    ("reason", "parts", "holds", "followed"),
    [
        (BranchEnd.LEFT_AT_START, True, True, False),
        (BranchEnd.LEFT_AT_STOP, True, True, False),
        (BranchEnd.LEFT_AT_STOP, True, False, True),
        (BranchEnd.LEFT_AT_STOP, False, True, True),
        (BranchEnd.CLOSED, True, True, True),
    ],
)
def test_a_branch_that_parts_and_is_known_by_its_end_is_none(
    follower: Followed,
    monkeypatch: pytest.MonkeyPatch,
    reason: BranchEnd,
    parts: bool,
    holds: bool,
    followed: bool,
) -> None:
    follower.legs.append(_Leg(front(5.0), reason))
    asked = []

    def known_end(self: Known, problem: Any, last: BranchPoint) -> bool:
        asked.append((problem.name, last.value))
        return holds

    monkeypatch.setattr(Known, "holds", known_end)
    known = Known(2)
    branch = _followed(front(3.0), LIMITS, 1, special(3.0) if parts else None, known)
    assert (branch is not None) is followed
    assert asked == ([("from 5.0", 5.0)] if parts and reason is not BranchEnd.CLOSED else [])
    assert len(known.ends) == (followed and reason is not BranchEnd.CLOSED)


@pytest.mark.parametrize(
    ("mirrored", "ahead", "back"), [(m, a, b) for m in (0, 1) for a in (0, 1) for b in (0, 1)]
)
def test_an_asymmetric_branch_alone_goes_on_where_it_joins(
    made: list[Any], monkeypatch: pytest.MonkeyPatch, mirrored: int, ahead: int, back: int
) -> None:
    asked = []

    def beyond(at: Any, sign: float) -> Any:
        asked.append(sign)
        return front(4.0 + 0.25 * sign) if (ahead if sign < 0.0 else back) else None

    monkeypatch.setattr(legs, "front_beyond", beyond)
    downwards = Limits(Interval(5.0, 2.0), LIMITS.settings)
    record, old = _Record([point(front(4.0))]), _Leg(front(4.0), BranchEnd.REJOINED)
    made.append(BranchEnd.TORN)
    leg, others = _joined(old, bifurcation(4.0, bool(mirrored)), downwards, record)
    assert asked == [-1.0, 1.0]
    goes_on = bool(mirrored and ahead)
    assert (leg.reason is BranchEnd.TORN) is goes_on
    assert (leg is old) is not goes_on
    assert [each.value for each in record.points] == ([4.0, 3.75] if goes_on else [4.0])
    beside = [3.75] * (ahead and not goes_on) + [4.25] * back
    assert [each.value for each in others] == beside


def test_branches_part_where_none_that_is_known_has_joined(
    made: list[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[Any] = []

    def joined(self: Known, problem: Any, at: Any, largest: float) -> bool:
        asked.append((problem, at.point.value, largest))
        return bool(at.point.value == 3.0)

    def followed(front: Any, limits: Limits, switches: int, parted: SpecialPoint, known: Known) -> Any:
        return front, switches, parted.value

    monkeypatch.setattr(Known, "is_joined", joined)
    monkeypatch.setattr(
        legs, "parted_fronts", lambda problem, at: [(problem, at.point.value, k) for k in (1, 2)]
    )
    monkeypatch.setattr(legs, "_followed", followed)
    record = _Record(switches=[("a", bifurcation(3.0)), ("b", bifurcation(4.0))])  # type: ignore[list-item]
    found = list(_parted(record, LIMITS, 3, Known(0)))
    assert found == [(("b", 4.0, k), 2, 4.0) for k in (1, 2)]
    assert asked == [("a", 3.0, 0.03), ("b", 4.0, 0.03)]


@dataclass(frozen=True)
class Eventful(Cubic):
    """As ``Cubic``, with three events in a passage, and phases."""

    def passage(self, value: float, state: np.ndarray) -> Given:
        return replace(super().passage(value, state), events=3, signature={("stop", None): 2})  # type: ignore[dict-item]


@pytest.mark.parametrize("mirrored", [False, True])
def test_a_point_is_of_the_whole_period_in_the_units_of_the_file(mirrored: bool) -> None:
    begin = _first_front(Eventful(mirrored), np.array([0.0]), -0.4, Interval(-0.4, 0.3))
    assert isinstance(begin, Front)
    found = _branch_point(begin)
    assert found.events == 3 * (1 + mirrored)
    assert found.multipliers == pytest.approx([0.36 if mirrored else 0.6], rel=1e-12)
    assert (found.value, found.state.tolist()) == (pytest.approx(-0.4, rel=1e-14), [0.0])
    assert found.signature == {("stop", None): 2}


def test_single_orbits_begin_a_millionth_of_the_interval_from_a_joint() -> None:
    branch = continuation(Logistic().doubled(), np.array([0.479]), 3.3, 2.5, FollowSettings(quiet=True))
    begun = [each.points[0].value for each in branch.branches]
    assert begun == pytest.approx([3.0 - 0.8e-6, 3.0 + 0.8e-6], abs=1e-12)
    assert [each.parted is branch.special[0] for each in branch.branches] == [True, True]
