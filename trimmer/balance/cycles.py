"""Solutions turned into limit cycles, with their stability."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.stability import other_unstable_poles, sine_of_crossing

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.inverse_response import InverseResponse


def limit_cycles_at(
    response: InverseResponse, curve: ElementCurve, u: NDArray[np.float64], x: NDArray[np.float64]
) -> tuple[LimitCycle, ...]:
    """Describe the solutions at (u, x), in order of frequency, then of amplitude."""
    if u.size == 0:
        return ()
    order = np.lexsort((-u, x))
    u, x = u[order], x[order]
    inverse, slope = response.value_and_slope(x)
    gain = curve.value(u, x)
    by_u, gain_by_x = curve.slopes(u, x)
    amplitudes, omegas = curve.amplitude(u), np.exp(x)
    unstable = other_unstable_poles(response, gain, omegas)
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
                residual=float(abs(1.0 + gain[place] / inverse[place])),
                crossing_angle=math.asin(min(1.0, abs(sine))),
                other_unstable_poles=others,
            )
        )
    return tuple(cycles)
