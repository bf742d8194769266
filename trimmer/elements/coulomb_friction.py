"""Coulomb friction with a displacement as its input."""

from dataclasses import dataclass
from typing import ClassVar, final

import numpy as np

from trimmer.arguments import finite_number, positive_number
from trimmer.arrays import Reals
from trimmer.elements.square_wave import SquareWaveElement


@final
@dataclass(frozen=True)
class CoulombFriction(SquareWaveElement):
    """Coulomb friction, F = force * sign(dx/dt), of a displacement x: N = j 4 force / (π A) at any amplitude.

    The harmonics are N_n = ±j 4 force / (π n A), + for n = 1, 5, 9 and - for n = 3, 7, 11. A sinusoid rests
    at no instant for longer, so the static force has no part in them; it has in motion. With a velocity as
    its input, as in a ``Feedback``, it is a ``Relay`` that may stick. Source: thesis, section 2.3.5
    (equations 2.48 to 2.52), with the sign of a displacement as the input.

    Attributes:
        force: Friction force while it slides, > 0, N.
        static: Largest force with which it sticks, >= force, N; the same as force if None.

    Raises:
        ValueError: if the force is not positive and finite, or the static one is less or not finite.
    """

    force: float
    static: float | None = None
    LEAD: ClassVar[complex] = 1j

    def __post_init__(self) -> None:
        positive_number("force", self.force, "N")
        if self.static is not None and finite_number("static", self.static, "N") < self.force:
            raise ValueError(f"static must not be less than force, {self.force!r} N, not {self.static!r}")

    def __repr__(self) -> str:
        static = "" if self.static is None else f", static={self.static!r}"
        return f"CoulombFriction(force={self.force!r}{static})"

    @property
    def breakaway(self) -> float:
        """Largest force with which it sticks, N."""
        return self.force if self.static is None else self.static

    @property
    def height(self) -> float:
        """The friction force, N."""
        return self.force

    def _mean_gain(self, amplitude: Reals) -> float:
        """Return 0: a mean of the displacement does not change its velocity, hence not the force."""
        return 0.0

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        return self.force * np.sign(np.cos(phase))
