"""Relay: ideal, with hysteresis, with a dead zone, or with both."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, final

import numpy as np

from trimmer.arguments import finite_number, positive_number
from trimmer.elements.arguments import positive_amplitudes
from trimmer.elements.bounds import range_shape
from trimmer.elements.expansion import Expansion, GainSensitivity, GainVariation
from trimmer.elements.square_wave import SquareWaveElement
from trimmer.elements.threshold_relay import Thresholds

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from trimmer.arrays import Complexes, Reals
    from trimmer.elements.element import Range
    from trimmer.elements.small_gains import SmallGains


@final
@dataclass(frozen=True)
class Relay(SquareWaveElement):
    """Relay, y = level * sign(x); with hysteresis and dead zone it switches at x = ±dead_zone ± hysteresis.

    The rising input switches from -level to 0 at hysteresis - dead_zone, and to level at dead_zone +
    hysteresis. The falling one switches from level to 0 at dead_zone - hysteresis, and to -level at
    -(dead_zone + hysteresis). Without dead zone the output changes between -level and level at once.

    N_n = 4 level / (π n A) for odd n if both are zero, at any amplitude. Else the amplitude has to exceed
    dead_zone + hysteresis. Up to that the output is zero, and N too, if hysteresis <= dead_zone; with more
    hysteresis the output stays at what it was, and N is NaN.

    Source: Gelb and Vander Velde, Multiple-Input Describing Functions (1968), section 2.3 and appendix B;
    Atherton, Nonlinear Control Engineering (1975), chapter 3; thesis, section 2.3.5, for the ideal one.

    Attributes:
        level: Output while the input is large, > 0, in the unit of the output.
        hysteresis: Half the width of each loop, >= 0, in the unit of the input.
        dead_zone: Half the width of the band without output, to the middle of the loops, >= 0, in the unit of
            the input.

    Raises:
        ValueError: if the level is not positive and finite, or another is negative or not finite;
            ``-Relay(level)`` has the other sign.
    """

    level: float
    hysteresis: float = 0.0
    dead_zone: float = 0.0
    LEAD: ClassVar[complex] = 1.0

    def __post_init__(self) -> None:
        positive_number("level", self.level, "unit of the output")
        for name in ("hysteresis", "dead_zone"):
            if finite_number(name, getattr(self, name), "unit of the input") < 0:
                raise ValueError(
                    f"{name} must not be negative (unit of the input), not {getattr(self, name)!r}"
                )

    @property
    def height(self) -> float:
        """The level, in the unit of the output."""
        return self.level

    @property
    def thresholds(self) -> Thresholds | None:
        """The inputs at which it switches; None for the ideal relay."""
        if self.hysteresis == 0 == self.dead_zone:
            return None
        return Thresholds(self.level, self.dead_zone, self.hysteresis)

    @property
    def amplitude_scale(self) -> float:
        """The amplitude from which on it switches; of the ideal relay the number of the level."""
        return self.dead_zone + self.hysteresis or self.level

    @property
    def constant_from(self) -> float:
        """1 if the relay rests below the threshold; infinite for the ideal one."""
        thresholds = self.thresholds
        return 1.0 if thresholds is not None and thresholds.rests else math.inf

    def domain(self, omega: ArrayLike | None = None) -> Reals:
        """Return 1 if the relay stays switched below the threshold, else infinity."""
        everywhere = super().domain(omega)
        thresholds = self.thresholds
        return everywhere if thresholds is None or thresholds.rests else np.ones_like(everywhere)[()]

    def sensitivity(self, u_range: Range, omega_range: Range | None = None) -> GainSensitivity:
        """Return 4/π for |dN/du| of the ideal relay; with thresholds a bound that is infinite at u = 1."""
        thresholds = self.thresholds
        if thresholds is None:
            return super().sensitivity(u_range, omega_range)
        shape = range_shape(u_range, omega_range)
        return GainSensitivity(
            np.broadcast_to(thresholds.steepest(u_range[1]), shape)[()], np.zeros(shape)[()]
        )

    def variation(self, u_range: Range, omega_range: Range | None = None) -> GainVariation:
        """Return zeros for the ideal relay; with thresholds a bound that is infinite at u = 1."""
        thresholds = self.thresholds
        if thresholds is None:
            return super().variation(u_range, omega_range)
        shape = range_shape(u_range, omega_range)
        return GainVariation(
            np.broadcast_to(thresholds.change_of_slope(*u_range), shape)[()], np.zeros(shape)[()]
        )

    def reach(self, u_range: Range, omega_range: Range | None = None) -> Reals | None:
        """Return the largest change of N from the middle of u, if there are thresholds."""
        thresholds = self.thresholds
        if thresholds is None:
            return None
        return np.broadcast_to(thresholds.reach(*u_range), range_shape(u_range, omega_range))[()]

    def small_gains(self) -> SmallGains | None:
        """Tell how N goes to zero for large amplitudes and, in a dead zone, for small ones."""
        thresholds = self.thresholds
        return None if thresholds is None else thresholds.small_gains()

    def mean_gain(self, amplitude: ArrayLike) -> Reals:
        """Return 2 level / (π A) for the ideal one, half of N_1: the mean output is (2/π) level asin(b/A)."""
        amplitudes, thresholds = positive_amplitudes(amplitude), self.thresholds
        if thresholds is not None:
            with np.errstate(all="ignore"):
                return thresholds.mean_gain(amplitudes)[()]
        return np.asarray(2.0 * self.level / (np.pi * amplitudes))[()]

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        thresholds = self.thresholds
        if thresholds is None:
            return super()._describing_function(amplitude, omega, harmonic)
        return thresholds.harmonic(amplitude, harmonic)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        thresholds = self.thresholds
        return (
            self.level * np.sign(np.sin(phase)) if thresholds is None else thresholds.output(phase, amplitude)
        )

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        thresholds = self.thresholds
        if thresholds is None:
            return super()._expansion(amplitude, omega)
        value = thresholds.harmonic(amplitude, 1)
        return Expansion(value, thresholds.slope(amplitude), np.zeros_like(value))
