"""Claims on figures 3.1 to 3.9: measured motions and their spectra, simulated open and closed loop."""

from __future__ import annotations

import numpy as np

from report.chapters.chapter_3.claims import driven_steady_motion as driven
from report.chapters.chapter_3.claims.section_3_2 import RAW_DATA
from report.chapters.chapter_6.claims.sections_6_3_and_6_4 import GAPS_QUOTED
from report.claim import Impact, Part, Uncheckable
from report.comparisons.printed import power_of
from report.evidence import Evidence
from report.numbers.driven_motion import FORCES, DrivenRun
from report.numbers.independent.harmonics import guard_over_cutter
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, line_near_second_mode
from report.parts import assertion, close, digits, so, uncheckable
from report.record import Record, claim, text
from report.thesis import DRIVE_AMPLITUDE, EXPERIMENT_GAP, LARGER_GAP, LARGEST_GAP, SAMPLE_RATE, TABLE_2
from trimmer import FrictionBacklash

OPEN_LOOP, CLOSED_LOOP = "report/numbers/driven_motion.py", "report/numbers/released_motion.py"
AT_THE_DRIVE = f"{driven.BY_LISTING}, 109.945 Hz and 1.5 mm, three forces of friction"
PARAMETERS = "the parameters of the experiment's trimmer (table C.1), which are confidential"
SETTLED = int(0.1 * SAMPLE_RATE)
"""Samples at the end of a run, when the start has died out: as many as the experiment recorded."""


def measured(what: str) -> Uncheckable:
    """Return the part on the recorded curves of a figure."""
    return uncheckable(what, "curves of three measurements", RAW_DATA)


def simulated(missing: str = PARAMETERS) -> Uncheckable:
    """Return the part on the simulated curves of a figure."""
    return uncheckable("curves", "curves for three forces of friction", missing)


@claim("fig-3.1", source=OPEN_LOOP)
def motions_without_play(known: Evidence) -> Record:
    yield from motions(known, 0.0, "without play")


@claim("fig-3.3", source=OPEN_LOOP)
def motions_with_play(known: Evidence) -> Record:
    yield from motions(known, EXPERIMENT_GAP, "with play")


def motions(known: Evidence, gap: float, case: str) -> Record:
    """Yield what the figures of the measured motions, with and without play, consist of."""
    runs = driven.runs_with(known, gap)
    settled = [(run.guard[run.last(SETTLED)], run.cutter[run.last(SETTLED)]) for run in runs]
    shares = [float(np.ptp(guard) / np.ptp(cutter)) for guard, cutter in settled]
    bound = max(guard_over_cutter(known.numbers.parameters, gap, run.force) for run in runs)
    means = f"a bound from harmonics, {100 * bound:.0f} %, for any friction up to these forces"
    yield assertion(
        "cutter and guard",
        "the cutter moves more than the guard",
        max(shares) < 1,
        f"the guard moves {100 * min(shares):.1f} to {100 * max(shares):.1f} % as far",
        method=AT_THE_DRIVE,
        second=so(means, bound < 1),
    )
    yield measured("measured motions")
    yield text("""
        The model [[ case ]] moves as the text describes. The recorded curves cannot be checked, and the
        figure drawn here has the parameters of Listing A.1, not those of the experiment's trimmer.
    """).given(case=case)


def largest(run: DrivenRun) -> set[int]:
    """Return the orders of the three largest harmonics."""
    return set(sorted(range(1, run.harmonics.size), key=lambda order: -run.harmonics[order])[:3])


@claim("fig-3.2", source=OPEN_LOOP)
def spectrum_without_play(known: Evidence) -> Record:
    runs = driven.runs_with(known, 0.0)
    first, third, fifth, seventh = (1e6 * runs[1].harmonics[order] for order in (1, 3, 5, 7))
    three = f"{first:.0f}, {third:.0f} and {fifth:.0f}"
    yield assertion(
        "peaks",
        "the three dominant peaks are the first, third and fifth harmonic",
        all(largest(run) == {1, 3, 5} for run in runs),
        f"with {runs[1].force} N {three} µm; the next, the seventh, has {seventh:.1f} µm",
        method=AT_THE_DRIVE,
        second=driven.confirm_friction(known),
    )
    yield measured("measured spectra")
    yield text("""
        The model with friction alone has these three as its largest peaks too, for each of the forces of
        section 3.3. The measured spectra cannot be checked; their peaks are those of table 3.1.
    """)


@claim("fig-3.4", source=OPEN_LOOP)
def spectrum_with_play(known: Evidence) -> Record:
    gap = float("200e-6")
    again = close("chapter 6, which quotes the gap again", float(GAPS_QUOTED["chapter 6"]), gap)
    caption = r"gap in the caption, from $200\times10^{-6}$ m"
    yield digits(caption, "200", 1e6 * gap, "µm", second=again)
    growth = [
        float(play.harmonics[order] / none.harmonics[order])
        for none, play in zip(
            driven.runs_with(known, 0.0), driven.runs_with(known, EXPERIMENT_GAP), strict=True
        )
        for order in (3, 5, 7)
    ]
    factors = f"factors of {min(growth):.1f} to {max(growth):.1f}"
    yield assertion(
        "harmonics",
        "with play the higher harmonics are larger than without",
        min(growth) > 1,
        f"third, fifth and seventh by {factors}, for the same friction",
        method=AT_THE_DRIVE,
        second=driven.confirm_play(known, EXPERIMENT_GAP),
    )
    yield measured("measured spectra")
    yield text("""
        Play of 0.2 mm raises the odd harmonics in the model. It adds no even ones, which table 3.2 lists as
        measured, see section 3.3.
    """)


@claim("fig-3.5", source="report/chapters/chapter_3/claims/measured_peaks.py")
def enlarged_spectrum(_: Evidence) -> Record:
    frequencies = [float(cell) for row in TABLE_2.values() for cell in row[1:]]
    low, high = min(frequencies), max(frequencies)
    yield assertion(
        "range of frequencies",
        "200 to 1000 Hz shows every tabulated harmonic but the first",
        low >= 200 and high <= 1000,
        f"they lie between {low:.3f} and {high:.3f} Hz",
        method="read in table 3.2",
    )
    yield measured("measured spectra")
    yield text("""
        The range fits the table. The sixth to ninth harmonic would lie in it as well, but are not tabulated;
        what was measured of them cannot be checked.
    """)


@claim("fig-3.6", source=OPEN_LOOP)
def smallest_gap(known: Evidence) -> Record:
    even = power_of(max(float(run.harmonics[::2].max()) for run in driven.runs_with(known, EXPERIMENT_GAP)))
    yield assertion(
        "spectrum",
        "it holds the odd harmonics of the drive and nothing else",
        driven.has_odd_harmonics_only(known),
        f"even harmonics up to {even} m, which is rounding and what is left of the start",
        method=driven.METHOD,
        second=driven.confirm_odd(known),
    )
    yield simulated()
    yield text("""
        Drawn with Listing A.1 the open loop shows what the text describes: the third and fifth harmonic
        beside the fundamental, and no other frequency. The heights depend on the trimmer, whose parameters
        are not given.
    """)


def following_the_drive(known: Evidence) -> Part:
    """Return the part on the largest gap, which the pin does not cross."""
    output = max(float(np.abs(run.output).max()) for run in driven.runs_with(known, LARGEST_GAP))
    element = FrictionBacklash(LARGEST_GAP).describing_function(DRIVE_AMPLITUDE)
    pin, play = 1e3 * DRIVE_AMPLITUDE, 1e3 * LARGEST_GAP
    free = f"the pin moves by {pin:.1f} mm to either side and its play is {play:.0f} mm wide"
    domain = "the domain of the describing function, which begins at half a gap"
    return assertion(
        r"$b$ = $200\times10^{-4}$ m",
        "the trimmer moves with the drive",
        output > 0,
        f"{free}, so it never reaches the bridge and the output stays at {output:.0f}",
        method=driven.BY_LISTING,
        second=so(domain, bool(np.isnan(element))),
    )


@claim("fig-3.7", source=OPEN_LOOP, impact=Impact.DOWNSTREAM)
def largest_gap(known: Evidence) -> Record:
    yield following_the_drive(known)
    thirds, fifths = (driven.micrometres(driven.runs_with(known, LARGER_GAP), order) for order in (3, 5))
    found = f"the third harmonic has {driven.listed(thirds)} µm, the fifth {driven.listed(fifths)}"
    fall = bool(np.all(np.diff(thirds) < 0) and np.all(np.diff(fifths) < 0))
    yield assertion(
        r"additional oscillations, drawn for $b$ = $200\times10^{-5}$ m",
        "friction makes them smaller and leaves their frequencies",
        fall and driven.has_odd_harmonics_only(known),
        f"{found} µm for 0.25, 0.50 and 0.75 N, at multiples of the drive's frequency",
        method=driven.BY_LISTING,
        second=driven.confirm_play(known, LARGER_GAP),
    )
    yield simulated()
    yield text("""
        A play of 20 mm lets a pin of 1.5 mm, the eccentricity of section 5.2.1, swing freely: nothing can
        move. Either the gap is misprinted or the pin moved by more than a centimetre. At 2 mm the model has
        two additional oscillations as described, which are the third and fifth harmonic; if $b$ were half of
        the gap, that play would not be crossed either.

        It is open what section 3.3 shows for its largest gap, and the oscillations do not suggest a limit
        cycle: harmonics of the drive look the same.
    """)


@claim("fig-3.8", source=OPEN_LOOP, impact=Impact.DOWNSTREAM)
def spectrum_of_the_largest_gap(known: Evidence) -> Record:
    yield following_the_drive(known)
    same = "all motions end with the same velocities, which repeat with the drive"
    repeat = power_of(known.motion.driven.run(LARGER_GAP, FORCES[0]).repeat)
    yield assertion(
        "settled motion, any gap",
        "it holds frequencies that are no harmonics of the drive",
        not driven.has_odd_harmonics_only(known),
        f"{same}; with a gap of 2 mm the last two periods differ by {repeat}",
        method=driven.METHOD,
        second=driven.confirm_odd(known),
    )
    yield simulated()
    yield text("""
        With the printed gap the spectrum would be empty, see figure 3.7. With a gap that is crossed it holds
        the odd harmonics, and, if the record begins with the start, natural modes that die out: with Listing
        A.1 at [[ mode | f0 ]] Hz, in the place of the peak at 366 Hz.

        See the peak at 365.999 Hz.
    """).given(mode=known.numbers.modes[1].frequency)


@claim("fig-3.9", source=CLOSED_LOOP)
def released_loop(known: Evidence) -> Record:
    released = known.motion.released
    lines = {
        (gap, force): line_near_second_mode(released.released(gap, force, INSIDE)) / gap
        for gap in (EXPERIMENT_GAP, LARGEST_GAP)
        for force in FORCES_OF_FIGURE
    }
    least, *_, most = FORCES_OF_FIGURE
    small, large = (lines[gap, most] / lines[gap, least] for gap in (EXPERIMENT_GAP, LARGEST_GAP))
    left = f"{100 * small:.0f} % with 0.2 mm and to {100 * large:.0f} % with 20 mm"
    scaling = "the scaling of the model, by which 20 mm with 0.25 N is a hundred times 0.2 mm with 0.0025 N"
    yield assertion(
        "peak near 350 Hz, released inside of the play",
        "friction suppresses it, and the larger gap needs more",
        small < large and lines[EXPERIMENT_GAP, most] < lines[EXPERIMENT_GAP, least],
        f"from {least} to {most} N it falls to {left}, released from {INSIDE} gaps",
        method=driven.BY_LISTING,
        second=close(scaling, lines[LARGEST_GAP, most], lines[EXPERIMENT_GAP, least]),
    )
    yield simulated(f"{PARAMETERS}; and from which state the loop was released")
    lasting = released.released(LARGEST_GAP, least, OUTSIDE)
    yield text("""
        All that the text reads from the figure also happens when nothing but a natural mode dies out. A limit
        cycle would do the same at another frequency, with Listing A.1 at [[ frequency | f0 ]] Hz, and would
        have an amplitude of [[ amplitude | f0 ]] mm in a gap of 20 mm, which no trimmer has room for.
    """).given(frequency=lasting.frequency, amplitude=1e3 * lasting.amplitude)
