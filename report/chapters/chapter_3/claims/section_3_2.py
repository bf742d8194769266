"""Claims of section 3.2: the tabulated peaks (tables 3.1 and 3.2), and what the two experiments show."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import numpy as np
import sympy

from derivations.symbols import velocities
from report.chapters.chapter_1.claims import MOVING_PARTS
from report.chapters.chapter_3.claims import driven_steady_motion as driven
from report.chapters.chapter_3.claims import measured_peaks as peaks
from report.judging.claim import Confirmation
from report.judging.comparisons.digits import PrintedDigits
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, equal, lost_in_the_copy, so, uncheckable
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.spectrum_bins import a_drive_fits, bins
from report.numbers.thesis import DRIVE_FREQUENCY, FRAMES_OF_TABLES, SAMPLE_RATE, TABLE_2

RAW_DATA = "the recorded motions of the three measurements, which are confidential"
DIFFERENCE = "219.890"
"""Both differences of table 3.1, Hz."""
DRIVE_ITEM = "109.945 Hz, driving frequency in the tables of the experiment"
MISPRINTED_ITEM = "109.450 Hz, first harmonic of measurements 2 and 3 in table 3.2"
QUOTED = (
    ("section 3.2 and tables, first peak", peaks.TABLE_1[1], DRIVE_ITEM),
    (
        "sections 3.2 and A.9, footnote 7 of section 5.2.1",
        "109.845",
        "109.845 Hz, driving frequency seen in the experiment",
    ),
    ("table 3.2, measurements 2 and 3", TABLE_2["M2"][0], MISPRINTED_ITEM),
)
"""The drive's frequency wherever it is quoted, Hz, and the printed thing that each is."""
ABOUT, ABOUT_SHARE = "109", 0.01
"""The drive's frequency where it is called approximate, Hz, and the share by which it then may be off."""


@claim("txt-3.2-odd-harmonics")
def odd_harmonics(known: Evidence) -> Record:
    thirds, fifths = (driven.micrometres(driven.runs_with(known, 0.0), order) for order in (3, 5))
    alike = "linear parts and friction are odd and all motions end with the same velocities"
    mirror = power_of(max(run.mirror for run in known.motion.driven.runs))
    yield assertion(
        "no even ones",
        "without play the spectrum holds odd multiples of the drive's frequency only",
        driven.has_odd_harmonics_only(known),
        f"{alike}, which therefore change sign after half a period; in the runs up to {mirror} of the output",
        method=driven.METHOD,
        second=driven.confirm_odd(known),
        certainty=Certainty.PROVEN,
    )
    third, fifth = driven.listed(thirds), driven.listed(fifths)
    found = f"with 0.25, 0.5 and 0.75 N the third has {third} µm and the fifth {fifth} µm"
    yield assertion(
        "where they come from",
        "they come from Coulomb friction",
        tuple(np.diff([thirds, fifths]).ravel() > 0),
        f"without friction the model is linear and has none; {found}, beside 1.51 mm",
        method=driven.BY_LISTING,
        second=driven.confirm_friction(known),
    )
    yield text(f"""
        For friction between any of the bodies and a sinusoidal pin the model has odd harmonics only. With
        Listing A.1, driven at the measured frequency, the fifth is larger than the third, because it meets
        the natural mode at {known.numbers.modes[2].frequency:.1f} Hz.
    """)


@claim("tab-3.1")
def first_table(_: Evidence) -> Record:
    for order, printed in peaks.TABLE_1.items():
        number, fault = order * peaks.DRIVE_BIN, None
        second = by_numpy(number)
        if order == 5:  # which is no bin as the copy has it
            fifth = Decimal(peaks.TABLE_1[3]) + Decimal(DIFFERENCE)
            means = "$f_3$ and the difference that the table prints"
            second = close(means, float(fifth), float(number * peaks.BIN), 1e-6)
            restored = PrintedDigits(str(fifth), number * peaks.BIN, "Hz")
            fault = lost_in_the_copy("the second digit, a 4 read as a 5", restored)
        item = DRIVE_ITEM if order == 1 else ""
        frequency = number * peaks.BIN
        yield digits(f"$f_{order}$", printed, frequency, "Hz", second=second, item=item, copy_fault=fault)
    number = 2 * peaks.DRIVE_BIN
    for label in ("$f_3 - f_1$", "$f_5 - f_3$"):
        yield digits(label, DIFFERENCE, number * peaks.BIN, "Hz", second=by_numpy(number))
    bins = ", ".join(str(order * peaks.DRIVE_BIN) for order in peaks.TABLE_1)
    yield text(f"""
        The peaks are the bins {bins} of {float(peaks.BIN):.4f} Hz, so $f_5$ is
        {float(5 * peaks.DRIVE_BIN * peaks.BIN):.3f} Hz. In the copy it is {peaks.TABLE_1[5]} Hz, which is no
        bin, is not five times the first, and contradicts the
        difference beside it. With that one digit put right the three are odd multiples of one frequency, as
        the text says. The difference is right, so the digit may have been misread in the copy.
    """)


def by_numpy(number: int) -> Confirmation:
    """Confirm the frequency of a bin."""
    frequencies = bins(FRAMES_OF_TABLES, SAMPLE_RATE)
    return close("NumPy's bins", float(frequencies[number]), float(number * peaks.BIN))


@claim("tab-3.2")
def second_table(_: Evidence) -> Record:
    measured = {}
    for name, row in TABLE_2.items():
        measured[name] = {order: peaks.nearest_bin(cell) for order, cell in enumerate(row, start=1)}
        for (order, number), printed in zip(measured[name].items(), row, strict=True):
            second = by_numpy(number)
            if not peaks.on_a_bin(printed):
                first = float(TABLE_2["M1"][0])
                second = close("the same peak in measurement 1", first, float(number * peaks.BIN), 1e-6)
            item = {TABLE_2["M1"][0]: DRIVE_ITEM, TABLE_2["M2"][0]: MISPRINTED_ITEM}.get(printed, "")
            yield digits(f"{name}, $f_{order}$", printed, number * peaks.BIN, "Hz", second=second, item=item)
    ranges = {name: peaks.common_drive(row, Fraction(1)) for name, row in measured.items()}
    places = ", ".join(f"{name} {low:.2f} to {high:.2f} Hz" for name, (low, high) in ranges.items())
    closest = [peaks.common_drive(row, Fraction(1, 2)) for row in measured.values()]
    fitting = sum(low <= high for low, high in closest)
    search = "a search over drives from 100 to 120 Hz in steps of a millihertz"
    yield assertion(
        "unequal differences",
        "they stay within the resolution: one bin from multiples of one drive frequency",
        tuple(low <= high for low, high in ranges.values()),
        f"the drive would be at {places}; within half a bin {fitting or 'none'} of the three fits",
        method="intervals of the drive's frequency, intersected over the five peaks",
        second=so(search, tuple(a_drive_fits(row, float(peaks.BIN)) for row in measured.values())),
    )
    yield text(f"""
        All cells but two are bins of {float(peaks.BIN):.4f} Hz to the last digit. In those two
        {TABLE_2["M2"][0]} stands for {TABLE_2["M1"][0]}; the same slip twice is hardly a fault of the copy.
        The text puts unequal differences down to the resolution, which is right: with peaks one bin off, a
        common drive fits each measurement. With the nearest bins none does, so peaks were shifted, by leakage
        or because the motor did not run evenly.

        The two cells change nothing else. That $f_2$ and $f_4$ are there at all matters more, see the
        [comparison with the model](#txt-3.3-open-loop-odd).
    """)


@claim("txt-3.2-drive-frequency")
def drive_frequency(_: Evidence) -> Record:
    drive = peaks.DRIVE_BIN * peaks.BIN
    means = "a third of the third harmonic in table 3.1"
    second = close(means, float(peaks.TABLE_1[3]) / 3, float(drive), 1e-6)
    for place, printed, item in QUOTED:
        yield digits(place, printed, drive, "Hz", second=second, item=item)
    share = abs(float(ABOUT) / float(drive) - 1)
    yield assertion(
        "sections 3.2 and 3.3, called approximate",
        f"the drive runs at about {ABOUT} Hz",
        share <= ABOUT_SHARE,
        f"{ABOUT} Hz is {100 * share:.1f} % below the first peak",
        method="quotient of the two frequencies",
        second=second,
    )
    odd = {order: order * peaks.DRIVE_BIN for order in peaks.TABLE_1}
    low, high = peaks.common_drive(odd, Fraction(1, 2))
    yield text(f"""
        The first two peaks of table 3.1 are 1 and 3 times {QUOTED[0][1]} Hz. The text calls them multiples of
        {QUOTED[1][1]} Hz, which has one digit wrong, and table 3.2 has {QUOTED[2][1]} Hz twice; neither is a
        bin of these spectra. By the bins of experiment 1 the drive lies between {low:.2f} and {high:.2f} Hz,
        so the three decimals carry no information.

        No result is affected: section 5.2.1 and appendix A.9 quote {QUOTED[1][1]} Hz again, and the models of
        chapters 4 and 5 run at {DRIVE_FREQUENCY:.0f} Hz.
    """)


@claim("txt-3.2-play-place")
def place_of_the_play(known: Evidence) -> Record:
    bodies = sympy.hessian(known.derivation.kinetic_energy, velocities).rank()
    yield assertion(
        "experiment 2",
        "the play lies between driving bridge and cutter",
        bodies == len(MOVING_PARTS),
        f"""
        sections 1.1, 2.3.4 and 3.1 have it between pin and driving bridge; bridge and cutter are one of the
        {bodies} bodies, with one displacement, so there is no joint between them that could have play
        """,
        method="rank of the mass matrix against the parts that the text names",
        second=equal("a count of the bodies", len(known.derivation.mechanism.bodies), bodies),
    )
    yield text("""
        Here the play was added between driving bridge and cutter. Section 1.1 calls these two rigidly
        connected, section 3.1 announces play between pin and bridge, and every model of the thesis has it
        there. Read as a slip of the pen nothing follows from it.

        Read as it stands, no model of the thesis describes the second experiment: the bridge would need a
        mass of its own.
    """)


@claim("txt-3.2-predicted-488")
def predicted_frequency(known: Evidence) -> Record:
    missing = "the parameters of the experiment's trimmer (table C.1) and figure C.3, both confidential"
    yield uncheckable("frequency of the prediction", "488 Hz", missing)
    yield text(f"""
        The number cannot be checked; for another trimmer, that of Listing A.1, the two limit cycles lie at
        {known.cycles.friction.unstable.frequency:.1f} and {known.cycles.friction.stable.frequency:.1f} Hz. It
        belongs to a loop that feeds the output back to the pin. In the experiment a motor moves the pin, and
        in the thesis's model of that no motion of another frequency can last. So the missing peak neither
        contradicts the describing function nor shows that friction suppressed a limit cycle, see [the missing
        limit cycle](#txt-3.2-no-limit-cycle).
    """)


@claim("txt-3.2-no-limit-cycle")
def no_limit_cycle(known: Evidence) -> Record:
    periodic, second = driven.has_the_drives_period(known), driven.confirm_period(known)
    every = "every motion of the driven model ends in one that repeats with the drive"
    for experiment in ("experiment 1, friction alone", "experiment 2, play and friction"):
        none = "there is no limit cycle"
        yield assertion(experiment, none, periodic, every, method=driven.METHOD, second=second)
    yield uncheckable("the spectra hold no further frequency", "No additional frequencies", RAW_DATA)
    yield assertion(
        "a peak in the spectrum of the driven trimmer",
        "a limit cycle that the describing function predicts is to be expected there",
        not periodic,
        driven.period_in_words(known),
        method=driven.METHOD,
        second=second,
    )
    yield text("""
        What is printed as found, no limit cycle in either experiment, is what the model demands for every gap
        and friction: a driven trimmer has none where play only passes the pin's displacement on, as in the
        thesis. Only the remark that the describing function promised one is wrong. The thesis says itself
        that nothing came of it, and draws no conclusion from it, so the card is graded as a slip. A bridge
        that rattles in its play with a mass of its own is outside of that model and of this proof; what it
        does is computed in the chapter on the real trimmer.

        The experiment cannot test the describing function, nor whether friction or play could keep a limit
        cycle up in a loop; a loop with feedback would have to be built.
    """)
