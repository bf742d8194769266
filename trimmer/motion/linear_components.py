"""Components without modes: a pin without play, and viscous friction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from trimmer.motion.switched_component import Component, Explicit, OutputLaw, RateProportional


@final
@dataclass(frozen=True)
class RigidComponent(Component):
    """The output is the input: a pin without play."""

    @property
    def name(self) -> str:
        """What it is called in events."""
        return "rigid pin"

    def output_law(self, mode: int) -> OutputLaw:
        """Return the identity."""
        return Explicit(1.0, (), 0.0)


@final
@dataclass(frozen=True)
class ViscousComponent(Component):
    """Output coefficient * rate of the input.

    Attributes:
        coefficient: Output per rate of the input.
    """

    coefficient: float

    @property
    def name(self) -> str:
        """What it is called in events."""
        return "viscous friction"

    @property
    def output_jumps(self) -> bool:
        """It does with the input's rate."""
        return True

    def output_law(self, mode: int) -> OutputLaw:
        """Return the proportionality."""
        return RateProportional(self.coefficient)
