"""What one step along a branch asks, with fronts and places made by hand."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.curves import OnCurve, line_front, parabola
from tests.trimmer.branches.maps import Bent, Failing, Steps, Torn
from trimmer.branches import step as stepping
from trimmer.branches.arc import Arc
from trimmer.branches.borders import Border, borders
from trimmer.branches.branch import BranchEnd
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_maps.period_map import Phase
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.branches.step import (
    Front,
    _astray,
    _at_end,
    _between,
    _end_passed,
    _passes,
    angle,
    at_border,
    begun,
    fold_at,
    step,
)

ALONG = np.array([0.0, 0.0, 1.0])


def front_at(map: OnCurve, value: float, reference: np.ndarray = ALONG) -> Front:
    place = map.at(value)
    tangent = place.tangent(reference)
    assert tangent is not None
    return begun(place.problem, place, tangent)


@pytest.mark.parametrize(("start", "stop"), [(2.0, 5.0), (5.0, 2.0)])
def test_the_end_that_is_passed_is_the_one_on_that_side(start: float, stop: float) -> None:
    ends = [_end_passed(np.array([9.0, value]), start, stop) for value in (1.9, 2.0, 3.0, 5.0, 5.1)]
    assert ends == [2.0, None, None, None, 5.0]


def test_orbits_are_sought_at_values_unless_the_branch_is_steep() -> None:
    flat = Front(None, None, np.array([0.6, -0.8]), 1.0)  # type: ignore[arg-type]
    assert flat.direction.tolist() == [0.0, -1.0]
    steep = Front(None, None, np.array([-math.sqrt(1.0 - 0.09**2), 0.09]), 1.0)  # type: ignore[arg-type]
    assert steep.direction is steep.tangent


def test_a_front_keeps_the_orbit_before_it_on_the_same_smooth_piece_alone() -> None:
    touching = parabola(signature=lambda p: {("stop", Phase.UPPER): int(p > 0.7)})
    front = front_at(touching, 0.5)
    near, far = (touching.at(value, front.problem) for value in (0.6, 0.8))
    assert front.before is None
    assert front.moved(near, front.tangent).before is front.place
    assert front.moved(far, front.tangent).before is None
    assert front.turn == np.sign(front.place.orientation(front.tangent)) != 0.0
    back = front_at(touching, 0.5, -ALONG)
    assert back.turn == -front.turn


def test_the_orbit_at_the_end_of_the_interval_is_exact() -> None:
    front = front_at(parabola(), 0.5)
    found = _at_end(front, np.array([0.4, 2.1, 0.7]), 0.6)
    assert found is not None
    assert found.position.tolist() == [pytest.approx(0.36), pytest.approx(1.8), 0.6]


def test_the_orbit_at_the_end_is_sought_on_the_way_to_a_position_beyond() -> None:
    asked = []
    problem = SimpleNamespace(correct=lambda *given: asked.append([np.array(each) for each in given]))
    near = SimpleNamespace(position=np.array([1.0, -2.0, 5.0]))
    front = Front(problem, near, ALONG, 1.0)  # type: ignore[arg-type]
    _at_end(front, np.array([3.0, 2.0, 1.0]), 4.0)
    assert [each.tolist() for each in asked[0]] == [[1.5, -1.0, 4.0], [0.0, 0.0, 1.0], 4.0]


@pytest.mark.parametrize(("length", "close"), [(1.9e-4, True), (2.1e-4, False)])
def test_a_branch_that_is_close_to_a_joint_ends_with_an_orbit_beyond(
    monkeypatch: pytest.MonkeyPatch, length: float, close: bool
) -> None:
    monkeypatch.setattr(stepping, "rejoined", lambda front, far: True)
    front = front_at(parabola(), 0.5)
    made = step(front, length, (0.0, 1.0))
    assert (made is not None) is close
    if made is not None:
        assert (made.front, made.ended, made.bend) == (front, BranchEnd.REJOINED, 0.0)
        assert (made.special, made.switches) == ((), ())
        assert made.beyond is not None
        assert made.beyond.position[2] == pytest.approx(0.5 + length / math.sqrt(11.0), rel=1e-12)


def test_a_step_over_a_tear_does_not_succeed() -> None:
    for map, made in ((Torn(), False), (Bent(0.5, -0.5), True)):
        front = line_front(map, -0.05, -0.1)
        assert (step(front, 0.2, (-1.0, 1.0)) is not None) is made
    # Nor does one on which an orbit between is not found.
    ending = line_front(Failing(), 0.45, 0.9)
    assert step(ending, 0.2, (-1.0, 1.0)) is None


def test_an_orbit_beside_or_behind_is_astray() -> None:
    front = Front(None, SimpleNamespace(position=np.array([1.0, 2.0])), np.array([0.6, 0.8]), 1.0)  # type: ignore[arg-type]

    def at(ahead: float, aside: float) -> Place:
        away = ahead * np.array([0.6, 0.8]) + aside * np.array([0.8, -0.6])
        return SimpleNamespace(position=np.array([1.0, 2.0]) + away)  # type: ignore[return-value]

    assert not _astray(front, at(0.3, 0.29))
    assert _astray(front, at(0.3, -0.31))
    assert _astray(front, at(-0.3, 0.1))
    assert _astray(front, at(0.0, 0.0))


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_a_step_over_the_end_of_the_interval_ends_there(direction: float) -> None:
    front = front_at(parabola(), 0.5, direction * ALONG)
    end = 0.5 + direction * 0.01
    for ends, reason in (
        ((0.5 - direction, end), BranchEnd.LEFT_AT_STOP),
        ((end, 0.5 - direction), BranchEnd.LEFT_AT_START),
    ):
        made = step(front, 0.1, ends)
        assert made is not None
        assert made.ended is reason
        assert made.front.place.position == pytest.approx([end**2, 3.0 * end, end], rel=1e-14)
        assert (made.special, made.switches, made.beyond) == ((), (), None)


def test_a_step_tells_its_bend_and_leads_along_the_curve() -> None:
    front = front_at(parabola(), 0.5)
    made = step(front, 0.3, (0.0, 10.0))
    assert made is not None
    assert made.ended is None
    value = 0.5 + 0.3 / math.sqrt(1.0 + 9.0 + 1.0)
    assert made.front.place.position == pytest.approx([value**2, 3.0 * value, value], rel=1e-12)
    before, after = np.array([1.0, 3.0, 1.0]), np.array([2.0 * value, 3.0, 1.0])
    cosine = before @ after / np.linalg.norm(before) / np.linalg.norm(after)
    assert made.bend == pytest.approx(math.acos(cosine), rel=1e-9)


def test_angles_are_exact_next_to_none_and_to_opposite_ones() -> None:
    for turn in (0.0, 1e-9, 0.3, math.pi / 2.0, 2.5, math.pi - 1e-9, math.pi):
        first = np.array([0.6, 0.8])
        second = np.array(
            [0.6 * math.cos(turn) - 0.8 * math.sin(turn), 0.6 * math.sin(turn) + 0.8 * math.cos(turn)]
        )
        assert angle(first, second) == pytest.approx(turn, abs=3e-16, rel=1e-6)


def test_a_steep_branch_that_bends_towards_the_end_stops_there() -> None:
    # On (root of p, 0) the tangent from 0.001 leads to 0.0042, and the orbit beside it is at 0.0067.
    root = OnCurve(
        lambda p: np.array([math.sqrt(max(p, 0.0)), 0.0]),
        lambda p: np.array([0.5 / math.sqrt(max(p, 1e-300)), 0.0]),
    )
    front = front_at(root, 0.001)
    assert abs(front.tangent[-1]) < 0.1
    predicted = front.place.position + 0.05 * front.tangent
    assert predicted[-1] < 0.005
    made = step(front, 0.05, (0.0, 0.005))
    assert made is not None
    assert made.ended is BranchEnd.LEFT_AT_STOP
    assert made.front.place.position == pytest.approx([math.sqrt(0.005), 0.0, 0.005], rel=1e-12)


def bordering(determinants: tuple[float, float], lengths: tuple[float, float], single: bool = True) -> Border:
    """Two orbits with what their slopes and tangents give."""
    counts = {("stop", Phase.UPPER): 1} if single else {("stop", Phase.UPPER): 1, ("stop", Phase.LOWER): 1}

    def place(number: int) -> SimpleNamespace:
        length = lengths[number]
        return SimpleNamespace(
            value=15.0,
            strobed=np.zeros(1),
            passage=SimpleNamespace(opens=lambda part, phase: False),
            multipliers=np.array([0.5, 1.5 * number]),
            signature=frozenset(counts.items()) if number else frozenset(),
            tangent=lambda _: None if math.isnan(length) else np.array([0.6, length]),
            orientation=lambda _: determinants[number],
        )

    return Border(place(0), place(1))  # type: ignore[arg-type]


NAN = math.nan


def test_a_branch_goes_on_beyond_a_border_where_the_determinant_keeps_its_sign() -> None:
    arc = Arc(None, np.zeros(2), np.array([0.0, 1.0]))  # type: ignore[arg-type]
    assert _passes(arc, bordering((2.0, 3.0), (1.0, 1.0)))
    assert _passes(arc, bordering((-2.0, -3.0), (1.0, 1.0)))
    assert not _passes(arc, bordering((2.0, -3.0), (1.0, 1.0)))
    assert not _passes(arc, bordering((2.0, 0.0), (1.0, 1.0)))
    assert not _passes(arc, bordering((2.0, 3.0), (NAN, 1.0)))
    assert not _passes(arc, bordering((2.0, 3.0), (1.0, NAN)))
    # Where two phases change at once the sign says nothing.
    assert _passes(arc, bordering((2.0, -3.0), (1.0, 1.0), single=False))


@pytest.mark.parametrize(
    ("lengths", "folds"),
    [
        ((0.8, -0.8), True),
        ((-0.8, 0.8), True),
        ((0.8, 0.8), False),
        ((-0.8, 0.0), False),
        ((0.0, -0.8), False),
        ((NAN, -0.8), False),
        ((0.8, NAN), False),
    ],
)
def test_a_border_where_the_branch_turns_around_is_a_fold_too(
    lengths: tuple[float, float], folds: bool
) -> None:
    problem = SimpleNamespace(value=lambda position: 5.0 * position[-1], state=lambda position: position[:-1])
    arc = Arc(problem, np.zeros(2), np.array([0.0, 1.0]))  # type: ignore[arg-type]
    points = at_border(arc, bordering((1.0, 1.0), lengths))
    assert [point.kind for point in points] == [SpecialKind.GRAZING, SpecialKind.FOLD][: 1 + folds]
    assert {point.value for point in points} == {15.0}
    assert points[0].note.endswith("jump from 0 to 1")


def test_a_fold_in_a_corner_is_where_its_phases_change() -> None:
    points = [
        SpecialPoint(kind, 1.0 + number, np.array([number]), (part,))
        for number, (kind, part) in enumerate([(SpecialKind.GRAZING, "stop"), (SpecialKind.STICK, "blade")])
    ]
    fold = fold_at(points)
    assert (fold.kind, fold.value, fold.state.tolist(), fold.parts) == (
        SpecialKind.FOLD,
        1.0,
        [0],
        ("stop",),
    )
    assert fold.note == "a corner at grazing and stick"


def test_pieces_next_to_a_border_are_looked_at_closely_there() -> None:
    front = front_at(parabola(), 0.5)
    arc = Arc(front.problem, front.place.position, ALONG)
    piece = front.place, parabola().at(0.9, front.problem)
    shares = {
        (False, False): [],
        (True, False): [1e-4, 1e-2],
        (False, True): [0.99, 0.9999],
        (True, True): [1e-4, 1e-2, 0.99, 0.9999],
    }
    for border, expected in shares.items():
        chain = _between(front, arc, piece, border)
        assert chain[0] is piece[0]
        assert chain[-1] is piece[1]
        found = [arc.distance(place) / 0.4 for place in chain[1:-1]]
        assert found == pytest.approx(expected, rel=1e-9)
    short = front.place, parabola().at(0.5 + 9e-8, front.problem)
    assert len(_between(front, arc, short, (True, True))) == 2


def test_smooth_pieces_are_looked_at_where_a_test_function_may_dip() -> None:
    turn = np.array([[1.0, 0.5], [0.25, 1.0]])
    inverse = np.linalg.inv(turn)
    map = parabola(matrix=lambda p: turn @ np.diag([-1.0 + (p - 0.6) ** 2, 0.0]) @ inverse)
    first = front_at(map, 0.2)
    place = map.at(0.5, first.problem)
    arc = Arc(first.problem, place.position, ALONG)
    far = map.at(0.9, first.problem)
    without = Front(first.problem, place, first.tangent, 1.0)
    assert len(_between(without, arc, (place, far), (False, False))) == 2
    behind = Front(first.problem, place, first.tangent, 1.0, first.place)
    looked = [each.position[-1] for each in _between(behind, arc, (place, far), (False, False))]
    assert any(value == pytest.approx(0.6, rel=1e-9) for value in looked)


def on_line(map: object, origin: float) -> tuple[Arc, Problem]:
    problem = Problem(map, 1.0, np.ones(1))  # type: ignore[arg-type]
    return Arc(problem, np.array([0.0, origin]), np.array([0.0, 1.0])), problem


def test_borders_come_in_their_order_up_to_a_number() -> None:
    for kinks, found in ((12, 12), (13, None)):
        places = tuple(0.1 + 0.01 * number for number in range(kinks))
        arc, problem = on_line(Steps(places), 0.0)
        near, far = (
            problem.correct(np.array([0.0, value]), np.array([0.0, 1.0]), value) for value in (0.0, 0.5)
        )
        assert near is not None and far is not None
        between = borders(arc, near, far)
        assert (None if between is None else len(between)) == found
        for border, place in zip(between or (), places, strict=False):
            assert border.before.position[-1] == pytest.approx(place, abs=1e-12)
            assert border.changes == {(f"stop {place}", Phase.LOWER): 1}
            assert border.is_single


def test_a_border_across_which_orbits_jump_is_none() -> None:
    arc, problem = on_line(Torn(), -0.5)
    near, far = (
        problem.correct(np.array([2.0 * value, value]), np.array([0.0, 1.0]), value) for value in (-0.5, 0.5)
    )
    assert near is not None and far is not None
    assert borders(arc, near, far) is None
    bent, problem = on_line(Bent(0.5, -0.5), -0.5)
    near, far = (
        problem.correct(np.array([value, value]), np.array([0.0, 1.0]), value) for value in (-0.5, 0.5)
    )
    assert near is not None and far is not None
    assert len(borders(bent, near, far) or ()) == 1
    assert borders(bent, near, near) == []
