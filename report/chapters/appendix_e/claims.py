"""Claims on figures E.1 and E.2: the closed loop for several gaps, the open loop for several amplitudes."""

from __future__ import annotations

import math

import numpy as np

from report.chapters.chapter_3.claims.driven_steady_motion import (
    METHOD,
    confirm_period,
    has_the_drives_period,
)
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.drive_amplitudes import GAP, AmplitudeRun
from report.numbers.linear_numbers import DRIVE_FREQUENCY
from report.numbers.released_motion import ReleasedRun
from trimmer import frequency_response
from trimmer.elements.friction_backlash import FrictionBacklash

PREDICTED = {3e-4: "0.0025", 4e-4: "0.0033", 5e-4: "0.0041", 6e-4: "0.0050"}
"""Amplitudes of table 5.2 for the gaps of figure E.1, m."""
ALIKE = 1e-9
CONSTANT = 0.05
"""Share by which a ripple may change and still be called unaltered."""
SEVENTH = 7
HARMONICS = np.arange(3, 80, 2)
PHASES = 2**13
UNALTERED = "the amplitude of the drive does not alter it"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_gaps(evidence), _amplitudes(evidence))


def _gaps(evidence: Evidence) -> Claim:
    runs = evidence.motion.released.appendix
    cycle, orbits = evidence.cycles.friction.stable, evidence.motion.closed.orbits
    frequencies = [run.frequency for run in runs]
    spread = max(frequencies) / min(frequencies) - 1
    return Claim(
        id="fig-E.1",
        parts=(
            *(_amplitude(run, cycle.amplitude) for run in runs),
            Part(
                "frequencies",
                Assertion(
                    statement="all four have the same frequency",
                    derived=spread < ALIKE,
                    evidence=(
                        f"{frequencies[0]:.2f} Hz in each; the prediction without rounded coefficients is "
                        f"{cycle.frequency:.2f} Hz"
                    ),
                    method="exact simulation",
                ),
                Confirmation(
                    "the exact orbit by two durations, with SciPy's matrix exponential",
                    CloseNumbers(orbits.friction_by_durations[1], frequencies[0], 1e-5),
                ),
            ),
        ),
        explanation=(
            f"The exact amplitude is {runs[0].amplitude / runs[0].gap:.4f} gaps, the predicted one "
            f"{cycle.amplitude:.4f}; to the digits of table 5.2 they are the same. That all four are alike "
            "is no further evidence: gap and displacements times one factor give the same motion. The "
            "reference of the text to the table is broken (??)."
        ),
        source="report/numbers/released_motion.py",
    )


def _amplitude(run: ReleasedRun, predicted: float) -> Part:
    return Part(
        f"amplitude for $b$ = {run.gap:g} m, as in table 5.2",
        PrintedDigits(PREDICTED[run.gap], run.amplitude, "m"),
        Confirmation("harmonic balance", CloseNumbers(predicted * run.gap, run.amplitude, 0.005)),
    )


def _harmonic(evidence: Evidence, run: AmplitudeRun, order: int) -> complex:
    """Return a harmonic of the output from describing function and response, m."""
    element = FrictionBacklash(GAP).describing_function(run.amplitude, harmonic=order)
    omega = 2 * math.pi * DRIVE_FREQUENCY * order
    gain = frequency_response(evidence.numbers.displacement_only, omega)
    return complex(element) * complex(gain) * run.amplitude


def _ripple(evidence: Evidence, run: AmplitudeRun) -> float:
    """Return half of peak to peak of the harmonics from the third on, m."""
    phases = 2 * math.pi * np.arange(PHASES) / PHASES
    lines = np.fft.rfft(FrictionBacklash(GAP).waveform(phases, run.amplitude))
    passed = np.zeros_like(lines)
    omegas = 2 * math.pi * DRIVE_FREQUENCY * HARMONICS
    passed[HARMONICS] = lines[HARMONICS] * frequency_response(evidence.numbers.displacement_only, omegas)
    return float(np.ptp(np.fft.irfft(passed))) / 2


def _unaltered(ripples: list[float]) -> bool:
    return max(ripples) - min(ripples) < CONSTANT * max(ripples)


def _amplitudes(evidence: Evidence) -> Claim:
    _, *moving = evidence.motion.drive_amplitudes
    largest = moving[-1]
    ripples = [run.ripple for run in moving]
    return Claim(
        id="fig-E.2",
        parts=(
            _all_amplitudes(evidence),
            Part(
                "the same, from $1.5\\times10^{-3}$ m on",
                Assertion(
                    statement=UNALTERED,
                    derived=_unaltered(ripples[1:]),
                    evidence=f"it changes by {100 * (1 - ripples[1] / ripples[-1]):.1f} %",
                    method="exact simulation from rest",
                ),
                Confirmation(
                    "the seventh harmonic from describing function and frequency response",
                    CloseNumbers(
                        abs(_harmonic(evidence, moving[1], SEVENTH)), moving[1].harmonics[SEVENTH], 1e-4
                    ),
                ),
            ),
            _nature(evidence),
        ),
        explanation=(
            "A drive far larger than the gap leaves behind the play a square wave of half a gap that does "
            f"not depend on its amplitude, so the ripple tends to {1e6 * largest.ripple:.1f} µm. That "
            "explains the observation without a limit cycle, of which the open loop has none. At 0.15 mm it "
            f"is {100 * (1 - ripples[0] / ripples[-1]):.0f} % smaller, and at 1.5 µm nothing moves."
        ),
        consequence=(
            "The answer of chapter 7, that the drive's amplitude has no effect on a limit cycle, rests on "
            "harmonics."
        ),
        impact=Impact.DOWNSTREAM,
        source="report/numbers/drive_amplitudes.py",
    )


def _all_amplitudes(evidence: Evidence) -> Part:
    still, *moving = evidence.motion.drive_amplitudes
    shown = ", ".join(f"{1e6 * run.ripple:.1f} µm at {1e3 * run.amplitude:g} mm" for run in moving)
    return Part(
        "oscillation on top of the drive's, all five amplitudes",
        Assertion(
            statement=UNALTERED,
            derived=_unaltered([still.ripple, *(run.ripple for run in moving)]),
            evidence=(
                f"at {1e6 * still.amplitude:.1f} µm the pin stays within its play of {1e6 * GAP:.0f} "
                "µm and nothing moves; above it half of peak to peak without the first harmonic is "
                f"{shown}"
            ),
            method="exact simulation from rest",
        ),
        Confirmation(
            f"{HARMONICS.size} lines of the element's waveform times the response, at 0.15 mm",
            CloseNumbers(_ripple(evidence, moving[0]), moving[0].ripple, 0.001),
        ),
    )


def _nature(evidence: Evidence) -> Part:
    return Part(
        "what it is",
        Assertion(
            statement="it is a limit cycle",
            derived=not has_the_drives_period(evidence),
            evidence=(
                "it consists of odd harmonics of the drive; far above the gap the play gives the "
                "pin's motion less a square wave of half a gap, whatever the amplitude"
            ),
            method=METHOD,
        ),
        confirm_period(evidence),
    )
