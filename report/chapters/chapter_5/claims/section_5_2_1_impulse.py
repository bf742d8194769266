"""Claims of section 5.2.1 on the closed loop after an impulse, and on ten times the gap."""

from __future__ import annotations

import math
from collections.abc import Sequence

from report.chapters.chapter_5.claims.section_5_2_1 import LARGE_GAP
from report.chapters.chapter_5.claims.section_5_2_1_simulated import SECOND_WAY, SOURCE, amplitude_part
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power_of
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.exact_orbits import ExactOrbits
from report.numbers.impulse_response import ABOVE, CHECKED
from report.numbers.record import Record
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.elements.friction_backlash import FrictionBacklash

THIRD_OF_A_SECOND = Record(0.3, 1_000_231)
"""A record whose bin nearest to the exact frequency has the printed digits; its length is not given."""
EDGE = 2e-8
"""Gap that the section takes for the smallest with a limit cycle, m."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_touching(evidence), _impulse(evidence), _larger_gap(evidence))


def one_impulse_part(evidence: Evidence) -> Part:
    """Return the part on one impulse for several gaps."""
    numbers = evidence.motion.closed.impulses
    return Part(
        "one impulse for all gaps",
        Assertion(
            statement=(
                "there is one after which the loop dies out for $10^{-8}$ m and goes on for "
                "$3\\times10^{-8}$ m"
            ),
            derived=not numbers.one_threshold,
            evidence=(
                f"impulse over gap alone decides: of {len(numbers.impulses)} impulses over nine decades "
                f"those below {1e6 * numbers.threshold:.2f} µs die out and those above go on, so $10^{{-8}}$ "
                "m goes on wherever $3\\times10^{-8}$ m does"
            ),
            method="scaling of the model; exact simulation over the whole range",
        ),
        Confirmation(
            f"events in the first {1e3 * CHECKED:.0f} ms after {ABOVE} thresholds, by SciPy's DOP853",
            CloseNumbers(*numbers.counted),
        ),
    )


def _impulse(evidence: Evidence) -> Claim:
    numbers = evidence.motion.closed.impulses
    left = [run for run in numbers.runs if run.impulse == max(each.impulse for each in numbers.runs)]
    smallest, largest = left[0], left[-1]
    return Claim(
        id="txt-5.2.1-impulse-1e-8",
        parts=(
            one_impulse_part(evidence),
            Part(
                "what is left for $10^{-8}$ m after an impulse that $3\\times10^{-8}$ m goes on after",
                Assertion(
                    statement="no oscillation",
                    derived=smallest.amplitude < smallest.gap / 2,
                    evidence=(
                        f"{1e9 * smallest.amplitude:.1f} nm, beside {1e9 * left[1].amplitude:.1f} nm for "
                        f"$2\\times10^{{-8}}$ m and {1e9 * largest.amplitude:.1f} nm for $3\\times10^{{-8}}$ "
                        "m"
                    ),
                    method=f"exact simulation of the three gaps with {power_of(smallest.impulse)} m s",
                ),
                Confirmation(
                    "the exact orbit for $10^{-8}$ m, by shooting",
                    CloseNumbers(
                        evidence.motion.closed.orbits.friction.stable.amplitude * smallest.gap,
                        smallest.amplitude,
                        1e-4,
                    ),
                ),
            ),
        ),
        explanation=(
            "Impulse, gap and motion times one factor are again a motion, so with one impulse it is the "
            "larger gap that dies out, if any: $3\\times10^{-8}$ m does below "
            f"{power_of(3e-8 * numbers.threshold, 2)} m s, $10^{{-8}}$ m below a third of that. Printed is "
            "the opposite order. Where all go on, they oscillate as 1 : 2 : 3, beside a first swing of "
            f"{numbers.peak:.0f}/s times the impulse; on one scale the smallest is easily not seen."
        ),
        consequence=(
            "The simulation does not support a threshold in the gap, which chapters 6 and 7 quote: what "
            "matters is how hard the loop is struck."
        ),
        impact=Impact.DOWNSTREAM,
        source="report/numbers/impulse_response.py",
    )


def _touching(evidence: Evidence) -> Claim:
    system, listing = evidence.numbers.displacement_only, evidence.cycles.listing
    predicted, repeated = (limit_cycles(each, FrictionBacklash(EDGE)) for each in (system, listing))
    stable = max(predicted, key=lambda cycle: cycle.amplitude)
    return Claim(
        id="txt-5.2.1-touching",
        parts=(
            _curves(predicted, repeated, stable),
            _simulated(evidence, stable),
        ),
        explanation=(
            "The section predicts none for $2\\times10^{-8}$ m, sees a small oscillation in the simulation, "
            "and concludes that the two agree. They do, but only because the prediction is another one: the "
            "curves of this gap are those of every gap and cross twice."
        ),
        consequence="The agreement that is found speaks for the method and against the threshold.",
        impact=Impact.DOWNSTREAM,
        source="trimmer/balance/solve.py",
    )


def _simulated(evidence: Evidence, stable: LimitCycle) -> Part:
    runs = [run for run in evidence.motion.closed.impulses.runs if run.gap == EDGE]
    simulated = max(run.amplitude for run in runs)
    return Part(
        "the small oscillation that is simulated",
        Assertion(
            statement="it agrees with what harmonic balance gives",
            derived=abs(simulated / stable.amplitude - 1) < 0.01,
            evidence=f"{1e9 * simulated:.1f} nm, beside {1e9 * stable.amplitude:.1f} nm",
            method="exact simulation, struck hard enough",
        ),
        Confirmation(
            "the exact orbit, by shooting",
            CloseNumbers(evidence.motion.closed.orbits.friction.stable.amplitude * EDGE, simulated, 1e-4),
        ),
    )


def _curves(predicted: Sequence[LimitCycle], repeated: Sequence[LimitCycle], stable: LimitCycle) -> Part:
    return Part(
        "the curves for $2\\times10^{-8}$ m",
        Assertion(
            statement="they just touch, so that no limit cycle is predicted",
            derived=not predicted or all(cycle.near_tangency for cycle in predicted),
            evidence=(
                f"they cross {len(predicted)} times, at {math.degrees(stable.crossing_angle):.0f} "
                f"degrees for the stable one, with {1e9 * stable.amplitude:.1f} nm"
            ),
            method="all solutions of harmonic balance for that gap",
        ),
        Confirmation("the coefficients of Listing A.9", CloseNumbers(len(repeated), len(predicted))),
    )


def _larger_gap(evidence: Evidence) -> Claim:
    orbits = evidence.motion.closed.orbits
    exact = orbits.friction.stable.frequency
    return Claim(
        id="txt-5.2.1-simulated-4e-5",
        parts=(
            amplitude_part(orbits, "amplitude", "3.2995e-04", LARGE_GAP),
            Part(
                "frequency",
                PrintedDigits("733.33", exact, "Hz"),
                Confirmation(SECOND_WAY, CloseNumbers(orbits.friction_by_durations[1], exact)),
                Slip(
                    "the nearest bin of a spectrum over 0.3 s is read, of which bins are 3.33 Hz apart",
                    THIRD_OF_A_SECOND.nearest(exact),
                    Verdict.EXPLAINED,
                ),
            ),
            _settled_part(orbits),
            _leaving_part(orbits),
        ),
        explanation=(
            "Ten times the gap gives ten times the motion at the same frequency, so this simulation repeats "
            "the one for $4\\times10^{-6}$ m. Its two readings, 734.00 and 733.33 Hz, are the nearest bins "
            "of one second and of 0.3 s, if 733.33 Hz is not the prediction of table 5.1 copied. The exact "
            f"multipliers agree that only the outer limit cycle shows: {_largest(orbits)[0]:.4f} per period "
            f"for it, {_largest(orbits)[1]:.3f} for the inner one. From the inner one a motion goes out to "
            "the other or dies out in the gap, by which side it starts on."
        ),
        consequence=(
            "The inner limit cycle is the edge of what dies out: a weak disturbance leaves the loop at rest."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _largest(orbits: ExactOrbits) -> tuple[float, float]:
    """Return the largest nontrivial multipliers of the stable and the unstable limit cycle."""
    stable, unstable = (
        abs(orbit.nontrivial_multipliers).max()
        for orbit in (orbits.friction.stable, orbits.friction.unstable)
    )
    return float(stable), float(unstable)


def _settled_part(orbits: ExactOrbits) -> Part:
    stable, unstable = _largest(orbits)
    return Part(
        "what shows in the settled motion",
        Assertion(
            statement="the first limit cycle shows and the second does not",
            derived=stable < 1 < unstable,
            evidence=(
                f"a disturbance changes by {stable:.4f} a period on it, by {unstable:.3f} on the second"
            ),
            method="Floquet multipliers of the exact orbits",
        ),
        Confirmation(
            "a motion that starts 0.1 % outside of the second one and ends on the first",
            CloseNumbers(orbits.left_by[1], orbits.friction.stable.amplitude, 1e-5),
        ),
    )


def _leaving_part(orbits: ExactOrbits) -> Part:
    inside, outside = orbits.left_by
    multipliers = orbits.friction.unstable.nontrivial_multipliers
    outward = multipliers[abs(multipliers) > 1]
    goes_out = [end > orbits.friction.unstable.amplitude for end in (inside, outside)]
    return Part(
        "where a motion goes that leaves the second one",
        Assertion(
            statement="it settles on the first",
            derived=all(goes_out),
            evidence=(
                f"started 0.1 % outside it ends at {outside:.4f} gaps, started 0.1 % inside it dies out"
            ),
            method="exact simulation of both",
        ),
        second_way(
            "its one multiplier outside of the unit circle, real and positive: it is left to either side",
            len(outward) == 1 and outward[0].imag == 0 and outward[0].real > 1,
        ),
    )
