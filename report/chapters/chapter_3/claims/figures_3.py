"""Claims on figures 3.1 to 3.9: measured motions and their spectra, simulated open and closed loop."""

from collections.abc import Sequence

import numpy as np

from report.chapters.chapter_3.claims import driven_steady_motion as driven
from report.chapters.chapter_3.claims.section_3_2 import RAW_DATA
from report.chapters.chapter_6.claims.sections_6_3_and_6_4 import GAPS_QUOTED
from report.judging.claim import ClaimPart, Uncheckable
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, so, uncheckable
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.driven_motion import FORCES, DrivenRun, transient_peaks
from report.numbers.evidence import Evidence
from report.numbers.independent.harmonics import guard_over_cutter
from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, line_near_second_mode
from report.numbers.thesis import (
    DRIVE_AMPLITUDE,
    EXPERIMENT_GAP,
    LARGER_GAP,
    LARGEST_GAP,
    MEASURED_DRIVE_FREQUENCY,
    OPEN_LOOP_PEAK,
    SAMPLE_RATE,
    TABLE_2,
)
from trimmer import FrictionBacklash

AT_THE_DRIVE = f"{driven.BY_LISTING}, 109.945 Hz and 1.5 mm, three forces of friction"
PARAMETERS = "the parameters of the experiment's trimmer (table C.1), which are confidential"
SETTLED = int(0.1 * SAMPLE_RATE)
"""Samples at the end of a run, when the start has died out: as many as the experiment recorded."""
OFF_A_HARMONIC = 0.1
"""Distance from a multiple of the drive's frequency at which a peak is no harmonic, as a share of it."""


def measured(what: str) -> Uncheckable:
    """Return the part on the recorded curves of a figure."""
    return uncheckable(what, "curves of three measurements", RAW_DATA)


def simulated(missing: str = PARAMETERS) -> Uncheckable:
    """Return the part on the simulated curves of a figure."""
    return uncheckable("curves", "curves for three forces of friction", missing)


def guard_shares(runs: Sequence[DrivenRun]) -> list[float]:
    """Return how far the guard moves in each settled run, as a share of the cutter's motion."""
    settled = [(run.guard[run.last(SETTLED)], run.cutter[run.last(SETTLED)]) for run in runs]
    return [float(np.ptp(guard) / np.ptp(cutter)) for guard, cutter in settled]


@claim("fig-3.1")
def motions_without_play(known: Evidence) -> Record:
    runs = driven.runs_with(known, 0.0)
    shares = guard_shares(runs)
    bound = max(guard_over_cutter(known.numbers.parameters, 0.0, run.force) for run in runs)
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
        The model without play moves as the text describes. The recorded curves cannot be checked. The figure
        drawn here has the parameters of Listing A.1, another trimmer's, at the drive of the experiment.
    """)


@claim("fig-3.3")
def motions_with_play(known: Evidence) -> Record:
    shares = guard_shares(driven.runs_with(known, EXPERIMENT_GAP))
    yield measured("measured motions")
    yield text(f"""
        The recorded curves cannot be checked, and the text says no more of them. In the model with play the
        guard moves {100 * min(shares):.1f} to {100 * max(shares):.1f} % as far as the cutter. The figure
        drawn here has the parameters of Listing A.1, another trimmer's, at the drive of the experiment.
    """)


def largest(run: DrivenRun) -> set[int]:
    """Return the orders of the three largest harmonics."""
    return set(sorted(range(1, run.harmonics.size), key=lambda order: -run.harmonics[order])[:3])


@claim("fig-3.2")
def spectrum_without_play(known: Evidence) -> Record:
    runs = driven.runs_with(known, 0.0)
    first, third, fifth, seventh = (1e6 * runs[1].harmonics[order] for order in (1, 3, 5, 7))
    three = f"{first:.0f}, {third:.0f} and {fifth:.0f}"
    yield assertion(
        "peaks",
        "the three dominant peaks are the first, third and fifth harmonic",
        tuple(largest(run) == {1, 3, 5} for run in runs),
        f"with {runs[1].force} N {three} µm; the next, the seventh, has {seventh:.1f} µm",
        method=AT_THE_DRIVE,
        second=driven.confirm_friction(known),
    )
    yield measured("measured spectra")
    yield text("""
        The model with friction alone has these three as its largest peaks too, for each of the forces of
        section 3.3; its parameters are those of Listing A.1, its drive is the experiment's. The measured
        spectra cannot be checked; their peaks are those of [table 3.1](#tab-3.1).
    """)


@claim("fig-3.4")
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
    yield text(f"""
        Play of {1e6 * EXPERIMENT_GAP:.0f} µm raises the odd harmonics in the model of Listing A.1, driven as
        in the experiment. It adds no even ones, which table 3.2 lists as measured, see [the open
        loop](#txt-3.3-open-loop-odd).
    """)


@claim("fig-3.5")
def enlarged_spectrum(_: Evidence) -> Record:
    frequencies = [float(cell) for row in TABLE_2.values() for cell in row[1:]]
    low, high = min(frequencies), max(frequencies)
    yield assertion(
        "range of frequencies",
        "200 to 1000 Hz shows every tabulated harmonic but the first",
        (low >= 200, high <= 1000),
        f"they lie between {low:.3f} and {high:.3f} Hz",
        method="read in table 3.2",
    )
    yield measured("measured spectra")
    yield text("""
        The range fits the table. The sixth to ninth harmonic would lie in it as well, but are not tabulated;
        what was measured of them cannot be checked.
    """)


@claim("fig-3.6")
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


def following_the_drive(known: Evidence) -> ClaimPart:
    """Return the part on the largest gap, which the pin does not cross."""
    output = max(float(np.abs(run.output).max()) for run in driven.runs_with(known, LARGEST_GAP))
    element = FrictionBacklash(LARGEST_GAP).describing_function(DRIVE_AMPLITUDE)
    pin, play = 1e3 * DRIVE_AMPLITUDE, 1e3 * LARGEST_GAP
    free = f"the pin moves by {pin:.1f} mm to either side and its play is {play:.0f} mm wide"
    domain = "the domain of the describing function, which begins at half a gap"
    return assertion(
        r"$b$ = $200\times10^{-4}$ m",
        f"driven by {pin:.1f} mm, as in section 5.2.1, the trimmer moves",
        output > 0,
        f"{free}, so it never reaches the bridge and the output stays at {output:.0f}",
        method=driven.BY_LISTING,
        second=so(domain, bool(np.isnan(element))),
        item="200e-4 m, gap of figures 3.7 and 3.8",
        certainty=Certainty.READING,
    )


@claim("fig-3.7")
def largest_gap(known: Evidence) -> Record:
    yield following_the_drive(known)
    thirds, fifths = (driven.micrometres(driven.runs_with(known, LARGER_GAP), order) for order in (3, 5))
    found = f"the third harmonic has {driven.listed(thirds)} µm, the fifth {driven.listed(fifths)}"
    yield assertion(
        r"additional oscillations, drawn for $b$ = $200\times10^{-5}$ m",
        "friction makes them smaller and leaves their frequencies",
        (
            *(rise < 0 for each in (thirds, fifths) for rise in np.diff(each)),
            driven.has_odd_harmonics_only(known),
        ),
        f"{found} µm for 0.25, 0.50 and 0.75 N, at multiples of the drive's frequency",
        method=driven.BY_LISTING,
        second=driven.confirm_play(known, LARGER_GAP),
    )
    yield simulated()
    yield text(f"""
        The stroke of the pin is not given here. If it is the {1e3 * DRIVE_AMPLITUDE} mm of section 5.2.1, a
        play of {1e3 * LARGEST_GAP:.0f} mm lets it swing freely and nothing moves: then another gap was
        simulated. If the gap is right, the pin moves by more than a centimetre, or its velocity bypasses the
        backlash block, which cannot be seen. At {1e3 * LARGER_GAP:.0f} mm the model of Listing A.1 has two
        additional oscillations as described, the third and the fifth harmonic.

        It is open what section 3.3 shows for its largest gap, and the oscillations do not suggest a limit
        cycle: harmonics of the drive look the same.
    """)


@claim("fig-3.8")
def spectrum_of_the_largest_gap(known: Evidence) -> Record:
    yield following_the_drive(known)
    run = known.motion.driven.run(LARGER_GAP, FORCES[0])
    _, peak, *_ = transient_peaks(run)
    mode = known.numbers.modes[1].frequency
    yield assertion(
        "a spectrum that begins with the start",
        "beside harmonics of the drive it shows another frequency",
        abs(peak / MEASURED_DRIVE_FREQUENCY - round(peak / MEASURED_DRIVE_FREQUENCY)) > OFF_A_HARMONIC,
        f"""
        with a gap of {1e3 * run.gap:.0f} mm what dies out after the start has a peak at {peak:.0f} Hz; the
        settled motion holds harmonics only, its last two periods differ by {power_of(run.repeat)}
        """,
        method=AT_THE_DRIVE,
        second=close("the second natural mode", mode, peak, 0.01),
    )
    yield simulated()
    yield text(f"""
        With the printed gap and the stroke of section 5.2.1 the spectrum would be empty, see [figure
        3.7](#fig-3.7). With a gap that is crossed it holds the odd harmonics and, if the record begins with
        the start, natural modes that die out. With Listing A.1 one has its peak at {mode:.0f} Hz; the peak of
        the experiment's trimmer is at {OPEN_LOOP_PEAK} Hz.

        Whether that peak is a limit cycle is judged [at the peak](#txt-3.3-peak-366).
    """)


@claim("fig-3.9")
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
        (small < large, lines[EXPERIMENT_GAP, most] < lines[EXPERIMENT_GAP, least]),
        f"from {least} to {most} N it falls to {left}, released from {INSIDE} gaps",
        method=driven.BY_LISTING,
        second=close(scaling, lines[LARGEST_GAP, most], lines[EXPERIMENT_GAP, least]),
    )
    yield simulated(f"{PARAMETERS}; and from which state the loop was released")
    lasting = released.released(LARGEST_GAP, least, OUTSIDE)
    yield text(f"""
        All that the text reads from the figure also happens when only a natural mode dies out. A limit cycle
        would do the same at another frequency, with Listing A.1 at {lasting.frequency:.0f} Hz, and with an
        amplitude of {1e3 * lasting.amplitude:.0f} mm in a gap of {1e3 * LARGEST_GAP:.0f} mm. Which of the two
        it is, is judged at [the peak near 350 Hz](#txt-3.3-peak-350).
    """)
