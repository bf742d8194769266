"""How a piece of branch is searched for a special point, with stand-ins."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.branches.curves import parabola, special
from tests.trimmer.branches.maps import Henon
from trimmer.branches.loci import relocation
from trimmer.branches.loci.relocation import Relocated, Sought, _searched, _special_points, relocated
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.branches.step import Front

FOLD = Sought(SpecialKind.FOLD, ())


def test_a_piece_is_followed_until_it_has_left_the_neighbourhood(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Any] = []
    ways = [1.09, 1.11, 0.0]

    def longest_step(front: Any, length: float, limits: Any, smallest: float) -> tuple[Any, float]:
        asked.append((front, length, smallest))
        assert limits.settings.largest_step == 1.0
        assert not limits.smooth
        # The ends of the interval are half a span from the value on either side, in spans.
        assert limits.interval.ends == pytest.approx((7.0 / 4.0 - 0.5, 7.0 / 4.0 + 0.5), rel=1e-14)
        away = ways.pop(0) * 1e-2
        place = SimpleNamespace(position=np.array([0.25 + 0.6 * away, 1.75 - 0.8 * away]))
        found = SimpleNamespace(front=SimpleNamespace(place=place), special=(special(away),))
        return found, 5e-3 if len(asked) == 1 else 9.0

    monkeypatch.setattr(relocation, "longest_step", longest_step)
    problem = SimpleNamespace(span=4.0, value=lambda position: 7.0)
    begin: Any = SimpleNamespace(problem=problem, place=SimpleNamespace(position=None))
    found = list(_special_points(begin, np.array([0.25, 1.75]), 1e-2, (3e-7, False)))
    assert [point.value for point in found] == pytest.approx([1.09e-2, 1.11e-2], rel=1e-12)
    assert [each[1:] for each in asked] == [(pytest.approx(2.2e-2, rel=1e-14), 3e-7), (5e-3, 3e-7)]
    assert asked[0][0] is begin


def test_a_piece_is_given_up_after_so_many_steps_or_where_none_is_made(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    here: Any = SimpleNamespace(
        problem=SimpleNamespace(span=4.0, value=lambda position: 7.0),
        place=SimpleNamespace(position=np.array([0.25, 1.75])),
    )
    lengths: list[float] = []

    def longest_step(front: Any, length: float, limits: Any, smallest: float) -> tuple[Any, float]:
        lengths.append(length)
        made = SimpleNamespace(front=here, special=(special(1.0),))
        return (None if len(lengths) == 40 else made), 9.0

    monkeypatch.setattr(relocation, "longest_step", longest_step)
    look = (1e-9, True)
    assert len(list(_special_points(here, here.place.position, 1e-2, look))) == 24
    assert lengths == pytest.approx([2.2e-2] * 24, rel=1e-14)
    assert len(list(_special_points(here, here.place.position, 1e-2, look))) == 15


@pytest.mark.parametrize("parts", [(), ("stop",)])
def test_what_is_near_and_fits_is_the_point(monkeypatch: pytest.MonkeyPatch, parts: tuple[str, ...]) -> None:
    asked: list[Any] = []
    points: list[SpecialPoint] = []

    def special_points(front: Front, centre: Any, reach: float, look: Any) -> Iterator[SpecialPoint]:
        asked.append((front, centre, reach, look))
        yield from points

    monkeypatch.setattr(relocation, "_special_points", special_points)
    map = parabola()
    problem = Problem(map, 4.0, np.array([2.0, 0.5]))
    centre = map.at(0.5, problem)
    tangent = centre.tangent(np.array([0.0, 0.0, -1.0]))
    assert tangent is not None

    def at(distance: float, **others: Any) -> SpecialPoint:
        position = centre.position + distance * tangent
        return special(problem.value(position), *problem.state(position), **others)

    kind = SpecialKind.GRAZING if parts else SpecialKind.FOLD
    other = at(1.9e-3, kind=SpecialKind.STICK, parts=("blade",))
    far, wanted = at(2.1e-3, kind=kind, parts=parts), at(-1.9e-3, kind=kind, parts=parts)
    points += [at(-2.1e-3, kind=SpecialKind.TORUS), other, far, wanted, at(0.0, kind=SpecialKind.TORUS)]
    found = _searched(centre, tangent, Sought(kind, parts), 1e-3)
    assert found is not None
    assert (found.point is wanted, found.others, found.problem is problem) == (True, (other,), True)
    ((front, middle, reach, look),) = asked
    assert middle is centre.position
    assert reach == 1e-3
    # Only what has parts may lie in a corner, and needs no bifurcations.
    assert look == ((2e-12, False) if parts else (pytest.approx(1e-6, rel=1e-12), True))
    begin = front.place.position
    assert tangent @ (begin - centre.position) == pytest.approx(-1e-3, rel=1e-9)
    assert front.tangent @ tangent == pytest.approx(1.0, rel=1e-4)
    nothing = _searched(centre, tangent, Sought(SpecialKind.SYMMETRY_BREAKING, ()), 1e-3)
    assert nothing is not None
    assert (nothing.point, len(nothing.others)) == (None, 3)


def test_a_piece_whose_beginning_is_not_found_near_is_none() -> None:
    map = parabola()
    centre = map.at(0.5)
    across = np.array([3.0, -1.0, 0.0]) / math.sqrt(10.0)
    # Along that direction the curve lies farther away than the reach.
    aside = (across + 0.3 * np.array([1.0, 3.0, 1.0]) / math.sqrt(11.0)) / math.hypot(1.0, 0.3)
    assert _searched(centre, aside, FOLD, 1e-3) is None
    lost = parabola(ends=0.4999)
    late = replace(centre, problem=Problem(lost, 1.0, np.ones(2)))
    tangent = centre.tangent(np.array([0.0, 0.0, -1.0]))
    assert tangent is not None
    assert _searched(late, tangent, FOLD, 1e-2) is None


def test_a_piece_without_a_tangent_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    centre = parabola().at(0.5)
    tangent = centre.tangent(np.array([0.0, 0.0, 1.0]))
    assert tangent is not None
    monkeypatch.setattr(Place, "tangent", lambda self, reference: None)
    assert _searched(centre, tangent, FOLD, 1e-3) is None


def test_both_directions_are_searched_until_the_point_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    answers: dict[int, Relocated | None] = {}
    asked: list[Any] = []

    def searched(centre: Any, direction: Any, sought: Sought, reach: float) -> Relocated | None:
        asked.append((direction, sought, reach))
        return answers[len(asked)]

    monkeypatch.setattr(relocation, "_searched", searched)

    def run(first: Relocated | None, second: Relocated | None) -> Relocated | None:
        answers.update({1: first, 2: second})
        asked.clear()
        return relocated(Henon(), 0.5, FOLD, 0.1, np.array([0.9, 0.27]), 0.03)

    problem: Any = None
    empty, other = Relocated(None, (), problem), Relocated(None, (), problem)
    good = Relocated(special(1.0), (), problem)
    assert run(good, empty) is good
    assert len(asked) == 1
    assert run(empty, good) is good
    assert asked[1][0].tolist() == (-asked[0][0]).tolist()
    assert asked[1][1:] == (FOLD, 0.03)
    assert run(empty, other) is empty
    assert run(None, other) is other
    assert run(None, None) is None
