"""A periodic signal as a trigonometric polynomial, and a decay added to it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arrays import Complexes, Reals


@dataclass(frozen=True)
class Decay:
    """amount exp(-rate (t - begun)), subtracted from a signal, in its unit, 1/s and s."""

    amount: float
    rate: float
    begun: float

    def at(self, times: Reals) -> Reals:
        """Return the values at times, s, in their shape."""
        values: Reals = self.amount * np.exp(-self.rate * (times - self.begun))
        return values


@dataclass(frozen=True, eq=False)
class PeriodicWaveform:
    """Re Σ c_n exp(i n omega t), n = 0 ... H, less a decay."""

    coefficients: Complexes  # c_0 (real), c_1 ... c_H in the unit of the signal, shape (H + 1,).
    omega: float  # Angular frequency, rad/s
    decay: Decay | None = None  # What is subtracted, None for nothing

    @property
    def period(self) -> float:
        """Period, s."""
        return 2.0 * np.pi / self.omega

    @cached_property
    def turning(self) -> Complexes:
        """Return i n omega, 1/s, shape (H + 1,)."""
        return np.asarray(1j * self.omega * np.arange(len(self.coefficients)), dtype=np.complex128)

    @cached_property
    def sharpness(self) -> float:
        """Bound of the modulus of the second derivative, in the unit of the signal per s²."""
        bound = float((abs(self.turning) ** 2 * abs(self.coefficients)).sum())
        return bound if self.decay is None else bound + self.decay.rate**2 * abs(self.decay.amount)

    def at(self, times: Reals) -> Reals:
        """Return the values at times, s, in their shape; decays only after they have begun."""
        values = self._sum(self.coefficients, times)
        return values if self.decay is None else values - self.decay.at(times)

    def slope(self, times: Reals) -> Reals:
        """Return the rates at times, s, in their shape."""
        slopes = self._sum(self.turning * self.coefficients, times)
        return slopes if self.decay is None else slopes + self.decay.rate * self.decay.at(times)

    def _sum(self, coefficients: Complexes, times: Reals) -> Reals:
        turns = np.exp(np.multiply.outer(np.asarray(times, dtype=float), self.turning))
        values: Reals = (turns @ coefficients).real
        return values

    def shifted(self, amount: float) -> PeriodicWaveform:
        """Return the signal plus an amount."""
        coefficients = self.coefficients.copy()
        coefficients[0] += amount
        return PeriodicWaveform(coefficients, self.omega, self.decay)
