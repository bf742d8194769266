"""Claims of section 5.2.1, and of chapters 6 and 7, on gap and amplitude: proportion, and a smallest gap."""

import math

from report.chapters.chapter_5.claims.section_5_2_1_predictions import SCALING, TINY_GAP, at_the_tiny_gap
from report.judging.claim import ClaimPart
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.limit_cycle_numbers import LimitCycleNumbers
from report.numbers.thesis import PLOT_OFFSET
from trimmer import FrictionBacklash, limit_cycles

SMALLEST_GAP = "2e-8 m, smallest gap with a limit cycle"
PROPORTIONAL = "the amplitude is proportional to the gap, the frequency does not depend on it"
"""Things that are printed in more than one place."""


def stable_at_the_tiny_gap(cycles: LimitCycleNumbers) -> float:
    """Return the stable amplitude over a tiny gap, with the coefficients of Listing A.9."""
    (cycle,) = (each for each in limit_cycles(cycles.listing, FrictionBacklash(TINY_GAP)) if each.stable)
    return cycle.amplitude / TINY_GAP


def proportional_part(known: Evidence) -> ClaimPart:
    """Return the part on proportion, which section 5.2.1 and chapter 7 share."""
    cycles, cycle = known.cycles, known.cycles.friction.stable
    listed = cycles.friction_listing.stable.amplitude
    return assertion(
        "",
        PROPORTIONAL,
        math.isclose(stable_at_the_tiny_gap(cycles), listed, rel_tol=1e-9),
        rf"$A = {cycle.amplitude:.4f}\,b$ at {cycle.frequency:.2f} Hz for every gap $b$",
        method=SCALING,
        second=at_the_tiny_gap(known, cycle),
        item=PROPORTIONAL,
        certainty=Certainty.PROVEN,
    )


@claim("txt-5.2.1-proportional")
def proportional(known: Evidence) -> Record:
    yield proportional_part(known)
    yield text(r"""
        $N$ depends on $b/A$ alone, so a solution $(A, \omega)$ for the gap $b$ gives the solution $(kA,
        \omega)$ for $kb$. The same holds for every kind of backlash. It excludes a smallest gap, which the
        [section itself states](#txt-5.2.1-threshold).
    """)


@claim("txt-7-proportional")
def proportional_in_chapter_7(known: Evidence) -> Record:
    yield proportional_part(known)
    yield text("""
        It is so, for every kind of backlash, [as at section 5.2.1](#txt-5.2.1-proportional).
    """)


def smallest_gap_part(known: Evidence) -> ClaimPart:
    """Return the part on the smallest gap, which section 5.2.1 and chapter 6 share."""
    listed = known.cycles.friction_listing.stable.amplitude
    means = "the scaling law, at a gap of a thousandth of that"
    second = close(means, stable_at_the_tiny_gap(known.cycles), listed)
    label, item = "smallest gap with a limit cycle", SMALLEST_GAP
    return digits(label, "2e-8", 0.0, "m", second=second, item=item, certainty=Certainty.PROVEN)


@claim("txt-5.2.1-threshold")
def threshold(known: Evidence) -> Record:
    stable = known.cycles.friction.stable.amplitude
    yield smallest_gap_part(known)
    yield text(f"""
        There is no threshold. $N$ depends on $b/A$ alone, so if one gap has a limit cycle, every gap has one
        with an amplitude in proportion: at $b = 10^{{-8}}$ m it is {power_of(stable * 1e-8, 2)} m. A curve
        that is plotted from $b/2 + 10^{{-6}}$ m on, as in Listing A.9, meets $G$ only for gaps above
        {power_of(PLOT_OFFSET / (stable - 0.5), 1)} m; another start gives another apparent threshold.

        Chapters 6 and 7 and the answer to the main question rest on this threshold. No gap is small enough to
        exclude the predicted limit cycle. What remains is its size, {stable:.1f} times the gap, and whether
        friction and drive let it start.
    """)


@claim("txt-6-threshold")
def threshold_in_chapter_6(known: Evidence) -> Record:
    yield smallest_gap_part(known)
    yield text("""
        There is no smallest gap, [as at section 5.2.1](#txt-5.2.1-threshold), from which the number is taken.

        A gap cannot be made small enough to exclude the predicted limit cycle.
    """)
