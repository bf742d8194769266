"""Solutions turned into limit cycles, with their stability."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.stability import other_unstable_poles, sine_of_crossing

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.loop import Loop


def limit_cycles_at(loop: Loop, u: NDArray[np.float64], x: NDArray[np.float64]) -> tuple[LimitCycle, ...]:
    """Describe the solutions at (u, x), in order of frequency, then of amplitude."""
    if u.size == 0:
        return ()
    order = np.lexsort((-u, x))
    u, x = u[order], x[order]
    inverse, slope = loop.response.value_and_slope(x)
    gain, by_u, gain_by_x = loop.curve.expansion(u, x)
    amplitudes, omegas = loop.curve.amplitude(u), np.exp(x)
    unstable = other_unstable_poles(loop, gain, amplitudes, omegas)
    # 1 + N G of the loop as it was given.
    residuals = np.abs((gain + inverse) / (inverse - loop.linear.value(omegas)))
    cycles = []
    for place in range(u.size):
        # u falls with amplitude, hence the sign.
        sine = sine_of_crossing(-complex(by_u[place]), complex(slope[place] + gain_by_x[place]))
        others = int(unstable[place])
        cycles.append(
            LimitCycle(
                amplitude=float(amplitudes[place]),
                omega=float(omegas[place]),
                stable=sine > 0 and others == 0,
                residual=float(residuals[place]),
                crossing_angle=math.asin(min(1.0, abs(sine))),
                index=1 if sine > 0 else -1,
                other_unstable_poles=others,
            )
        )
    return tuple(cycles)
