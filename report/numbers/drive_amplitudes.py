"""The open loop of section 5.2.1 and appendix E with drives of very different amplitude.

Friction-controlled backlash of 40 µm, 100 Hz, pin displacement only, without friction between the bodies.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import control
import numpy as np

from report.numbers.linear_numbers import DRIVE_FREQUENCY
from trimmer.arrays import Reals
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.motion.loops import Drive, OpenLoop
from trimmer.motion.simulation import simulate

GAP = 4e-5
"""Total clearance, m."""
AMPLITUDES = (1.5e-6, 1.5e-4, 1.5e-3, 1.5e-2, 1.5e-1)
"""Amplitudes of the pin in figure E.2, m, in rising order."""
PERIODS = 40
"""Periods from rest."""
SAMPLES = 2048
"""Samples of a period."""


@dataclass(frozen=True, eq=False)
class AmplitudeRun:
    """The settled output for one amplitude of the drive.

    Attributes:
        amplitude: Of the pin, m.
        phases: Of the pin over the last two periods, rad.
        output: q2 - q4 there, m.
        harmonics: Amplitude of the output at 0, 1, 2 ... times the drive's frequency, m.
        ripple: Half of peak to peak of the output without its first harmonic, m.
    """

    amplitude: float
    phases: Reals
    output: Reals
    harmonics: Reals
    ripple: float


def solve_drive_amplitudes(system: control.StateSpace) -> tuple[AmplitudeRun, ...]:
    """Simulate each amplitude; ``system`` is the trimmer from the bridge's displacement to q2 - q4."""
    return tuple(_run(system, amplitude) for amplitude in AMPLITUDES)


def _run(system: control.StateSpace, amplitude: float) -> AmplitudeRun:
    omega = 2 * math.pi * DRIVE_FREQUENCY
    loop = OpenLoop(system, FrictionBacklash(GAP), Drive(amplitude, omega))
    motion = simulate(loop, PERIODS / DRIVE_FREQUENCY)
    phases = 2 * math.pi * np.arange(2 * SAMPLES) / SAMPLES
    output = motion.output(motion.duration - 2 / DRIVE_FREQUENCY + phases / omega)
    lines = np.fft.rfft(output[SAMPLES:])
    first = 2 * (lines[1] * np.exp(1j * phases)).real / SAMPLES
    amplitudes = 2 * np.abs(lines) / SAMPLES
    amplitudes[0] /= 2
    return AmplitudeRun(amplitude, phases, output, amplitudes, float(np.ptp(output - first)) / 2)
