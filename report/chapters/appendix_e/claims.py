"""Claims on figures E.1 and E.2: the closed loop for several gaps, the open loop for several amplitudes."""

from report.chapters.chapter_3.claims import driven_steady_motion as driven
from report.chapters.chapter_5.claims.section_5_2_1_driven import open_loop_harmonic
from report.judging.parts import assertion, close, digits
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence
from report.numbers.independent.harmonics import RIPPLE, ripple_behind_backlash
from report.numbers.thesis import DRIVE_OMEGA, LARGE_GAP

PREDICTED = {3e-4: "0.0025", 4e-4: "0.0033", 5e-4: "0.0041", 6e-4: "0.0050"}
"""Amplitudes of table 5.2 for the gaps of figure E.1, m."""
ALIKE = 1e-9
CONSTANT = 0.05  # Share by which a ripple may change and still be called unaltered
SEVENTH = 7
UNALTERED = "the amplitude of the drive does not alter it"
DRIVE_ITEM = "the drive's amplitude does not alter the limit cycle"
OPEN_LOOP_ITEM = "the open loop shows the limit cycle of the closed loop"


@claim("fig-E.1")
def gaps(known: Evidence) -> Record:
    runs, cycle = known.motion.released.appendix, known.cycles.friction.stable
    for run in runs:
        second = close("harmonic balance", cycle.amplitude * run.gap, run.amplitude, 0.005)
        label = f"amplitude for $b$ = {run.gap:g} m, as in table 5.2"
        item = f"{PREDICTED[run.gap]} m, amplitude for b = {1e4 * run.gap:.0f}e-4 m in table 5.2"
        yield digits(label, PREDICTED[run.gap], run.amplitude, "m", second=second, item=item)
    frequencies = [run.frequency for run in runs]
    by_durations = "the exact orbit by two durations, with SciPy's matrix exponential"
    yield assertion(
        "frequencies",
        "all four have the same frequency",
        max(frequencies) / min(frequencies) - 1 < ALIKE,
        f"""
        {frequencies[0]:.2f} Hz in each; the prediction without rounded coefficients is {cycle.frequency:.2f}
        Hz
        """,
        method="exact simulation",
        second=close(by_durations, known.orbits.friction_by_durations[1], frequencies[0], 1e-5),
    )
    yield text(f"""
        The exact amplitude is {runs[0].amplitude / runs[0].gap:.4f} gaps, the predicted one
        {cycle.amplitude:.4f}; to the digits of [table 5.2](#tab-5.2) they are the same. That all four agree
        is one result, not four: gap and displacements times one factor give the same motion. The text's
        reference to the table is printed as two question marks.
    """)


def unaltered(ripples: list[float]) -> bool:
    """Tell whether ripples (m) differ by no more than a share of the largest."""
    return max(ripples) - min(ripples) < CONSTANT * max(ripples)


@claim("fig-E.2")
def amplitudes(known: Evidence) -> Record:
    system, runs = known.numbers.displacement_only, known.motion.drive_amplitudes
    still, smallest, thesis, *_, largest = runs
    ripples = [run.ripple for run in runs]
    by_lines = f"{RIPPLE.size} lines of the element's waveform times the response, at 0.15 mm"
    ripple = ripple_behind_backlash(system, LARGE_GAP, smallest.amplitude, DRIVE_OMEGA)
    shown = ", ".join(f"{1000000.0 * run.ripple:.1f} µm at {1000.0 * run.amplitude:g} mm" for run in runs[1:])
    yield assertion(
        "oscillation on top of the drive's, all five amplitudes",
        UNALTERED,
        unaltered(ripples),
        f"""
        at {1e6 * still.amplitude:.1f} µm the pin stays within its play of {1e6 * LARGE_GAP:.0f} µm and
        nothing moves; above it half of peak to peak without the first harmonic is {shown}
        """,
        method="exact simulation from rest",
        second=close(by_lines, ripple, smallest.ripple, 0.001),
        item=DRIVE_ITEM,
        severity=Severity.RESULT,
    )
    seventh = open_loop_harmonic(known, SEVENTH)
    by_response = "the seventh harmonic from describing function and frequency response"
    yield assertion(
        r"the same, from $1.5\times10^{-3}$ m on",
        UNALTERED,
        unaltered(ripples[2:]),
        f"it changes by {100 * (1 - thesis.ripple / largest.ripple):.1f} %",
        method="exact simulation from rest",
        second=close(by_response, seventh, thesis.harmonics[SEVENTH], 1e-4),
        item=DRIVE_ITEM,
    )
    yield assertion(
        "what it is",
        "it is a limit cycle",
        not driven.has_the_drives_period(known),
        """
        it consists of odd harmonics of the drive; far above the gap the play gives the pin's motion less a
        square wave of half a gap, whatever the amplitude
        """,
        method=driven.METHOD,
        second=driven.confirm_period(known),
        item=OPEN_LOOP_ITEM,
        severity=Severity.CONCLUSION,
        certainty=Certainty.PROVEN,
    )
    smaller = 100 * (1 - smallest.ripple / largest.ripple)
    yield text(f"""
        A drive far larger than the gap leaves a square wave of half a gap behind the play, whatever its
        amplitude, so the ripple tends to {1e6 * largest.ripple:.1f} µm. That explains the observation without
        a limit cycle, which the open loop does not have. At {f"{1e3 * smallest.amplitude:g}"} mm the ripple
        is {smaller:.0f} % smaller, and at {f"{1e6 * still.amplitude:g}"} µm nothing moves.

        The answer of chapter 7, that the drive's amplitude has no effect on a limit cycle, rests on
        harmonics.
    """)
