"""The findings that change most for somebody who builds on the thesis, each with its size."""

from __future__ import annotations

import math

from report.claims.section_5_1_2 import CUTTER, GUARD
from report.claims.section_5_1_2_low_pass import HARMONICS, LIMIT_CYCLE_OMEGA, highest_unfiltered
from report.document import Highlight
from report.evidence import Evidence
from report.limit_cycle_numbers import LimitCycleNumbers
from report.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY
from trimmer import (
    asymptotic_roll_off,
    bandwidth_crossings,
    filtering_ratio,
    gain_crossings,
)


def highlights(evidence: Evidence) -> tuple[Highlight, ...]:
    """Return the findings that matter most, most important first."""
    numbers = evidence.numbers
    system = numbers.displacement_only
    fifth = [
        float(filtering_ratio(system, 2 * math.pi * drive, 5))
        for drive in (DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY)
    ]
    cutoff, unity = bandwidth_crossings(system), gain_crossings(system)[-1]
    static, printed_static = (
        float(numerator[-1] / numbers.denominator[-1])
        for numerator in (numbers.numerator, numbers.combined_numerator({CUTTER: 1, GUARD: 1}))
    )
    return (
        *_about_limit_cycles(evidence.cycles),
        Highlight(
            "txt-5.1.3-first-resonance",
            "Resonances matter although the drive is far below them: its harmonics are passed better than "
            "the drive itself.",
            f"the fifth {fifth[0]:.1f} times better at {DRIVE_FREQUENCY:.0f} Hz; it would be {fifth[1]:.0f} "
            f"times at {MEASURED_DRIVE_FREQUENCY} Hz, the measured drive",
        ),
        Highlight(
            "txt-5.1.2-filtering",
            "The filtering hypothesis holds near the predicted limit cycle, not at every frequency.",
            f"fails below {highest_unfiltered(system, HARMONICS):.0f} Hz; at 733 Hz the third harmonic is "
            f"passed {float(filtering_ratio(system, LIMIT_CYCLE_OMEGA, 3)):.3f} times as well",
        ),
        Highlight(
            "txt-5.1.2-roll-off",
            "The linear part is a low-pass filter of second order, not of first.",
            f"−{-asymptotic_roll_off(system):.0f} dB per decade instead of −20",
        ),
        Highlight(
            "txt-5.1.2-cutoff",
            "The quoted cutoff is the frequency of unit gain.",
            f"{unity:.1f} rad/s; the gain is 3 dB down at {cutoff[0]:.1f} and finally at "
            f"{cutoff[-1]:.1f} rad/s",
        ),
        Highlight(
            "eq-5.1",
            "The printed transfer function mixes two outputs and loses powers of ten.",
            f"static gain {printed_static:.4f} instead of {static:.4f}",
        ),
        Highlight(
            "eq-2.8",
            "The pin's velocity loses its amplitude.",
            f"{1 / DRIVE_AMPLITUDE:.0f} times too large at 1.5 mm; neither figure 5.1 nor the loop uses it",
        ),
        Highlight(
            "fig-5.1",
            "Started from rest, the output does not follow the pin precisely.",
            f"off by {100 * numbers.start.deviation / DRIVE_AMPLITUDE:.0f} % of the amplitude in the "
            "first period",
        ),
    )


def _about_limit_cycles(cycles: LimitCycleNumbers) -> tuple[Highlight, ...]:
    friction, both = cycles.friction.stable, cycles.friction_both_channels.stable
    inertia = cycles.inertia.stable
    return (
        Highlight(
            "txt-6-threshold",
            "No gap is small enough to exclude the predicted limit cycle; the threshold of 2e-8 m is an "
            "effect of the plotted range.",
            f"amplitude {friction.amplitude:.2f} times the gap, for every gap",
        ),
        Highlight(
            "lst-A.1",
            "The velocity of the pin, which the thesis's loop leaves out, changes the predicted limit cycle.",
            f"amplitude {both.amplitude:.2f} times the gap with it, "
            f"{100 * (1 - both.amplitude / friction.amplitude):.0f} % less; {both.frequency:.1f} instead of "
            f"{friction.frequency:.1f} Hz",
        ),
        Highlight(
            "txt-5.2.2-prediction",
            "The prediction for inertia-controlled backlash is wrong, and with it the band of frequencies.",
            f"{inertia.frequency:.1f} Hz instead of 814.9 Hz; the band is "
            f"{inertia.frequency - friction.frequency:.0f} Hz wide, not 82",
        ),
        Highlight(
            "txt-5.2.5-coulomb-term",
            "The friction term of the equivalent nonlinearity has the wrong sign, factor and unit.",
            "friction feeds the oscillation where it should damp it; no contour of section 5.2.5 stands",
        ),
    )
