"""Bifurcations on pieces of branch whose multipliers are given over the value."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.curves import OnCurve, parabola
from trimmer.branches import bifurcations as module
from trimmer.branches.arc import Arc, LostError
from trimmer.branches.bifurcations import (
    Bifurcation,
    _corner,
    _explained,
    _located,
    _products,
    bifurcations,
    dips,
    straight,
)
from trimmer.branches.orbit import Place
from trimmer.branches.special import SpecialKind, SpecialPoint

ALONG = np.array([0.0, 0.0, 1.0])


def arc_of(map: OnCurve, origin: float) -> Arc:
    place = map.at(origin)
    return Arc(place.problem, place.position, ALONG)


def diagonal(first: Callable[[float], float], second: Callable[[float], float]) -> OnCurve:
    """The parabola with two real multipliers; the eigenvectors are not the axes."""
    turn = np.array([[1.0, 0.5], [0.25, 1.0]])
    return parabola(matrix=lambda p: turn @ np.diag([first(p), second(p)]) @ np.linalg.inv(turn))


def pair(modulus: Callable[[float], float], angle: float = 1.0) -> OnCurve:
    """The parabola with a pair of multipliers."""
    turn = np.array([[math.cos(angle), -2.0 * math.sin(angle)], [0.5 * math.sin(angle), math.cos(angle)]])
    return parabola(matrix=lambda p: modulus(p) * turn)


def found(map: OnCurve, *values: float) -> list[tuple[SpecialKind, float]]:
    arc = arc_of(map, values[0])
    each = bifurcations(arc, [map.at(value, arc.problem) for value in values])
    assert all(one.point.value == arc.problem.value(one.place.position) for one in each)
    return [(one.point.kind, one.point.value) for one in each]


def test_a_multiplier_that_passes_minus_one_is_a_period_doubling() -> None:
    map = diagonal(lambda p: -0.5 - p, lambda p: 0.3)
    assert found(map, 0.1, 0.9) == [(SpecialKind.PERIOD_DOUBLING, pytest.approx(0.5, rel=1e-12))]
    arc = arc_of(map, 0.1)
    (each,) = bifurcations(arc, [map.at(0.1, arc.problem), map.at(0.9, arc.problem)])
    assert each.switches
    assert each.point.state == pytest.approx([0.25, 1.5], rel=1e-12)


def test_a_pair_that_passes_the_circle_is_a_torus_and_two_real_ones_are_not() -> None:
    torus = pair(lambda p: 0.7 + 0.5 * p)
    assert found(torus, 0.1, 0.9) == [(SpecialKind.TORUS, pytest.approx(0.6, rel=1e-12))]
    arc = arc_of(torus, 0.1)
    (each,) = bifurcations(arc, [torus.at(0.1, arc.problem), torus.at(0.9, arc.problem)])
    assert not each.switches
    # Two real ones whose product passes 1: one of them is far inside the circle.
    real = diagonal(lambda p: -2.0, lambda p: -0.4 - 0.2 * p)
    assert found(real, 0.1, 0.9) == []


def test_of_three_multipliers_the_products_are_those_of_different_ones() -> None:
    place = SimpleNamespace(multipliers=np.array([2.0, -3.0, 5.0 + 1.0j]))
    wanted = [-6.0, 10.0 + 2.0j, -15.0 - 3.0j]
    assert _products(place).tolist() == wanted  # type: ignore[arg-type]


def test_several_on_a_chain_come_in_their_order() -> None:
    map = diagonal(lambda p: -0.7 - p, lambda p: -1.6 + p)
    kinds = [(SpecialKind.PERIOD_DOUBLING, pytest.approx(value, rel=1e-12)) for value in (0.3, 0.6)]
    assert found(map, 0.1, 0.5, 0.9) == kinds
    # On one link alone nothing tells of them: the function has its sign again.
    assert found(map, 0.05, 0.95) == []


def test_a_link_is_halved_until_what_is_found_explains_the_multipliers_outside() -> None:
    # Both multipliers leave the circle on one link, so that their product keeps its sign.
    map = diagonal(lambda p: -0.7 - p, lambda p: -0.4 - p)
    kinds = [(SpecialKind.PERIOD_DOUBLING, pytest.approx(value, rel=1e-12)) for value in (0.3, 0.6)]
    assert found(map, 0.1, 0.9) == kinds
    arc = arc_of(map, 0.1)
    assert bifurcations(arc, [map.at(0.1, arc.problem), map.at(0.9, arc.problem)], 0) == []


def test_a_multiplier_that_jumps_past_minus_one_is_none() -> None:
    for first, last in ((-0.9, -1.2), (-1.2, -0.9)):
        jumping = diagonal(lambda p, first=first, last=last: first if p < 0.5 else last, lambda p: 0.3)  # type: ignore[misc]
        # However far it is halved nothing explains the multiplier outside.
        assert found(jumping, 0.1, 0.9) == []


@pytest.mark.parametrize(
    ("near", "far", "value", "jumps"),
    [
        (1e-4, -10.0, 0.009, False),
        (10.0, -1e-4, -0.009, False),
        (1e-4, -10.0, 0.011, True),
        (-10.0, 1e-4, -0.011, True),
        (-10.0, 1e-4, -0.009, False),
    ],
)
def test_a_function_jumps_where_it_is_not_zero_relative_to_the_larger_end(
    monkeypatch: pytest.MonkeyPatch, near: float, far: float, value: float, jumps: bool
) -> None:
    kind, asked = SpecialKind.TORUS, []

    def root(test: Callable[[tuple[float]], float], *ends: tuple[float]) -> tuple[float]:
        asked.append(ends)
        return (value,)

    arc = SimpleNamespace(root=root, distance=lambda place: 0.0)
    monkeypatch.setattr(module, "_tests", lambda arc: {kind: lambda place: place[0]})
    monkeypatch.setattr(module, "_corner", lambda *given: [SimpleNamespace(place="jump", of=given)])
    monkeypatch.setattr(module, "_located", lambda *given: [SimpleNamespace(place="root", of=given)])
    (each,) = module._between(arc, (near,), (far,), 0)  # type: ignore[arg-type]
    assert each.place == ("jump" if jumps else "root")
    assert each.of[-2:] == (kind, (value,))  # type: ignore[attr-defined]
    assert asked == [((near,), (far,))]


@pytest.mark.parametrize(
    ("near", "far", "changes"), [(0.0, 1.0, True), (0.0, -1.0, False), (1.0, 0.0, True), (-1.0, 0.0, False)]
)
def test_zero_counts_as_one_side(
    monkeypatch: pytest.MonkeyPatch, near: float, far: float, changes: bool
) -> None:
    arc = SimpleNamespace(root=lambda test, *ends: (0.0,), distance=lambda place: 0.0)
    monkeypatch.setattr(module, "_tests", lambda arc: {SpecialKind.TORUS: lambda place: place[0]})
    monkeypatch.setattr(module, "_located", lambda *given: [SimpleNamespace(place="root")])
    assert len(module._between(arc, (near,), (far,), 0)) == changes  # type: ignore[arg-type]


@pytest.mark.parametrize("splits", [0, 1, 3])
def test_what_nothing_explains_is_halved_so_many_times(monkeypatch: pytest.MonkeyPatch, splits: int) -> None:
    halves = []

    def smooth(distance: float, near: float, far: float) -> float:
        assert distance == 0.5 * (near + far)
        halves.append((near, far))
        return distance

    arc = SimpleNamespace(smooth=smooth, distance=float)
    monkeypatch.setattr(module, "_tests", lambda arc: {})
    monkeypatch.setattr(module, "_explained", lambda *_: False)
    assert bifurcations(arc, [0.0, 1.0, 3.0], splits) == []  # type: ignore[arg-type, list-item]
    assert len(halves) == 2 * (2**splits - 1)
    halves.clear()
    assert bifurcations(arc, [0.0, 1.0]) == []  # type: ignore[arg-type, list-item]
    assert len(halves) == 2**6 - 1


def fake(tangent_value: float) -> Place:
    return SimpleNamespace(  # type: ignore[return-value]
        value=21.0, strobed=np.array([0.4]), tangent=lambda _: np.array([0.6, tangent_value])
    )


PROBLEM = SimpleNamespace(
    map=SimpleNamespace(mirrored=False),
    value=lambda position: 7.0 * position[-1],
    state=lambda position: 2.0 * position[:-1],
)
ARC = Arc(PROBLEM, np.zeros(2), np.array([0.0, 1.0]))  # type: ignore[arg-type]


def test_a_corner_is_a_fold_alone() -> None:
    place = fake(0.8)
    (corner,) = _corner(SpecialKind.FOLD, place)
    assert corner.point.kind is SpecialKind.FOLD
    assert (corner.point.value, corner.point.state.tolist()) == (21.0, [0.4])
    assert corner.point.note.startswith("a corner")
    assert not corner.switches
    assert corner.place is place
    for kind in (SpecialKind.PERIOD_DOUBLING, SpecialKind.SYMMETRY_BREAKING, SpecialKind.TORUS):
        assert _corner(kind, place) == []


@pytest.mark.parametrize(
    ("kind", "mirrored", "named", "switches"),
    [
        (SpecialKind.FOLD, False, SpecialKind.FOLD, False),
        (SpecialKind.FOLD, True, SpecialKind.FOLD, False),
        (SpecialKind.PERIOD_DOUBLING, False, SpecialKind.PERIOD_DOUBLING, True),
        (SpecialKind.PERIOD_DOUBLING, True, SpecialKind.SYMMETRY_BREAKING, True),
        (SpecialKind.SYMMETRY_BREAKING, False, SpecialKind.SYMMETRY_BREAKING, True),
    ],
)
def test_a_mirrored_map_loses_its_symmetry_where_a_multiplier_passes_minus_one(
    kind: SpecialKind, mirrored: bool, named: SpecialKind, switches: bool
) -> None:
    problem = SimpleNamespace(**{**vars(PROBLEM), "map": SimpleNamespace(mirrored=mirrored)})
    arc = Arc(problem, ARC.origin, ARC.direction)  # type: ignore[arg-type]
    (each,) = _located(arc, kind, fake(0.8))
    assert (each.point.kind, each.switches) == (named, switches)
    assert (each.point.value, each.point.state.tolist()) == (21.0, [0.4])


def test_a_torus_is_known_by_the_pair_whose_product_is_nearest_to_one() -> None:
    place = fake(0.8)
    turning = np.exp(1.0j)
    place.multipliers = np.array([5.0, 0.1, turning, 1.0 / turning])  # type: ignore[misc]
    assert [each.point.kind for each in _located(ARC, SpecialKind.TORUS, place)] == [SpecialKind.TORUS]
    place.multipliers = np.array([5.0 + 0.0j, 2.0 * turning, 2.0 / turning, 0.2])  # type: ignore[misc]
    assert _located(ARC, SpecialKind.TORUS, place) == []


def of_kinds(*kinds: SpecialKind) -> list[Bifurcation]:
    return [Bifurcation(SpecialPoint(kind, 0.0, np.zeros(1)), fake(1.0), False) for kind in kinds]


@pytest.mark.parametrize(
    ("kinds", "outside", "good"),
    [
        ((), (0, 0), True),
        ((), (0, 1), False),
        ((), (2, 2), True),
        ((SpecialKind.FOLD,), (0, 1), True),
        ((SpecialKind.FOLD,), (2, 1), True),
        ((SpecialKind.FOLD,), (0, 0), False),
        ((SpecialKind.FOLD, SpecialKind.PERIOD_DOUBLING), (0, 0), True),
        ((SpecialKind.TORUS,), (0, 2), True),
        ((SpecialKind.TORUS,), (2, 0), True),
        ((SpecialKind.TORUS,), (0, 1), False),
        ((SpecialKind.TORUS,), (0, 0), True),
        ((SpecialKind.TORUS, SpecialKind.FOLD), (3, 0), True),
        ((SpecialKind.FOLD,), (0, 3), False),
    ],
)
def test_what_was_found_explains_how_many_multipliers_leave_the_circle(
    kinds: Sequence[SpecialKind], outside: tuple[int, int], good: bool
) -> None:
    ends = [
        SimpleNamespace(multipliers=np.array([-1.5] * count + [1.0, 0.9, -0.3 + 0.2j])) for count in outside
    ]
    assert _explained(of_kinds(*kinds), *ends) == good  # type: ignore[arg-type]


def test_a_multiplier_on_the_circle_is_not_outside() -> None:
    ends = [SimpleNamespace(multipliers=np.array([modulus, 0.5, -1.0j])) for modulus in (1.0, 0.9)]
    assert _explained([], *ends)  # type: ignore[arg-type]
    assert _explained([], *ends[::-1])  # type: ignore[arg-type]


def test_a_chord_must_lie_close_to_both_tangents() -> None:
    map = parabola()
    arc = arc_of(map, 0.0)
    near, far = map.at(0.0, arc.problem), map.at(0.5, arc.problem)
    assert straight(arc, near, far)
    assert not straight(arc, far, near)
    # Tangents (0, 3, 1) and (2 p, 3, 1), chord (p, 3, 1): the cosine at the beginning is 0.9 at p = 1.53.
    cosines = [math.sqrt(10.0 / (10.0 + p * p)) for p in (1.5, 1.56)]
    assert cosines[0] > 0.9 > cosines[1]
    assert straight(arc, near, map.at(1.5, arc.problem))
    assert not straight(arc, near, map.at(1.56, arc.problem))
    # Of two that are as near as rounding the chord has no direction.
    assert straight(arc, map.at(1e-9, arc.problem), near)
    stuck = parabola(matrix=lambda p: np.eye(2))
    lost = arc_of(stuck, 0.0)
    assert not straight(lost, stuck.at(0.0, lost.problem), stuck.at(0.5, lost.problem))


def touching(at: float, depth: float) -> OnCurve:
    """A multiplier that comes as near to -1 as a depth at a value, and turns back."""
    return diagonal(lambda p: -1.0 + depth + (p - at) ** 2, lambda p: 0.0)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_dip_is_looked_at_where_the_parabola_is_lowest(sign: float) -> None:
    map = touching(0.6, sign * 0.0)
    arc = arc_of(map, 0.5)
    before, near, far = (map.at(value, arc.problem) for value in (0.2, 0.5, 0.9))
    found = dips(arc, before, near, far)
    assert any(each == pytest.approx(0.1, rel=1e-9) for each in found)
    assert found == sorted(found)


@pytest.mark.parametrize(
    ("at", "depth", "seen"),
    [(0.6, 0.004, True), (0.6, 0.0042, True), (0.6, 0.0046, False), (0.45, 0.0, False)],
)
def test_a_dip_is_as_deep_as_a_share_of_the_ends_and_ahead(at: float, depth: float, seen: bool) -> None:
    # The lowest end is at 0.5, 0.01 above the lowest point: there is 0.3 of it where the depth is 0.00429.
    map = touching(at, depth)
    arc = arc_of(map, 0.5)
    found = dips(arc, *(map.at(value, arc.problem) for value in (0.2, 0.5, 0.9)))
    lowest = [each for each in found if abs(each - (at - 0.5)) < 1e-6]
    assert bool(lowest) == seen


def test_a_function_that_changes_its_sign_or_bends_the_other_way_has_no_dip() -> None:
    for map in (
        diagonal(lambda p: -0.5 - p, lambda p: 0.0),
        diagonal(lambda p: -0.9 - (p - 0.6) ** 2 + 0.5, lambda p: 0.0),
    ):
        arc = arc_of(map, 0.55)
        assert dips(arc, *(map.at(value, arc.problem) for value in (0.2, 0.55, 0.7))) == []


@pytest.mark.parametrize(
    ("values", "lowest"),
    [
        # A parabola through values at -0.3, 0 and 0.4: 0.01 + 2 (p - 0.25)^2 and its mirror image.
        ((0.615, 0.135, 0.055), 0.25),
        ((-0.615, -0.135, -0.055), 0.25),
        # It changes its sign: a root is found by itself, and no dip.
        ((0.595, 0.115, -0.01), None),
        ((-0.1, 0.115, 0.035), None),
        # The lowest point lies behind, or beyond.
        ((0.19, 0.04, 1.0), None),
        ((2.0, 1.0, 0.5), None),
    ],
)
def test_a_dip_is_the_lowest_point_of_a_parabola_through_three_values(
    monkeypatch: pytest.MonkeyPatch, values: tuple[float, ...], lowest: float | None
) -> None:
    monkeypatch.setattr(module, "_tests", lambda arc: dict.fromkeys("ab", lambda place: place[1]))
    arc = SimpleNamespace(distance=lambda place: place[0])
    places = zip((-0.3, 0.0, 0.4), values, strict=True)
    found = dips(arc, *places)  # type: ignore[arg-type, call-arg]
    assert found == ([] if lowest is None else [pytest.approx(lowest, rel=1e-12)])


def test_without_a_tangent_the_branch_is_lost() -> None:
    stuck = parabola(matrix=lambda p: np.eye(2))
    arc = arc_of(stuck, 0.0)
    with pytest.raises(LostError):
        bifurcations(arc, [stuck.at(0.0, arc.problem), stuck.at(0.5, arc.problem)])
