"""Claims of appendix A.10: the search for intersections (listing A.9), its grid and its coefficients."""

from __future__ import annotations

from fractions import Fraction

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power_of
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import friction_by_newton
from trimmer.balance.limit_cycle import LimitCycle

SOURCE = "report/numbers/limit_cycle_numbers.py"
NUMERATOR = ("1e07", "1.233e10", "5.939e14", "1.65e17", "4.065e21", "3.667e23", "5.714e27")
DENOMINATOR = (
    *("1", "1378", "7.076e07", "3.878e10", "1.069e15"),
    *("2.676e17", "4.889e21", "4.595e23", "5.971e27"),
)
GRID_OFFSET, GRID_END, GRID_POINTS = 1e-6, 0.0025, 10000
LISTING_GAP = 4e-5
LINE_OF_SEARCH, LINE_OF_START = 23, 31


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_listing(evidence), _grid(evidence), _coefficients(evidence))


def _coefficient_parts(evidence: Evidence) -> list[Part]:
    numbers = evidence.numbers
    rows = (
        ("above the bar", NUMERATOR, numbers.numerator, evidence.cycles.listing.num[0][0]),
        ("below the bar", DENOMINATOR, numbers.denominator, evidence.cycles.listing.den[0][0]),
    )
    parts = []
    for place, printed, derived, used in rows:
        for power, (digits, exact, value) in enumerate(
            zip(reversed(printed), reversed(derived), reversed(used), strict=True)
        ):
            parts.append(
                Part(
                    f"{place}, $s^{power}$",
                    PrintedDigits(digits, exact),
                    Confirmation(
                        "the value that the search uses", CloseNumbers(float(Fraction(exact)), value, 1e-3)
                    ),
                )
            )
    return parts


def _coefficients(evidence: Evidence) -> Claim:
    right, rounded = evidence.cycles.friction.stable, evidence.cycles.friction_listing.stable
    return Claim(
        id="txt-A.10-coefficients",
        parts=tuple(_coefficient_parts(evidence)),
        explanation=(
            "All sixteen coefficients are the exact ones rounded to four digits; those of equation 5.1, "
            "which differ in the numerator, belong to another output. The rounding is not harmless: the "
            f"predicted amplitude moves by {100 * (rounded.amplitude / right.amplitude - 1):.2f} % and the "
            f"frequency by {rounded.frequency - right.frequency:+.2f} Hz."
        ),
        source="derivations/transfer_function.py",
    )


def _grid(evidence: Evidence) -> Claim:
    step = (GRID_END - LISTING_GAP / 2 - GRID_OFFSET) / (GRID_POINTS - 1)
    unstable = evidence.cycles.friction.unstable.amplitude
    smallest = GRID_OFFSET / (unstable - 0.5)
    return Claim(
        id="txt-A.10-grid",
        parts=(
            Part(
                "",
                Assertion(
                    statement=(
                        "the plotted locus $-1/N$ shows every intersection, for every gap that is studied"
                    ),
                    derived=smallest < 1e-8,
                    evidence=(
                        "it starts at $b/2 + 10^{-6}$ m, so the second limit cycle, at "
                        f"${unstable:.4f}\\,b$, is on it only for gaps above {power_of(smallest, 1)} m"
                    ),
                    method="arithmetic on the grid of line 9",
                ),
                Confirmation(
                    "the amplitude where the plot begins, at that gap",
                    CloseNumbers(smallest / 2 + GRID_OFFSET, smallest * unstable),
                ),
            ),
        ),
        explanation=(
            f"The grid is absolute, in steps of {1e6 * step:.2f} µm from a start that does not follow the "
            "gap, while the curve depends on $b/A$ alone. For a small gap the plot holds the end of the "
            "curve near $-1$ and nothing else."
        ),
        consequence=(
            "A limit cycle that seems to appear as the gap grows (sections 5.2.1 and 6) comes into the "
            "plotted range; it was there before."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _found(evidence: Evidence, cycle: LimitCycle) -> tuple[float, float]:
    system = evidence.cycles.listing
    return friction_by_newton(tuple(system.num[0][0]), tuple(system.den[0][0]), cycle)


def _listing(evidence: Evidence) -> Claim:
    cycle = evidence.cycles.friction_listing.stable
    amplitude, omega = _found(evidence, cycle)
    return Claim(
        id="lst-A.9",
        parts=(
            Part(
                "the two equations of lines 23 to 26, at their solution: amplitude over gap",
                PrintedDigits("8.2845", cycle.amplitude),
                Confirmation("Newton's method in 30 digits", CloseNumbers(amplitude, cycle.amplitude)),
            ),
            Part(
                "order of the lines",
                Assertion(
                    statement="the start of the search is defined before it is used",
                    derived=LINE_OF_START < LINE_OF_SEARCH,
                    evidence=f"line {LINE_OF_SEARCH} uses `x0`, line {LINE_OF_START} defines it",
                    method="read in the printed lines",
                ),
            ),
        ),
        explanation=(
            "Real and imaginary part of the condition are right here, unlike equation 2.54, and the search "
            "converges to the thesis's numbers: $3.3138\\cdot 10^{-4}/4\\cdot 10^{-5} = 8.2845$ at "
            f"{omega:.1f} rad/s. Run from an empty workspace it stops, because the start is defined after "
            "the search; it finds one solution for each start, and nothing tells whether there are more. The "
            "text says line 22 for the search; in the copy at hand it is line 23."
        ),
        consequence=(
            "Two starts gave the two limit cycles of table 5.1; a search for all of them finds no third."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )
