"""Claims of section 3.3 on the closed loop: the peak near 350 Hz, and what friction does to a limit cycle."""

from __future__ import annotations

import numpy as np
import sympy

from derivations.friction import FORCE
from report.chapters.chapter_3.claims.section_3_3_open_loop import OPEN_LOOP_PEAK
from report.claim import Claim, Confirmation, Impact, Number, Part, Uncheckable, Words
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.driven_motion import GAP, LARGEST_GAP
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, SCALE, released_peak

SOURCE = "report/numbers/released_motion.py"
PEAK, PREDICTED = "350", "488"
"""Peak of figure 3.9 for every gap, and the limit cycle predicted for the same trimmer in section 3.2, Hz."""
PEAK_DIGITS = "3.5e2"
"""The peak to the digits that "about 350" stands for."""
BIN = 10.0
"""Widest bin of the spectra of chapter 3, Hz."""
ALIKE = 1e-9
"""Relative difference of two motions that are alike but for their scale."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_peak(evidence), _suppression(evidence))


def _peak(evidence: Evidence) -> Claim:
    lasting = evidence.motion.released.released(GAP, FORCES_OF_FIGURE[0], OUTSIDE)
    return Claim(
        id="txt-3.3-peak-350",
        parts=(
            _peak_for_gap(evidence, GAP),
            _peak_for_gap(evidence, LARGEST_GAP),
            _only_limit_cycles(evidence),
            _prediction(),
            _open_loop(),
            Uncheckable(
                "which it is in the experiment's trimmer",
                Words("this peak belongs to a limit cycle"),
                "the parameters of that trimmer (table C.1), and from which state the loop was released",
            ),
        ),
        explanation=(
            "That a frequency does not depend on the gap says nothing: natural modes do not know the gap "
            "either. Released inside of its play the loop with Listing A.1 dies out, sooner with more "
            "friction, and has its peak at the second natural mode for either gap, which is how the figure "
            f"is described; released outside it goes on at {lasting.frequency:.0f} Hz. The thesis's own "
            f"prediction for its trimmer is {PREDICTED} Hz."
        ),
        consequence=(
            "The peak reads as a natural mode that is dying out. Chapter 7 takes from this section that "
            "friction suppresses limit cycles."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _peak_for_gap(evidence: Evidence, gap: float) -> Part:
    run = evidence.motion.released.released(gap, FORCES_OF_FIGURE[0], INSIDE)
    peak, mode = released_peak(run), evidence.numbers.modes[1]
    return Part(
        f"released inside of its play, gap {1e3 * gap:g} mm, {run.force} N",
        PrintedDigits(PEAK_DIGITS, peak, "Hz"),
        Confirmation("the second natural mode", CloseNumbers(mode.frequency, peak, 5e-3)),
        printed_form=Number(PEAK, "Hz"),
    )


def _only_limit_cycles(evidence: Evidence) -> Part:
    inside, outside = (
        [evidence.motion.released.released(gap, FORCES_OF_FIGURE[0], start) for gap in (GAP, LARGEST_GAP)]
        for start in (INSIDE, OUTSIDE)
    )
    shares = [released_peak(run) for run in inside]
    moved = abs(shares[1] - shares[0]) > BIN
    return Part(
        "why it should be a limit cycle",
        Assertion(
            statement="a frequency that does not depend on the gap belongs to a limit cycle",
            derived=moved or any(run.goes_on for run in inside),
            evidence=(
                f"inside of the play the peaks are at {shares[0]:.1f} and {shares[1]:.1f} Hz for gaps of 0.2 "
                f"and 20 mm, and the motion dies out; the limit cycle is at {outside[0].frequency:.1f} and "
                f"{outside[1].frequency:.1f} Hz"
            ),
            method="exact simulation with the parameters of Listing A.1, two starts for each gap",
        ),
        Confirmation(
            "the second natural mode, which knows no gap",
            CloseNumbers(evidence.numbers.modes[1].frequency, shares[0], 5e-3),
        ),
    )


def _prediction() -> Part:
    return Part(
        "prediction of section 3.2 for the same trimmer",
        Assertion(
            statement="the peak is at the limit cycle's predicted frequency",
            derived=abs(float(PREDICTED) - float(PEAK)) < BIN,
            evidence=f"{PREDICTED} Hz was predicted, whatever the gap",
            method="read in the text: the two printed frequencies",
        ),
    )


def _open_loop() -> Part:
    distance = float(OPEN_LOOP_PEAK) - float(PEAK)
    return Part(
        "agreement with the open loop",
        Assertion(
            statement="the peak of the open loop agrees with it",
            derived=abs(distance) < BIN,
            evidence=(
                f"{OPEN_LOOP_PEAK} Hz lies {distance:.0f} Hz higher, {distance:.0f} bins of the open loop's "
                "spectrum; rounded as 350 is it would read 370"
            ),
            method="read in the text: the two printed frequencies",
        ),
    )


def _suppression(evidence: Evidence) -> Claim:
    released = evidence.motion.released
    lasting = [run for run in released.by_force if run.goes_on]
    largest = released.released(LARGEST_GAP, FORCES_OF_FIGURE[-1], OUTSIDE)
    least = released.released(LARGEST_GAP, FORCES_OF_FIGURE[0], OUTSIDE)
    share = 100 * (1 - largest.amplitude / least.amplitude)
    return Claim(
        id="txt-3.3-friction-suppresses",
        parts=(_smaller(evidence), _ends(evidence), _larger_gap(evidence)),
        explanation=(
            "With friction between cutter and guard that resists their motion, all of it holds, and the "
            "force needed is proportional to the gap. With Listing A.1 and 0.2 mm the limit cycle lasts up "
            f"to {lasting[-1].force} N, so the forces below 1 N that the text assumes weaken it and do not "
            f"end it. For 20 mm the largest force of figure 3.9 takes {share:.1f} % of its "
            f"{1e3 * least.amplitude:.0f} mm, which no figure shows; what was suppressed there was, it "
            "seems, another peak."
        ),
        source=SOURCE,
    )


def _smaller(evidence: Evidence) -> Part:
    lasting = [run for run in evidence.motion.released.by_force if run.goes_on]
    amplitudes = np.array([run.amplitude for run in lasting])
    predicted = evidence.cycles.equivalent.in_place_both_channels.stable
    second = lasting[1]
    balance = np.interp(second.force / GAP, predicted.force_per_gap, predicted.amplitude)
    shown = ", ".join(f"{1e6 * run.amplitude:.0f} µm with {run.force:g} N" for run in lasting)
    return Part(
        "amplitude",
        Assertion(
            statement="the amplitude of the limit cycle falls as friction rises",
            derived=bool((np.diff(amplitudes) < 0).all()),
            evidence=shown,
            method="exact simulation with the parameters of Listing A.1, gap 0.2 mm",
        ),
        Confirmation(
            f"harmonic balance at {second.force} N", CloseNumbers(balance, second.amplitude / GAP, 0.02)
        ),
    )


def _ends(evidence: Evidence) -> Part:
    *_, before, last = evidence.motion.released.by_force
    largest = GAP * evidence.cycles.equivalent.in_place_both_channels.merger.force_per_gap
    return Part(
        "existence",
        Assertion(
            statement="enough friction suppresses it",
            derived=before.goes_on and not last.goes_on,
            evidence=f"with {before.force} N it lasts, with {last.force} N the motion comes to rest",
            method="exact simulation with the parameters of Listing A.1, gap 0.2 mm",
        ),
        second_way(
            f"harmonic balance, whose two solutions merge at {largest:.3f} N",
            before.force < largest < last.force,
        ),
    )


def _larger_gap(evidence: Evidence) -> Part:
    scale, rate = sympy.symbols("lambda", positive=True), sympy.Symbol("w", real=True)
    same_force = FORCE * scale * sympy.sign(scale * rate) == scale * FORCE * sympy.sign(rate)
    released = evidence.motion.released
    small, large = released.by_force[1], released.scaled
    distance = float(np.abs(large.output - SCALE * small.output).max() / np.abs(large.output).max())
    return Part(
        "larger gap",
        Assertion(
            statement="a larger gap needs more friction",
            derived=bool(same_force),
            evidence=(
                "displacements, gap and $F_c$ times the same factor give the same motion times that factor, "
                "so the force that ends it is proportional to the gap"
            ),
            method="every equation is of first degree in displacements, gap and force",
        ),
        second_way(
            f"exact simulation with a factor of {SCALE}, whose two motions agree to a billionth",
            distance < ALIKE,
        ),
    )
