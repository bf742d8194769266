"""The two blocks of section 5.2.1 with drives of very different amplitude, in open loop and fed back.

The thesis calls figures 5.11, 5.12b and 5.14 open loop; the loop of figure 2.5 with a sinusoidal reference,
e = r - y, is the other way to drive the two blocks. Both are friction-controlled backlash of ``LARGE_GAP``
and the trimmer, the pin acting by its displacement alone, without friction between the bodies.
"""

import math
from dataclasses import dataclass

import control
import numpy as np

from report.numbers.record import harmonics
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA, LARGE_GAP
from trimmer import Drive, Feedback, FrictionBacklash, OpenLoop, PeriodicOrbit, peaks, simulate
from trimmer.arrays import Reals
from trimmer.elements import Element
from trimmer.loops import LoopMotion
from trimmer.spectra import Window
from trimmer.spectra.spectrum import amplitude_spectrum

AMPLITUDES = (1.5e-6, 1.5e-4, DRIVE_AMPLITUDE, 1.5e-2, 1.5e-1)
"""Amplitudes of the drive in figure E.2, m, in rising order."""
PERIODS, SAMPLES = 40, 2048  # Periods of the open loop from rest, and samples of a period
SETTLING, RECORD = 0.5, 0.5  # Time before a record of the loop with a reference and its length, s
SAMPLE_RATE = 10_000.0  # Hz; that record holds a whole number of periods of the reference
PEAKS = 6
AWAY = 1.0  # Least distance of a line from every multiple of the reference's frequency, Hz


@dataclass(frozen=True, eq=False)
class AmplitudeRun:
    """The settled output for one amplitude of the drive."""

    amplitude: float  # Of the pin, m
    phases: Reals  # Of the pin over the last two periods, rad
    output: Reals  # q2 - q4 there, m
    harmonics: Reals  # Amplitude of the output at 0, 1, 2 ... times the drive's frequency, m.
    ripple: float  # Half of peak to peak of the output without its first harmonic, m


def solve_drive_amplitudes(system: control.StateSpace) -> tuple[AmplitudeRun, ...]:
    """Simulate each amplitude; ``system`` is the trimmer from the bridge's displacement to q2 - q4."""
    return tuple(_open_loop(system, amplitude) for amplitude in AMPLITUDES)


def _open_loop(system: control.StateSpace, amplitude: float) -> AmplitudeRun:
    loop = OpenLoop(system, FrictionBacklash(LARGE_GAP), Drive(amplitude, DRIVE_OMEGA))
    motion = simulate(loop, PERIODS / DRIVE_FREQUENCY)
    phases = 2 * math.pi * np.arange(2 * SAMPLES) / SAMPLES
    output = motion.output(motion.duration - 2 / DRIVE_FREQUENCY + phases / DRIVE_OMEGA)
    lines = np.fft.rfft(output[SAMPLES:])
    first = 2 * (lines[1] * np.exp(1j * phases)).real / SAMPLES
    ripple = float(np.ptp(output - first)) / 2
    return AmplitudeRun(amplitude, phases, output, harmonics(output[SAMPLES:]), ripple)


def reference_loop(system: control.LTI, element: Element, reference: Drive) -> Feedback:
    """Return negative feedback of G and an element with a reference r: the element's input is e = r - y."""
    G = control.ss(system)
    plant = control.ss(
        G.A,
        np.hstack([G.B, 0.0 * G.B]),
        np.vstack([G.C, -G.C]),
        [[0.0, 0.0], [0.0, 1.0]],
        states=G.state_labels,
        inputs=["e", "r"],
        outputs=["y", "e"],
    )
    return Feedback(plant, {"e": element}, {"r": reference})


@dataclass(frozen=True, eq=False)
class ReferenceRun:
    """One run with a reference of ``DRIVE_FREQUENCY``."""

    amplitude: float  # Of the reference, m
    largest: float  # Largest |y| of the record, m
    base: float  # Amplitude of y at the frequency of the reference, m
    frequency: float  # Frequency of the largest line that is no multiple of the reference's, Hz; NaN for none
    line: float  # Its amplitude, m; 0 for none
    motion: LoopMotion  # The motion from its start


@dataclass(frozen=True, eq=False)
class ReferenceNumbers:
    """Runs of the loop with a reference."""

    from_rest: ReferenceRun  # A reference of 1.5 mm in the thesis's loop, started from rest
    from_limit_cycle: tuple[ReferenceRun, ...]  # Each of ``AMPLITUDES``, started on the limit cycle
    both_channels: ReferenceRun  # 1.5 mm, started on the limit cycle of the loop with the pin's velocity too


def solve_reference(orbit: PeriodicOrbit, orbit_both: PeriodicOrbit) -> ReferenceNumbers:
    """Simulate the runs; the orbits are the stable limit cycles of the two loops for a gap of one metre."""
    return ReferenceNumbers(
        from_rest=_fed_back(orbit, DRIVE_AMPLITUDE, on_limit_cycle=False),
        from_limit_cycle=tuple(_fed_back(orbit, amplitude, on_limit_cycle=True) for amplitude in AMPLITUDES),
        both_channels=_fed_back(orbit_both, DRIVE_AMPLITUDE, on_limit_cycle=True),
    )


def _fed_back(orbit: PeriodicOrbit, amplitude: float, on_limit_cycle: bool) -> ReferenceRun:
    reference = Drive(amplitude, DRIVE_OMEGA)
    loop = reference_loop(orbit.motion.loop.model, FrictionBacklash(LARGE_GAP), reference)
    if on_limit_cycle:
        load = orbit.motion.element_output(0.0)
        state = LARGE_GAP * np.append(orbit.motion.state(0.0), load)
        motion = simulate(loop, SETTLING + RECORD, state=state)
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
