"""Where phases change, on arcs whose orbits are known: with few orbits, and as near as rounding permits."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from types import SimpleNamespace

import pytest

from trimmer.branches.narrowing import narrowed
from trimmer.branches.period_maps.period_map import Phase

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


def test_an_orbit_that_is_not_found_ends_the_search() -> None:
    arc = KnownArc(0.003, lambda beyond: beyond)
    arc.between = lambda *_: None  # type: ignore[assignment,method-assign,return-value]
    assert narrowed(arc, arc.place(0.0), arc.place(0.01)) is None  # type: ignore[arg-type]
