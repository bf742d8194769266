"""The open loop of section 5.2.1 behind backlash: parts and second ways that several places share."""

from __future__ import annotations

import math

import numpy as np

from report.claim import Confirmation, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.drive_amplitudes import SAMPLES, AmplitudeRun
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from report.numbers.reference_loop import GAP
from trimmer import frequency_response
from trimmer.elements.friction_backlash import FrictionBacklash

LOOP_CLOSED = "the output is fed back: the loop of figure 2.5 with the drive as its reference, e = r - y"
PRINTED_SIZE = 0.001
"""Printed size of the output, m."""
ABOUT = 0.1
"""Share by which an approximate size may be off."""
REPEATS = 1e-6
"""Share of the output by which two periods that are alike may differ."""
NEAR = 2.0
"""Distance from the limit cycle's frequency at which a line may still be said to be at it, Hz."""


def open_loop(evidence: Evidence) -> AmplitudeRun:
    """Return the settled open loop of the section."""
    runs = evidence.motion.drive_amplitudes
    return next(run for run in runs if run.amplitude == DRIVE_AMPLITUDE)


def harmonic_in_open_loop(evidence: Evidence, order: int) -> Confirmation:
    """Confirm a harmonic of the settled open loop without simulation."""
    element = FrictionBacklash(GAP).describing_function(DRIVE_AMPLITUDE, harmonic=order)
    omega = 2 * math.pi * order * DRIVE_FREQUENCY
    response = complex(frequency_response(evidence.numbers.displacement_only, omega))
    return Confirmation(
        f"harmonic {order} by describing function and frequency response",
        CloseNumbers(
            DRIVE_AMPLITUDE * abs(complex(element) * response),
            float(open_loop(evidence).harmonics[order]),
            1e-4,
        ),
    )


def open_loop_repeats(evidence: Evidence) -> Confirmation:
    """Confirm by simulation that the open loop ends with the period of its drive."""
    runs = evidence.motion.drive_amplitudes
    periods = [(run.output[:SAMPLES], run.output[SAMPLES:]) for run in runs]
    return second_way(
        f"exact simulation with {len(runs)} drives, of which the last two periods are alike",
        all(abs(second - first).max() <= REPEATS * abs(second).max() for first, second in periods),
    )


def size_part(evidence: Evidence, label: str) -> Part:
    """Return the part on the size of the output, which the open loop exceeds and the closed one has."""
    opened, closed = open_loop(evidence), evidence.motion.closed.reference.from_rest
    largest = float(np.abs(opened.output).max())
    return Part(
        label,
        Assertion(
            statement="the output of the open loop goes from about -0.001 to 0.001 m",
            derived=_about(largest),
            evidence=(
                f"it goes to ±{1e3 * largest:.3f} mm; the loop with the drive as reference goes to "
                f"±{1e3 * closed.largest:.3f} mm"
            ),
            method="exact simulation, 1.5 mm at 100 Hz, gap 40 µm: open loop settled, closed loop from rest",
        ),
        harmonic_in_open_loop(evidence, 1),
        Slip(LOOP_CLOSED, _about(closed.largest), Verdict.ERRATUM),
    )


def _about(largest: float) -> bool:
    return abs(largest - PRINTED_SIZE) < ABOUT * PRINTED_SIZE


def line_part(evidence: Evidence, label: str) -> Part:
    """Return the part on the line at the limit cycle's frequency, which only the closed loop has."""
    opened, closed = open_loop(evidence), evidence.motion.closed.reference.from_rest
    cycle = evidence.motion.closed.orbits.friction.stable
    nearest = DRIVE_FREQUENCY * round(cycle.frequency / DRIVE_FREQUENCY)
    order = round(nearest / DRIVE_FREQUENCY)
    decay = max(mode.eigenvalue.real for mode in evidence.numbers.modes)
    return Part(
        label,
        Assertion(
            statement="the open loop has a line at the frequency of the limit cycle",
            derived=decay >= 0 or abs(nearest - cycle.frequency) < NEAR,
            evidence=(
                "backlash repeats with the drive, and behind it every free motion decays as "
                f"$e^{{{decay:.0f}\\,t}}$ or faster: what stays are multiples of 100 Hz, the nearest at "
                f"{nearest:.0f} Hz with {1e6 * opened.harmonics[order]:.1f} µm. With the drive as reference "
                f"there is one at {closed.frequency:.2f} Hz with {1e6 * closed.line:.0f} µm"
            ),
            method="periodic input of a stable linear system; exact simulation",
        ),
        harmonic_in_open_loop(evidence, order),
        Slip(LOOP_CLOSED, abs(closed.frequency - cycle.frequency) < NEAR, Verdict.ERRATUM),
    )
