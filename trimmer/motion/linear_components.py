"""Components that do not switch: a pin without backlash, and viscous friction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from trimmer.motion.switched_component import Component, Explicit, OutputLaw, RateProportional


@final
@dataclass(frozen=True)
class RigidComponent(Component):
    """A pin without backlash: the output is the input."""

    @property
    def name(self) -> str:
        """Name of the component: rigid pin; it has no events."""
        return "rigid pin"

    def output_law(self, mode: int) -> OutputLaw:
        """Return the law output = input."""
        return Explicit(1.0, (), 0.0)


@final
@dataclass(frozen=True)
class ViscousComponent(Component):
    """Viscous friction: the output is a coefficient times the rate of the input.

    Attributes:
        coefficient: Output per rate of the input, N s/m for a force of a displacement.
    """

    coefficient: float

    @property
    def name(self) -> str:
        """Name of the component: viscous friction; it has no events."""
        return "viscous friction"

    @property
    def output_jumps(self) -> bool:
        """True: the output jumps with the rate of the input."""
        return True

    def output_law(self, mode: int) -> OutputLaw:
        """Return the law output = coefficient * rate of the input."""
        return RateProportional(self.coefficient)
