"""Signals of a loop as rows over its extended state: what can be read of a motion."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arguments import require_instance
from trimmer.displacement import Displacement
from trimmer.errors import UnsupportedMotionError
from trimmer.motion.signals import Signal, Steady

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.loops.loops import Loop


class LoopSignal(Enum):
    """A signal that every loop has."""

    OUTPUT = "output of the linear system"
    ELEMENT_INPUT = "input of the nonlinear element"
    ELEMENT_OUTPUT = "output of the nonlinear element"


READ = {
    "output": LoopSignal.OUTPUT,
    "element_input": LoopSignal.ELEMENT_INPUT,
    "element_output": LoopSignal.ELEMENT_OUTPUT,
}
"""What is read of every loop, by name."""


def row_in_modes(loop: Loop, signal: LoopSignal | Displacement | str) -> Signal:
    """Return a signal, or a displacement of a trimmer, as a functional of the extended state in each mode."""
    own = loop.own_row(signal)
    if own is not None:
        return own
    require_instance("signal", signal, (LoopSignal, Displacement), "a LoopSignal or a Displacement")
    model, modes = loop.model, loop.modes
    if isinstance(signal, Displacement):
        return Steady(_of_states(loop, signal))
    if signal is LoopSignal.ELEMENT_INPUT:
        return lambda mode: modes[mode].signals[0].input
    factors = np.array(modes.system.interconnection.element_factors)

    def element_output(mode: int) -> Reals:
        row: Reals = factors @ np.array([each.output for each in modes[mode].signals[: len(factors)]])
        return row

    if signal is LoopSignal.ELEMENT_OUTPUT:
        return element_output
    of_states = np.zeros(modes.system.layout.size)
    of_states[: model.nstates] = model.C[0]
    return lambda mode: of_states + model.D[0, 0] * element_output(mode)


def _of_states(loop: Loop, displacement: Displacement) -> Reals:
    row = np.zeros(loop.modes.system.layout.size)
    labels = list(loop.model.state_labels)
    for body, sign in ((displacement.of, 1.0), (displacement.relative_to, -1.0)):
        if body is None:
            continue
        if not loop.has_states or body.coordinate not in labels:
            raise UnsupportedMotionError(
                f"{displacement.label} cannot be read from this loop: its linear system has no state "
                f"{body.coordinate}; use a TrimmerLoop, or the state space of pin_model"
            )
        row[labels.index(body.coordinate)] += sign
    return row
