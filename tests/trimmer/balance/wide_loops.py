"""Random loops of every element: delays, many lags, clusters, roots on the axis and to its right, all scales.

G is put together from its roots, which are known to all digits whatever its coefficients tell. Drawn is the
shape of a loop, with frequencies about 1 rad/s and gains about 1; units of time, of the element's input and
of its output come on top of it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum, auto

import control
import numpy as np

from trimmer import InertiaBacklash, Preload, Relay, Saturation, ViscousBacklash, ViscousFriction
from trimmer.arrays import Complexes, Reals
from trimmer.elements import CoulombFriction, DeadZone, Element, FrictionBacklash


@dataclass(frozen=True)
class KnownRoots:
    """G = gain * prod(s - zero) / prod(s - pole), rad/s."""

    gain: float
    zeros: tuple[complex, ...]
    poles: tuple[complex, ...]

    def inverse(self, omega: Reals) -> Complexes:
        """Evaluate 1/G(j omega), in pairs that hardly overflow."""
        value = np.full(omega.shape, 1.0 / self.gain, dtype=complex)
        for place in range(len(self.poles)):
            value *= 1j * omega - self.poles[place]
            if place < len(self.zeros):
                value /= 1j * omega - self.zeros[place]
        return value

    def phase(self, omega: Reals) -> Reals:
        """The phase of G, continuous in omega but for half turns at roots on the axis, rad."""
        turned = np.full(omega.shape, 0.0 if self.gain > 0 else np.pi)
        for roots, sign in ((self.zeros, 1.0), (self.poles, -1.0)):
            for root in roots:
                turned += sign * np.angle((1j * omega - root) * (1.0 if root.real <= 0 else -1.0))
                turned += np.pi if root.real > 0 else 0.0
        return turned

    def log_size(self, omega: Reals) -> Reals:
        """Ln |G|."""
        value = np.full(omega.shape, np.log(abs(self.gain)))
        for roots, sign in ((self.zeros, 1.0), (self.poles, -1.0)):
            for root in roots:
                value += sign * np.log(np.abs(1j * omega - root))
        return value

    def faster(self, factor: float) -> KnownRoots:
        """Return G of s / factor."""
        degree = len(self.poles) - len(self.zeros)
        scaled = (tuple(factor * root for root in roots) for roots in (self.zeros, self.poles))
        return KnownRoots(self.gain * factor**degree, *scaled)

    def state_space(self) -> control.StateSpace:
        """Return a chain of sections of order two or one: no coefficient holds more than two roots."""
        poles, zeros = _sections(self.poles), _sections(self.zeros)
        system = control.ss([], [], [], [[1.0]])
        for place, section in enumerate(poles):
            above = zeros[place] if place < len(zeros) else np.ones(1)
            system = control.ss(control.tf(above, section)) * system
        return self.gain * system

    def transfer_function(self) -> control.TransferFunction:
        numerator, denominator = (np.atleast_1d(np.poly(roots)).real for roots in (self.zeros, self.poles))
        return control.tf(self.gain * numerator, denominator)


def _sections(roots: tuple[complex, ...]) -> list[Reals]:
    """Return polynomials of two roots each, of one at last, highest power first."""
    above = [root for root in roots if root.imag > 0]
    real = [root.real for root in roots if root.imag == 0]
    pairs = [np.array([1.0, -2.0 * root.real, abs(root) ** 2]) for root in above]
    return pairs + [np.poly(real[place : place + 2]) for place in range(0, len(real), 2)]


class Kind(Enum):
    """What an element is made of; the values only part them."""

    RELAY = auto()
    FRICTION = auto()
    RELAY_AND_FRICTION = auto()
    DAMPED_FRICTION = auto()
    PRELOAD = auto()
    THRESHOLDS = auto()
    SATURATION = auto()
    DEAD_ZONE = auto()
    TWO_CORNERS = auto()
    PLAY = auto()
    PLAY_AND_DAMPING = auto()
    PLAY_AND_FRICTION = auto()
    TWO_PLAYS = auto()
    CARRIED = auto()
    CARRIED_AND_RUBBING = auto()
    THROWN = auto()
    FROZEN = auto()


@dataclass(frozen=True)
class WideLoop:
    """A loop, and what the brute force needs to know of it beside the element itself."""

    response: KnownRoots
    element: Element
    kind: Kind
    system: control.LTI


def wide_loop(seed: tuple[int, ...]) -> WideLoop:
    """Draw a loop; the same for the same seed."""
    random = np.random.default_rng(seed)
    shape = _shape(random)
    kind = list(Kind)[random.integers(len(Kind))]
    fast, size, force = (10.0 ** (random.uniform(-9, 9) if random.random() < 0.4 else 0.0) for _ in range(3))
    # About the largest degree that doubles hold.
    fast = fast ** min(1.0, 25.0 / len(shape.poles))
    place = 10.0 ** random.uniform(-1.5, 1.5)
    gain = 10.0 ** random.uniform(-1.5, 2.5) * (1.0 if random.random() < 0.85 else -1.0)
    gain *= float(np.exp(-shape.log_size(np.array([place]))[0]))
    is_turned = random.random() >= 0.85
    element = _ELEMENTS[kind](_Drawn(random, size, force, fast * place))
    element = -element if is_turned else element
    response = replace(shape, gain=shape.gain * gain).faster(fast)
    response = replace(response, gain=response.gain * size / force)
    system: control.LTI = response.transfer_function()
    if len(shape.poles) <= 8 and random.random() < 0.15:
        system = response.state_space()
    return WideLoop(response, element, kind, system)


def _shape(random: np.random.Generator) -> KnownRoots:
    poles: list[complex] = [0j] * int(random.choice(4, p=[0.6, 0.25, 0.1, 0.05]))
    zeros: list[complex] = []
    if random.random() < 0.45:
        numerator, denominator = control.pade(10.0 ** random.uniform(-1, 1.3), int(random.integers(1, 11)))
        poles += np.roots(denominator).tolist()
        zeros += np.roots(numerator).tolist()
    if random.random() < 0.5:
        poles += _lags(random, int(random.integers(1, 31 if random.random() < 0.4 else 6)))
    for _ in range(int(random.integers(0, 3))):
        poles += _pair(10.0 ** random.uniform(-1.5, 1.5), 10.0 ** random.uniform(-3, 0))
    if random.random() < 0.12:
        poles += _pair(10.0 ** random.uniform(-1, 1), 0.0)
    if random.random() < 0.06:
        poles.append(complex(10.0 ** random.uniform(-1, 1)))
    if not poles:
        poles += _lags(random, int(random.integers(2, 8)))
    for _ in range(int(random.integers(0, 4))):
        side = 1.0 if random.random() < 0.3 else -1.0
        wanted = _pair(10.0 ** random.uniform(-1, 1), side * 10.0 ** random.uniform(-2, 0))
        if random.random() < 0.6:
            wanted = [complex(side * -(10.0 ** random.uniform(-1.5, 1.5)))]
        if len(zeros) + len(wanted) <= len(poles):
            zeros += wanted
    return KnownRoots(1.0, tuple(zeros), tuple(poles))


def _pair(omega: float, damping: float) -> list[complex]:
    root = omega * complex(-damping, np.sqrt(1.0 - min(damping**2, 1.0)))
    return [root, root.conjugate()]


def _lags(random: np.random.Generator, count: int) -> list[complex]:
    """All alike, in a cluster, evenly spaced, or spread over decades."""
    spread = [0.0, 10.0 ** random.uniform(-6, -1), 0.0, random.uniform(0.3, 3.0)][int(random.integers(4))]
    if spread == 0.0 and random.random() < 0.5:
        return [complex(-(place + 1.0) / np.sqrt(count)) for place in range(count)]
    return [complex(-(10.0 ** (spread * random.uniform(-1, 1)))) for _ in range(count)]


@dataclass(frozen=True)
class _Drawn:
    """Draws numbers for inputs of a size and outputs of a force, near an omega, a decade off either way."""

    random: np.random.Generator
    size: float
    force: float
    omega: float

    def one(self, scale: float) -> float:
        return float(scale * 10.0 ** self.random.uniform(-1, 1))

    @property
    def some_size(self) -> float:
        return self.one(self.size)

    @property
    def some_force(self) -> float:
        return self.one(self.force)

    @property
    def stiffness(self) -> float:
        return self.one(self.force / self.size)

    @property
    def damping(self) -> float:
        return self.one(self.force / self.size / self.omega)

    @property
    def lag(self) -> float:
        return self.one(1.0 / self.omega)


_ELEMENTS: dict[Kind, Callable[[_Drawn], Element]] = {
    Kind.RELAY: lambda of: Relay(of.some_force),
    Kind.FRICTION: lambda of: CoulombFriction(of.some_force),
    Kind.RELAY_AND_FRICTION: lambda of: Relay(of.some_force) + CoulombFriction(of.some_force),
    Kind.DAMPED_FRICTION: lambda of: CoulombFriction(of.some_force) + ViscousFriction(of.damping),
    Kind.PRELOAD: lambda of: Preload(of.some_force, of.stiffness),
    Kind.THRESHOLDS: lambda of: Relay(of.some_force, *_thresholds(of.random, of.some_size)),
    Kind.SATURATION: lambda of: Saturation(of.some_size, of.stiffness),
    Kind.DEAD_ZONE: lambda of: DeadZone(of.some_size, of.stiffness),
    Kind.TWO_CORNERS: lambda of: (
        Saturation(of.some_size, of.stiffness) + DeadZone(of.some_size, of.stiffness)
    ),
    Kind.PLAY: lambda of: of.stiffness * FrictionBacklash(of.some_size),
    Kind.PLAY_AND_DAMPING: lambda of: (
        of.stiffness * FrictionBacklash(of.some_size) + ViscousFriction(of.damping)
    ),
    Kind.PLAY_AND_FRICTION: lambda of: (
        of.stiffness * FrictionBacklash(of.some_size) + CoulombFriction(of.some_force)
    ),
    Kind.TWO_PLAYS: lambda of: (
        of.stiffness * FrictionBacklash(of.some_size) + of.stiffness * FrictionBacklash(of.some_size)
    ),
    Kind.CARRIED: lambda of: of.stiffness * ViscousBacklash(of.some_size, of.lag),
    Kind.CARRIED_AND_RUBBING: lambda of: (
        of.stiffness * ViscousBacklash(of.some_size, of.lag)
        + (CoulombFriction(of.some_force) + ViscousFriction(of.damping))
    ),
    Kind.THROWN: lambda of: of.stiffness * InertiaBacklash(of.some_size),
    Kind.FROZEN: lambda of: of.stiffness * ViscousBacklash(of.some_size, of.lag).at(of.omega),
}


def _thresholds(random: np.random.Generator, size: float) -> tuple[float, float]:
    """Hysteresis and dead zone of a relay, not both zero."""
    share = float(random.choice([0.0, 1.0, random.uniform(0.05, 0.95), 0.5]))
    return share * size, (1.0 - share) * size
