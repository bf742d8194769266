"""Frequencies where a frequency response crosses a gain or the real axis: all of them.

Between two neighbouring extrema |G| is monotonic, so it crosses a level at most once; likewise the phase.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import control
import numpy as np

from trimmer.arguments import positive_number
from trimmer.linear.extrema import polished_root, stationary_gains, stationary_phases
from trimmer.linear.zero_pole_gain import ZeroPoleGain
from trimmer.showing.shown import ShownFields

_REACH = 1e6
"""How far beyond the smallest and the largest root a crossing is looked for where |G| is level in the end."""

_LOG_LIMIT = 1e4
"""Stands for an infinite logarithm of a gain, as at a pole on the axis; root finders need numbers."""

_PHASE_ROUNDING = 1e-12  # Phase, rad, below which a distance from the real axis is taken for rounding


@dataclass(frozen=True)
class RealAxisCrossing(ShownFields):
    """A place where G(j omega) is real.

    Attributes:
        omega: Angular frequency, rad/s.
        value: G there, a real number in the unit of output over input; negative at a phase crossover.
    """

    omega: float
    value: float


def gain_crossings(system: control.lti.LTI, level: float = 1.0) -> tuple[float, ...]:
    """Find all omega > 0 with |G(j omega)| = level, in rising order.

    A level that is only touched, to rounding, may be found or not. Where |G| tends to a limit other than 0 or
    infinity (at low or high frequency), it is followed to a million times beyond the outermost root.

    Args:
        system: A system with one input and one output.
        level: Gain, > 0, in the unit of output over input; 1 is 0 dB.

    Returns:
        Angular frequencies, rad/s.

    Raises:
        ValueError: if the level is not positive and finite.
        UnsupportedSystemError: see ``trimmer.linear.frequency_response.require_siso``.
    """
    log_level = math.log(positive_number("level", level))
    factored = ZeroPoleGain.of(system)

    def excess(omega: float) -> float:
        return float(np.clip(factored.log_gain(omega) - log_level, -_LOG_LIMIT, _LOG_LIMIT))

    ends = _gain_ends(factored, excess)
    breaks = _breaks(factored, ends, (omega for omega, _ in stationary_gains(factored)))
    return tuple(_crossings_of_zero(excess, breaks))


def real_axis_crossings(system: control.lti.LTI) -> tuple[RealAxisCrossing, ...]:
    """Find all omega > 0 where G(j omega) crosses the real axis away from the origin, in rising order.

    Where G is real on an interval of the axis, as in an undamped system, that is no crossing.

    Args:
        system: A system with one input and one output.

    Returns:
        Crossings with omega in rad/s and the value in the unit of output over input.

    Raises:
        UnsupportedSystemError: see ``trimmer.linear.frequency_response.require_siso``.
    """
    factored = ZeroPoleGain.of(system)
    breaks = _breaks(factored, _root_range(factored, _REACH), stationary_phases(factored))
    return tuple(
        RealAxisCrossing(omega, float((-1) ** half_turns * np.exp(factored.log_gain(omega))))
        for lower, upper in pairwise(breaks)
        for omega, half_turns in _half_turns(factored, lower, upper)
    )


def _root_range(factored: ZeroPoleGain, reach: float) -> tuple[float, float]:
    magnitudes = np.abs(factored.roots)
    magnitudes = magnitudes[magnitudes > 0]
    if magnitudes.size == 0:
        return 1.0 / reach, reach
    return float(magnitudes.min() / reach), float(magnitudes.max() * reach)


def _gain_ends(factored: ZeroPoleGain, excess: Callable[[float], float]) -> tuple[float, float]:
    """Widen the range of the roots until the straight ends of the Bode plot have passed the level."""
    lower, upper = _root_range(factored, _REACH)
    low_slope = float(factored.exponents[factored.roots == 0].sum())
    high_slope = -float(factored.relative_degree)
    if low_slope and low_slope * excess(lower) >= 0:  # the lowest break itself is no crossing
        lower *= math.exp(-excess(lower) / low_slope - 1)
    if high_slope * excess(upper) < 0:
        upper *= math.exp(-excess(upper) / high_slope + 1)
    return lower, upper


def _breaks(factored: ZeroPoleGain, ends: tuple[float, float], stationary: Iterator[float]) -> list[float]:
    """Frequencies between which a curve is monotonic and without jumps."""
    on_axis = (float(root.imag) for root in factored.roots if root.real == 0 and root.imag > 0)
    return sorted({*ends, *stationary, *on_axis})


def _crossings_of_zero(function: Callable[[float], float], breaks: list[float]) -> Iterator[float]:
    values = [function(omega) for omega in breaks]
    for (lower, at_lower), (upper, at_upper) in pairwise(zip(breaks, values, strict=True)):
        if at_lower * at_upper < 0:
            yield polished_root(function, lower, upper)
        elif at_upper == 0:
            yield upper


def _half_turns(factored: ZeroPoleGain, lower: float, upper: float) -> Iterator[tuple[float, int]]:
    """Yield (omega, k) where the phase passes k pi between two breaks, in order of frequency."""
    inside = math.sqrt(lower) * math.sqrt(upper)
    jumps = ZeroPoleGain(
        1.0, *(tuple(r for r in roots if r.real == 0) for roots in (factored.zeros, factored.poles))
    )
    offset = float(jumps.phase(inside))

    def phase(omega: float) -> float:
        return float(factored.phase(omega) - jumps.phase(omega)) + offset

    start, end = phase(lower), phase(upper)
    smallest = math.ceil((min(start, end) + _PHASE_ROUNDING) / math.pi)
    largest = math.floor((max(start, end) - _PHASE_ROUNDING) / math.pi)
    order = range(smallest, largest + 1) if start < end else range(largest, smallest - 1, -1)
    for k in order:
        yield polished_root(partial(_phase_beyond, phase, k), lower, upper), k


def _phase_beyond(phase: Callable[[float], float], half_turns: int, omega: float) -> float:
    return phase(omega) - half_turns * math.pi
