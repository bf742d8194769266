"""A relay with hysteresis, dead zone or both in the time domain."""

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

SILENT, POSITIVE, NEGATIVE = range(3)


@final
@dataclass(frozen=True)
class ThresholdComponent(Component):
    """Output level > 0, 0 or -level; it rises at ``on`` > 0 and falls at ``off``, and so for negative inputs.

    Without a dead zone, ``off`` is -``on``, and the output goes from one sign to the other at once. With
    the two equal the relay has no memory; where the output then works against the rate of the input it
    would have to slide along the threshold, with values between 0 and the level, which is not followed.
    """

    level: float
    on: float
    off: float

    name = "relay"  # Name of the component in events: relay
    mode_names = ("silent", "plus", "minus")
    """Names of the modes by number: ``SILENT``, ``POSITIVE``, ``NEGATIVE``."""
    output_jumps = True  # True: the output changes at once

    @property
    def slides(self) -> bool:
        """Whether it may have to slide along a threshold: it has no hysteresis."""
        return self.on == self.off

    @property
    def has_dead_zone(self) -> bool:
        """Whether the output is zero between its signs."""
        return self.off > -self.on

    def mirrored(self, mode: int) -> int:
        """Return the mode of the mirrored motion: the signs change places."""
        return (SILENT, NEGATIVE, POSITIVE)[mode]

    def output_law(self, mode: int) -> OutputLaw:
        """Return the level with its sign, or zero."""
        return Explicit(0.0, (), (0.0, self.level, -self.level)[mode])

    def event_functions(self, mode: int, signals: Signals, attracting: bool) -> tuple[ComponentFunction, ...]:
        """Return the distances of the input from where the output changes."""
        if mode == SILENT:
            limit = self.on * signals.one
            return (
                self._switch(limit - signals.input, POSITIVE),
                self._switch(limit + signals.input, NEGATIVE),
            )
        side = 1.0 if mode == POSITIVE else -1.0
        other = NEGATIVE if mode == POSITIVE else POSITIVE
        row = side * signals.input - self.off * signals.one
        return (self._switch(row, SILENT if self.has_dead_zone else other, mode == NEGATIVE),)

    def _switch(self, row: Reals, target: int, negative: bool = False) -> ComponentFunction:
        """Return an event function; where there is no hysteresis that of the way back is zero then, too."""
        zero = 1 if self.slides else 0
        known = (zero,) if target != SILENT else (0, zero) if negative else (zero, 0)
        unknown = (0,) * len(known)
        reached, jumped = (ModeChange(EventKind.SWITCH, target, (), zeros) for zeros in (known, unknown))
        return ComponentFunction(row, reached, jumped, continuous=1)

    def initial(self, input_value: float, switching_value: float, output: float) -> tuple[int, Reals]:
        """Start with the output that is asked for, or silent, or with the sign of the input."""
        may = {
            POSITIVE: input_value > self.off or input_value >= self.on,
            NEGATIVE: input_value < -self.off or input_value <= -self.on,
            SILENT: self.has_dead_zone and abs(input_value) < self.on,
        }
        sign = POSITIVE if switching_value >= 0 else NEGATIVE
        wanted = POSITIVE if output > 0 else NEGATIVE if output < 0 else SILENT
        order = (wanted, SILENT, sign, POSITIVE, NEGATIVE)
        return next(mode for mode in order if may[mode]), np.zeros(0)
