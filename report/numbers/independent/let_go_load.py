"""A load that a pin A sin ωt pushes, and that a constant friction force brings to rest when it is let go."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

STEP = 1e-6
"""Of the sampled pin, s."""


@dataclass(frozen=True)
class LetGoLoad:
    """The load: amplitude of its pin, m, rad/s of it, and deceleration by friction, m/s²."""

    amplitude: float
    omega: float
    deceleration: float

    @property
    def phase(self) -> float:
        """Of the pin when it lets the load go, rad: it begins to decelerate faster than friction can."""
        return math.asin(self.deceleration / (self.amplitude * self.omega**2))

    @property
    def velocity(self) -> float:
        """With which it is let go, m/s."""
        return self.amplitude * self.omega * math.cos(self.phase)

    @property
    def seconds(self) -> float:
        """Until it is at rest, s."""
        return self.velocity / self.deceleration

    def ahead(self) -> float:
        """Return how far ahead of the pin it comes to rest, m."""
        pin = self.amplitude * (math.sin(self.phase + self.omega * self.seconds) - math.sin(self.phase))
        return self.velocity**2 / (2 * self.deceleration) - pin

    def ahead_by_integration(self) -> float:
        """Return the same by integrating both motions, m."""
        speed = self.amplitude * self.omega
        flight = solve_ivp(
            lambda t, state: [state[1] - speed * math.cos(self.phase + self.omega * t), -self.deceleration],
            (0, self.seconds),
            [0.0, self.velocity],
            rtol=1e-10,
            atol=1e-14,
        )
        return float(flight.y[0, -1])

    def largest_acceleration(self) -> float:
        """Return the pin's largest acceleration by second differences over a period, m/s²."""
        times = np.arange(0, 2 * math.pi / self.omega, STEP)
        return float(np.abs(np.diff(self.amplitude * np.sin(self.omega * times), 2)).max()) / STEP**2
