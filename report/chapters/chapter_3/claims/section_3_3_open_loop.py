"""Claims of section 3.3 on the driven open loop: its harmonics, and the peaks at 366 and 550 Hz."""

from __future__ import annotations

from report.chapters.chapter_3.claims.driven_harmonics import confirm_play
from report.chapters.chapter_3.claims.driven_steady_motion import (
    METHOD,
    SOURCE,
    confirm_odd,
    confirm_period,
    has_odd_harmonics_only,
    has_the_drives_period,
    period_in_words,
)
from report.chapters.chapter_3.claims.measured_peaks import TABLE_2
from report.claim import Claim, Impact, Part, Uncheckable, Words
from report.comparisons.assertion import Assertion
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.driven_motion import FORCES, GAP, LARGER_GAP
from report.numbers.linear_numbers import MEASURED_DRIVE_FREQUENCY
from report.numbers.transient_spectrum import transient_peaks

OPEN_LOOP_PEAK, FIFTH = "365.999", "549.999"
"""Peaks of figure 3.8, Hz."""
BIN_OF_FIGURE = 1.0
"""Widest bins of which both peaks are whole multiples together with their digits, Hz."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_odd(evidence), _peak_366(evidence), _peak_550(evidence), _subharmonic())


def _odd(evidence: Evidence) -> Claim:
    return Claim(
        id="txt-3.3-open-loop-odd",
        parts=(
            _largest_harmonics(evidence),
            Part(
                "no others",
                Assertion(
                    statement="the model shows no further frequencies",
                    derived=has_odd_harmonics_only(evidence),
                    evidence=(
                        "play, friction and linear part are odd, and all motions end with the same "
                        "velocities; even harmonics are rounding in every run"
                    ),
                    method=METHOD,
                ),
                confirm_odd(evidence),
            ),
            _beside_the_experiment(evidence),
        ),
        explanation=(
            "The model has odd harmonics only, the fifth being raised by the natural mode at "
            f"{evidence.numbers.modes[2].frequency:.1f} Hz. The experiment without play agrees with that. "
            "With play it shows the second and fourth harmonic as well, which takes something that is not "
            "symmetric: friction that differs by direction, a spring that is stiffer to one side, a pin that "
            "does not move as a sine. An uneven play would only shift the mean."
        ),
        consequence=(
            "The model lacks what makes the even harmonics, so the agreement cannot carry the conclusions on "
            "larger gaps."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _largest_harmonics(evidence: Evidence) -> Part:
    runs = [evidence.motion.driven.run(GAP, force) for force in FORCES]
    largest = [sorted(range(2, run.harmonics.size), key=lambda n: -run.harmonics[n])[:2] for run in runs]
    listing = "; ".join(
        f"{run.force} N: {1e6 * run.harmonics[3]:.0f}, {1e6 * run.harmonics[5]:.0f} and "
        f"{1e6 * run.harmonics[7]:.0f} µm"
        for run in runs
    )
    return Part(
        "largest harmonics",
        Assertion(
            statement="beside the fundamental the third and the fifth are the largest",
            derived=all(set(pair) == {3, 5} for pair in largest),
            evidence=f"third, fifth and seventh with {listing}",
            method="exact simulation with the parameters of Listing A.1",
        ),
        confirm_play(evidence, GAP),
    )


def _beside_the_experiment(evidence: Evidence) -> Part:
    measured = range(1, 1 + min(len(row) for row in TABLE_2.values()))
    even = [f"$f_{order}$" for order in measured if order % 2 == 0]
    return Part(
        "agreement with the experiment",
        Assertion(
            statement="the experiment with play shows the harmonics of the model",
            derived=not (even and has_odd_harmonics_only(evidence)),
            evidence=(
                f"table 3.2 has {' and '.join(even)} in all of its {len(TABLE_2)} measurements, "
                "which the model cannot have for any parameters"
            ),
            method="orders of the tabulated harmonics against the theorem",
        ),
        confirm_odd(evidence),
    )


def _peak_366(evidence: Evidence) -> Claim:
    run = evidence.motion.driven.run(LARGER_GAP, FORCES[0])
    peaks = transient_peaks(run)
    mode = evidence.numbers.modes[1]
    return Claim(
        id="txt-3.3-peak-366",
        parts=(
            _multiple_of_the_drive(),
            Part(
                "limit cycle",
                Assertion(
                    statement="it can be that of a limit cycle",
                    derived=not has_the_drives_period(evidence),
                    evidence=period_in_words(evidence),
                    method=METHOD,
                ),
                confirm_period(evidence),
            ),
            Uncheckable(
                "which natural mode of the experiment's trimmer it is",
                Words("365.999 Hz"),
                "the parameters of that trimmer (table C.1), which are confidential",
            ),
        ),
        explanation=(
            "A driven trimmer with friction has no limit cycle. What is left beside harmonics is the start: "
            f"with Listing A.1 what dies out after it has its peaks at {_list(peaks)} Hz, near natural "
            f"modes, of which the second is at {mode.frequency:.1f} Hz with a time constant of "
            f"{-1000 / mode.eigenvalue.real:.0f} ms. A spectrum that begins with the start shows it."
        ),
        consequence=(
            "The evidence for a limit cycle in the open loop is gone. A spectrum of the settled motion, or "
            "of two records of different length, would have told a transient from an oscillation that lasts."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _multiple_of_the_drive() -> Part:
    order = float(OPEN_LOOP_PEAK) / MEASURED_DRIVE_FREQUENCY
    return Part(
        "harmonic of the drive",
        Assertion(
            statement="365.999 Hz is a multiple of the drive's frequency",
            derived=abs(order - round(order)) * MEASURED_DRIVE_FREQUENCY < BIN_OF_FIGURE,
            evidence=f"it is {order:.3f} times 109.945 Hz",
            method="quotient of the two frequencies",
            asserted=False,
        ),
        second_way(
            "the two nearest harmonics, 329.835 and 439.780 Hz, both more than 36 bins away",
            min(abs(float(OPEN_LOOP_PEAK) - each) for each in (329.835, 439.78)) > 36 * BIN_OF_FIGURE,
        ),
    )


def _list(peaks: tuple[float, ...]) -> str:
    return ", ".join(f"{peak:.0f}" for peak in peaks[:-1]) + f" and {peaks[-1]:.0f}"


def _peak_550(evidence: Evidence) -> Claim:
    fifth = 5 * MEASURED_DRIVE_FREQUENCY
    mode = evidence.numbers.modes[2]
    near = abs(float(FIFTH) - fifth) <= BIN_OF_FIGURE / 2
    return Claim(
        id="txt-3.3-peak-550",
        parts=(
            Part(
                "five times the drive",
                Assertion(
                    statement="549.999 Hz is the fifth harmonic of the drive",
                    derived=near and has_odd_harmonics_only(evidence),
                    evidence=(
                        f"five times 109.945 Hz is {fifth:.3f} Hz, whose nearest bin of 1 Hz is 550 Hz; the "
                        "model holds odd harmonics and nothing else"
                    ),
                    method=METHOD,
                ),
                confirm_odd(evidence),
            ),
        ),
        explanation=(
            f"It is the fifth harmonic, magnified by the natural mode at {mode.frequency:.1f} Hz (Listing "
            "A.1). The text calls it a subharmonic, which is judged apart. 549.999 and 365.999 Hz read like "
            "bins of 1 Hz with one sample too many, as in the experiment's tables."
        ),
        source=SOURCE,
    )


def _subharmonic() -> Claim:
    return Claim(
        id="txt-3.3-subharmonic",
        parts=(
            Part(
                "the peak at 549.999 Hz",
                Assertion(
                    statement="it is a subharmonic",
                    derived=float(FIFTH) < MEASURED_DRIVE_FREQUENCY,
                    evidence=(
                        "a subharmonic has a fraction of the drive's frequency, and this has five times it"
                    ),
                    method="read in the text, against the two frequencies printed there",
                ),
            ),
        ),
        explanation="It is a harmonic, the fifth. Chapter 7 uses the same word.",
        consequence="None: only the word is wrong.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )
