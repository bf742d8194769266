"""Claims of section 3.3 on the closed loop: the peak near 350 Hz, and what friction does to a limit cycle."""

from __future__ import annotations

import numpy as np
import sympy

from derivations.friction import FORCE
from report.chapters.chapter_3.claims.driven_steady_motion import (
    BY_LISTING,
    METHOD,
    confirm_period,
    has_the_drives_period,
)
from report.chapters.chapter_3.claims.section_3_3_open_loop import OPEN_LOOP_PEAK
from report.claim import Impact, Number
from report.evidence import Evidence
from report.numbers.driven_motion import GAP, LARGEST_GAP
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, SCALE, released_peak
from report.parts import assertion, close, digits, so, uncheckable
from report.record import Record, claim, text
from report.text import filled

SOURCE = "report/numbers/released_motion.py"
PEAK, PREDICTED = "350", "488"
"""Peak of figure 3.9 for every gap, and the limit cycle predicted for the same trimmer in section 3.2, Hz."""
PEAK_DIGITS = "3.5e2"
"""The peak to the digits that "about 350" stands for."""
BIN = 10.0
"""Widest bin of the spectra of chapter 3, Hz."""
ALIKE = 1e-9
"""Relative difference of two motions that are alike but for their scale."""
UNMOVED = 0.005
"""Share by which a frequency may change and still be called unaffected."""
RISING = f"{BY_LISTING}, gap 0.2 mm"
IN_TEXT = "read in the text: the two printed frequencies"


@claim("txt-3.3-peak-350", source=SOURCE, impact=Impact.DOWNSTREAM)
def peak_350(known: Evidence) -> Record:
    mode, least = known.numbers.modes[1].frequency, FORCES_OF_FIGURE[0]
    inside, outside = (
        [known.motion.released.released(gap, least, start) for gap in (GAP, LARGEST_GAP)]
        for start in (INSIDE, OUTSIDE)
    )
    small, large = peaks = [released_peak(run) for run in inside]
    for run, peak in zip(inside, peaks, strict=True):
        yield digits(
            f"released inside of its play, gap {1e3 * run.gap:g} mm, {run.force} N",
            PEAK_DIGITS,
            peak,
            "Hz",
            second=close("the second natural mode", mode, peak, 5e-3),
            printed_form=Number(PEAK, "Hz"),
        )
    yield assertion(
        "why it should be a limit cycle",
        "a frequency that does not depend on the gap belongs to a limit cycle",
        abs(large - small) > BIN or any(run.goes_on for run in inside),
        filled(
            """
            inside of the play the peaks are at [[ small | f1 ]] and [[ large | f1 ]] Hz for gaps of 0.2 and
            20 mm, and the motion dies out; the limit cycle is at [[ lasting_small | f1 ]] and
            [[ lasting_large | f1 ]] Hz
            """,
            small=small,
            large=large,
            lasting_small=outside[0].frequency,
            lasting_large=outside[1].frequency,
        ),
        method=f"{BY_LISTING}, two starts for each gap",
        second=close("the second natural mode, which knows no gap", mode, small, 5e-3),
    )
    yield assertion(
        "prediction of section 3.2 for the same trimmer",
        "the peak is at the limit cycle's predicted frequency",
        abs(float(PREDICTED) - float(PEAK)) < BIN,
        f"{PREDICTED} Hz was predicted, whatever the gap",
        method=IN_TEXT,
    )
    distance = float(OPEN_LOOP_PEAK) - float(PEAK)
    yield assertion(
        "agreement with the open loop",
        "the peak of the open loop agrees with it",
        abs(distance) < BIN,
        filled(
            """
            [[ peak ]] Hz lies [[ distance | f0 ]] Hz higher, [[ distance | f0 ]] bins of the open loop's
            spectrum; rounded as 350 is it would read 370
            """,
            peak=OPEN_LOOP_PEAK,
            distance=distance,
        ),
        method=IN_TEXT,
    )
    yield uncheckable(
        "which it is in the experiment's trimmer",
        "this peak belongs to a limit cycle",
        "the parameters of that trimmer (table C.1), and from which state the loop was released",
    )
    yield text(
        """
        That a frequency does not depend on the gap says nothing: natural modes do not know the gap either.
        Released inside of its play the loop with Listing A.1 dies out, sooner with more friction, and has its
        peak at the second natural mode for either gap, which is how the figure is described; released outside
        it goes on at [[ lasting | f0 ]] Hz. The thesis's own prediction for its trimmer is [[ predicted ]]
        Hz.

        The peak reads as a natural mode that is dying out. Chapter 7 takes from this section that friction
        suppresses limit cycles.
        """,
        lasting=outside[0].frequency,
        predicted=PREDICTED,
    )


@claim("txt-3.3-friction-suppresses", source=SOURCE)
def suppression(known: Evidence) -> Record:
    released, branches = known.motion.released, known.cycles.equivalent.in_place_both_channels
    lasting = [run for run in released.by_force if run.goes_on]
    amplitudes, weak = np.array([run.amplitude for run in lasting]), lasting[1]
    predicted = branches.stable
    balance = np.interp(weak.force / GAP, predicted.force_per_gap, predicted.amplitude)
    yield assertion(
        "amplitude",
        "the amplitude of the limit cycle falls as friction rises",
        bool((np.diff(amplitudes) < 0).all()),
        ", ".join(f"{1e6 * run.amplitude:.0f} µm with {run.force:g} N" for run in lasting),
        method=RISING,
        second=close(f"harmonic balance at {weak.force} N", balance, weak.amplitude / GAP, 0.02),
    )
    *_, before, last = released.by_force
    merger = GAP * branches.merger.force_per_gap
    merge = f"harmonic balance, whose two solutions merge at {merger:.3f} N"
    yield assertion(
        "existence",
        "enough friction suppresses it",
        before.goes_on and not last.goes_on,
        f"with {before.force} N it lasts, with {last.force} N the motion comes to rest",
        method=RISING,
        second=so(merge, before.force < merger < last.force),
    )
    scale, rate = sympy.symbols("lambda", positive=True), sympy.Symbol("w", real=True)
    same_force = FORCE * scale * sympy.sign(scale * rate) == scale * FORCE * sympy.sign(rate)
    small, large = released.by_force[1].output, released.scaled.output
    distance = float(np.abs(large - SCALE * small).max() / np.abs(large).max())
    alike = f"exact simulation with a factor of {SCALE}, whose two motions agree to a billionth"
    yield assertion(
        "larger gap",
        "a larger gap needs more friction",
        bool(same_force),
        """
        displacements, gap and $F_c$ times the same factor give the same motion times that factor, so the
        force that ends it is proportional to the gap
        """,
        method="every equation is of first degree in displacements, gap and force",
        second=so(alike, distance < ALIKE),
    )
    least, *_, most = (released.released(LARGEST_GAP, force, OUTSIDE) for force in FORCES_OF_FIGURE)
    yield text(
        """
        With friction between cutter and guard that resists their motion, all of it holds, and the force
        needed is proportional to the gap. With Listing A.1 and 0.2 mm the limit cycle lasts up to [[ force ]]
        N, so the forces below 1 N that the text assumes weaken it and do not end it. For 20 mm the largest
        force of figure 3.9 takes [[ share | f1 ]] % of its [[ amplitude | f0 ]] mm, which no figure shows;
        what was suppressed there was, it seems, another peak.
        """,
        force=lasting[-1].force,
        share=100 * (1 - most.amplitude / least.amplitude),
        amplitude=1e3 * least.amplitude,
    )


@claim("txt-3.3-friction-frequency", source=SOURCE, impact=Impact.DOWNSTREAM)
def frequency_under_friction(known: Evidence) -> Record:
    yield assertion(
        "oscillations of the driven trimmer",
        "friction leaves their frequency",
        has_the_drives_period(known),
        "they are harmonics of the drive, whatever the friction",
        method=METHOD,
        second=confirm_period(known),
    )
    lasting = [run for run in known.motion.released.by_force if run.goes_on]
    without, weak, *_, strong = lasting
    slower = without.frequency - strong.frequency
    predicted = known.cycles.equivalent.in_place_both_channels.stable
    balance = np.interp(weak.force / GAP, predicted.force_per_gap, predicted.frequency)
    yield assertion(
        "self-sustained oscillation",
        "friction leaves its frequency",
        slower < UNMOVED * without.frequency,
        ", ".join(f"{run.frequency:.1f} Hz with {run.force:g} N" for run in lasting),
        method=RISING,
        second=close(f"harmonic balance at {weak.force} N", balance, weak.frequency, 1e-3),
    )
    yield text(
        """
        What is observed, peaks that friction lowers and does not move, is right and is what harmonics of the
        drive do. The reason given, that a self-sustained oscillation loses amplitude and not frequency, does
        not hold: backlash acts by the ratio of amplitude and gap, so a smaller oscillation is slower, by
        [[ slower | f0 ]] Hz at [[ force ]] N.

        A peak that stays in its place while friction changes speaks for a harmonic of the drive and against a
        limit cycle; the text takes it for the opposite.
        """,
        slower=slower,
        force=strong.force,
    )
