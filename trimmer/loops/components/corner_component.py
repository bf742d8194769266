"""Saturation and dead zone in the time domain: three straight lines, each a mode."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arrays import Reals
from trimmer.loops.components.switched_component import (
    Component,
    ComponentFunction,
    EventKind,
    Explicit,
    ModeChange,
    OutputLaw,
    Signals,
)

BETWEEN, ABOVE, BELOW = range(3)


@final
@dataclass(frozen=True)
class CornerComponent(Component):
    """Output inner_slope * input up to a threshold > 0, with another slope beyond it, and no jump."""

    threshold: float
    inner_slope: float
    outer_slope: float

    mode_names = ("between the thresholds", "above", "below")
    """Names of the modes by number: ``BETWEEN``, ``ABOVE``, ``BELOW``."""

    @property
    def name(self) -> str:
        """Name of the component in events: saturation or dead zone."""
        return "dead zone" if self.inner_slope == 0 else "saturation"

    def mirrored(self, mode: int) -> int:
        """Return the mode of the mirrored motion: above and below change places."""
        return (BETWEEN, BELOW, ABOVE)[mode]

    def output_law(self, mode: int) -> OutputLaw:
        """Return the straight line of the mode."""
        if mode == BETWEEN:
            return Explicit(self.inner_slope, (), 0.0)
        step = (self.inner_slope - self.outer_slope) * self.threshold
        return Explicit(self.outer_slope, (), step if mode == ABOVE else -step)

    def event_functions(self, mode: int, signals: Signals, attracting: bool) -> tuple[ComponentFunction, ...]:
        """Return the distances of the input from the thresholds, positive on the side of the mode."""
        limit = self.threshold * signals.one
        if mode == BETWEEN:
            return (
                _corner(limit - signals.input, ABOVE, (1,), (0,)),
                _corner(limit + signals.input, BELOW, (1,), (0,)),
            )
        side = 1.0 if mode == ABOVE else -1.0
        known = (1, 0) if mode == ABOVE else (0, 1)
        return (_corner(side * signals.input - limit, BETWEEN, known, (0, 0)),)

    def initial(self, input_value: float, switching_value: float, output: float) -> tuple[int, Reals]:
        """Start on the line that the input is on; there are no states and no output to choose."""
        beyond = ABOVE if input_value > 0 else BELOW
        return (beyond if abs(input_value) > self.threshold else BETWEEN), np.zeros(0)


def _corner(row: Reals, target: int, reached: tuple[int, ...], jumped: tuple[int, ...]) -> ComponentFunction:
    """Return the event function of a corner; the input is continuous whatever the outputs of others do."""
    return ComponentFunction(
        row,
        ModeChange(EventKind.CORNER, target, (), reached),
        ModeChange(EventKind.CORNER, target, (), jumped),
        continuous=1,
    )
