"""Where branches join and part, and what is known of them, on maps whose orbits are known."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.curves import OnCurve, parabola
from tests.trimmer.branches.maps import Cubic, Given, Logistic
from trimmer.branches import switching
from trimmer.branches.arc import LostError
from trimmer.branches.branch import Branch, BranchEnd, BranchPoint
from trimmer.branches.joining import _located, front_beyond, joint
from trimmer.branches.known import Known, _images
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_maps.period_map import Phase
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.branches.step import Front, begun
from trimmer.branches.switching import _critical, _first, parted_fronts

ALONG = np.array([0.0, 0.0, 1.0])
ALONE = FollowSettings(switches=0, quiet=True)


def of_value(value: float, state: float) -> BranchPoint:
    return BranchPoint(value, np.array([state]), np.array([0.5 + 0j]), {}, 0)


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


def test_the_images_of_an_orbit_are_where_a_passage_may_begin_or_those_of_the_single_map() -> None:
    ends = {0.5: 0.25, 0.25: 0.125, 0.125: 0.75}

    def passage(value: float, state: np.ndarray) -> SimpleNamespace:
        assert value == 3.0
        return SimpleNamespace(end=np.array([ends[state[0]]]))

    def images(doublings: int, *phases: float) -> list[float]:
        map = SimpleNamespace(single=None, passage=passage)
        for _ in range(doublings):
            map = SimpleNamespace(single=map)
        map.phases = lambda value, state: [np.array([each]) for each in phases]
        found = _images(map, of_value(3.0, 0.5))  # type: ignore[arg-type]
        return [float(each[0]) for each in found]

    assert images(0) == [0.5]
    assert images(0, 0.1, 0.2) == [0.1, 0.2]
    assert images(1, 0.5) == [0.5, 0.25]
    assert images(2, 0.5) == [0.5, 0.25, 0.125, 0.75]
    assert images(1, 0.25, 0.125) == [0.25, 0.125]


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
    known = Known(0, rejoined=[(1, of_value(3.125, 0.7))])
    assert known.is_joined(problem, bifurcation, 0.0625)  # type: ignore[arg-type]
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


def test_the_secant_method_goes_on_from_the_nearest_orbit() -> None:
    asked = []

    def at(value: float, guess: tuple[str, float]) -> SimpleNamespace:
        asked.append((value, guess))
        return SimpleNamespace(at=value, multipliers=np.array([-1.0 - 3.0 * (value - 2.5), 0.5, 7.0]))

    arc = SimpleNamespace(
        at=at, distance=lambda place: place.at, predicted=lambda place, value: ("from", place.at)
    )
    found = _located(arc, SimpleNamespace(at=2.0))  # type: ignore[arg-type]
    assert found.at == pytest.approx(2.5, abs=1e-14)  # type: ignore[attr-defined]
    # The function is a straight line: it is known from two orbits, and one more is the root.
    values = [value for value, _ in asked]
    assert values[:3] == pytest.approx([2.0, 2.0 + 1e-6, 2.5], abs=1e-9)
    assert [from_where for _, (_, from_where) in asked[:3]] == [2.0, 2.0, values[1]]
    assert values[-1] == found.at  # type: ignore[attr-defined]
    lost = SimpleNamespace(**{**vars(arc), "at": lambda value, guess: None})
    with pytest.raises(LostError):
        _located(lost, SimpleNamespace(at=2.0))  # type: ignore[arg-type]
    endless = SimpleNamespace(
        **{
            **vars(arc),
            "at": lambda value, guess: SimpleNamespace(at=value, multipliers=np.array([value**2])),
        }
    )
    with pytest.raises(LostError):
        _located(endless, SimpleNamespace(at=2.0))  # type: ignore[arg-type]


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


@pytest.mark.parametrize(
    ("multipliers", "doubled"),
    [
        ((-1.0, -3.0), True),
        ((1.0, -3.0), False),
        ((-1.0, -5.0), True),
        ((1.2, -0.7), False),
    ],
)
def test_of_several_multipliers_the_one_nearest_to_either_side_parts(
    monkeypatch: pytest.MonkeyPatch, multipliers: tuple[float, float], doubled: bool
) -> None:
    asked = []
    critical = np.array([0.6, 0.8, 0.0])

    def of(place: Place, multiplier: float) -> np.ndarray:
        asked.append(multiplier)
        return critical

    monkeypatch.setattr(switching, "_critical", of)
    monkeypatch.setattr(switching, "_first", lambda *given: given)
    problem = Problem(parabola(), 7.0, np.array([2.0, 3.0]))
    place = SimpleNamespace(multipliers=np.array(multipliers), position="there")
    fronts = parted_fronts(problem, SimpleNamespace(place=place))  # type: ignore[arg-type]
    assert asked == [-1.0 if doubled else 1.0]
    assert [(origin, direction.tolist()) for _, origin, direction in fronts] == [  # type: ignore[misc, has-type]
        ("there", (sign * critical).tolist()) for sign in ((1.0,) if doubled else (1.0, -1.0))
    ]
    found = fronts[0][0]  # type: ignore[index]
    assert found.map.doublings == int(doubled)
    assert (found.span, found.sizes is problem.sizes) == (7.0, True)


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
    torn = Branch((), (), BranchEnd.TORN, "")
    assert torn.success
    assert (torn.branches, torn.parted, torn.doublings) == ((), None, 0)
    assert not Branch((), (), BranchEnd.NO_START, "").success
    for multipliers, stable in (([0.9, -0.5], True), ([0.9, -1.0], False), ([0.3, 1.0 - 1e-10], False)):
        point = BranchPoint(0.0, np.zeros(1), np.array(multipliers, dtype=complex), {}, 0)
        assert point.stable is stable


def test_a_special_point_tells_its_parts() -> None:
    point = SpecialPoint(SpecialKind.STICK, 1.0 / 3.0, np.zeros(1), ("blade", "comb"))
    assert "stick of blade and comb at 0.333333333" in str(point)
    assert " of " not in str(SpecialPoint(SpecialKind.FOLD, 2.0, np.zeros(1)))


def test_a_doubled_map_joins_both_passages() -> None:
    map = Logistic().doubled()
    first = Logistic().passage(3.2, np.array([0.3]))
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
    known = {("a", Phase.UPPER): (3e-3, 2e-3), ("b", Phase.STICK): (4e-3, 5e-3)}
    one, other = (
        SimpleNamespace(shortest=lambda part, phase, half=half: known[part, phase][half]) for half in (0, 1)
    )
    halves = replace(passage, first=one, second=other)  # type: ignore[arg-type]
    assert halves.shortest("a", Phase.UPPER) == 2e-3
    assert halves.shortest("b", Phase.STICK) == 4e-3
    assert map.doubled().doublings == 2
    assert map.size == 1
    counted = replace(
        passage,
        first=SimpleNamespace(signature={"a": 1, "b": 2}, events=3),  # type: ignore[arg-type]
        second=SimpleNamespace(signature={"b": 1}, events=5),  # type: ignore[arg-type]
    )
    assert counted.signature == {"a": 1, "b": 3}
    assert counted.events == 8
