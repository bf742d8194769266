"""Limit cycles of a random loop by brute force: a dense grid, N from textbook formulas, and SciPy's solver.

Where N is proportional to 1/A a change of the sign of Im(c G) is one, if c G is negative there; G is the
product of the roots that it was made of. Else 1 + N G is followed round each cell of a grid of amplitude and
frequency, and SciPy solves from every cell round which its phase turns. A grid may miss some; what it finds
are solutions.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq, root

from tests.trimmer.balance.wide_loops import Kind, KnownRoots, WideLoop
from trimmer import CoulombFriction, DeadZone, FrictionBacklash, Preload, Relay, Saturation, ViscousFriction
from trimmer.arrays import Complexes, Reals
from trimmer.elements import Element, ScaledElement, SumOfElements

PROPORTIONAL = {Kind.RELAY, Kind.FRICTION, Kind.RELAY_AND_FRICTION, Kind.DAMPED_FRICTION, Kind.PRELOAD}
ALONG_AXIS = 6000
OMEGAS, AMPLITUDES = 500, 120
BEYOND = 1e5  # How far beyond the roots is looked where the amplitude is eliminated; a hundredth of it else
BESIDE = np.sinh(np.linspace(-6.0, 6.0, 49))


@dataclass(frozen=True)
class Found:
    """A solution: amplitude, in the unit of the input, and omega, rad/s."""

    amplitude: float
    omega: float


def limit_cycles_by_brute_force(loop: WideLoop) -> list[Found]:
    with np.errstate(all="ignore"):
        return _along_the_axis(loop) if loop.kind in PROPORTIONAL else _in_the_plane(loop)


def gain(element: Element, amplitude: Reals, omega: Reals) -> Complexes:
    """N by formulas of textbooks where there are; of a load that coasts, the element's own."""
    match element:
        case SumOfElements():
            return sum((gain(term, amplitude, omega) for term in element.terms), np.zeros(amplitude.shape))
        case ScaledElement():
            return element.factor * gain(element.element, amplitude, omega)
        case ViscousFriction():
            return 1j * element.damping * omega
        case Preload():
            return element.slope + 4.0 * element.level / (np.pi * amplitude) + 0j
        case CoulombFriction():
            return 4j * element.force / (np.pi * amplitude)
        case Relay():
            on, off = element.dead_zone + element.hysteresis, element.dead_zone - element.hysteresis
            cosines = np.sqrt(1.0 - (on / amplitude) ** 2) + np.sqrt(1.0 - (off / amplitude) ** 2)
            switching = 2.0 * element.level / (np.pi * amplitude)
            value = switching * (cosines - 2j * element.hysteresis / amplitude)
            return np.where(amplitude > on, value, 0.0 if off >= 0 else np.nan)
        case Saturation():
            u = np.minimum(element.threshold / amplitude, 1.0)
            return element.slope * (2.0 / np.pi) * (np.arcsin(u) + u * np.sqrt((1.0 - u) * (1.0 + u))) + 0j
        case DeadZone():
            beyond = np.sqrt(np.maximum(amplitude - element.threshold, 0.0) * (amplitude + element.threshold))
            return element.slope / np.pi * _less_its_sine(2.0 * np.arctan2(beyond, element.threshold)) + 0j
        case FrictionBacklash():
            beyond = 2.0 - element.gap / amplitude  # Play ends where it is 0.
            turn = 4.0 * np.arcsin(np.sqrt(0.5 * beyond))
            return _less_its_sine(turn) / (2.0 * np.pi) - 1j * beyond * (2.0 - beyond) / np.pi
    return element.describing_function(amplitude, omega)


def _less_its_sine(angle: Reals) -> Reals:
    return np.where(angle < 0.1, angle**3 / 6.0 - angle**5 / 120.0 + angle**7 / 5040.0, angle - np.sin(angle))


def frequencies(response: KnownRoots, count: int, beyond: float) -> Reals:
    """Return angular frequencies, rad/s, rising; closer beside each root."""
    roots = np.array([*response.zeros, *response.poles])
    sizes = np.abs(roots[roots != 0])
    sizes = sizes if sizes.size else np.ones(1)
    beside = roots.imag + np.maximum(np.abs(roots.real), 1e-7 * np.abs(roots)) * BESIDE[:, None]
    lowest, highest = sizes.min() / beyond, sizes.max() * beyond
    beside = beside[(beside > lowest) & (beside < highest)]
    return np.unique(np.concatenate([np.geomspace(lowest, highest, count), beside.ravel()]))


def _on_axis(response: KnownRoots) -> Reals:
    roots = np.array([*response.zeros, *response.poles])
    return roots.imag[(roots.real == 0) & (roots.imag > 0)]


def _away_from(places: Reals, omega: float) -> bool:
    """Whether a frequency is not at a root on the axis, where phases jump."""
    return bool((np.abs(places - omega) > 1e-8 * omega).all())


def _along_the_axis(loop: WideLoop) -> list[Found]:
    """Follow the phase of c G, or of c/(1/G + N less c/A), through half turns."""
    unit = complex(gain(loop.element, np.full(1, 1e-300), np.ones(1))[0]) * 1e-300
    linear = loop.kind in {Kind.PRELOAD, Kind.DAMPED_FRICTION}
    infinite = np.full(1, np.inf)

    def total(omega: Reals) -> Complexes:
        return loop.response.inverse(omega) + gain(
            loop.element, np.broadcast_to(infinite, omega.shape), omega
        )

    def turned(omega: Reals) -> Reals:
        if linear:
            return np.angle(-unit / total(omega))
        return np.angle(np.exp(1j * (loop.response.phase(omega) + np.angle(unit) - np.pi)))

    def size(omega: float) -> float:
        place = np.array([omega])
        return float(-np.log(np.abs(total(place)))[0] if linear else loop.response.log_size(place)[0])

    omega = frequencies(loop.response, ALONG_AXIS, BEYOND)
    angle = turned(omega)
    changes = np.flatnonzero((np.sign(angle[1:]) != np.sign(angle[:-1])) & (np.abs(np.diff(angle)) < 2.0))
    found = []
    for k in changes:
        low, high = float(omega[k]), float(omega[k + 1])
        place = brentq(lambda x: float(turned(np.array([x]))[0]), low, high, xtol=1e-300, rtol=1e-14)
        near = [turned(np.array([place * side]))[0] for side in (1 - 1e-9, 1 + 1e-9)]
        log_amplitude = size(place) + math.log(abs(unit))
        if (
            np.abs(near).max() < 0.5
            and _away_from(_on_axis(loop.response), place)
            and abs(log_amplitude) < 690
        ):
            found.append(Found(math.exp(log_amplitude), place))
    return found


def _smallest_amplitude(element: Element) -> float:
    """From which on N exists, or changes with A."""
    match element:
        case SumOfElements():
            smallest = [_smallest_amplitude(term) for term in element.terms]
            exact = [each for each, term in zip(smallest, element.terms, strict=True) if _ends(term)]
            return max(exact) if exact else min(each for each in smallest if each > 0)
        case ScaledElement():
            return _smallest_amplitude(element.element)
        case Relay():
            return element.dead_zone + element.hysteresis
        case Saturation() | DeadZone():
            return element.threshold
        case FrictionBacklash():
            return 0.5 * element.gap
        case ViscousFriction() | CoulombFriction():
            return 0.0
    raise TypeError(element)


def _ends(element: Element) -> bool:
    return isinstance(element.element if isinstance(element, ScaledElement) else element, FrictionBacklash)


SHARES = np.concatenate([np.geomspace(1e-7, 0.3, AMPLITUDES // 3), 1 - np.geomspace(0.69, 1e-10, AMPLITUDES)])
"""Of the smallest amplitude over the amplitude."""


def _in_the_plane(loop: WideLoop) -> list[Found]:
    omega = frequencies(loop.response, OMEGAS, BEYOND / 100.0)
    shares, kind = SHARES[:, None], loop.kind
    coasting = kind in {Kind.CARRIED, Kind.CARRIED_AND_RUBBING, Kind.THROWN, Kind.FROZEN}

    def amplitude_of(share: Reals, omega: Reals) -> Reals:
        if coasting:
            return loop.element.amplitude_scale / (share * loop.element.domain(omega))
        return _smallest_amplitude(loop.element) / share

    def excess(share: Reals, omega: Reals) -> Complexes:
        amplitude = np.broadcast_to(amplitude_of(share, omega), np.broadcast_shapes(share.shape, omega.shape))
        value = gain(loop.element, amplitude, np.broadcast_to(omega, amplitude.shape))
        return value + loop.response.inverse(omega)

    phase = np.angle(excess(shares, omega[None, :]))
    corners = (phase[:-1, :-1], phase[1:, :-1], phase[1:, 1:], phase[:-1, 1:])
    steps = (end - start for start, end in zip(corners, (*corners[1:], corners[0]), strict=True))
    turns = sum((step + np.pi) % (2 * np.pi) - np.pi for step in steps) / (2 * np.pi)
    found: list[Found] = []
    for i, j in np.argwhere(np.abs(np.nan_to_num(np.rint(turns))) == 1)[:40]:
        solved = _solved(excess, (SHARES[i], SHARES[i + 1]), (omega[j], omega[j + 1]))
        if solved is None or not _away_from(_on_axis(loop.response), solved[1]):
            continue
        place = float(np.ravel(amplitude_of(np.array([solved[0]]), np.array([solved[1]])))[0])
        found.append(Found(place, solved[1]))
    return found


def _solved(excess, shares: tuple[float, float], omegas: tuple[float, float]) -> tuple[float, float] | None:
    """Solve in a cell, with v = ln(share/(1 - share)) and x = ln omega; None if that leads out of it."""

    def logit(share: float) -> float:
        return math.log(share / (1.0 - share))

    lower, upper = (
        np.array([logit(shares[0]), math.log(omegas[0])]),
        np.array([logit(shares[1]), math.log(omegas[1])]),
    )
    middle, width = 0.5 * (lower + upper), upper - lower

    def at(place: Reals) -> complex:
        v, x = middle + width * place
        return complex(np.ravel(excess(np.array([1.0 / (1.0 + math.exp(-v))]), np.array([math.exp(x)])))[0])

    scale = max(abs(at(np.array(corner))) for corner in ((-0.5, -0.5), (0.5, 0.5)))

    def parts(place: Reals) -> list[float]:
        value = at(place) / scale
        return [value.real, value.imag] if math.isfinite(abs(value)) else [1e3, 1e3]

    try:
        solution = root(parts, [0.0, 0.0], tol=1e-13)
    except OverflowError:
        return None
    place = np.asarray(solution.x)
    if np.abs(place).max() > 0.51 or np.abs(parts(place)).max() > 1e-9:
        return None
    v, x = middle + width * place
    return 1.0 / (1.0 + math.exp(-v)), math.exp(x)
