"""A set-valued sign function in the time domain: ideal relay, and Coulomb friction with true stick."""

from dataclasses import dataclass
from typing import final

import numpy as np

from trimmer.arrays import Reals
from trimmer.loops.components.switched_component import (
    Component,
    ComponentFunction,
    Constrained,
    EventKind,
    Explicit,
    ModeChange,
    OutputLaw,
    Signals,
)

PLUS, MINUS, HELD = range(3)


@final
@dataclass(frozen=True)
class RelayComponent(Component):
    """Output level * sign(s), anything between at s = 0, with s the input or its rate.

    Where the output works against the rate of s, s can be held at zero (a sliding mode; stick, if s is a
    velocity) by the output that does so, as long as its size does not exceed the level (Filippov 1988).

    A friction may hold more than its level. Where it slips, the output then falls to the level at once.
    """

    level: float  # Size of the output, > 0, in the unit of the output (N for friction)
    of_rate: bool  # Whether s is the rate of the input, as for friction whose input is a displacement
    static: float = 0.0  # Largest output that holds s at zero, >= level
    of_velocity: bool = False  # Whether it is friction whose input is a velocity

    mode_names = ("plus", "minus", "held")  # Names of the modes by number: ``PLUS``, ``MINUS``, ``HELD``
    output_jumps = True  # True: the output changes its sign at once

    def __post_init__(self) -> None:
        object.__setattr__(self, "static", max(self.static, self.level))

    @property
    def rubs(self) -> bool:
        """Whether it is friction."""
        return self.of_rate or self.of_velocity

    @property
    def drops(self) -> bool:
        """Whether the output falls where it slips."""
        return self.static > self.level

    @property
    def name(self) -> str:
        """Name of the component in events: friction or relay."""
        return "friction" if self.rubs else "relay"

    @property
    def continuous_rates(self) -> int:
        """One if the rate of the input switches, else none: the switching function must not jump."""
        return 1 if self.of_rate else 0

    def mirrored(self, mode: int) -> int:
        """Return the mode of the mirrored motion: the signs change places, the held output stays."""
        return (MINUS, PLUS, HELD)[mode]

    def output_law(self, mode: int) -> OutputLaw:
        """Return the level with its sign, or the constraint that holds s at zero."""
        if mode == HELD:
            return Constrained()
        return Explicit(0.0, (), self.level if mode == PLUS else -self.level)

    def switching_function(self, signals: Signals) -> Reals:
        """Return s: the input, or its rate for friction."""
        return signals.input_rate if self.of_rate else signals.input

    def event_functions(self, mode: int, signals: Signals, attracting: bool) -> tuple[ComponentFunction, ...]:
        """Return s with its sign, or the distances of the holding output from its limits."""
        if mode == HELD:
            return self._limits(signals)
        side, other = (1.0, MINUS) if mode == PLUS else (-1.0, PLUS)
        reverse, jump = (ModeChange(EventKind.SWITCH, other, (), (zeros,)) for zeros in (1, 0))
        stick = ModeChange(EventKind.STICK, HELD, (), (0, 0))
        switching = side * self.switching_function(signals)
        return (ComponentFunction(switching, stick if attracting else reverse, jump, continuous=1),)

    def _limits(self, signals: Signals) -> tuple[ComponentFunction, ComponentFunction]:
        """Return the distances of the holding output from its limits."""
        most = self.static * signals.one
        return (
            ComponentFunction(most - signals.output, *self.slip(forwards=True)),
            ComponentFunction(most + signals.output, *self.slip(forwards=False)),
        )

    def slip(self, forwards: bool) -> tuple[ModeChange, ModeChange]:
        """Return what follows where the holding output reaches a limit, and where it is beyond it at once."""
        target = PLUS if forwards else MINUS
        known = 1 if self.drops else 2
        return ModeChange(EventKind.SLIP, target, (), (known,)), ModeChange(EventKind.SLIP, target, (), (1,))

    def initial(self, input_value: float, switching_value: float, output: float) -> tuple[int, Reals]:
        """Start with the sign of s, held where s is zero; there are no states and no output to choose."""
        mode = HELD if switching_value == 0 else PLUS if switching_value > 0 else MINUS
        return mode, np.zeros(0)
