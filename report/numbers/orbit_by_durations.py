"""A second way to the limit cycles of backlash: the state at the impact and two durations, by SciPy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import expm
from scipy.optimize import fsolve

from trimmer.arrays import Reals
from trimmer.orbits.periodic_orbit import PeriodicOrbit


@dataclass(frozen=True, eq=False)
class _Loop:
    """x' = A x + B u, y = C x, with a gap of one and the orbit's period as unit of time."""

    A: Reals
    B: Reals
    C: Reals
    heavy: bool

    def contact(self, state: Reals, time: float) -> Reals:
        """Return the state after a contact on the upper side, where u = -y - 1/2."""
        return _after(self.A - np.outer(self.B, self.C), -self.B / 2, 0 * self.B, state, time)

    def release(self, state: Reals) -> tuple[float, float]:
        """Return position and velocity of the bridge that is let go; a light one stops at once."""
        velocity = self.C @ self._rate(state) if self.heavy else 0.0
        return float(-self.C @ state) - 0.5, float(-velocity)

    def flight(self, state: Reals, bridge: tuple[float, float], time: float) -> Reals:
        """Return the state after the free flight of the bridge."""
        return _after(self.A, self.B * bridge[0], self.B * bridge[1], state, time)

    def leaving(self, state: Reals) -> float:
        """Return what is zero with the contact force: velocity, or for a heavy bridge acceleration."""
        held, rate = self.A - np.outer(self.B, self.C), self._rate(state)
        return float(self.C @ (held @ rate if self.heavy else rate))

    def _rate(self, state: Reals) -> Reals:
        return np.asarray(self.A @ state + self.B * (-self.C @ state - 0.5))


def orbit_by_durations(near: PeriodicOrbit, heavy: bool) -> tuple[float, float]:
    """Return |y| at the end of contact and the frequency (Hz) of an orbit with two contacts in a period.

    Unknown are the state at an impact and the lengths of contact and flight. After half a period the state
    has changed its sign, the contact ends where its force is zero, and the flight on the other side.

    Args:
        near: The orbit, for a gap of one metre; rounded, it is where the search starts.
        heavy: Whether the bridge keeps the pin's velocity (inertia-controlled) or stops (friction-controlled,
            where the first result is the amplitude).
    """
    model, period = near.motion.loop.model, near.period
    leave, meet = near.switching_times[:2]
    states = near.motion.state(np.append(np.linspace(0, period, 101), meet))
    sizes = np.abs(states).max(axis=1)
    rates = period / sizes
    loop = _Loop(model.A * sizes * rates[:, None], model.B[:, 0] * rates, model.C[0] * sizes, heavy)

    def residual(unknowns: Reals) -> Reals:
        begin, (contact, flight) = unknowns[:-2], unknowns[-2:]
        released = loop.contact(begin, contact)
        bridge = loop.release(released)
        end = loop.flight(released, bridge, flight)
        meets = -loop.C @ end - bridge[0] - bridge[1] * flight + 0.5
        return np.append(end + begin, [loop.leaving(released), meets])

    lengths = np.array([period / 2 - (meet - leave), meet - leave]) / period
    found = fsolve(residual, np.round(np.append(-states[:, -1] / sizes, lengths), 3), xtol=1e-13)
    released = loop.contact(found[:-2], found[-2])
    return abs(float(loop.C @ released)), float(1 / (2 * found[-2:].sum() * period))


def _after(matrix: Reals, constant: Reals, slope: Reals, state: Reals, time: float) -> Reals:
    """Return the solution of x' = matrix x + constant + slope t after a time."""
    size = state.size
    whole = np.zeros((size + 2, size + 2))
    whole[:size, :size], whole[:size, size], whole[:size, size + 1] = matrix, constant, slope
    whole[size + 1, size] = 1.0
    return np.asarray((expm(whole * time) @ np.append(state, [1.0, 0.0]))[:size])
