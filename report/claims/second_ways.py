"""Second ways to what harmonic balance and Tsypkin's condition say, for the claims of section 5.2."""

from __future__ import annotations

import math
from collections.abc import Sequence

import control
import numpy as np

from report.claim import Confirmation
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from trimmer import frequency_response
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.elements.element import Element
from trimmer.orbits.periodic_orbit import PeriodicOrbit

PHASES = 2**15
CLOSES = 1e-6
"""Accuracy to which a loop closes with a sampled waveform or a sum of harmonics."""
TERMS = 4_001
"""Highest harmonic of a square wave that is summed."""


def by_floquet(orbits: Sequence[PeriodicOrbit], *, stable: bool) -> Confirmation:
    """Confirm that the exact orbits beside some limit cycles are all stable, or all unstable."""
    sizes = ", ".join(f"{abs(orbit.nontrivial_multipliers).max():.3f}" for orbit in orbits)
    return Confirmation(
        "the Floquet multipliers of the exact orbit" + "s" * (len(orbits) > 1),
        Assertion(
            statement="disturbances of the exact orbit die out",
            derived=all(orbit.stable for orbit in orbits)
            if stable
            else any(orbit.stable for orbit in orbits),
            asserted=stable,
            evidence=f"they change by {sizes} a period at most",
            method=f"at most {sizes} per period",
        ),
    )


def by_waveform(
    system: control.TransferFunction, pairs: Sequence[tuple[Element, LimitCycle]]
) -> Confirmation:
    """Confirm limit cycles by the first line of each element's sampled waveform: N G is -1."""
    worst = max(
        abs(1 + sampled_gain(element, cycle) * complex(frequency_response(system, cycle.omega)))
        for element, cycle in pairs
    )
    return Confirmation(
        "the first line in the spectrum of the waveform", CloseNumbers(1 + worst, 1.0, CLOSES)
    )


def sampled_gain(element: Element, cycle: LimitCycle) -> complex:
    """Return the first harmonic of an element's sampled waveform over the amplitude of its input."""
    phases = 2 * np.pi * np.arange(PHASES) / PHASES
    output = element.waveform(phases, cycle.amplitude, cycle.omega)
    return complex(2j * np.mean(output * np.exp(-1j * phases)) / cycle.amplitude)


def by_harmonics(
    system: control.TransferFunction, frequencies: Sequence[float], feedback: float = 0.0
) -> Confirmation:
    """Confirm that a square wave of each frequency (Hz) returns with zero at its jumps, by summed harmonics.

    ``feedback`` is a gain round the system beside the relay.
    """
    orders = np.arange(1, TERMS + 1, 2)
    sums = []
    for frequency in frequencies:
        response = frequency_response(system, 2 * math.pi * frequency * orders)
        sums.append(float(np.sum((response / (1 + feedback * response)).imag / orders)))
    return Confirmation(
        f"the sum of {orders.size} harmonics at the jump",
        CloseNumbers(1 + max(map(abs, sums)), 1.0, CLOSES),
    )
