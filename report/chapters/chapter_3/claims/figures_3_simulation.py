"""Claims on figures 3.6 to 3.9, the simulated open and closed loop."""

from __future__ import annotations

import numpy as np

from report.chapters.chapter_3.claims.driven_harmonics import confirm_play
from report.chapters.chapter_3.claims.driven_steady_motion import METHOD, confirm_odd, has_odd_harmonics_only
from report.claim import Claim, Confirmation, Impact, Part, Uncheckable, Words
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.printed import power_of
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.driven_motion import FORCES, GAP, LARGER_GAP, LARGEST_GAP
from report.numbers.linear_numbers import DRIVE_AMPLITUDE
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, line_near_second_mode
from trimmer.elements.friction_backlash import FrictionBacklash

OPEN_LOOP, CLOSED_LOOP = "report/numbers/driven_motion.py", "report/numbers/released_motion.py"
PARAMETERS = "the parameters of the experiment's trimmer (table C.1), which are confidential"
SIMULATION = "exact simulation with the parameters of Listing A.1"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _smallest_gap(evidence),
        _largest_gap(evidence),
        _largest_gap_spectrum(evidence),
        _released(evidence),
    )


def _curves(missing: str = PARAMETERS) -> Uncheckable:
    return Uncheckable("curves", Words("curves for three forces of friction"), missing)


def _smallest_gap(evidence: Evidence) -> Claim:
    runs = [evidence.motion.driven.run(GAP, force) for force in FORCES]
    return Claim(
        id="fig-3.6",
        parts=(
            Part(
                "spectrum",
                Assertion(
                    statement="it holds the odd harmonics of the drive and nothing else",
                    derived=has_odd_harmonics_only(evidence),
                    evidence=(
                        "even harmonics up to "
                        f"{power_of(max(float(run.harmonics[::2].max()) for run in runs))} m, which is "
                        "rounding and what is left of the start"
                    ),
                    method=METHOD,
                ),
                confirm_odd(evidence),
            ),
            _curves(),
        ),
        explanation=(
            "Drawn with Listing A.1 the open loop shows what the text describes: the third and fifth "
            "harmonic beside the fundamental, and no other frequency. The heights depend on the trimmer, "
            "whose parameters are not given."
        ),
        source=OPEN_LOOP,
    )


def _follows_the_drive(evidence: Evidence) -> Part:
    runs = [evidence.motion.driven.run(LARGEST_GAP, force) for force in FORCES]
    largest = max(float(np.abs(run.output).max()) for run in runs)
    return Part(
        "$b$ = $200\\times10^{-4}$ m",
        Assertion(
            statement="the trimmer moves with the drive",
            derived=largest > 0,
            evidence=(
                f"the pin moves by {1e3 * DRIVE_AMPLITUDE:.1f} mm to either side and its play is "
                f"{1e3 * LARGEST_GAP:.0f} mm wide, so it never reaches the bridge and the output stays at "
                f"{largest:.0f}"
            ),
            method=SIMULATION,
        ),
        second_way(
            "the domain of the describing function, which begins at half a gap",
            bool(np.isnan(FrictionBacklash(LARGEST_GAP).describing_function(DRIVE_AMPLITUDE))),
        ),
    )


def _largest_gap(evidence: Evidence) -> Claim:
    runs = [evidence.motion.driven.run(LARGER_GAP, force) for force in FORCES]
    thirds, fifths = ([1e6 * run.harmonics[order] for run in runs] for order in (3, 5))
    return Claim(
        id="fig-3.7",
        parts=(
            _follows_the_drive(evidence),
            Part(
                "additional oscillations, drawn for $b$ = $200\\times10^{-5}$ m",
                Assertion(
                    statement="friction makes them smaller and leaves their frequencies",
                    derived=bool(np.all(np.diff(thirds) < 0) and np.all(np.diff(fifths) < 0))
                    and has_odd_harmonics_only(evidence),
                    evidence=(
                        f"the third harmonic has {_list(thirds)} µm, the fifth {_list(fifths)} µm for 0.25, "
                        "0.50 and 0.75 N, at multiples of the drive's frequency"
                    ),
                    method=SIMULATION,
                ),
                confirm_play(evidence, LARGER_GAP),
            ),
            _curves(),
        ),
        explanation=(
            "A play of 20 mm lets a pin of 1.5 mm, the eccentricity of section 5.2.1, swing freely: nothing "
            "can move. Either the gap is misprinted or the pin moved by more than a centimetre. At 2 mm the "
            "model has two additional oscillations as described, which are the third and fifth harmonic; if "
            "$b$ were half of the gap, that play would not be crossed either."
        ),
        consequence=(
            "It is open what section 3.3 shows for its largest gap, and the oscillations do not suggest a "
            "limit cycle: harmonics of the drive look the same."
        ),
        impact=Impact.DOWNSTREAM,
        source=OPEN_LOOP,
    )


def _list(values: list[float]) -> str:
    return ", ".join(f"{value:.0f}" for value in values)


def _largest_gap_spectrum(evidence: Evidence) -> Claim:
    run = evidence.motion.driven.run(LARGER_GAP, FORCES[0])
    return Claim(
        id="fig-3.8",
        parts=(
            _follows_the_drive(evidence),
            Part(
                "settled motion, any gap",
                Assertion(
                    statement="it holds frequencies that are no harmonics of the drive",
                    derived=not has_odd_harmonics_only(evidence),
                    evidence=(
                        "all motions end with the same velocities, which repeat with the drive; with a gap "
                        f"of 2 mm the last two periods differ by {power_of(run.repeat)}"
                    ),
                    method=METHOD,
                ),
                confirm_odd(evidence),
            ),
            _curves(),
        ),
        explanation=(
            "With the printed gap the spectrum would be empty, see figure 3.7. With a gap that is crossed it "
            "holds the odd harmonics, and, if the record begins with the start, natural modes that die out: "
            f"with Listing A.1 at {evidence.numbers.modes[1].frequency:.0f} Hz, in the place of the peak at "
            "366 Hz."
        ),
        consequence="See the peak at 365.999 Hz.",
        impact=Impact.DOWNSTREAM,
        source=OPEN_LOOP,
    )


def _released(evidence: Evidence) -> Claim:
    released = evidence.motion.released
    lines = {
        (gap, force): line_near_second_mode(released.released(gap, force, INSIDE)) / gap
        for gap in (GAP, LARGEST_GAP)
        for force in FORCES_OF_FIGURE
    }
    least, largest = FORCES_OF_FIGURE[0], FORCES_OF_FIGURE[-1]
    lasting = released.released(LARGEST_GAP, least, OUTSIDE)
    left = {gap: lines[gap, largest] / lines[gap, least] for gap in (GAP, LARGEST_GAP)}
    return Claim(
        id="fig-3.9",
        parts=(
            Part(
                "peak near 350 Hz, released inside of the play",
                Assertion(
                    statement="friction suppresses it, and the larger gap needs more",
                    derived=left[GAP] < left[LARGEST_GAP] and lines[GAP, largest] < lines[GAP, least],
                    evidence=(
                        f"from {least} to {largest} N it falls to {100 * left[GAP]:.0f} % with 0.2 mm and to "
                        f"{100 * left[LARGEST_GAP]:.0f} % with 20 mm, released from {INSIDE} gaps"
                    ),
                    method=SIMULATION,
                ),
                Confirmation(
                    "the scaling of the model, by which 20 mm with 0.25 N is a hundred times 0.2 mm with "
                    "0.0025 N",
                    CloseNumbers(lines[LARGEST_GAP, largest], lines[GAP, least]),
                ),
            ),
            _curves(f"{PARAMETERS}; and from which state the loop was released"),
        ),
        explanation=(
            "All that the text reads from the figure also happens when nothing but a natural mode dies out. "
            "A limit cycle would do the same at another frequency, with Listing A.1 at "
            f"{lasting.frequency:.0f} Hz, and would have an amplitude of {1e3 * lasting.amplitude:.0f} mm in "
            "a gap of 20 mm, which no trimmer has room for."
        ),
        source=CLOSED_LOOP,
    )
