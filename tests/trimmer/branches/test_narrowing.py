"""Where phases change, on arcs whose orbits are known: with few orbits, and as near as rounding permits."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.branches.borders import Border, special_points
from trimmer.branches.narrowing import _constant, _difference, _extrapolated, _likely, _root, narrowed
from trimmer.branches.period_maps.period_map import Phase
from trimmer.branches.special import SpecialKind

KEY = ("stop", Phase.UPPER)


@dataclass
class KnownArc:
    """An arc on which a contact is there beyond a place, for a duration that depends on how far beyond."""

    border: float
    duration: Callable[[float], float]
    narrowest: float = 1e-13
    sign: float = 1.0
    asked: list[float] = field(default_factory=list)

    def place(self, distance: float) -> SimpleNamespace:
        beyond = self.sign * (distance - self.border)
        there = beyond > 0.0
        passage = SimpleNamespace(shortest=lambda *_: self.duration(beyond) if there else math.inf)
        return SimpleNamespace(
            at=distance, signature=frozenset({(KEY, 1)}) if there else frozenset(), passage=passage
        )

    def distance(self, place: SimpleNamespace) -> float:
        return float(place.at)

    def between(self, distance: float, left: SimpleNamespace, right: SimpleNamespace) -> SimpleNamespace:
        assert left.at < distance < right.at
        self.asked.append(distance)
        return self.place(distance)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("border", [0.0031, 0.0005, 0.00999])
@pytest.mark.parametrize(
    ("duration", "most"),
    [
        (lambda beyond: 2.0 * beyond + 5.0 * beyond**2, 16),
        (lambda beyond: math.sqrt(beyond) * (1.0 + 3.0 * math.sqrt(beyond) - 8.0 * beyond), 22),
        (lambda beyond: max(1e-6 * beyond, 1e-18) // 1e-18 * 1e-18, 22),
        (lambda beyond: math.inf, 70),
        (lambda beyond: 1.0, 70),
        (lambda beyond: 1.0 - beyond, 70),
    ],
    ids=["linear", "root", "rounded", "unknown", "constant", "misleading"],
)
def test_the_border_is_found(
    duration: Callable[[float], float], most: int, border: float, sign: float
) -> None:
    arc = KnownArc(border, duration, sign=sign)
    found = narrowed(arc, arc.place(0.0), arc.place(0.01))  # type: ignore[arg-type]
    assert found is not None
    left, right = (place.at for place in found)  # type: ignore[attr-defined]
    assert left <= border <= right
    assert right - left <= arc.narrowest
    assert len(arc.asked) <= most


def test_a_piece_that_is_as_short_as_rounding_leaves_is_not_halved() -> None:
    for width, count in ((0.5, 0), (0.625, 1)):
        arc = KnownArc(0.25, lambda beyond: math.inf, narrowest=0.5)
        assert narrowed(arc, arc.place(0.0), arc.place(width)) is not None  # type: ignore[arg-type]
        assert len(arc.asked) == count


def test_an_orbit_that_is_not_found_ends_the_search() -> None:
    arc = KnownArc(0.003, lambda beyond: beyond)
    arc.between = lambda *_: None  # type: ignore[assignment,method-assign,return-value]
    assert narrowed(arc, arc.place(0.0), arc.place(0.01)) is None  # type: ignore[arg-type]


def asked(duration: Callable[[float], float]) -> list[int]:
    """How many orbits are asked for at borders all over the piece."""
    counts = []
    for border in np.linspace(2e-4, 9.8e-3, 25):
        for sign in (1.0, -1.0):
            arc = KnownArc(float(border), duration, sign=sign)
            found = narrowed(arc, arc.place(0.0), arc.place(0.01))  # type: ignore[arg-type]
            assert found is not None
            left, right = (place.at for place in found)  # type: ignore[attr-defined]
            assert left <= border <= right
            assert right - left <= arc.narrowest
            counts.append(len(arc.asked))
    return counts


def test_durations_known_to_few_digits_cost_few_trials_too() -> None:
    # Where several trials in a row fall on one side, the next goes farther; else it takes up to 48.
    assert max(asked(lambda beyond: max(1e-6 * beyond, 1e-18) // 1e-18 * 1e-18)) <= 17


def test_smooth_durations_cost_far_fewer_trials_than_halving() -> None:
    # Halving takes 37.
    assert np.mean(asked(lambda beyond: 2.0 * beyond + 5.0 * beyond**2)) <= 11.0
    assert np.mean(asked(lambda beyond: math.sqrt(beyond) * (1.0 + 3.0 * math.sqrt(beyond)))) <= 12.5


def signature(counts: dict[tuple[str, Phase], int]) -> SimpleNamespace:
    return SimpleNamespace(signature=frozenset(counts.items()))


def test_the_difference_is_a_phase_of_which_one_side_has_more() -> None:
    lower, stick = ("stop", Phase.LOWER), ("blade", Phase.STICK)
    left, right = signature({KEY: 1, lower: 2, stick: 1}), signature({KEY: 1, lower: 1, stick: 3})
    # The first by name of those that change.
    assert _difference(left, right) == (stick, 2)  # type: ignore[arg-type]
    assert _difference(right, left) == (stick, -2)  # type: ignore[arg-type]
    assert _difference(signature({}), signature({KEY: 1, lower: 1})) == (lower, 1)  # type: ignore[arg-type]
    assert _difference(signature({lower: 2}), signature({KEY: 1, lower: 2})) == (KEY, 1)  # type: ignore[arg-type]


def test_the_root_of_durations_is_extrapolated_from_the_last_that_fall() -> None:
    def pairs(power: int, distances: tuple[float, ...]) -> list[tuple[float, float]]:
        # distance = 0.7 - 2 T^power - 0.5 T^(power + 1), so that the duration is zero at 0.7.
        durations = np.linspace(0.5, 0.2, len(distances)) * 4e-5
        return [
            (0.7 - 2.0 * (T / 4e-5) ** power - 0.5 * (T / 4e-5) ** (power + 1), float(T)) for T in durations
        ]

    for power in (1, 2):
        known = pairs(power, (1.0,) * 3)
        root, error = _extrapolated(known, power)
        assert root == pytest.approx(0.7, rel=1e-12)
        rough, unsure = _extrapolated(known[-2:], power)
        (x, a), (y, b) = known[-2:]
        assert rough == pytest.approx((x * b**power - y * a**power) / (b**power - a**power), rel=1e-12)
        assert unsure == pytest.approx(abs(rough - y), rel=1e-12)
        assert error == pytest.approx(0.1 * abs(root - rough), rel=1e-9)
        # The better of both powers is taken; what does not fall is left out, and all but the last three.
        assert _root(known) == (root, error)
        assert _root([(-9.0, 9e-5), (-8.0, 8e-5), *known[:2], (0.5, 7e-5), known[2]]) == (root, error)
    assert np.isnan(_root([(0.1, 1.0)])).all()
    assert np.isnan(_root([(0.1, 1.0), (0.2, 1.0)])).all()


def test_durations_that_say_nothing_have_no_root() -> None:
    assert _constant(np.array([0.1, 0.2]), np.array([1.0, 1.0]), 1) == math.inf


@pytest.mark.parametrize(
    ("on_left", "share"),
    [
        # The border is at 1/9 of the piece by the last two durations, 0.25 and 0.5, and known as well.
        ([False], 2.0 / 9.0),
        ([True, False], 2.0 / 9.0),
        # Two trials behind it, one after the other: the next goes ten times as far, but half way at most.
        ([False, False], 5.0 / 9.0),
        ([True], 1.0 / 18.0),
    ],
)
def test_a_trial_goes_beyond_the_border_by_its_error(on_left: list[bool], share: float) -> None:
    arc = KnownArc(0.5, lambda beyond: beyond)
    seen = [arc.place(distance) for distance in (0.0, 1.0, 0.75)]
    found = _likely(arc, seen, seen[0], seen[2], on_left)  # type: ignore[arg-type]
    assert found == pytest.approx(0.75 * (1.0 - share), rel=1e-12)
    alone = _likely(arc, seen[:2], seen[0], seen[1], [])  # type: ignore[arg-type]
    assert alone == pytest.approx(0.8, rel=1e-14)


def crossed(
    before: dict[tuple[str, Phase], int], after: dict[tuple[str, Phase], int], *outside: float
) -> Border:
    places = [
        SimpleNamespace(
            signature=frozenset(counts.items()),
            value=21.0,
            strobed=np.array([0.5]),
            passage=SimpleNamespace(opens=lambda part, phase: part == "blade"),
            multipliers=np.array([-1.0, 0.5j, *outside[: 2 * number]]),
        )
        for number, counts in enumerate((before, after))
    ]
    return Border(*places)  # type: ignore[arg-type]


def test_a_border_tells_its_parts_and_changes_in_the_order_of_their_names() -> None:
    wall, comb = ("wall", Phase.LOWER), ("comb", Phase.UPPER)
    other, stick = ("comb", Phase.LOWER), ("blade", Phase.STICK)
    border = crossed({wall: 2, comb: 1, stick: 1}, {comb: 3, other: 1, wall: 1, stick: 1}, 1.5, 2.5)
    assert border.changes == {wall: -1, comb: 2, other: 1}
    assert not border.is_single
    (point,) = special_points(border)  # type: ignore[arg-type]
    assert (point.kind, point.parts) == (SpecialKind.GRAZING, ("comb", "wall"))
    assert (point.value, point.state.tolist()) == (21.0, [0.5])
    notes = ["comb: contact on the lower side, +1", "comb: contact on the upper side, +2"]
    notes += ["wall: contact on the lower side, -1", "multipliers outside the unit circle jump from 0 to 2"]
    assert point.note == "; ".join(notes)
    both = special_points(crossed({wall: 1}, {stick: 2}))  # type: ignore[arg-type]
    assert [(each.kind, each.parts, each.note) for each in both] == [
        (SpecialKind.GRAZING, ("wall",), "wall: contact on the lower side, -1"),
        (SpecialKind.STICK, ("blade",), "blade: stick, +2, where it slips for a moment"),
    ]
    assert crossed({wall: 1}, {wall: 2}).is_single
    assert crossed({wall: 2}, {wall: 1}).is_single
    assert not crossed({wall: 2}, {}).is_single
    assert not crossed({wall: 1}, {stick: 1}).is_single
