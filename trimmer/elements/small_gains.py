"""Where a describing function goes to zero: the phase it has there.

A backlash's N vanishes at the edge of the dead band, if the load hardly coasts. With gamma = omega M/D,
φ = atan gamma, the angle of contact l and E = exp((l - π)/gamma), the equations of backlash_motion.py read

π Re N = l - sin l + 2 sin l (E sin² φ + sin²(φ + l/2)),
-π Im N = v² + sin² φ (1 - E²) - 2 E sin φ cos φ sin l >= v², v = sin(φ + l) + E sin φ.

So |N| >= v²/π. Let |N| <= 0.003. Then sin(φ + l) <= 0.0971. If φ + l > π/2, then l > 1.47 and Re N > 0.15,
which is too much; so φ + l < 0.0973. Hence gamma < 0.1, l < 0.0973, and E < 1e-13, which the last digits
below cover.

- |N| >= sin² φ / π > 0.3 gamma².
- The phase of jN is δ = atan(Re N / -Im N), and δ > 0. With sin²(φ + l/2) < v² and sin l < √(π |N|),
  tan δ < l/6 + 2.001 l < 2.2 √(π |N|) < 4 √|N|.
- Let |N| >= 25 gamma². As sin²(φ + l/2) > sin²(l/2), π Re N > l - sin l cos l > 0.66 l³. As v < gamma + l,
  -π Im N < (gamma + l)² + gamma², and it is more than |N| π/1.03, as tan δ < 0.22. With gamma <= √|N|/5,
  l > 1.5 √|N|, hence gamma < l/7, and tan δ > 0.66 l³ / ((8/7)² + 1/49) l² > 0.49 l > 0.73 √|N|. So
  δ > 0.7 √|N|.

A saturation, a dead zone and a relay with a dead zone but no hysteresis have a real N: δ = 0. With hysteresis
N goes to zero for large amplitudes only, and lags (``trimmer.elements.threshold_relay``).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

BACKLASH_LARGEST = 0.003  # |N| of a backlash up to which the bounds are proven

STEEPEST = 4.0  # Upper bound of δ/√|N|

GENTLEST = 0.7  # Lower bound of δ/√|N| for |N| >= ``COASTING`` gamma²

COASTING = 25.0  # |N|/gamma² from which on that holds

LEAST = 0.3  # Lower bound of |N|/gamma²


@dataclass(frozen=True)
class SmallGains:
    """What is known of N where |N| is at most ``largest``: its phase is that of the direction, and δ.

    There -``behind`` |N|/scale <= δ <= ``steepest`` √(|N|/scale), and δ >= ``gentlest`` √(|N|/scale) if
    |N| >= ``COASTING`` scale (lag omega)². Everywhere |N| >= min(``LEAST`` scale (lag omega)², largest).
    """

    direction: complex  # Limit of N/|N| for N to 0
    scale: float  # Factor on N
    lag: float  # gamma/omega, s; 0 for a load that does not coast
    steepest: float = STEEPEST  # See above, >= 0
    gentlest: float = GENTLEST  # See above, >= 0; if it is positive, δ is so wherever N is not zero
    behind: float = 0.0  # See above, >= 0
    reach: float = BACKLASH_LARGEST  # |N|/scale up to which the bounds hold; may be infinite

    @property
    def largest(self) -> float:
        """|N| up to which the bounds hold."""
        return self.scale * self.reach

    def scaled(self, factor: float) -> SmallGains:
        """Take N times a factor that is not 0."""
        return replace(
            self, direction=self.direction if factor > 0 else -self.direction, scale=self.scale * abs(factor)
        )


def small_gains_of_backlash(lag: float) -> SmallGains:
    """Return the small gains of a backlash whose load has the time constant ``lag``, s."""
    return SmallGains(direction=-1j, scale=1.0, lag=lag)


def real_small_gains(scale: float) -> SmallGains:
    """Return the small gains of an N that is real and positive, or zero; any size of it is a scale."""
    return SmallGains(1.0, scale, lag=0.0, steepest=0.0, gentlest=0.0, reach=math.inf)
