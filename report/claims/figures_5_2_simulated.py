"""Claims on the figures of section 5.2 that show simulations: 5.7, 5.9, 5.11, 5.12, 5.14, 5.19 and 5.20."""

from __future__ import annotations

import math

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.claims.second_ways import by_harmonics
from report.claims.section_5_2_1 import LARGE_GAP, ROUNDED, SMALL_GAP
from report.claims.section_5_2_1_driven import line_part, size_part
from report.claims.section_5_2_1_impulse import one_impulse_part
from report.claims.section_5_2_1_simulated import SECOND_WAY, peak_part
from report.claims.section_5_2_2_simulated import largest_other_line, peak_parts
from report.claims.section_5_2_4_simulated import candidates_part, friction_part, relay_part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.relay_loop import VISCOUS

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
        _relay(evidence),
        _relay_and_viscous(evidence),
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
                        f"{strong[0].impulse:.0e} m s it is "
                        + ", ".join(f"{1e9 * run.amplitude:.1f} nm" for run in strong)
                        + f", {sizes[0]:.3f} gaps each"
                    ),
                    method="exact simulation of the three gaps with one impulse",
                ),
            ),
        ),
        explanation=(
            "The three panels can only be one curve at three scales; if one of them dies out after the same "
            "impulse as the others, it is that of the largest gap. A panel without oscillation, one with a "
            "little and one with a clear one, in this order, do not follow from the model. Three amplitudes "
            "of 1 : 2 : 3 on one scale may look like it."
        ),
        consequence="The threshold of 2e-8 m has no support in simulation.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/impulse_response.py",
    )


def _small_gap(evidence: Evidence) -> Claim:
    orbits = evidence.motion.closed.orbits
    exact, rounded = (
        SMALL_GAP * pair.stable.amplitude for pair in (orbits.friction, orbits.friction_listing)
    )
    second = Confirmation(SECOND_WAY, CloseNumbers(SMALL_GAP * orbits.friction_by_durations[0], exact))
    sizes = abs(orbits.friction.stable.harmonics)
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
            Part(
                "b: number of peaks",
                Assertion(
                    statement="a single peak stands out",
                    derived=bool(sizes[1:].max() < STANDS_OUT * sizes[0]),
                    evidence=(
                        f"the next one, the third harmonic, has {100 * sizes[2] / sizes[0]:.2f} % of the "
                        "first"
                    ),
                    method="Fourier coefficients of the exact orbit",
                ),
            ),
        ),
        explanation=(
            "The exact oscillation is its own mirror image half a period later, so both readings should be "
            f"{exact:.4e} m. The upper one is what rounded coefficients give, {rounded:.4e} m, cut after "
            "four digits; the lower one is 0.2 % smaller and misses the peak, or the motion had not settled. "
            "That one line stands out is right: this limit cycle is nearly a sine."
        ),
        consequence="The amplitude of the simulation is 0.5 % off, more than the prediction that it tests.",
        impact=Impact.LOCAL,
        source=ORBITS,
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


def _relay(evidence: Evidence) -> Claim:
    numbers = evidence.motion.closed.relay
    return Claim(
        id="fig-5.19",
        parts=(relay_part(numbers, "relay of 0.015 in the loop"), _relay_in_open_loop(evidence)),
        explanation=(
            "The caption says open loop, the text feedback; neither has a limit cycle. Behind a relay in "
            "open loop stand odd multiples of the drive. In the loop the relay oscillates ever faster with "
            "ever smaller swings, so a simulation ends with what its step or tolerance leaves."
        ),
        consequence="See the high frequency in section 5.2.4.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/relay_loop.py",
    )


def _relay_in_open_loop(evidence: Evidence) -> Part:
    decay = max(mode.eigenvalue.real for mode in evidence.numbers.modes)
    return Part(
        "in open loop, as the caption has it",
        Assertion(
            statement="an oscillation besides the drive's harmonics goes on",
            derived=decay >= 0,
            evidence=(
                "a relay turns a sine into a square wave of the same period, and behind it free motions "
                f"decay as $e^{{{decay:.0f}\\,t}}$ or faster"
            ),
            method="periodic input of a stable linear system",
        ),
    )


def _relay_and_viscous(evidence: Evidence) -> Claim:
    numbers = evidence.motion.closed.relay
    return Claim(
        id="fig-5.20",
        parts=(
            candidates_part(
                numbers.with_viscous,
                "the block on the output, as a relay with a gain of 0.1",
                "a periodic oscillation goes on",
                by_harmonics(evidence.numbers.displacement_only, numbers.with_viscous.frequencies, VISCOUS),
            ),
            friction_part(numbers, "the block on the output's velocity, as friction"),
        ),
        explanation=(
            "Which signal enters the block is not said. On the output it is a relay with a small gain, and "
            "there is no periodic motion; on its velocity it is friction, and the loop sticks or creeps to "
            "rest without oscillation. A lasting high frequency is again the simulation's own."
        ),
        consequence="The second simulation does not confirm the first.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/relay_loop.py",
    )
