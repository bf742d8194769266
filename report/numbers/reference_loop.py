"""The loop of figure 2.5 with a sinusoidal reference, e = r - y, beside the open loop (section 5.2.1).

The thesis calls figures 5.11, 5.12b and 5.14 open loop; this is the other way to drive the two blocks.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import final

import control
import numpy as np

from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from trimmer.arrays import Reals
from trimmer.elements.element import Element
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.motion.interconnection import Interconnection, realized
from trimmer.motion.loops import Drive, Loop, element_around
from trimmer.motion.motion import Motion
from trimmer.motion.simulation import simulate
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.spectra.peaks import peaks
from trimmer.spectra.spectrum import amplitude_spectrum
from trimmer.spectra.window import Window

GAP = 4e-5
"""Gap of figures 5.11 and 5.12b, m."""
AMPLITUDES = (1.5e-6, 1.5e-4, DRIVE_AMPLITUDE, 1.5e-2, 1.5e-1)
"""Amplitudes of figure E.2, m, in rising order."""
SETTLING, RECORD = 0.5, 0.5
"""Time before a record and its length, s."""
SAMPLE_RATE = 10_000.0
"""Hz; the record holds a whole number of periods of the reference."""
PEAKS = 6
AWAY = 1.0
"""Least distance of a line from every multiple of the reference's frequency, Hz."""


@final
@dataclass(frozen=True, eq=False)
class ReferenceLoop(Loop):
    """Negative feedback with a reference: the element's input is r - y.

    Attributes:
        system: G.
        element: The nonlinear element.
        reference: r.
    """

    system: control.LTI
    element: Element
    reference: Drive

    def interconnection(self) -> Interconnection:
        """Return the equations."""
        closed = element_around(self.model, self.element, None)
        return replace(closed, drive=self.reference, drive_gain=np.ones(len(closed.components)))

    @property
    def model(self) -> control.StateSpace:
        """The system in state space."""
        return realized(self.system)


@dataclass(frozen=True, eq=False)
class ReferenceRun:
    """One run with a reference of ``DRIVE_FREQUENCY``.

    Attributes:
        amplitude: Of the reference, m.
        largest: Largest |y| of the record, m.
        base: Amplitude of y at the frequency of the reference, m.
        frequency: Frequency of the largest line that is no multiple of the reference's, Hz; NaN for none.
        line: Its amplitude, m; 0 for none.
        motion: The motion from its start.
    """

    amplitude: float
    largest: float
    base: float
    frequency: float
    line: float
    motion: Motion


@dataclass(frozen=True, eq=False)
class ReferenceNumbers:
    """Runs with friction-controlled backlash of ``GAP``.

    Attributes:
        from_rest: A reference of 1.5 mm in the thesis's loop, started from rest.
        from_limit_cycle: Each of ``AMPLITUDES``, started on the limit cycle.
        both_channels: 1.5 mm, started on the limit cycle of the loop with the pin's velocity too.
    """

    from_rest: ReferenceRun
    from_limit_cycle: tuple[ReferenceRun, ...]
    both_channels: ReferenceRun


def solve_reference(orbit: PeriodicOrbit, orbit_both: PeriodicOrbit) -> ReferenceNumbers:
    """Simulate the runs; the orbits are the stable limit cycles of the two loops for a gap of one metre."""
    return ReferenceNumbers(
        from_rest=_run(orbit, DRIVE_AMPLITUDE, aboard=False),
        from_limit_cycle=tuple(_run(orbit, amplitude, aboard=True) for amplitude in AMPLITUDES),
        both_channels=_run(orbit_both, DRIVE_AMPLITUDE, aboard=True),
    )


def _run(orbit: PeriodicOrbit, amplitude: float, aboard: bool) -> ReferenceRun:
    reference = Drive(amplitude, 2 * math.pi * DRIVE_FREQUENCY)
    loop = ReferenceLoop(orbit.motion.loop.model, FrictionBacklash(GAP), reference)
    if aboard:
        motion = simulate(
            loop,
            SETTLING + RECORD,
            initial_state=GAP * orbit.motion.state(0.0),
            element_output=GAP * float(orbit.motion.element_output(0.0)),
        )
    else:
        motion = simulate(loop, SETTLING + RECORD)
    output = motion.output(SETTLING + np.arange(round(RECORD * SAMPLE_RATE)) / SAMPLE_RATE)
    line = 2 * abs(np.fft.rfft(output)[round(RECORD * DRIVE_FREQUENCY)]) / output.size
    frequency, size = other_line(output, SAMPLE_RATE, DRIVE_FREQUENCY)
    return ReferenceRun(amplitude, float(np.abs(output).max()), float(line), frequency, size, motion)


def other_line(output: Reals, sample_rate: float, drive: float) -> tuple[float, float]:
    """Return frequency (Hz) and amplitude of the largest line that is no multiple of a drive's frequency.

    NaN and 0 if there is none.
    """
    found = peaks(amplitude_spectrum(output, sample_rate, Window.BLACKMAN_HARRIS), limit=PEAKS)
    for peak in found:
        if abs(peak.frequency - drive * round(peak.frequency / drive)) > AWAY:
            return peak.frequency, peak.amplitude
    return math.nan, 0.0
