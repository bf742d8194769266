"""Van der Pol's oscillator x'' + α (x² − 1) x' + x = 0, integrated over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from scipy.integrate import solve_ivp

if TYPE_CHECKING:
    from trimmer.arrays import Reals

SAMPLES = 512


def third_harmonic(damping: float) -> float:
    """Return the third harmonic of the limit cycle's position, as a share of the first, for α = damping."""

    def flow(_: float, state: Reals) -> list[float]:
        position, velocity = state
        return [velocity, -damping * (position**2 - 1) * velocity - position]

    def upwards(_: float, state: Reals) -> float:
        return float(state[0])

    upwards.direction = 1  # type: ignore[attr-defined]
    settled = solve_ivp(flow, (0, 60), [2.0, 0.0], events=upwards, dense_output=True, rtol=1e-8, atol=1e-10)
    start, end = settled.t_events[0][-2:]
    period = settled.sol(np.linspace(start, end, SAMPLES, endpoint=False))[0]
    lines = np.abs(np.fft.rfft(period))
    return float(lines[3] / lines[1])
