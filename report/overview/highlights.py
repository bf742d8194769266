"""The findings that change most for somebody who builds on the thesis, each with its size."""

from __future__ import annotations

from report.chapters.chapter_5.claims.section_5_1_2 import HARMONICS
from report.document import Highlight
from report.evidence import Evidence
from report.numbers.independent.linear_trimmer import highest_unfiltered
from report.text import filled
from report.thesis import DRIVE_FREQUENCY, EXPERIMENT_GAP, LIMIT_CYCLE_OMEGA, MEASURED_DRIVE_FREQUENCY, TURN
from trimmer import Body, asymptotic_roll_off, filtering_ratio


def highlights(known: Evidence) -> tuple[Highlight, ...]:
    """Return the findings that matter most, most important first."""
    cycles, numbers, system = known.cycles, known.numbers, known.numbers.displacement_only
    friction, both = cycles.friction.stable, cycles.friction_both_channels.stable
    inertia = cycles.inertia.stable.frequency
    band = inertia - friction.frequency
    in_place, in_place_both = cycles.equivalent.in_place, cycles.equivalent.in_place_both_channels
    at_drive, at_measured = (
        float(filtering_ratio(system, TURN * drive, 5))
        for drive in (DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY)
    )
    printed_sum = numbers.combined_numerator({Body.CUTTER.index: 1, Body.GUARD.index: 1})
    static, printed_static = (
        float(numerator[-1] / numbers.denominator[-1]) for numerator in (numbers.numerator, printed_sum)
    )
    return (
        _highlight(
            "txt-5.2.1-open-loop-peak",
            """
            A trimmer that its pin drives has no limit cycle: a stable linear system behind play settles to
            the period of the drive.
            """,
            """
            proven for any gap and any friction; the peaks read as limit cycles are harmonics of the drive,
            such as 550 Hz, five times 110 Hz, or modes that decay
            """,
        ),
        _highlight(
            "txt-6-threshold",
            r"""
            No gap is small enough to exclude the predicted limit cycle; the threshold of $2\times10^{-8}$ m
            is an effect of the plotted range.
            """,
            f"amplitude {friction.amplitude:.2f} times the gap, for every gap",
        ),
        _highlight(
            "lst-A.1",
            "The velocity of the pin, which the thesis's loop leaves out, changes the predicted limit cycle.",
            """
            amplitude [[ amplitude | f2 ]] times the gap with it, [[ less | f0 ]] % less; [[ frequency | f1 ]]
            instead of [[ without | f1 ]] Hz
            """,
            amplitude=both.amplitude,
            less=100 * (1 - both.amplitude / friction.amplitude),
            frequency=both.frequency,
            without=friction.frequency,
        ),
        _highlight(
            "txt-5.2.2-prediction",
            "The prediction for inertia-controlled backlash is wrong, and with it the band of frequencies.",
            f"{inertia:.1f} Hz instead of 814.9 Hz; the band is {band:.0f} Hz wide, not 82",
        ),
        _highlight(
            "txt-5.2.5-coulomb-term",
            """
            Friction has the wrong sign in equation 3.2 and in the equivalent nonlinearity, whose term has the
            wrong factor and unit too.
            """,
            "it feeds the oscillation where it should damp it; no contour of section 5.2.5 stands",
        ),
        _highlight(
            "txt-5.2.5-prediction",
            """
            With friction in its place, between cutter and guard, the limit cycle ends when friction exceeds a
            force that grows with the gap.
            """,
            """
            for 0.2 mm [[ thesis | f2 ]] N in the thesis's loop, [[ both | f2 ]] N with the pin's velocity;
            the thesis predicts 737.5 Hz where there is no limit cycle
            """,
            thesis=EXPERIMENT_GAP * in_place.merger.force_per_gap,
            both=EXPERIMENT_GAP * in_place_both.merger.force_per_gap,
        ),
        _highlight(
            "txt-5.1.3-first-resonance",
            """
            Resonances matter although the drive is far below them: its harmonics are passed better than the
            drive itself.
            """,
            """
            the fifth [[ at_drive | f1 ]] times better at [[ drive | f0 ]] Hz; it would be
            [[ at_measured | f0 ]] times at [[ measured ]] Hz, the measured drive
            """,
            at_drive=at_drive,
            drive=DRIVE_FREQUENCY,
            at_measured=at_measured,
            measured=MEASURED_DRIVE_FREQUENCY,
        ),
        _highlight(
            "txt-5.1.2-filtering",
            "The filtering hypothesis holds near the predicted limit cycle, not at every frequency.",
            """
            fails below [[ highest | f0 ]] Hz; at 733 Hz the third harmonic is passed [[ third | f3 ]] times
            as well
            """,
            highest=highest_unfiltered(system, HARMONICS),
            third=float(filtering_ratio(system, LIMIT_CYCLE_OMEGA, 3)),
        ),
        _highlight(
            "txt-5.1.2-roll-off",
            "The linear part is a low-pass filter of second order, not of first.",
            f"−{-asymptotic_roll_off(system):.0f} dB per decade instead of −20",
        ),
        _highlight(
            "eq-5.1",
            "The printed transfer function mixes two outputs and loses powers of ten.",
            f"static gain {printed_static:.4f} instead of {static:.4f}",
        ),
    )


def _highlight(claim: str, sentence: str, size: str, /, **numbers: object) -> Highlight:
    return Highlight(claim, filled(sentence), filled(size, **numbers))
