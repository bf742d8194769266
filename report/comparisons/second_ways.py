"""Second ways to what a claim derives, and how a finding names them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import control
import mpmath
import numpy as np

from report.claim import Confirmation
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from trimmer import frequency_response
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.elements.element import Element
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.orbits.periodic_orbit import PeriodicOrbit

DIGITS = 30
GRID = np.geomspace(1, 1e6, 20_000)
FINE_GRID = np.geomspace(100, 1e5, 40_001)
"""Angular frequencies, rad/s."""
PHASES = 2**15
CLOSES = 1e-6
"""Accuracy to which a loop closes with a sampled waveform or a sum of harmonics."""
TERMS = 4_001
"""Highest harmonic of a square wave that is summed."""


def second_way(means: str, holds: bool) -> Confirmation:
    """Confirm a finding by another way to it, of which is known whether it leads to the same finding."""
    return Confirmation(means, Assertion(statement=means, derived=bool(holds), evidence=means, method=means))


def by_division_back(omega: float, frequency: float) -> Confirmation:
    """Confirm a conversion from rad/s to Hz by turning it round in 30 digits."""
    with mpmath.workdps(DIGITS):
        back = float(2 * mpmath.pi * mpmath.mpf(frequency))
    return Confirmation(f"$2\\pi$ times it, in {DIGITS} digits", CloseNumbers(back, omega, 1e-14))


def by_grid(system: control.TransferFunction, crossings: int) -> Confirmation:
    """Confirm how often a locus crosses the negative real axis."""
    response = frequency_response(system, GRID)
    changes = np.diff(np.sign(response.imag)).astype(bool) & (response.real[1:] < 0)
    return Confirmation(
        f"changes of sign of $\\mathrm{{Im}}\\,G$ at {GRID.size} frequencies where $\\mathrm{{Re}}\\,G < 0$",
        CloseNumbers(1 + int(changes.sum()), 1 + crossings),
    )


def by_matching_real_parts(system: control.TransferFunction, share: float, count: int) -> Confirmation:
    """Confirm the number of solutions of 1 + N G = 0 for backlash with a term j 4 share/(π A), A in gaps.

    At each frequency of a grid the real part of N, which rises with A, gives A; what is left of the imaginary
    part then changes its sign at a solution.
    """
    needed = -1 / np.asarray(frequency_response(system, FINE_GRID))
    amplitudes = 0.5 + np.geomspace(1e-9, 1e6, FINE_GRID.size)
    element = FrictionBacklash(1.0).describing_function(amplitudes)
    amplitude = np.interp(needed.real, element.real, amplitudes, left=np.nan, right=np.nan)
    imaginary = np.interp(needed.real, element.real, element.imag) + 4 * share / (np.pi * amplitude)
    left = imaginary - needed.imag
    return Confirmation(
        f"the real part solved for the amplitude at {FINE_GRID.size} frequencies",
        CloseNumbers(1 + int((left[:-1] * left[1:] < 0).sum()), 1 + count),
    )


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
        abs(
            1
            + sampled_gain(element, cycle.amplitude, cycle.omega)
            * complex(frequency_response(system, cycle.omega))
        )
        for element, cycle in pairs
    )
    return Confirmation(
        "the first line in the spectrum of the waveform", CloseNumbers(1 + worst, 1.0, CLOSES)
    )


def sampled_gain(element: Element, amplitude: float, omega: float) -> complex:
    """Return the first harmonic of an element's sampled waveform over the amplitude of its input."""
    phases = 2 * np.pi * np.arange(PHASES) / PHASES
    output = element.waveform(phases, amplitude, omega)
    return complex(2j * np.mean(output * np.exp(-1j * phases)) / amplitude)


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
