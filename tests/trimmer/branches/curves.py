"""A map whose orbits are any curve, for what is found on a piece of branch."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from tests.trimmer.branches.maps import Given, Single
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_maps.period_map import Phase
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.branches.step import Front, begun
from trimmer.errors import UnsupportedMotionError

Curve = Callable[[float], np.ndarray]


def nothing(_: float) -> Mapping[tuple[str, Phase], int]:
    return {}


def none(_: float) -> np.ndarray:
    return np.zeros((2, 2))


@dataclass(frozen=True)
class OnCurve(Single):
    """(x, y) -> curve(p) + M(p) ((x, y) - curve(p)): its orbits are the curve, its multipliers those of M."""

    curve: Curve
    rate: Curve
    matrix: Callable[[float], np.ndarray] = none
    signature: Callable[[float], Mapping[tuple[str, Phase], int]] = nothing
    ends: float = np.inf
    size: int = 2
    mirrored: bool = False
    asked: list[float] = field(default_factory=list)

    def passage(self, value: float, state: np.ndarray) -> Given:
        if value > self.ends:
            raise UnsupportedMotionError("it cannot be followed")
        self.asked.append(value)
        away, matrix = state - self.curve(value), self.matrix(value)
        end = self.curve(value) + matrix @ away
        by_value = (np.eye(2) - matrix) @ self.rate(value)
        return Given(end, matrix, by_value, abs(state), self.signature(value))

    def at(self, value: float, problem: Problem | None = None) -> Place:
        """Return the orbit at a value, by itself as one of a problem without units."""
        problem = Problem(self, 1.0, np.ones(2)) if problem is None else problem
        place = problem.place(problem.position(value, self.curve(value)))
        assert place is not None
        return place


def parabola(**others: object) -> OnCurve:
    """The orbits (p², 3 p)."""
    return OnCurve(
        lambda p: np.array([p * p, 3.0 * p]),
        lambda p: np.array([2.0 * p, 3.0]),
        **others,  # type: ignore[arg-type]
    )


def line_front(map: object, value: float, state: float, sign: float = 1.0) -> Front:
    """Return the front of a branch of a map with one state, towards larger values or smaller ones."""
    problem = Problem(map, 1.0, np.ones(1))  # type: ignore[arg-type]
    place = problem.correct(np.array([state, value]), np.array([0.0, 1.0]), value)
    assert place is not None
    tangent = place.tangent(np.array([0.0, sign]))
    assert tangent is not None
    return begun(problem, place, tangent)


def special(
    value: float, *state: float, kind: SpecialKind = SpecialKind.FOLD, parts: tuple[str, ...] = ()
) -> SpecialPoint:
    """Return a special point with a state."""
    return SpecialPoint(kind, value, np.array(state), parts)
