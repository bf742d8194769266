"""Exact limit cycles of section 5.2, per gap.

Amplitudes go with the gap and frequencies do not depend on it, so a gap of one metre stands for all.
"""

from __future__ import annotations

from dataclasses import dataclass

import control
import numpy as np

from report.numbers.limit_cycle_numbers import LimitCycleNumbers, Pair
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.orbit_by_durations import orbit_by_durations
from trimmer.elements.element import Element
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.linear.model import InputChannels, pin_model
from trimmer.motion.simulation import simulate
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.orbits.periodic_orbits import periodic_orbits

ASIDE = 1e-3
"""How far beside the unstable limit cycle two motions start, relative."""
DURATION = 0.5
"""Their length, s."""


@dataclass(frozen=True, eq=False)
class OrbitPair:
    """The unstable and the stable limit cycle of one loop, for a gap of one metre."""

    unstable: PeriodicOrbit
    stable: PeriodicOrbit


@dataclass(frozen=True, eq=False)
class ExactOrbits:
    """Exact limit cycles for a gap of one metre.

    Attributes:
        friction: Friction-controlled backlash in the thesis's loop (pin displacement only).
        left_by: Amplitudes to which motions go that start on the unstable one of ``friction`` with all
            displacements and velocities a little smaller, and a little larger.
        friction_listing: As ``friction``, with the rounded coefficients of Listing A.9.
        friction_both_channels: As ``friction``, with the pin's velocity as second input.
        inertia: Inertia-controlled backlash in the thesis's loop.
        friction_by_durations: Amplitude and frequency (Hz) of the stable one of ``friction`` in a second way.
        inertia_by_durations: Frequency (Hz) of the stable one of ``inertia`` in a second way.
    """

    friction: OrbitPair
    left_by: tuple[float, float]
    friction_listing: OrbitPair
    friction_both_channels: OrbitPair
    inertia: OrbitPair
    friction_by_durations: tuple[float, float]
    inertia_by_durations: float


def solve_orbits(numbers: LinearNumbers, cycles: LimitCycleNumbers) -> ExactOrbits:
    """Find the exact orbit of each predicted limit cycle."""
    thesis, both = (
        pin_model(numbers.parameters, channels=channels)
        for channels in (InputChannels.DISPLACEMENT_ONLY, InputChannels.DISPLACEMENT_AND_VELOCITY)
    )
    friction, inertia = FrictionBacklash(1.0), InertiaBacklash(1.0)
    pair, heavy = _pair(thesis, friction, cycles.friction), _pair(thesis, inertia, cycles.inertia)
    return ExactOrbits(
        friction=pair,
        left_by=(_end(pair.unstable, 1 - ASIDE), _end(pair.unstable, 1 + ASIDE)),
        friction_listing=_pair(cycles.listing, friction, cycles.friction_listing),
        friction_both_channels=_pair(both, friction, cycles.friction_both_channels),
        inertia=heavy,
        friction_by_durations=orbit_by_durations(pair.stable, heavy=False),
        inertia_by_durations=orbit_by_durations(heavy.stable, heavy=True)[1],
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
