"""Viscous friction in the time domain: a linear element without modes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.motion.component import Component, Guard, OutputLaw, RateProportional, Signals

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Reals = NDArray[np.float64]


@final
@dataclass(frozen=True)
class ViscousComponent(Component):
    """Output coefficient * rate of the input, always.

    Attributes:
        coefficient: Output per rate of the input.
    """

    coefficient: float

    @property
    def name(self) -> str:
        """What it is called in events."""
        return "viscous friction"

    @property
    def mode_names(self) -> tuple[str, ...]:
        """Name of the only mode."""
        return ("always",)

    @property
    def state_count(self) -> int:
        """None."""
        return 0

    @property
    def output_jumps(self) -> bool:
        """True: with the input's rate."""
        return True

    @property
    def continuous_rates(self) -> int:
        """None."""
        return 0

    def mirrored(self, mode: int) -> int:
        """Return the mode on the other side."""
        return mode

    def output_law(self, mode: int) -> OutputLaw:
        """Return the proportionality."""
        return RateProportional(self.coefficient)

    def state_rates(self, mode: int) -> Reals:
        """Return an empty matrix."""
        return np.zeros((0, 0))

    def switching_function(self, signals: Signals) -> Reals:
        """Return the rate; nothing switches on it."""
        return signals.input_rate

    def guards(self, mode: int, signals: Signals, attracting: bool) -> tuple[Guard, ...]:
        """Return none."""
        return ()

    def initial(self, input_value: float, switching_value: float, output: float) -> tuple[int, Reals]:
        """Start in the only mode."""
        return 0, np.zeros(0)
