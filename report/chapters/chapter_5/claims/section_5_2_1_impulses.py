"""Claims of section 5.2.1 on the simulated closed loop at the gap that is taken for the smallest."""

import math

from report.chapters.chapter_5.claims.section_5_2_1_scaling import SMALLEST_GAP
from report.judging.claim import ClaimPart
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, equal
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.impulse_response import ABOVE, CHECKED
from trimmer import FrictionBacklash, limit_cycles

NO_OSCILLATION = "no oscillation for 1e-8 m and oscillation for 3e-8 m, simulated closed loop"
"""Thing that the text and figure 5.7 state."""
EDGE = 2e-8  # Gap that the section takes for the smallest with a limit cycle, m


@claim("txt-5.2.1-touching")
def touching(known: Evidence) -> Record:
    element = FrictionBacklash(EDGE)
    predicted, listed = (
        limit_cycles(system, element) for system in (known.numbers.displacement_only, known.cycles.listing)
    )
    stable = max(predicted, key=lambda cycle: cycle.amplitude)
    yield assertion(
        r"the curves for $2\times10^{-8}$ m",
        "they just touch, so that no limit cycle is predicted",
        tuple(cycle.near_tangency for cycle in predicted),
        f"""
        they cross {len(predicted)} times, at {math.degrees(stable.crossing_angle):.0f} degrees for the stable
        one, with {1e9 * stable.amplitude:.1f} nm
        """,
        method="all solutions of harmonic balance for that gap",
        second=equal("the coefficients of Listing A.9", len(listed), len(predicted)),
        item=SMALLEST_GAP,
    )
    simulated = max(run.amplitude for run in known.motion.closed.impulses.runs if run.gap == EDGE)
    exact = EDGE * known.orbits.friction.stable.amplitude
    yield assertion(
        "the small oscillation that is simulated",
        "it agrees with what harmonic balance gives",
        abs(simulated / stable.amplitude - 1) < 0.01,
        f"{1e9 * simulated:.1f} nm, beside {1e9 * stable.amplitude:.1f} nm",
        method="exact simulation, struck hard enough",
        second=close("the exact orbit, by shooting", exact, simulated, 1e-4),
    )
    yield text(r"""
        The section predicts no limit cycle for $2\times10^{-8}$ m, sees a small oscillation in the
        simulation, and concludes that the two agree. Harmonic balance does agree with the simulation, because
        it predicts that oscillation: the curves of this gap are those of every gap and cross twice.

        The agreement that is found speaks for the method and against the threshold.
    """)


def one_impulse_part(known: Evidence) -> ClaimPart:
    """Return the part on one impulse for several gaps."""
    numbers = known.motion.closed.impulses
    means = f"events in the first {1e3 * CHECKED:.0f} ms after {ABOVE} thresholds, by SciPy's DOP853"
    return assertion(
        "with one impulse for all gaps",
        r"there is one after which the loop dies out for $10^{-8}$ m and goes on for $3\times10^{-8}$ m",
        not numbers.one_threshold,
        rf"""
        impulse over gap alone decides: of {len(numbers.impulses)} impulses over nine decades those below
        {1e6 * numbers.threshold:.2f} µs die out and those above go on, so $10^{{-8}}$ m goes on wherever
        $3\times10^{{-8}}$ m does
        """,
        method="scaling of the model; exact simulation over the whole range",
        second=equal(means, *numbers.counted),
        item=NO_OSCILLATION,
        certainty=Certainty.READING,
    )


@claim("txt-5.2.1-impulse-1e-8")
def impulse(known: Evidence) -> Record:
    numbers = known.motion.closed.impulses
    strongest = max(run.impulse for run in numbers.runs)
    smallest, middle, largest = (run for run in numbers.runs if run.impulse == strongest)
    exact = known.orbits.friction.stable.amplitude * smallest.gap
    yield one_impulse_part(known)
    yield assertion(
        r"what is left for $10^{-8}$ m after an impulse that $3\times10^{-8}$ m goes on after",
        "no oscillation",
        smallest.amplitude < smallest.gap / 2,
        rf"""
        {1e9 * smallest.amplitude:.1f} nm, beside {1e9 * middle.amplitude:.1f} nm for $2\times10^{{-8}}$ m and
        {1e9 * largest.amplitude:.1f} nm for $3\times10^{{-8}}$ m
        """,
        method=f"exact simulation of the three gaps with {power_of(strongest)} m s",
        second=close("the exact orbit for $10^{-8}$ m, by shooting", exact, smallest.amplitude, 1e-4),
        item=NO_OSCILLATION,
    )
    yield text(rf"""
        The text names one impulse input and gives no size. Impulse, gap and motion times one factor are again
        a motion, so with one impulse it is the larger gap that dies out, if any: $3\times10^{{-8}}$ m does
        below {power_of(3e-8 * numbers.threshold, 2)} m s, $10^{{-8}}$ m below a third of that. Where all go
        on, they oscillate as 1 : 2 : 3 after a first swing of {numbers.peak:.0f}/s times the impulse, beside
        which the smallest is easily not seen. If the impulse was smaller for the smaller gap, any outcome is
        possible.

        In neither case does the simulation support a threshold in the gap, which chapters 6 and 7 quote. What
        matters is how hard the loop is struck.
    """)
