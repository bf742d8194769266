"""Stroke, harmonics and impacts of a periodic motion, from the exact motion itself."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.motion.backlash_component import LOWER, UPPER, BacklashComponent
from trimmer.orbits.measures import HARMONICS, extremes_of
from trimmer.orbits.return_map import arcs, flow
from trimmer.showing.shown import ShownFields

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.motion.mode import LoopMode
    from trimmer.motion.motion import Motion

NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)
"""Gauss-Legendre quadrature of a step; in one the fastest mode turns by about 2 rad, a harmonic by 30."""


@final
@dataclass(frozen=True)
class ImpactEvent(ShownFields):
    """A meeting of the pin with a side of its gap.

    Attributes:
        time: s, from the start of the motion.
        component: Which element, by name.
        mode: Mode of that element afterwards: the side of the gap.
        speed: How fast pin and load approach each other just before, m/s.
    """

    time: float
    component: str
    mode: str
    speed: float


def stroke(motion: Motion, row: Callable[[LoopMode], Reals]) -> float:
    """Return the largest value less the smallest one of a signal over a motion, in its unit."""
    modes = motion.loop.modes
    lowest, highest = extremes_of(modes, arcs(modes, motion.log, motion.duration), row)
    return highest - lowest


def harmonics_by_quadrature(motion: Motion, row: Callable[[LoopMode], Reals]) -> Complexes:
    """Return the complex amplitudes c_n, n = 1 to HARMONICS, of a signal over a period.

    The signal is Im Σ c_n exp(j n omega t) + constant, with t = 0 at the start of the motion. Unlike the
    closed form of ``trimmer.orbits.measures`` it also holds under a drive, which turns with omega itself.

    Args:
        motion: A motion over one period.
        row: Gives the row of the signal in a mode.
    """
    turning = -2j * np.pi / motion.duration * np.arange(1, HARMONICS + 1)
    totals = np.zeros(HARMONICS, dtype=complex)
    for times, weights in _pieces(motion):
        (values,) = motion.values(times, lambda mode: row(mode)[None])
        totals += np.exp(np.multiply.outer(turning, times)) @ (weights * values)
    amplitudes: Complexes = 2j * totals / motion.duration
    return amplitudes


def impacts(motion: Motion) -> Iterator[ImpactEvent]:
    """Yield the impacts of a periodic motion over its period, in order of time.

    One at the very end of the period, which is the beginning of the next, is told at the end.
    """
    log, modes = motion.log, motion.loop.modes
    ends = np.append(log.start[1:], motion.duration)
    following = np.append(log.mode[1:], log.mode[0])
    for segment, (end, after) in enumerate(zip(ends.tolist(), following.tolist(), strict=True)):
        before, state = int(log.mode[segment]), log.state[segment]
        elapsed = end - float(log.start[segment])
        if elapsed > 0:
            state = flow(modes, before, elapsed) @ state
        changes = zip(modes[before].statuses, modes[after].statuses, strict=True)
        for place, (left, entered) in enumerate(changes):
            component = modes.system.interconnection.components[place]
            if isinstance(component, BacklashComponent) and _is_impact(left, entered):
                mode = modes[before]
                play = mode.signals[place].input - mode.signals[place].output
                speed = abs(float(play @ mode.flow @ state))
                yield ImpactEvent(
                    end, modes.system.interconnection.labels[place], component.mode_names[entered], speed
                )


def _is_impact(left: int, entered: int) -> bool:
    return left not in (UPPER, LOWER) and entered in (UPPER, LOWER)


def _pieces(motion: Motion) -> Iterator[tuple[Reals, Reals]]:
    """Yield times and weights that integrate over a motion, arc by arc."""
    begin = 0.0
    modes = motion.loop.modes
    for arc in arcs(modes, motion.log, motion.duration):
        steps = math.ceil(arc.duration / float(modes.tables.step[arc.mode]))
        width = arc.duration / steps
        lows = begin + width * np.arange(steps)
        times = (lows[:, None] + 0.5 * width * (1.0 + NODES)).ravel()
        yield np.minimum(times, motion.duration), np.tile(0.5 * width * WEIGHTS, steps)
        begin += arc.duration
