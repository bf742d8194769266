"""The motion that drives the pin."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import final


@final
@dataclass(frozen=True)
class Drive:
    """A sinusoidal displacement amplitude * sin(omega t + phase).

    Attributes:
        amplitude: Half of peak to peak, >= 0, m (or the unit of the element's input).
        omega: Angular frequency, > 0, rad/s.
        phase: Phase at t = 0, rad.

    Raises:
        ValueError: if a value is not finite, the amplitude negative or omega not positive.
    """

    amplitude: float
    omega: float
    phase: float = 0.0

    def __post_init__(self) -> None:
        for name in ("amplitude", "omega", "phase"):
            if not math.isfinite(getattr(self, name)):
                raise ValueError(f"{name} of the drive must be finite, not {getattr(self, name)!r}")
        if self.amplitude < 0:
            raise ValueError(f"amplitude of the drive must not be negative, not {self.amplitude!r}")
        if self.omega <= 0:
            raise ValueError(f"omega of the drive must be positive (rad/s), not {self.omega!r}")

    @property
    def frequency(self) -> float:
        """Frequency, Hz."""
        return self.omega / (2.0 * math.pi)

    @property
    def period(self) -> float:
        """Period, s."""
        return 2.0 * math.pi / self.omega
