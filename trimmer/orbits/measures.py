"""Extremes and harmonics of the element's input along a motion, from the flow itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.hybrid.taylor import DEGREE
from trimmer.orbits.return_map import flow

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from trimmer.arrays import Complexes, Reals
    from trimmer.loops.mode import LoopMode
    from trimmer.loops.system import LoopModes
    from trimmer.orbits.return_map import Arc


HARMONICS = 15
"""Number of harmonics that an orbit has."""
POINTS = 33
"""Points of a step between which the slope changes its sign at most once; the fastest mode turns by 2 rad."""
GRID = np.linspace(0.0, 1.0, POINTS)[:, None] ** np.arange(DEGREE + 1)
"""Powers of these points: (POINTS, DEGREE + 1)."""
NEWTON_STEPS = 4
"""Steps of Newton's method from such a bracket to an extreme that is exact to rounding."""


def extremes(modes: LoopModes, chain: Sequence[Arc]) -> tuple[float, float]:
    """Return the smallest and the largest input of the first component along a chain of arcs, in its unit."""
    return extremes_of(modes, chain, lambda mode: mode.signals[0].input)


def extremes_of(
    modes: LoopModes, chain: Sequence[Arc], row: Callable[[LoopMode], Reals]
) -> tuple[float, float]:
    """Return the smallest and the largest value of a signal along a chain, in its unit.

    Args:
        modes: Modes of the loop.
        chain: Arcs of the motion.
        row: Gives the row of the signal in a mode, shape (n,) over the extended state.
    """
    values = [value for arc in chain for value in _candidates(modes, arc, row(modes[arc.mode]))]
    return min(values), max(values)


def _candidates(modes: LoopModes, arc: Arc, row: Reals) -> list[float]:
    """Return a signal at the ends of an arc and where its rate is zero."""
    size, step = modes.system.layout.size, float(modes.tables.step[arc.mode])
    terms = modes.tables.series[arc.mode].reshape(size, DEGREE + 1, size) @ row
    whole = modes.tables.screen[arc.mode, :, :size].T
    state, left, values = arc.state, arc.duration / step, []
    while left > 0:
        values += _extremes_of(state @ terms, min(left, 1.0))
        state, left = whole @ state, left - 1.0
    return values


def _extremes_of(coefficients: Reals, end: float) -> list[float]:
    """Return a polynomial at 0, at the end, and at its extremes in between."""
    powers = np.arange(len(coefficients))
    scaled = coefficients * end**powers
    slope = scaled[1:] * powers[1:]
    slopes = GRID[:, :-1] @ slope
    turning = np.flatnonzero((slopes[:-1] > 0) != (slopes[1:] > 0))
    roots = (turning + 0.5) / (POINTS - 1)
    for _ in range(NEWTON_STEPS):
        at = roots[:, None] ** powers
        roots = roots - (at[:, :-1] @ slope) / (at[:, :-2] @ (slope[1:] * powers[1:-1]))
    inner = roots[:, None] ** powers @ scaled
    return [float(scaled[0]), float(scaled.sum()), *inner.tolist()]


def harmonics(modes: LoopModes, chain: Sequence[Arc]) -> Complexes:
    """Return the complex amplitudes c_n of the first component's input e, in its unit, shape (HARMONICS,).

    e = Im Σ c_n exp(j n omega t) + constant. The integral of exp(-j n omega t) Z over an arc is known:
    (M - j n omega)^-1 applied to the difference at its ends.

    Args:
        modes: Modes of the loop.
        chain: Arcs of one period.
    """
    period = sum(arc.duration for arc in chain)
    rotations = 2j * np.pi / period * np.arange(1, HARMONICS + 1)
    identity = np.eye(modes.system.layout.size)
    totals = np.zeros(HARMONICS, dtype=complex)
    begin = 0.0
    for arc in chain:
        mode = modes[arc.mode]
        end = flow(modes, arc.mode, arc.duration) @ arc.state
        difference = np.exp(-rotations * (begin + arc.duration))[:, None] * end
        difference -= np.exp(-rotations * begin)[:, None] * arc.state
        matrices = mode.flow - rotations[:, None, None] * identity
        totals += np.linalg.solve(matrices, difference[..., None])[..., 0] @ mode.signals[0].input
        begin += arc.duration
    amplitudes: Complexes = 2j * totals / period
    return amplitudes
