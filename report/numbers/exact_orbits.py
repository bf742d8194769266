"""Exact limit cycles of section 5.2, per gap, by shooting and in a second way.

Amplitudes go with the gap and frequencies do not depend on it, so a gap of one metre stands for all.
"""

from dataclasses import dataclass

import control
import numpy as np
from scipy.optimize import fsolve

from report.numbers.limit_cycle_numbers import LimitCycleNumbers, Pair
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.time_stepping import linear_step
from trimmer import FrictionBacklash, InertiaBacklash, PeriodicOrbit, periodic_orbits, simulate
from trimmer.arrays import Reals
from trimmer.elements import Element
from trimmer.linear.model import InputChannels, pin_model

ASIDE = 1e-3  # How far beside the unstable limit cycle two motions start, relative
DURATION = 0.5  # Length of these motions, s


@dataclass(frozen=True, eq=False)
class OrbitPair:
    """The unstable and the stable limit cycle of one loop, for a gap of one metre."""

    unstable: PeriodicOrbit
    stable: PeriodicOrbit


@dataclass(frozen=True, eq=False)
class ExactOrbits:
    """Exact limit cycles for a gap of one metre."""

    friction: OrbitPair  # Friction-controlled backlash in the thesis's loop (pin displacement only)
    # Amplitudes to which motions go that start on the unstable one of ``friction`` with all displacements and
    # velocities a little smaller, and a little larger
    left_by: tuple[float, float]
    friction_listing: OrbitPair  # As ``friction``, with the rounded coefficients of Listing A.9
    friction_both_channels: OrbitPair  # As ``friction``, with the pin's velocity as second input
    inertia: OrbitPair  # Inertia-controlled backlash in the thesis's loop
    # Amplitude and frequency (Hz) of the stable one of ``friction`` in a second way
    friction_by_durations: tuple[float, float]
    inertia_by_durations: float  # Frequency (Hz) of the stable one of ``inertia`` in a second way


def solve_orbits(numbers: LinearNumbers, cycles: LimitCycleNumbers) -> ExactOrbits:
    """Find the exact orbit of each predicted limit cycle."""
    thesis, both = (
        pin_model(numbers.parameters, channels=channels)
        for channels in (InputChannels.DISPLACEMENT_ONLY, InputChannels.DISPLACEMENT_AND_VELOCITY)
    )
    friction, inertia = FrictionBacklash(1.0), InertiaBacklash(1.0)
    of_friction, of_inertia = _pair(thesis, friction, cycles.friction), _pair(thesis, inertia, cycles.inertia)
    return ExactOrbits(
        friction=of_friction,
        left_by=(_end(of_friction.unstable, 1 - ASIDE), _end(of_friction.unstable, 1 + ASIDE)),
        friction_listing=_pair(cycles.listing, friction, cycles.friction_listing),
        friction_both_channels=_pair(both, friction, cycles.friction_both_channels),
        inertia=of_inertia,
        friction_by_durations=orbit_by_durations(of_friction.stable, inertia=False),
        inertia_by_durations=orbit_by_durations(of_inertia.stable, inertia=True)[1],
    )


def _pair(system: control.LTI, element: Element, predicted: Pair) -> OrbitPair:
    stable, unstable = periodic_orbits(system, element, (predicted.stable, predicted.unstable))
    return OrbitPair(unstable, stable)


def _end(orbit: PeriodicOrbit, factor: float) -> float:
    """Return half of peak to peak at the end of a motion that starts on an orbit times a factor."""
    motion = simulate(
        orbit.motion.loop,
        DURATION,
        initial_state=factor * orbit.motion.state(0.0),
        element_output=factor * float(orbit.motion.element_output(0.0)),
    )
    return float(np.ptp(motion.output(np.linspace(DURATION - 4 * orbit.period, DURATION, 4_001)))) / 2


@dataclass(frozen=True, eq=False)
class _ScaledLoop:
    """x' = A x + B u, y = C x, with a gap of one and the orbit's period as unit of time."""

    A: Reals
    B: Reals
    C: Reals
    inertia: bool

    def contact(self, state: Reals, time: float) -> Reals:
        """Return the state after a contact on the upper side, where u = -y - 1/2."""
        through, hold, _ = linear_step(self.A - np.outer(self.B, self.C), self.B, time)
        return through @ state - hold / 2

    def release(self, state: Reals) -> tuple[float, float]:
        """Return position and velocity of the bridge that is let go; without inertia it stops at once."""
        velocity = self.C @ self._rate(state) if self.inertia else 0.0
        return float(-self.C @ state) - 0.5, float(-velocity)

    def flight(self, state: Reals, bridge: tuple[float, float], time: float) -> Reals:
        """Return the state after the free flight of the bridge."""
        through, hold, ramp = linear_step(self.A, self.B, time)
        return through @ state + bridge[0] * hold + bridge[1] * time * ramp

    def leaving(self, state: Reals) -> float:
        """Return what is zero with the contact force: velocity, or with inertia its acceleration."""
        held, rate = self.A - np.outer(self.B, self.C), self._rate(state)
        return float(self.C @ (held @ rate if self.inertia else rate))

    def _rate(self, state: Reals) -> Reals:
        return np.asarray(self.A @ state + self.B * (-self.C @ state - 0.5))


def orbit_by_durations(near: PeriodicOrbit, inertia: bool) -> tuple[float, float]:
    """Return |y| at the end of contact and the frequency (Hz) of an orbit with two contacts in a period.

    Unknown are the state at an impact and the lengths of contact and flight. After half a period the state
    has changed its sign, the contact ends where its force is zero, and the flight on the other side. The
    search starts near an orbit for a gap of one metre, rounded. The bridge keeps the pin's velocity
    (inertia-controlled) or stops (friction-controlled, where the first result is the amplitude).
    """
    model, period = near.motion.loop.model, near.period
    leave, meet = near.switching_times[:2]
    states = near.motion.state(np.append(np.linspace(0, period, 101), meet))
    sizes = np.abs(states).max(axis=1)
    rates = period / sizes
    loop = _ScaledLoop(model.A * sizes * rates[:, None], model.B[:, 0] * rates, model.C[0] * sizes, inertia)

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
