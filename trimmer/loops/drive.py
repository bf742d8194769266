"""Sinusoidal drives, and the period that several have in common."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

from trimmer.arguments import finite_number
from trimmer.ties import common_return


@final
@dataclass(frozen=True, init=False)
class Drive:
    """A sinusoidal displacement amplitude * sin(omega t + phase).

    ``Drive(1.5e-3, omega=691.0)`` and ``Drive(1.5e-3, frequency=110.0)`` are two ways to give one.

    Attributes:
        amplitude: Half of peak to peak, >= 0, m (or the unit of the element's input).
        omega: Angular frequency, > 0, rad/s.
        phase: Phase at t = 0, rad.

    Raises:
        WrongTypeError: if a value is no real number.
        ValueError: if a value is not finite, the amplitude negative or the frequency not positive; or unless
            exactly one of omega (rad/s) and frequency (Hz) is given.
    """

    amplitude: float
    omega: float
    phase: float = 0.0

    def __init__(
        self,
        amplitude: float,
        omega: float | None = None,
        phase: float = 0.0,
        *,
        frequency: float | None = None,
    ) -> None:
        if (omega is None) == (frequency is None):
            given = "neither" if omega is None else f"omega={omega!r} and frequency={frequency!r}"
            raise ValueError(f"a drive needs omega (rad/s) or frequency (Hz), and one only: {given} is given")
        if frequency is not None:
            omega = 2.0 * math.pi * _checked("frequency", frequency, "Hz")
        object.__setattr__(self, "amplitude", _checked("amplitude", amplitude, "m"))
        object.__setattr__(self, "omega", _checked("omega", omega, "rad/s"))
        object.__setattr__(self, "phase", _checked("phase", phase, "rad"))
        if self.amplitude < 0:
            raise ValueError(f"amplitude of the drive must not be negative, not {amplitude!r}")
        for name, value, unit in (("frequency", frequency, "Hz"), ("omega", self.omega, "rad/s")):
            if value is not None and value <= 0:
                raise ValueError(f"{name} of the drive must be positive ({unit}), not {value!r}")

    @property
    def frequency(self) -> float:
        """Frequency of the drive, Hz."""
        return self.omega / (2.0 * math.pi)

    @property
    def period(self) -> float:
        """Period of the drive, s."""
        return 2.0 * math.pi / self.omega


def _checked(name: str, value: object, unit: str) -> float:
    return finite_number(f"{name} of the drive", value, unit)


def common_omega(drives: Sequence[Drive]) -> tuple[float, tuple[int, ...]] | None:
    """Return what the omegas, rad/s, of drives are multiples of, and which; None of nothing, 0 of none."""
    slowest = min((drive.omega for drive in drives), default=0.0)
    if (found := common_return([drive.omega / slowest for drive in drives])) is None:
        return None
    periods, turns = found
    return slowest / periods, turns
