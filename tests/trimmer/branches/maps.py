"""Maps whose branches and special points are known, and the passage that they give."""

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from trimmer.branches.period_maps.driven_passage import Restart
from trimmer.errors import UnsupportedMotionError
from trimmer.motion.part import Phase


@dataclass(frozen=True, eq=False)
class Given:
    """A passage of which all is given."""

    end: np.ndarray
    jacobian: np.ndarray
    rate: np.ndarray
    sizes: np.ndarray
    signature: Mapping[tuple[str, Phase], int] = field(default_factory=dict)
    events: int = 0
    grazed: tuple[str, ...] = ()
    is_linear: bool = False
    middle: np.ndarray | None = None

    @property
    def monodromy(self) -> np.ndarray:
        return self.jacobian

    def shortest(self, part: str, phase: Phase) -> float:
        return math.inf

    def opens(self, part: str, phase: Phase) -> bool:
        return False

    def strobed(self, state: np.ndarray) -> np.ndarray:
        return state

    def restart(self, tangent: np.ndarray) -> Restart | None:
        return None


class Single:
    """What all these maps share."""

    size = 1
    mirrored = False
    doublings = 0
    single = None

    def doubled(self) -> "Doubled":
        return Doubled(self)

    def phases(self, value: float, state: np.ndarray) -> list[np.ndarray]:
        return [state]


class Doubled(Single):
    """Two passages of a map as one, without mirror."""

    def __init__(self, single: Any) -> None:
        self.single, self.size, self.doublings = single, single.size, single.doublings + 1

    def passage(self, value: float, state: np.ndarray) -> Given:
        first = self.single.passage(value, state)
        second = self.single.passage(value, first.end)
        return Given(
            second.end,
            second.jacobian @ first.jacobian,
            second.jacobian @ first.rate + second.rate,
            np.maximum(first.sizes, second.sizes),
            Counter(first.signature) + Counter(second.signature),
            middle=first.end,
        )


@dataclass(frozen=True)
class Logistic(Single):
    """x -> r x (1 - x)."""

    def passage(self, value: float, state: np.ndarray) -> Given:
        rest = state * (1.0 - state)
        return Given(value * rest, np.array([[value * (1.0 - 2.0 * state[0])]]), rest, abs(state))


@dataclass(frozen=True)
class Henon(Single):
    """(x, y) -> (1 - a x² + y, b x) with the units of x and y chosen at will."""

    b: float = 0.3
    units: tuple[float, float] = (1.0, 1.0)
    unit_of_value: float = 1.0
    size: int = 2

    def passage(self, value: float, state: np.ndarray) -> Given:
        units, a = np.array(self.units), value / self.unit_of_value
        x, y = state / units
        end = np.array([1.0 - a * x * x + y, self.b * x])
        jacobian = np.array([[-2.0 * a * x, 1.0], [self.b, 0.0]]) * units[:, None] / units
        rate = np.array([-x * x, 0.0]) * units / self.unit_of_value
        return Given(end * units, jacobian, rate, abs(state))


@dataclass(frozen=True)
class DelayedLogistic(Single):
    """(x, y) -> (r x (1 - y), x): a torus parts at r = 2."""

    size: int = 2

    def passage(self, value: float, state: np.ndarray) -> Given:
        x, y = state
        jacobian = np.array([[value * (1.0 - y), -value * x], [1.0, 0.0]])
        return Given(
            np.array([value * x * (1.0 - y), x]), jacobian, np.array([x * (1.0 - y), 0.0]), abs(state)
        )


@dataclass(frozen=True)
class Bent(Single):
    """x -> p + left x for x < 0, p + right x otherwise: fixed points p/(1 - left) and p/(1 - right).

    It stands for a contact whose damping sets in at once: the slope jumps where x = 0.
    """

    left: float
    right: float
    phase: Phase = Phase.UPPER

    def passage(self, value: float, state: np.ndarray) -> Given:
        slope = self.right if state[0] >= 0.0 else self.left
        contacts = {("stop", self.phase): int(state[0] >= 0.0)}
        return Given(value + slope * state, np.array([[slope]]), np.ones(1), np.ones(1), contacts)


@dataclass(frozen=True)
class Cubic(Single):
    """x -> (1 + p) x - x³, its mirror image taken if it is mirrored: symmetry is lost at p = 0."""

    mirrored: bool = False

    def passage(self, value: float, state: np.ndarray) -> Given:
        sign = -1.0 if self.mirrored else 1.0
        slope = np.diag(1.0 + value - 3.0 * state**2)
        return Given(sign * ((1.0 + value) * state - state**3), sign * slope, sign * state, np.ones(1))


@dataclass(frozen=True)
class Ring(Single):
    """x -> x - (x² + p² - 1) / 5: the fixed points lie on a circle."""

    def passage(self, value: float, state: np.ndarray) -> Given:
        end = state - 0.2 * (state**2 + value**2 - 1.0)
        return Given(end, np.diag(1.0 - 0.4 * state), np.array([-0.4 * value]), np.ones(1))


@dataclass(frozen=True)
class Twice(Single):
    """x -> -(1 + (p - a) (p - b)) x: a multiplier is beyond -1 but for p between a and b."""

    first: float
    second: float

    def passage(self, value: float, state: np.ndarray) -> Given:
        beyond = (value - self.first) * (value - self.second)
        by_value = -(2.0 * value - self.first - self.second) * state
        return Given(-(1.0 + beyond) * state, np.array([[-(1.0 + beyond)]]), by_value, np.ones(1))


@dataclass(frozen=True)
class Steps(Single):
    """x -> x / 2 + |p - a| + |p - b| + x_0 with a contact for each kink, near as they are."""

    kinks: tuple[float, ...]

    def passage(self, value: float, state: np.ndarray) -> Given:
        made = {(f"stop {each}", Phase.LOWER): int(value > each) for each in self.kinks}
        end = 0.5 * state + sum(max(value - each, 0.0) for each in self.kinks)
        return Given(end, np.array([[0.5]]), np.array([float(sum(made.values()))]), np.ones(1), made)


@dataclass(frozen=True)
class Torn(Single):
    """x -> x / 2 + p, and 1 more from p = 0 on: the fixed point jumps."""

    def passage(self, value: float, state: np.ndarray) -> Given:
        sticks = {("blade", Phase.STICK): int(value > 0.0)}
        end = 0.5 * state + value + (value > 0.0)
        return Given(end, np.array([[0.5]]), np.ones(1), np.ones(1), sticks)


@dataclass(frozen=True)
class Failing(Single):
    """x -> x / 2 + p for p < 1/2; beyond that the motion cannot be followed."""

    def passage(self, value: float, state: np.ndarray) -> Given:
        if value >= 0.5:
            raise UnsupportedMotionError("it cannot be followed")
        return Given(0.5 * state + value, np.array([[0.5]]), np.ones(1), np.ones(1))
