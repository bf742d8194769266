"""Claim of chapter 7 on the amplitude of the input."""

from __future__ import annotations

import math

import numpy as np

from report.chapters.chapter_5.claims.driven_open_loop import open_loop_repeats
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from trimmer import frequency_response
from trimmer.elements.friction_backlash import FrictionBacklash

OPEN_LOOP_GAP = 4e-5
DRIVE_AMPLITUDES = (0.0005, DRIVE_AMPLITUDE, 0.003)
TURN = 2 * math.pi
FIFTH = 5


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_input_amplitude(evidence),)


def harmonic_of_output(evidence: Evidence, amplitude: float, frequency: float, harmonic: int) -> float:
    """Return the amplitude of a harmonic behind backlash and linear part in open loop, m."""
    gain = FrictionBacklash(OPEN_LOOP_GAP).describing_function(amplitude, harmonic=harmonic)
    response = frequency_response(evidence.numbers.displacement_only, TURN * harmonic * frequency)
    return float(amplitude * abs(gain * response))


def _input_amplitude(evidence: Evidence) -> Claim:
    fifth = [harmonic_of_output(evidence, a, DRIVE_FREQUENCY, 5) for a in DRIVE_AMPLITUDES]
    return Claim(
        id="txt-7-input-amplitude",
        parts=(
            _open_loop(evidence),
            _dependence(evidence, fifth),
        ),
        explanation=(
            "In open loop nothing is fed back, so there is no limit cycle that could keep its amplitude: "
            "what is seen are harmonics of the drive. Scaling shows what they may depend on: input and gap "
            "times one factor give the output times that factor, so an output that did not depend on the "
            "input would be proportional to the gap. That is the limit for an input much larger than the "
            "gap, where backlash adds nearly a square wave of half the gap; from 1.5 to 3 mm the fifth "
            f"harmonic grows by {100 * (fifth[2] / fifth[1] - 1):.1f} %, which is easily taken for nothing."
        ),
        consequence=(
            "The answer holds as an approximation for wide strokes. It says nothing on a limit cycle under a "
            "drive in closed loop, which this method with one sinusoid does not reach."
        ),
        impact=Impact.LOCAL,
        source="trimmer/elements/friction_backlash.py",
    )


def by_simulation(evidence: Evidence, fifth: float) -> Confirmation:
    """Confirm the fifth harmonic for a drive of 1.5 mm and 100 Hz, m."""
    run = next(run for run in evidence.motion.drive_amplitudes if run.amplitude == DRIVE_AMPLITUDE)
    return Confirmation(
        "exact simulation with 1.5 mm and 100 Hz", CloseNumbers(float(run.harmonics[FIFTH]), fifth, 1e-4)
    )


def _dependence(evidence: Evidence, fifth: list[float]) -> Part:
    below = FrictionBacklash(OPEN_LOOP_GAP).describing_function(0.49 * OPEN_LOOP_GAP)
    return Part(
        "what it depends on",
        Assertion(
            statement="the amplitude of the input has no effect on the oscillation that is left",
            derived=max(fifth) / min(fifth) < 1.001 and not np.isnan(below),
            evidence=(
                "for a gap of 40 µm the fifth harmonic of the output is "
                + ", ".join(f"{1e6 * a:.2f} µm" for a in fifth)
                + " for inputs of "
                + ", ".join(f"{1e3 * a:.1f} mm" for a in DRIVE_AMPLITUDES)
                + "; below half of the gap there is no output at all"
            ),
            method="fifth harmonic of the derived element times the response of $G$",
        ),
        by_simulation(evidence, fifth[1]),
    )


def _open_loop(evidence: Evidence) -> Part:
    decay = max(mode.eigenvalue.real for mode in evidence.numbers.modes)
    return Part(
        "what oscillates in open loop",
        Assertion(
            statement="besides the drive and its harmonics a limit cycle goes on",
            derived=decay >= 0,
            evidence=(
                "the backlash repeats with the drive's period, and behind it every free motion of "
                f"the linear part decays as $e^{{{decay:.1f}\\,t}}$ or faster"
            ),
            method="periodic input of a stable linear system",
        ),
        open_loop_repeats(evidence),
    )
