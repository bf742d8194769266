"""The driven open loop behind backlash: parts and second ways for section 5.2, its figures and chapter 7."""

from __future__ import annotations

import numpy as np

from report.claim import Confirmation, Part
from report.evidence import Evidence
from report.numbers.drive_amplitudes import SAMPLES, AmplitudeRun
from report.numbers.independent.harmonics import harmonic_behind
from report.numbers.record import change
from report.parts import assertion, close, made_here, so
from report.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA, LARGE_GAP
from trimmer import FrictionBacklash

LOOP_CLOSED = "the output is fed back: the loop of figure 2.5 with the drive as its reference, e = r - y"
PRINTED_SIZE = 1.0
"""Printed size of the output, mm."""
ABOUT = 0.1
"""Share by which an approximate size may be off."""
REPEATS = 1e-6
"""Share of the output by which two periods that are alike may differ."""
NEAR = 2.0
"""Distance from the limit cycle's frequency at which a line may still be said to be at it, Hz."""


def open_loop(known: Evidence) -> AmplitudeRun:
    """Return the settled open loop of the section."""
    return next(run for run in known.motion.drive_amplitudes if run.amplitude == DRIVE_AMPLITUDE)


def open_loop_harmonic(
    known: Evidence, order: int, amplitude: float = DRIVE_AMPLITUDE, omega: float = DRIVE_OMEGA
) -> float:
    """Return the amplitude of a harmonic of the open loop without simulation, m, for a drive (m, rad/s)."""
    element = FrictionBacklash(LARGE_GAP)
    return harmonic_behind(known.numbers.displacement_only, element, amplitude, omega, order)


def harmonic_in_open_loop(known: Evidence, order: int) -> Confirmation:
    """Confirm a harmonic of the settled open loop without simulation."""
    by_balance, simulated = open_loop_harmonic(known, order), open_loop(known).harmonics[order]
    means = f"harmonic {order} by describing function and frequency response"
    return close(means, by_balance, float(simulated), 1e-4)


def open_loop_repeats(known: Evidence) -> Confirmation:
    """Confirm by simulation that the open loop ends with the period of its drive."""
    runs = known.motion.drive_amplitudes
    periods = [(run.output[:SAMPLES], run.output[SAMPLES:]) for run in runs]
    return so(
        f"exact simulation with {len(runs)} drives, of which the last two periods are alike",
        all(change(first, second) <= REPEATS for first, second in periods),
    )


def size_part(known: Evidence, label: str) -> Part:
    """Return the part on the size of the output, which the open loop exceeds and the closed one has."""
    opened = 1e3 * float(np.abs(open_loop(known).output).max())
    closed = 1e3 * known.motion.closed.reference.from_rest.largest
    by_opened, by_closed = (abs(size - PRINTED_SIZE) < ABOUT * PRINTED_SIZE for size in (opened, closed))
    return assertion(
        label,
        "the output of the open loop goes from about -0.001 to 0.001 m",
        by_opened,
        f"it goes to ±{opened:.3f} mm; the loop with the drive as reference goes to ±{closed:.3f} mm",
        method="exact simulation, 1.5 mm at 100 Hz, gap 40 µm: open loop settled, closed loop from rest",
        second=harmonic_in_open_loop(known, 1),
        slip=made_here(LOOP_CLOSED, by_closed),
    )


def line_part(known: Evidence, label: str) -> Part:
    """Return the part on the line at the limit cycle's frequency, which only the closed loop has."""
    opened, closed = open_loop(known), known.motion.closed.reference.from_rest
    cycle = known.orbits.friction.stable
    order = round(cycle.frequency / DRIVE_FREQUENCY)
    nearest = DRIVE_FREQUENCY * order
    decay = max(mode.eigenvalue.real for mode in known.numbers.modes)
    return assertion(
        label,
        "the open loop has a line at the frequency of the limit cycle",
        decay >= 0 or abs(nearest - cycle.frequency) < NEAR,
        r"""
        backlash repeats with the drive, and behind it every free motion decays as $e^{[[ decay | f0 ]]\,t}$
        or faster: what stays are multiples of 100 Hz, the nearest at [[ nearest | f0 ]] Hz with
        [[ size | f1 ]] µm. With the drive as reference there is one at [[ frequency | f2 ]] Hz with
        [[ line | f0 ]] µm
        """,
        numbers={
            "decay": decay,
            "nearest": nearest,
            "size": 1e6 * opened.harmonics[order],
            "frequency": closed.frequency,
            "line": 1e6 * closed.line,
        },
        method="periodic input of a stable linear system; exact simulation",
        second=harmonic_in_open_loop(known, order),
        slip=made_here(LOOP_CLOSED, abs(closed.frequency - cycle.frequency) < NEAR),
    )
