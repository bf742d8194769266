"""Jumps of a sweep: changes of a motion that do not become smaller with the step of the number."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trimmer.hybrid.stretch import Instant
from trimmer.maps.plateau import Plateau
from trimmer.response.results.response import MotionKind

LEAST = 0.05  # Least change of a stroke, as a share of the largest one, that may be a jump
HALVINGS = 3  # How often a step with such a change is halved
LEFT = 0.5  # Share of the change that is left by then if it is a jump; what changes evenly leaves an eighth
CALM = (MotionKind.PERIODIC, MotionKind.REST)
"""Kinds of motion whose stroke does not change from one window to another."""


@dataclass(frozen=True)
class Jump:
    """Two values between which the motion jumps to another one."""

    point: int  # Number of the first point of the sweep behind it, counted from 0
    # before, after: The values, in the order of the sweep, closer together than its steps
    before: float
    after: float
    output: str  # The output that changes most beside its largest stroke
    change: float  # Of its peak to peak, in its unit


Step = Callable[[float, float, Instant], tuple[Plateau, Instant]]
"""Goes from one value to another from an instant on; gives what moves there, and where that ends."""


def jumps(
    outputs: Sequence[str],
    values: Sequence[float],
    plateaus: Sequence[Plateau],
    ends: Sequence[Instant],
    step: Step,
) -> tuple[Jump, ...]:
    """Return the jumps of a sweep.

    Args:
        outputs: Names of the outputs.
        values: Of the number, in the order of the sweep.
        plateaus: What moves there.
        ends: Where each of these ends.
        step: Goes from one value to another.
    """
    measured = [plateau.outputs for plateau in plateaus if plateau.measured]
    if len(measured) < 2 or not outputs:
        return ()
    sizes = np.array([[each[name].peak_to_peak for name in outputs] for each in measured])
    shares = sizes / np.maximum(sizes.max(axis=0), np.finfo(float).tiny)
    changes = abs(np.diff(shares, axis=0)).max(axis=1)
    found = []
    for at in np.flatnonzero(changes > LEAST).tolist():
        if not at and plateaus[0].kind is MotionKind.UNDECIDED:
            continue  # What is left of the start dies out.
        highest = changes[at] >= changes[max(at - 1, 0) : at + 2].max()
        if highest and any(plateau.kind in CALM for plateau in plateaus[at : at + 2]):
            chosen = int(np.argmax(abs(shares[at + 1] - shares[at])))
            step_of = _SweepStep(outputs[chosen], *values[at : at + 2], *sizes[at : at + 2, chosen].tolist())
            narrow = step_of.narrowed(ends[at], step)
            if abs(narrow.change) >= LEFT * abs(step_of.change):
                found.append(Jump(at + 1, narrow.before, narrow.after, narrow.output, narrow.change))
    return tuple(found)


@dataclass(frozen=True)
class _SweepStep:
    """A step of a sweep: the values before and after it, and the strokes of an output there."""

    output: str
    before: float
    after: float
    first: float
    last: float

    @property
    def change(self) -> float:
        return self.last - self.first

    def narrowed(self, instant: Instant, step: Step) -> _SweepStep:
        """Return the half of the half of it, and so on, in which more of the change is."""
        narrow = self
        for _ in range(HALVINGS):
            middle = 0.5 * (narrow.before + narrow.after)
            plateau, end = step(narrow.before, middle, instant)
            if not plateau.measured:
                break
            size = plateau.outputs[self.output].peak_to_peak
            if abs(size - narrow.first) < abs(narrow.last - size):
                narrow, instant = replace(narrow, before=middle, first=size), end
            else:
                narrow = replace(narrow, after=middle, last=size)
        return narrow
