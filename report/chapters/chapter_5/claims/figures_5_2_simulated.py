"""Claims on the figures of section 5.2 that show simulations of backlash: 5.7, 5.9, 5.11, 5.12 and 5.14."""

from __future__ import annotations

import math

from report.chapters.chapter_5.claims.driven_open_loop import line_part, size_part
from report.chapters.chapter_5.claims.section_5_2_1 import LARGE_GAP, ROUNDED, SMALL_GAP
from report.chapters.chapter_5.claims.section_5_2_1_impulse import one_impulse_part
from report.chapters.chapter_5.claims.section_5_2_1_simulated import SECOND_WAY, peak_part
from report.chapters.chapter_5.claims.section_5_2_2_simulated import largest_other_line, peak_parts
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power_of
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from trimmer.balance.leakage import harmonic_leakage
from trimmer.elements.friction_backlash import FrictionBacklash

ORBITS, DRIVEN = "report/numbers/exact_orbits.py", "report/numbers/reference_loop.py"
STANDS_OUT = 0.01
"""Share of the largest line below which another does not show beside it."""
UNIT = 1e-8
"""Unit of the last digit of the reading 3.303e-5, m."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _three_gaps(evidence),
        _small_gap(evidence),
        _driven_response(evidence),
        _driven_spectrum(evidence),
        _inertia(evidence),
    )


def larger_gap_parts(evidence: Evidence) -> tuple[Part, ...]:
    """Return the parts on the right half of figure 5.10, the time response for 40 µm."""
    orbit = evidence.motion.closed.orbits.friction.stable
    return (
        Part(
            "b: time response",
            Assertion(
                statement="an oscillation sustains itself",
                derived=orbit.stable,
                evidence=(
                    f"{1e6 * LARGE_GAP * orbit.amplitude:.2f} µm at {orbit.frequency:.2f} Hz; the motion is "
                    "that of figure 5.9, ten times as large"
                ),
                method="Floquet multipliers of the exact orbit",
            ),
            Confirmation(
                "a motion that starts 0.1 % outside of the unstable orbit and ends on this one",
                CloseNumbers(evidence.motion.closed.orbits.left_by[1], orbit.amplitude, 1e-5),
            ),
        ),
    )


def _three_gaps(evidence: Evidence) -> Claim:
    numbers = evidence.motion.closed.impulses
    strong = [run for run in numbers.runs if run.impulse == numbers.runs[0].impulse]
    sizes = [run.amplitude / run.gap for run in strong]
    return Claim(
        id="fig-5.7",
        parts=(
            one_impulse_part(evidence),
            Part(
                "from top to bottom",
                Assertion(
                    statement="what goes on grows faster than the gap",
                    derived=max(sizes) / min(sizes) > 1.1,
                    evidence=(
                        "after "
                        f"{power_of(strong[0].impulse)} m s it is "
                        + ", ".join(f"{1e9 * run.amplitude:.1f} nm" for run in strong)
                        + f", {sizes[0]:.3f} gaps each"
                    ),
                    method="exact simulation of the three gaps with one impulse",
                ),
                Confirmation(
                    "the exact orbit, by shooting",
                    CloseNumbers(evidence.motion.closed.orbits.friction.stable.amplitude, sizes[0], 1e-4),
                ),
            ),
        ),
        explanation=(
            "The three panels can only be one curve at three scales; if one of them dies out after the same "
            "impulse as the others, it is that of the largest gap. A panel without oscillation, one with a "
            "little and one with a clear one, in this order, do not follow from the model. Three amplitudes "
            "of 1 : 2 : 3 on one scale may look like it."
        ),
        consequence="The threshold of $2\\times10^{-8}$ m has no support in simulation.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/impulse_response.py",
    )


def _others_by_balance(evidence: Evidence) -> Confirmation:
    """Confirm by the element's harmonics that none stands out beside the first."""
    leakage = harmonic_leakage(
        evidence.numbers.displacement_only, FrictionBacklash(1.0), evidence.cycles.friction.stable
    )
    return second_way(
        f"the element's harmonics times the response, at most {100 * max(leakage):.2f} %",
        max(leakage) < STANDS_OUT,
    )


def _small_gap(evidence: Evidence) -> Claim:
    orbits = evidence.motion.closed.orbits
    exact, rounded = (
        SMALL_GAP * pair.stable.amplitude for pair in (orbits.friction, orbits.friction_listing)
    )
    second = Confirmation(SECOND_WAY, CloseNumbers(SMALL_GAP * orbits.friction_by_durations[0], exact))
    return Claim(
        id="fig-5.9",
        parts=(
            Part(
                "a: upper reading",
                PrintedDigits("3.303e-5", exact, "m"),
                second,
                Slip(
                    f"{ROUNDED}, and the last digit is cut off",
                    UNIT * math.floor(rounded / UNIT),
                    Verdict.EXPLAINED,
                ),
            ),
            Part("a: lower reading", PrintedDigits("-3.2961e-5", -exact, "m"), second),
            peak_part(orbits, "b: peak"),
            _one_peak(evidence),
        ),
        explanation=(
            "The exact oscillation is its own mirror image half a period later, so both readings should be "
            f"{power_of(exact, 4)} m. The upper one is what rounded coefficients give, "
            f"{power_of(rounded, 4)} m, cut after four digits; the lower one is 0.2 % smaller and misses the "
            "peak, or the motion had not settled. That one line stands out is right: this limit cycle is "
            "nearly a sine."
        ),
        consequence="The amplitude of the simulation is 0.5 % off, more than the prediction that it tests.",
        impact=Impact.LOCAL,
        source=ORBITS,
    )


def _one_peak(evidence: Evidence) -> Part:
    sizes = abs(evidence.motion.closed.orbits.friction.stable.harmonics)
    return Part(
        "b: number of peaks",
        Assertion(
            statement="a single peak stands out",
            derived=bool(sizes[1:].max() < STANDS_OUT * sizes[0]),
            evidence=(
                f"the next one, the third harmonic, has {100 * sizes[2] / sizes[0]:.2f} % of the first"
            ),
            method="Fourier coefficients of the exact orbit",
        ),
        _others_by_balance(evidence),
    )


def _driven_response(evidence: Evidence) -> Claim:
    closed = evidence.motion.closed.reference.from_rest
    return Claim(
        id="fig-5.11",
        parts=(size_part(evidence, "output of the linear block"),),
        explanation=(
            "The figure as the text describes it, ±1 mm with a strong faster oscillation, is that of the "
            f"loop with the drive as its reference: {1e3 * closed.base:.2f} mm at 100 Hz and "
            f"{1e3 * closed.line:.2f} mm at {closed.frequency:.1f} Hz. Behind an open loop the output is the "
            "drive, with harmonics of one percent."
        ),
        consequence="It is no picture of the driven trimmer, whose output is not fed back to the pin.",
        impact=Impact.DOWNSTREAM,
        source=DRIVEN,
    )


def _driven_spectrum(evidence: Evidence) -> Claim:
    sizes = abs(evidence.motion.closed.orbits.friction.stable.harmonics)
    return Claim(
        id="fig-5.12",
        parts=(
            Part(
                "a: closed loop",
                Assertion(
                    statement="one line stands out, that of the limit cycle",
                    derived=bool(sizes[1:].max() < STANDS_OUT * sizes[0]),
                    evidence=f"all others have less than {100 * sizes[1:].max() / sizes[0]:.2f} % of it",
                    method="Fourier coefficients of the exact orbit",
                ),
                _others_by_balance(evidence),
            ),
            line_part(evidence, "b: the second line of the driven loop"),
        ),
        explanation=(
            "Part a is right. Part b is called open loop, but its second line, at the limit cycle's "
            "frequency, needs the output to be fed back. The gaps of the two parts differ by a factor of "
            "ten, which changes nothing in frequency."
        ),
        consequence="The two configurations are not equivalent, as the text concludes from this figure.",
        impact=Impact.DOWNSTREAM,
        source=DRIVEN,
    )


def _inertia(evidence: Evidence) -> Claim:
    read, size = largest_other_line(evidence.motion.closed.timed_block)
    return Claim(
        id="fig-5.14",
        parts=peak_parts(evidence),
        explanation=(
            "As for friction-controlled backlash, what is printed belongs to a closed loop with the drive as "
            f"reference, here with Listing A.8's block in it: beside multiples of 100 Hz its largest line is "
            f"in the bin at {read:.1f} Hz, with {1e6 * size:.0f} µm. In open loop there is none at all."
        ),
        consequence="See the peak at 659 Hz in section 5.2.2.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/timed_block.py",
    )
