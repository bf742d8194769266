"""The findings that change most for somebody who builds on the thesis, each with its size."""

from __future__ import annotations

import math

from report.chapters.chapter_5.claims.section_5_1_2 import CUTTER, GUARD
from report.chapters.chapter_5.claims.section_5_1_2_low_pass import (
    HARMONICS,
    LIMIT_CYCLE_OMEGA,
    highest_unfiltered,
)
from report.document import Highlight
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import LimitCycleNumbers
from report.numbers.linear_numbers import DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY
from trimmer import asymptotic_roll_off, filtering_ratio

EXPERIMENT_GAP = 2e-4
"""Gap of the experiment with play, m."""


def highlights(evidence: Evidence) -> tuple[Highlight, ...]:
    """Return the findings that matter most, most important first."""
    numbers = evidence.numbers
    system = numbers.displacement_only
    fifth = [
        float(filtering_ratio(system, 2 * math.pi * drive, 5))
        for drive in (DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY)
    ]
    static, printed_static = (
        float(numerator[-1] / numbers.denominator[-1])
        for numerator in (numbers.numerator, numbers.combined_numerator({CUTTER: 1, GUARD: 1}))
    )
    return (
        Highlight(
            "txt-5.2.1-open-loop-peak",
            "A trimmer that its pin drives has no limit cycle: a stable linear system behind play settles to "
            "the period of the drive.",
            "proven for any gap and any friction; the peaks read as limit cycles are harmonics of the drive, "
            "such as 550 Hz, five times 110 Hz, or modes that decay",
        ),
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
            "eq-5.1",
            "The printed transfer function mixes two outputs and loses powers of ten.",
            f"static gain {printed_static:.4f} instead of {static:.4f}",
        ),
    )


def _about_limit_cycles(cycles: LimitCycleNumbers) -> tuple[Highlight, ...]:
    friction, both = cycles.friction.stable, cycles.friction_both_channels.stable
    inertia, places = cycles.inertia.stable, cycles.equivalent
    thesis, both_ends = (
        branch.merger.force_per_gap * EXPERIMENT_GAP
        for branch in (places.in_place, places.in_place_both_channels)
    )
    return (
        Highlight(
            "txt-6-threshold",
            "No gap is small enough to exclude the predicted limit cycle; the threshold of $2\\times10^{-8}$ "
            "m is an effect of the plotted range.",
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
            "Friction has the wrong sign in equation 3.2 and in the equivalent nonlinearity, whose term has "
            "the wrong factor and unit too.",
            "it feeds the oscillation where it should damp it; no contour of section 5.2.5 stands",
        ),
        Highlight(
            "txt-5.2.5-prediction",
            "With friction in its place, between cutter and guard, the limit cycle ends when friction "
            "exceeds a force that grows with the gap.",
            f"for 0.2 mm {thesis:.2f} N in the thesis's loop, {both_ends:.2f} N with the pin's velocity; the "
            "thesis predicts 737.5 Hz where there is no limit cycle",
        ),
    )
