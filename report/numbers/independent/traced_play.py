"""A sine of amplitude one, traced through the characteristic of friction-controlled backlash in steps."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from trimmer.arrays import Reals


STEPS = 20_000
"""Steps per period."""


@cache
def traced(half_gap: float) -> tuple[Reals, Reals]:
    """Return phases (rad) of a period that begins at the input's peak, and the outputs there.

    The input starts in the middle of the gap, a quarter period before. The output stays unless the input is
    half a gap away and pushes it.
    """
    phases = 2 * np.pi / STEPS * np.arange(1.25 * STEPS)
    output, outputs = 0.0, []
    for position in np.sin(phases).tolist():
        output = min(max(output, position - half_gap), position + half_gap)
        outputs.append(output)
    start = STEPS // 4
    return phases[start:], np.array(outputs[start:])


def boundaries(half_gap: float) -> Reals:
    """Return the phases (rad) at which the output comes to rest or starts to move, in one period."""
    phases, outputs = traced(half_gap)
    moving = np.diff(outputs) != 0
    return np.append(phases[0], phases[1:-1][moving[1:] != moving[:-1]])


def outputs_at(half_gap: float, position: float) -> Reals:
    """Return the outputs of one period at those times at which the input passes a position."""
    phases, outputs = traced(half_gap)
    return outputs[np.flatnonzero(np.diff(np.sign(np.sin(phases) - position)))]
