"""Claims of section 3.3 on the driven open loop: its harmonics, and its peaks at 366 and 550 Hz."""

from report.chapters.chapter_3.claims import driven_steady_motion as driven
from report.chapters.chapter_3.claims.measured_peaks import TABLE_1
from report.judging.parts import assertion, so, uncheckable
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.driven_motion import FORCES, transient_peaks
from report.numbers.evidence import Evidence
from report.numbers.thesis import (
    EXPERIMENT_GAP,
    LARGER_GAP,
    MEASURED_DRIVE_FREQUENCY,
    OPEN_LOOP_PEAK,
    TABLE_2,
)

FIFTH = "549.999"  # The other peak of figure 3.8, Hz
BIN_OF_FIGURE = 1.0  # Widest bins of which both peaks are whole multiples together with their digits, Hz
PEAK_ITEM = f"{OPEN_LOOP_PEAK} Hz, peak of figure 3.8 that is no harmonic of the drive"
SUBHARMONICS = "subharmonics, word for harmonics of the drive"


@claim("txt-3.3-open-loop-odd")
def odd_harmonics(known: Evidence) -> Record:
    runs, odd = driven.runs_with(known, EXPERIMENT_GAP), driven.has_odd_harmonics_only(known)
    second = driven.confirm_odd(known)
    largest = [sorted(range(2, run.harmonics.size), key=lambda n: -run.harmonics[n])[:2] for run in runs]
    sizes = ((run.force, *(1e6 * run.harmonics[order] for order in (3, 5, 7))) for run in runs)
    rows = (f"{force} N: {third:.0f}, {fifth:.0f} and {more:.0f} µm" for force, third, fifth, more in sizes)
    yield assertion(
        "largest harmonics",
        "beside the fundamental the third and the fifth are the largest",
        tuple(set(pair) == {3, 5} for pair in largest),
        f"third, fifth and seventh with {'; '.join(rows)}",
        method=driven.BY_LISTING,
        second=driven.confirm_play(known, EXPERIMENT_GAP),
    )
    yield assertion(
        "no others",
        "the model shows no further frequencies",
        odd,
        """
        play, friction and linear part are odd, and all motions end with the same velocities; even harmonics
        are rounding in every run
        """,
        method=driven.METHOD,
        second=second,
        certainty=Certainty.PROVEN,
    )
    measured = range(1, 1 + min(len(row) for row in TABLE_2.values()))
    even = [f"$f_{order}$" for order in measured if order % 2 == 0]
    table = f"table 3.2 has {' and '.join(even)}"
    yield assertion(
        "agreement with the experiment",
        "the experiment with play shows the harmonics of the model",
        not (even and odd),
        f"{table} in all of its {len(TABLE_2)} measurements, which the model cannot have for any parameters",
        method="orders of the tabulated harmonics against the theorem",
        second=second,
        certainty=Certainty.PROVEN,
    )
    yield text(f"""
        With any parameters the model has odd harmonics only, and so has the experiment without play. With
        play the experiment shows the second and fourth as well, yet the text finds the two in agreement; its
        next paragraph weakens this to some extent. Even harmonics take something that is not symmetric, such
        as friction that differs by direction, a spring that is stiffer to one side, or a pin that does not
        move as a sine; a play that is off centre only shifts the mean. With Listing A.1, driven at the
        measured frequency, the fifth harmonic is large because a mode at
        {known.numbers.modes[2].frequency:.1f} Hz lies next to it.

        The model lacks what makes the even harmonics, so the agreement cannot carry the conclusions on larger
        gaps.
    """)


@claim("txt-3.3-peak-366")
def peak_366(known: Evidence) -> Record:
    order = float(OPEN_LOOP_PEAK) / MEASURED_DRIVE_FREQUENCY
    neighbours = (TABLE_1[3], TABLE_2["M1"][3])
    away = min(abs(float(OPEN_LOOP_PEAK) - float(each)) for each in neighbours)
    nearest = f"the tabulated harmonics beside it, {' and '.join(neighbours)} Hz, {away:.0f} Hz away or more"
    yield assertion(
        "harmonic of the drive",
        f"{OPEN_LOOP_PEAK} Hz is a multiple of the drive's frequency",
        abs(order - round(order)) * MEASURED_DRIVE_FREQUENCY < BIN_OF_FIGURE,
        f"it is {order:.3f} times {MEASURED_DRIVE_FREQUENCY} Hz",
        method="quotient of the two frequencies",
        asserted=False,
        second=so(nearest, away > 30 * BIN_OF_FIGURE),
    )
    yield assertion(
        "limit cycle",
        "it can be that of a limit cycle",
        not driven.has_the_drives_period(known),
        driven.period_in_words(known),
        method=driven.METHOD,
        second=driven.confirm_period(known),
        item=PEAK_ITEM,
        certainty=Certainty.PROVEN,
    )
    missing = "the parameters of that trimmer (table C.1), which are confidential"
    yield uncheckable("which natural mode of the experiment's trimmer it is", f"{OPEN_LOOP_PEAK} Hz", missing)
    *peaks, last = transient_peaks(known.motion.driven.run(LARGER_GAP, FORCES[0]))
    mode = known.numbers.modes[1]
    yield text(f"""
        A driven trimmer has no limit cycle where play only passes the pin's displacement on, with any
        friction that resists the motion. What is left beside harmonics is the start: with Listing A.1 the
        motion that dies out after it has peaks at {driven.listed(peaks)} and {last:.0f} Hz, near natural
        modes. A spectrum that begins with the start shows the second of them, at {mode.frequency:.1f} Hz with
        a time constant of {-1000 / mode.eigenvalue.real:.0f} ms. With friction as equation 3.2 has it a
        trimmer could oscillate by itself, but friction would then raise the peak, which the text does not
        see.

        The evidence for a limit cycle in the open loop is gone. A spectrum of the settled motion, or of two
        records of different length, would have told a transient from an oscillation that lasts.
    """)


@claim("txt-3.3-peak-550")
def peak_550(known: Evidence) -> Record:
    fifth = 5 * MEASURED_DRIVE_FREQUENCY
    five = f"five times {MEASURED_DRIVE_FREQUENCY} Hz is {fifth:.3f}"
    near = abs(float(FIFTH) - fifth) <= BIN_OF_FIGURE / 2
    yield assertion(
        "five times the drive",
        "549.999 Hz is the fifth harmonic of the drive",
        (near, driven.has_odd_harmonics_only(known)),
        f"{five} Hz, whose nearest bin of 1 Hz is 550 Hz; the model holds odd harmonics and nothing else",
        method=driven.METHOD,
        second=driven.confirm_odd(known),
    )
    yield text(f"""
        It is the fifth harmonic. The trimmer of Listing A.1, another one, would magnify it by its natural
        mode at {known.numbers.modes[2].frequency:.1f} Hz. The text calls it a subharmonic, which is [judged
        apart](#txt-3.3-subharmonic). {FIFTH} and {OPEN_LOOP_PEAK} Hz read like bins of {BIN_OF_FIGURE:.0f} Hz
        with one sample too many, as in the experiment's tables.
    """)


@claim("txt-3.3-subharmonic")
def subharmonic(_: Evidence) -> Record:
    yield assertion(
        "the peak at 549.999 Hz",
        "it is a subharmonic",
        float(FIFTH) < MEASURED_DRIVE_FREQUENCY,
        "a subharmonic has a fraction of the drive's frequency, and this has five times it",
        method="read in the text, against the two frequencies printed there",
        item=SUBHARMONICS,
    )
    yield text("""
        It is a harmonic, the fifth. Chapter 7 uses the [same word](#txt-7-subharmonics).

        None: only the word is wrong.
    """)
