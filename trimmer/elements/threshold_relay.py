"""A relay that switches at thresholds: its describing function, and bounds of that.

The output is L from where the rising input passes ``on`` until the falling one passes ``off``, |off| <= on.
With u = on/A, r = off/on, sin α = u and sin ρ = r u the harmonics are, for odd n,

N_n = (2L/(π n on)) u (exp(-jnα) + exp(jnρ)) = (4L/(π n on)) u cos(n(α + ρ)/2) exp(-jn(α - ρ)/2).

Of the two terms of N_1, g(u) = u exp(-jα) lies on the circle of diameter 1 through 0 and -j, as does its
conjugate for ρ; so g(u) and g(v) are |sin(α_u - α_v)| apart, and |dg/du| = 1/cos α, which is not bounded.

Where on > off, |N| is small only for large amplitudes. With c = 2L/(π on) and m = cos(π/4 + asin(r)/2),
u >= 1/2 means |N| >= c m, as cos((α + ρ)/2) falls with u. For u < 1/2, N lags by (α - ρ)/2 <= α <= πu/3, and
|N| > 2 c u cos(π/6); so it lags by less than 0.61 |N|/c.
"""

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Flags, Reals
from trimmer.elements.backlashes.backlash_bounds import ROUNDED_UP
from trimmer.elements.element import Bounds, Element, Limits
from trimmer.elements.expansion import Expansion
from trimmer.elements.small_gains import SmallGains, real_small_gains

_BEHIND = 0.61
_ROUNDING = 1e-15  # More than the rounding error of a difference of angles, or of its sine
_LARGEST = np.finfo(float).max


@dataclass(frozen=True)
class ThresholdRelay(Element):
    """A relay of level L > 0 that switches on at an input > 0.

    Dead zone and hysteresis are (on + off) / 2 and (on - off) / 2, both >= 0.
    """

    level: float
    dead_zone: float
    hysteresis: float

    _has_reach = True

    @property
    def on(self) -> float:
        """Input at which the rising output reaches the level."""
        return self.dead_zone + self.hysteresis

    @property
    def off(self) -> float:
        """Input at which the falling output leaves it."""
        return self.dead_zone - self.hysteresis

    @property
    def amplitude_scale(self) -> float:
        """The amplitude from which on it switches, in the unit of the input."""
        return self.on

    @property
    def constant_from(self) -> float:
        """1 if the relay rests below the threshold; infinite if it stays switched."""
        return 1.0 if self.rests else math.inf

    @property
    def _size(self) -> float:
        """The factor c = 2L / (π on), in the unit of N."""
        return 2.0 * self.level / (math.pi * self.on)

    @property
    def rests(self) -> bool:
        """Whether the output is zero, from any start, while the amplitude does not exceed ``on``."""
        return self.off >= 0.0

    def _silent(self, amplitude: Reals) -> Flags:
        """Return whether the amplitude is too small for the relay to switch."""
        return np.asarray(amplitude <= self.on)

    @property
    def _silence(self) -> float:
        """What N is where the relay does not switch: 0 if it rests there, else NaN."""
        return 0.0 if self.rests else math.nan

    def _cosines(self, amplitude: Reals) -> tuple[Reals, Reals]:
        """Return cos α and cos ρ, to full relative precision; NaN where the relay does not switch."""
        half = 0.5 * np.minimum(amplitude, _LARGEST)  # The sum below would overflow for the whole.
        rising, falling = (
            np.sqrt((half - 0.5 * place) / half * ((half + 0.5 * place) / half))
            for place in (self.on, self.off)
        )
        return rising, falling

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        """Evaluate N_n for odd n; ``_silence`` where the relay does not switch."""
        finite = np.minimum(amplitude, _LARGEST)
        rising, falling = self._cosines(amplitude)
        sine, other = self.on / finite, self.off / finite
        middle = 0.5 * (np.arctan2(sine, rising) + np.arctan2(other, falling))
        from_peak = 0.5 * (np.arctan2(rising, sine) + np.arctan2(falling, other))
        sign = 1.0 if harmonic % 4 == 1 else -1.0
        cosine = np.where(middle < from_peak, np.cos(harmonic * middle), sign * np.sin(harmonic * from_peak))
        size = 4.0 * self.level / (np.pi * harmonic) / amplitude
        value = size * cosine * np.exp(-1j * harmonic * self._lag(finite, rising, falling))
        value[self._silent(amplitude)] = self._silence
        return np.asarray(value)

    def _lag(self, amplitude: Reals, rising: Reals, falling: Reals) -> Reals:
        """(α - ρ)/2; where both are positive, without the difference that a narrow hysteresis would lose."""
        if not self.rests:
            return 0.5 * (np.arctan2(self.on / amplitude, rising) - np.arctan2(self.off / amplitude, falling))
        width = 2.0 * self.hysteresis / amplitude
        sine = width * (2.0 * self.dead_zone / (self.on * falling + self.off * rising))
        return 0.5 * np.arctan2(sine, rising * falling + self.on / amplitude * (self.off / amplitude))

    def _expansion(self, amplitude: Reals, omega: Reals) -> Expansion:
        """Evaluate N_1, and dN_1/du = c (exp(-2jα) / cos α + exp(2jρ) / cos ρ)."""
        value = self._describing_function(amplitude, omega, 1)
        finite = np.minimum(amplitude, _LARGEST)
        rising, falling = self._cosines(amplitude)
        slope = (rising - 1j * self.on / finite) ** 2 / rising
        slope += (falling + 1j * self.off / finite) ** 2 / falling
        slope *= self._size
        slope[self._silent(amplitude)] = self._silence
        return Expansion(value, slope, np.zeros_like(value))

    def _mean_gain(self, amplitude: Reals) -> Reals:
        """Evaluate L/(πA) (1/cos α + 1/cos ρ), which follows from the four phases of switching."""
        rising, falling = self._cosines(amplitude)
        gain = self.level / (np.pi * amplitude) * (1.0 / rising + 1.0 / falling)
        return np.where(self._silent(amplitude), self._silence, gain)

    def _waveform(self, phase: Reals, amplitude: Reals, omega: Reals) -> Reals:
        rising, falling = self._cosines(amplitude)
        start = np.arctan2(self.on / amplitude, rising)
        duration = np.pi - start - np.arctan2(self.off / amplitude, falling)
        elapsed = np.mod(phase - start, 2.0 * np.pi)
        value = np.where(elapsed < duration, self.level, 0.0)
        value = np.where((elapsed >= np.pi) & (elapsed - np.pi < duration), -self.level, value)
        return np.where(self._silent(amplitude), self._silence, value)

    def small_gains(self) -> SmallGains:
        """Tell how N goes to zero for large amplitudes and, in a dead zone, for small ones."""
        if self.hysteresis == 0:
            return real_small_gains(self._size)
        reach = math.sqrt(self.hysteresis / self.on) / ROUNDED_UP
        return SmallGains(1.0, self._size, 0.0, steepest=0.0, gentlest=0.0, behind=_BEHIND, reach=reach)

    def _domain(self, omega: Reals) -> float:
        """Return 1 if the relay stays switched below the threshold, else infinity."""
        return math.inf if self.rests else 1.0

    def _sensitivity(self, u: Limits, omega: Limits) -> Bounds:
        """Bound |dN/du| up to some u by c (1/cos α + 1/cos ρ); infinite at u = 1."""
        steepest = ROUNDED_UP * self._size * sum(1.0 / np.cos(angle) for angle in self._angles(u[1]))
        return np.where(self._still(u), 0.0, steepest), 0.0

    def _variation(self, u: Limits, omega: Limits) -> Bounds:
        """Bound the change of dN/du between two u; infinite at u = 1.

        The derivative of exp(-2jα)/cos α by α has the modulus √(4 + tan² α) / cos α, which rises with |α|.
        """
        total = np.zeros(u[0].shape)
        for first, last in zip(*map(self._angles, u), strict=True):
            steepness = np.sqrt(4.0 + np.tan(last) ** 2) / np.cos(last)
            total += (np.abs(last - first) + _ROUNDING) * steepness
        return np.where(self._still(u), 0.0, ROUNDED_UP * self._size * total), 0.0

    def _reach(self, u: Limits, omega: Limits) -> Reals:
        """Bound how far N is from its value in the middle of two u, by the chords of the two circles."""
        total, ratios = np.zeros(u[0].shape), (1.0, self.off / self.on)
        for ratio, centre in zip(ratios, self._angles(0.5 * (u[0] + u[1])), strict=True):
            ends = (np.arcsin(np.clip(each * ratio, -1.0, 1.0)) for each in u)
            chord = np.maximum(*(np.sin(np.abs(end - centre)) for end in ends)) + _ROUNDING
            total += chord / abs(ratio) if abs(ratio) > _SMALLEST_RATIO else _widest(u)
        leaves = (u[1] > 1.0) & (self.hysteresis > 0)
        return np.where(self._still(u), 0.0, np.where(leaves, np.inf, ROUNDED_UP * self._size * total))

    def _still(self, u: Limits) -> Flags:
        """Return where the relay rests in its dead zone at all u between two; it does at u = 1 already."""
        return np.asarray(self.rests & (u[0] >= 1.0))

    def _angles(self, u: Reals) -> tuple[Reals, Reals]:
        """Return α and ρ for some u; those of u = 1 beyond that."""
        within = np.minimum(u, 1.0)
        return np.arcsin(within), np.arcsin(within * (self.off / self.on))


_SMALLEST_RATIO = 1e-6


def _widest(u: Limits) -> Reals:
    """Bound the change of u exp(jρ) from the middle for |r| <= 1e-6, where it is that of u, nearly."""
    return np.asarray(0.5 * (u[1] - u[0]) * ROUNDED_UP + _ROUNDING)
