"""Claims of section 3.3 on the closed loop: its peak near 350 Hz, and what friction does to a limit cycle."""

from __future__ import annotations

import numpy as np
import sympy

from derivations import assumed
from derivations.elements.friction import FORCE
from report.chapters.chapter_3.claims import driven_steady_motion as driven
from report.judging.parts import assertion, close, so, uncheckable
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.driven_motion import FORCES
from report.numbers.evidence import Evidence
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, SCALE, released_peak
from report.numbers.thesis import EXPERIMENT_GAP, LARGEST_GAP, OPEN_LOOP_PEAK

PEAK, PREDICTED = "350", "488"
"""Peak of figure 3.9 for every gap, and the limit cycle predicted for the same trimmer in section 3.2, Hz."""
BIN = 10.0
"""Widest bin of the spectra of chapter 3, Hz."""
ABOUT = 0.05
"""Share by which a frequency that is printed as about equal may be off."""
ALIKE = 1e-9
"""Relative difference of two motions that are alike but for their scale."""
ASSUMED_FORCE = "1.0"
"""Force below which section 3.3 assumes friction to be, N."""
UNMOVED = 0.005
"""Share by which a frequency may change and still be called unaffected."""
RISING = f"{driven.BY_LISTING}, gap {1e3 * EXPERIMENT_GAP:g} mm"


@claim("txt-3.3-peak-350")
def peak_350(known: Evidence) -> Record:
    mode, least = known.numbers.modes[1].frequency, FORCES_OF_FIGURE[0]
    inside, outside = (
        [known.motion.released.released(gap, least, start) for gap in (EXPERIMENT_GAP, LARGEST_GAP)]
        for start in (INSIDE, OUTSIDE)
    )
    small, large = (released_peak(run) for run in inside)
    goes_on, scaled = (run.frequency for run in outside)
    yield assertion(
        "why it should be a limit cycle",
        "a frequency that does not depend on the gap belongs to a limit cycle",
        abs(large - small) > BIN or any(run.goes_on for run in inside),
        f"""
        released inside of its play the loop dies out, with peaks at {small:.1f} and {large:.1f} Hz for gaps
        of {f"{1e3 * EXPERIMENT_GAP:g}"} and {f"{1e3 * LARGEST_GAP:g}"} mm; released outside it has its limit
        cycle, at {goes_on:.1f} and {scaled:.1f} Hz
        """,
        method=f"{driven.BY_LISTING}, two starts for each gap",
        second=close("the second natural mode, which knows no gap", mode, small, 5e-3),
        item="350 Hz, peak of figure 3.9 for every gap read as a limit cycle",
    )
    distance = float(OPEN_LOOP_PEAK) - float(PEAK)
    yield assertion(
        "agreement with the open loop",
        "the peak of the open loop agrees with it, as far as about 350 Hz goes",
        abs(distance) <= ABOUT * float(OPEN_LOOP_PEAK),
        f"{OPEN_LOOP_PEAK} Hz lies {distance:.0f} Hz higher, {100 * distance / float(PEAK):.0f} %",
        method="read in the text: the two printed frequencies",
    )
    missing = "the parameters of that trimmer (table C.1), and from which state the loop was released"
    yield uncheckable(
        "which it is in the experiment's trimmer", "this peak belongs to a limit cycle", missing
    )
    yield text(f"""
        The text takes the peak for a limit cycle because it is there for every gap. Natural modes do not
        depend on the gap either: the loop with Listing A.1, released inside of its play, dies out with a peak
        at its second natural mode, whatever the gap and the sooner the more friction. Released outside it
        goes on at {goes_on:.0f} Hz. For the experiment's trimmer section 3.2 itself predicts a limit cycle at
        {PREDICTED} Hz, not near {PEAK} Hz.

        The peak reads as a natural mode that is dying out. Chapter 7 takes from this section that friction
        suppresses limit cycles.
    """)


@claim("txt-3.3-friction-suppresses")
def suppression(known: Evidence) -> Record:
    released, branches = known.motion.released, known.cycles.equivalent.in_place_both_channels
    lasting = [run for run in released.by_force if run.goes_on]
    weak, predicted = lasting[1], branches.stable
    balance = np.interp(weak.force / EXPERIMENT_GAP, predicted.force_per_gap, predicted.amplitude)
    yield assertion(
        "amplitude",
        "the amplitude of the limit cycle falls as friction rises",
        tuple(np.diff([run.amplitude for run in lasting]) < 0),
        ", ".join(f"{1e6 * run.amplitude:.0f} µm with {run.force:g} N" for run in lasting),
        method=RISING,
        second=close(f"harmonic balance at {weak.force} N", balance, weak.amplitude / EXPERIMENT_GAP, 0.02),
    )
    *_, before, last = released.by_force
    merger = EXPERIMENT_GAP * branches.merger.force_per_gap
    merge = f"harmonic balance, whose two solutions merge at {merger:.3f} N"
    yield assertion(
        "existence",
        "enough friction suppresses it",
        (before.goes_on, not last.goes_on),
        f"with {before.force} N it lasts, with {last.force} N the motion comes to rest",
        method=RISING,
        second=so(merge, before.force < merger < last.force),
    )
    scale, rate = assumed.positive("lambda"), assumed.real("w")
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
        certainty=Certainty.PROVEN,
    )
    least, *_, most = (released.released(LARGEST_GAP, force, OUTSIDE) for force in FORCES_OF_FIGURE)
    share = 100 * (1 - most.amplitude / least.amplitude)
    yield text(f"""
        With friction between cutter and guard that resists their motion all of it holds, and the force that
        is needed is proportional to the gap. With Listing A.1 and {f"{1e3 * EXPERIMENT_GAP:g}"} mm the limit
        cycle lasts up to {lasting[-1].force} N: the forces below {ASSUMED_FORCE} N that the text assumes
        weaken it and do not end it. For {f"{1e3 * LARGEST_GAP:g}"} mm the largest force of figure 3.9 takes
        {share:.1f} % of its {1e3 * least.amplitude:.0f} mm, which no figure shows; what was suppressed there
        seems to be another peak.
    """)


@claim("txt-3.3-friction-frequency")
def frequency_under_friction(known: Evidence) -> Record:
    yield assertion(
        "oscillations of the driven trimmer",
        "friction leaves their frequency",
        driven.has_the_drives_period(known),
        "they are harmonics of the drive, whatever the friction",
        method=driven.METHOD,
        second=driven.confirm_period(known),
        certainty=Certainty.PROVEN,
    )
    lasting = [run for run in known.motion.released.by_force if run.goes_on]
    without, weak, *_, strong = lasting
    slower = without.frequency - strong.frequency
    predicted = known.cycles.equivalent.in_place_both_channels.stable
    balance = np.interp(weak.force / EXPERIMENT_GAP, predicted.force_per_gap, predicted.frequency)
    yield assertion(
        "self-sustained oscillation",
        "friction leaves its frequency",
        slower < UNMOVED * without.frequency,
        ", ".join(f"{run.frequency:.1f} Hz with {run.force:g} N" for run in lasting),
        method=RISING,
        second=close(f"harmonic balance at {weak.force} N", balance, weak.frequency, 1e-3),
        certainty=Certainty.READING,
    )
    of_text = next(run for run in lasting if run.force == FORCES[-1])
    amplitude = 100 * (1 - of_text.amplitude / without.amplitude)
    frequency = 100 * (1 - of_text.frequency / without.frequency)
    yield text(f"""
        The observation is right: friction lowers the peaks and does not move them, as harmonics of a drive
        behave. A self-sustained oscillation does not keep its frequency exactly: backlash acts by the ratio
        of amplitude and gap, so a smaller one is slower. With Listing A.1 and {f"{1e3 * EXPERIMENT_GAP:g}"}
        mm the text's largest force, {of_text.force} N, takes {amplitude:.0f} % of its amplitude and
        {frequency:.1f} % of its frequency. Read as what can be seen in a time response, the reason given is
        right.

        None on numbers. But a peak that stays while friction changes is no sign of a limit cycle: a harmonic
        of the drive stays as well, and exactly.
    """)
