"""Claims of section 3.3 on the driven open loop: its harmonics, and the peaks at 366 and 550 Hz."""

from __future__ import annotations

from report.chapters.chapter_3.claims.driven_steady_motion import (
    BY_LISTING,
    METHOD,
    SOURCE,
    confirm_odd,
    confirm_period,
    confirm_play,
    has_odd_harmonics_only,
    has_the_drives_period,
    listed,
    period_in_words,
    runs_with,
)
from report.chapters.chapter_3.claims.measured_peaks import TABLE_2
from report.claim import Impact
from report.evidence import Evidence
from report.numbers.driven_motion import FORCES, GAP, LARGER_GAP
from report.numbers.transient_spectrum import transient_peaks
from report.parts import assertion, so, uncheckable
from report.record import Record, claim, text
from report.text import filled
from report.thesis import MEASURED_DRIVE_FREQUENCY

OPEN_LOOP_PEAK, FIFTH = "365.999", "549.999"
"""Peaks of figure 3.8, Hz."""
BIN_OF_FIGURE = 1.0
"""Widest bins of which both peaks are whole multiples together with their digits, Hz."""


@claim("txt-3.3-open-loop-odd", source=SOURCE, impact=Impact.DOWNSTREAM)
def odd_harmonics(known: Evidence) -> Record:
    runs, odd, second = runs_with(known, GAP), has_odd_harmonics_only(known), confirm_odd(known)
    largest = [sorted(range(2, run.harmonics.size), key=lambda n: -run.harmonics[n])[:2] for run in runs]
    sizes = ((run.force, *(1e6 * run.harmonics[order] for order in (3, 5, 7))) for run in runs)
    rows = (f"{force} N: {third:.0f}, {fifth:.0f} and {more:.0f} µm" for force, third, fifth, more in sizes)
    yield assertion(
        "largest harmonics",
        "beside the fundamental the third and the fifth are the largest",
        all(set(pair) == {3, 5} for pair in largest),
        f"third, fifth and seventh with {'; '.join(rows)}",
        method=BY_LISTING,
        second=confirm_play(known, GAP),
    )
    yield assertion(
        "no others",
        "the model shows no further frequencies",
        odd,
        """
        play, friction and linear part are odd, and all motions end with the same velocities; even harmonics
        are rounding in every run
        """,
        method=METHOD,
        second=second,
    )
    measured = range(1, 1 + min(len(row) for row in TABLE_2.values()))
    even = [f"$f_{order}$" for order in measured if order % 2 == 0]
    yield assertion(
        "agreement with the experiment",
        "the experiment with play shows the harmonics of the model",
        not (even and odd),
        filled(
            """
            table 3.2 has [[ even ]] in all of its [[ count ]] measurements, which the model cannot have for
            any parameters
            """,
            even=" and ".join(even),
            count=len(TABLE_2),
        ),
        method="orders of the tabulated harmonics against the theorem",
        second=second,
    )
    yield text(
        """
        The model has odd harmonics only, the fifth being raised by the natural mode at [[ mode | f1 ]] Hz.
        The experiment without play agrees with that. With play it shows the second and fourth harmonic as
        well, which takes something that is not symmetric: friction that differs by direction, a spring that
        is stiffer to one side, a pin that does not move as a sine. An uneven play would only shift the mean.

        The model lacks what makes the even harmonics, so the agreement cannot carry the conclusions on larger
        gaps.
        """,
        mode=known.numbers.modes[2].frequency,
    )


@claim("txt-3.3-peak-366", source=SOURCE, impact=Impact.DOWNSTREAM)
def peak_366(known: Evidence) -> Record:
    order = float(OPEN_LOOP_PEAK) / MEASURED_DRIVE_FREQUENCY
    nearest = "the two nearest harmonics, 329.835 and 439.780 Hz, both more than 36 bins away"
    away = min(abs(float(OPEN_LOOP_PEAK) - each) for each in (329.835, 439.78))
    yield assertion(
        "harmonic of the drive",
        "365.999 Hz is a multiple of the drive's frequency",
        abs(order - round(order)) * MEASURED_DRIVE_FREQUENCY < BIN_OF_FIGURE,
        f"it is {order:.3f} times 109.945 Hz",
        method="quotient of the two frequencies",
        asserted=False,
        second=so(nearest, away > 36 * BIN_OF_FIGURE),
    )
    yield assertion(
        "limit cycle",
        "it can be that of a limit cycle",
        not has_the_drives_period(known),
        period_in_words(known),
        method=METHOD,
        second=confirm_period(known),
    )
    missing = "the parameters of that trimmer (table C.1), which are confidential"
    yield uncheckable("which natural mode of the experiment's trimmer it is", "365.999 Hz", missing)
    *peaks, last = transient_peaks(known.motion.driven.run(LARGER_GAP, FORCES[0]))
    mode = known.numbers.modes[1]
    yield text(
        """
        A driven trimmer with friction has no limit cycle. What is left beside harmonics is the start: with
        Listing A.1 what dies out after it has its peaks at [[ peaks ]] and [[ last | f0 ]] Hz, near natural
        modes, of which the second is at [[ mode | f1 ]] Hz with a time constant of [[ constant | f0 ]] ms. A
        spectrum that begins with the start shows it.

        The evidence for a limit cycle in the open loop is gone. A spectrum of the settled motion, or of two
        records of different length, would have told a transient from an oscillation that lasts.
        """,
        peaks=listed(peaks),
        last=last,
        mode=mode.frequency,
        constant=-1000 / mode.eigenvalue.real,
    )


@claim("txt-3.3-peak-550", source=SOURCE)
def peak_550(known: Evidence) -> Record:
    fifth = 5 * MEASURED_DRIVE_FREQUENCY
    near = abs(float(FIFTH) - fifth) <= BIN_OF_FIGURE / 2
    yield assertion(
        "five times the drive",
        "549.999 Hz is the fifth harmonic of the drive",
        near and has_odd_harmonics_only(known),
        filled(
            """
            five times 109.945 Hz is [[ fifth | f3 ]] Hz, whose nearest bin of 1 Hz is 550 Hz; the model holds
            odd harmonics and nothing else
            """,
            fifth=fifth,
        ),
        method=METHOD,
        second=confirm_odd(known),
    )
    yield text(
        """
        It is the fifth harmonic, magnified by the natural mode at [[ mode | f1 ]] Hz (Listing A.1). The text
        calls it a subharmonic, which is judged apart. 549.999 and 365.999 Hz read like bins of 1 Hz with one
        sample too many, as in the experiment's tables.
        """,
        mode=known.numbers.modes[2].frequency,
    )


@claim("txt-3.3-subharmonic", source=SOURCE, impact=Impact.NOTATION)
def subharmonic(_: Evidence) -> Record:
    yield assertion(
        "the peak at 549.999 Hz",
        "it is a subharmonic",
        float(FIFTH) < MEASURED_DRIVE_FREQUENCY,
        "a subharmonic has a fraction of the drive's frequency, and this has five times it",
        method="read in the text, against the two frequencies printed there",
    )
    yield text(
        """
        It is a harmonic, the fifth. Chapter 7 uses the same word.

        None: only the word is wrong.
        """
    )
