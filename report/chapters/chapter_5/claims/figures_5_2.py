"""Claims on the figures of section 5.2 that show -1/N with G."""

from __future__ import annotations

from report.chapters.chapter_5.claims.section_5_2_1 import ROUNDED
from report.chapters.chapter_5.claims.section_5_2_1_scaling import PLOT_OFFSET
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power
from report.comparisons.second_ways import by_grid
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import friction_exactly, inertia_by_newton
from trimmer import real_axis_crossings
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash

SOURCE = "trimmer/balance/solve.py"
PLOTTED = "the locus is plotted from b/2 + $10^{-6}$ m on, as in Listing A.9"
HERTZ_OF_BAND = ("733", "815")


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _tiny_gaps(evidence),
        _one_intersection(evidence),
        _inertia(evidence),
        _band(evidence),
        _coulomb(evidence),
    )


def _plotted(cycles: list[LimitCycle], gap: float) -> int:
    return sum(cycle.amplitude >= gap / 2 + PLOT_OFFSET for cycle in cycles)


def _intersections(evidence: Evidence, gap: str, printed: str) -> Part:
    found = limit_cycles(evidence.cycles.listing, FrictionBacklash(float(gap)))
    exact = limit_cycles(evidence.numbers.displacement_only, FrictionBacklash(float(gap)))
    return Part(
        f"intersections for $b$ = {power(gap)} m",
        PrintedDigits(printed, len(found)),
        Confirmation("the exact coefficients", CloseNumbers(len(exact), len(found))),
        Slip(PLOTTED, _plotted(found, float(gap)), Verdict.ERRATUM),
    )


def _tiny_gaps(evidence: Evidence) -> Claim:
    return Claim(
        id="fig-5.6",
        parts=(
            _intersections(evidence, "1e-8", "0"),
            _intersections(evidence, "2e-8", "0"),
            _intersections(evidence, "3e-8", "1"),
        ),
        explanation=(
            "All three gaps have two intersections, at the same two points of the locus: the whole curve is "
            "the same, only the amplitudes along it change. What the figure shows depends on where the "
            "plotted amplitudes begin; with the start of Listing A.9 none of the three would show any."
        ),
        consequence=(
            "The threshold of $2\\times10^{-8}$ m in section 5.2.1 and chapter 6 is read from this figure."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _one_intersection(evidence: Evidence) -> Claim:
    return Claim(
        id="fig-5.8",
        parts=(_intersections(evidence, "4e-6", "1"),),
        explanation=(
            "There are two, as for every gap. The second lies at 0.527 times the gap, below the amplitude at "
            "which the plotted locus begins, so the figure shows the first one only."
        ),
        consequence="It makes the second limit cycle of figure 5.10 look like an effect of the larger gap.",
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _inertia(evidence: Evidence) -> Claim:
    found = limit_cycles(evidence.numbers.displacement_only, InertiaBacklash(1.0))
    scaled = len(limit_cycles(evidence.numbers.displacement_only, InertiaBacklash(1e-3)))
    below_two = [cycle for cycle in found if 1 / cycle.amplitude <= 2]
    stable = evidence.cycles.inertia.stable
    _, omega = inertia_by_newton(evidence.numbers, stable)
    return Claim(
        id="fig-5.13",
        parts=(
            Part(
                "intersections",
                PrintedDigits("1", len(found)),
                Confirmation("the gap scaled by a thousand", CloseNumbers(scaled, len(found))),
                Slip("the curve is drawn for beta up to 2 only", len(below_two), Verdict.ERRATUM),
            ),
            Part(
                "angular frequency of the stable one",
                PrintedDigits("5.12e3", stable.omega, "rad/s"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(omega, stable.omega)),
            ),
        ),
        explanation=(
            f"Drawn with equation 2.43 the curve meets the locus twice: once at {stable.omega:.0f} rad/s, "
            "and once more beyond $\\beta = 2$, where the thesis stops. What was drawn to give 5120 rad/s "
            "could not be found."
        ),
        consequence="See the prediction in section 5.2.2 and the band of equation 5.10.",
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _band(evidence: Evidence) -> Claim:
    low, high = evidence.cycles.friction.stable, evidence.cycles.inertia.stable
    _, omega = inertia_by_newton(evidence.numbers, high)
    _, low_omega = friction_exactly(evidence.numbers, low)
    return Claim(
        id="fig-5.17",
        parts=(
            Part(
                "lower end",
                PrintedDigits(HERTZ_OF_BAND[0], low.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(low_omega, low.omega)),
                Slip(ROUNDED, evidence.cycles.friction_listing.stable.frequency, Verdict.EXPLAINED),
            ),
            Part(
                "upper end",
                PrintedDigits(HERTZ_OF_BAND[1], high.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(omega, high.omega)),
            ),
        ),
        explanation=(
            "The arrow ends at the two limits of the load, of which the upper one is wrong: "
            f"{high.frequency:.1f} Hz. The band between them is as the section says, and narrower."
        ),
        consequence="See equation 5.10.",
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _coulomb(evidence: Evidence) -> Claim:
    crossings = real_axis_crossings(evidence.numbers.displacement_only)
    negative = sum(crossing.value < 0 for crossing in crossings)
    return Claim(
        id="fig-5.18",
        parts=(
            Part(
                "intersections with the negative real axis",
                PrintedDigits("0", negative),
                by_grid(evidence.numbers.displacement_only, negative),
            ),
        ),
        explanation=(
            "The locus and the negative real axis do not meet, as the text reads from the figure. For "
            "friction in this loop the curve to draw is the positive imaginary axis, which the locus does "
            "not meet either."
        ),
        source="trimmer/crossings.py",
    )
