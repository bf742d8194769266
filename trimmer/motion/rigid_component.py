"""A connection without play."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from trimmer.motion.component import Component, Explicit, Guard, OutputLaw, Signals

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Reals = NDArray[np.float64]


@final
@dataclass(frozen=True)
class RigidComponent(Component):
    """The output is the input: a pin without play."""

    @property
    def name(self) -> str:
        """What it is called in events."""
        return "rigid pin"

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
        """False, as long as the input does not."""
        return False

    @property
    def continuous_rates(self) -> int:
        """None."""
        return 0

    def mirrored(self, mode: int) -> int:
        """Return the mode on the other side."""
        return mode

    def output_law(self, mode: int) -> OutputLaw:
        """Return the identity."""
        return Explicit(1.0, (), 0.0)

    def state_rates(self, mode: int) -> Reals:
        """Return an empty matrix."""
        return np.zeros((0, 0))

    def switching_function(self, signals: Signals) -> Reals:
        """Return the input; nothing switches on it."""
        return signals.input

    def guards(self, mode: int, signals: Signals, attracting: bool) -> tuple[Guard, ...]:
        """Return none."""
        return ()

    def initial(self, input_value: float, switching_value: float, output: float) -> tuple[int, Reals]:
        """Start in the only mode."""
        return 0, np.zeros(0)
