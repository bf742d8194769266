"""Claims of section 5.2.1 on predictions for friction-controlled backlash, with tables 5.1 and 5.2."""

from __future__ import annotations

import math

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.claims.second_ways import by_floquet
from report.claims.section_5_2_1_scaling import PLOT_OFFSET, TINY_GAP, at_the_tiny_gap
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import LimitCycleNumbers, friction_by_newton
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.elements.friction_backlash import FrictionBacklash

SOURCE = "trimmer/balance/solve.py"
ROUNDED = "the coefficients of Listing A.9, rounded to four digits, are used"
TURN = 2 * math.pi
SMALL_GAP, LARGE_GAP = 4e-6, 4e-5
TABLE_GAPS = ("1e-4", "2e-4", "3e-4", "4e-4", "5e-4", "6e-4", "7e-4", "8e-4", "9e-4", "1e-3")
TABLE_AMPLITUDES = (
    *("0.00083", "0.0017", "0.0025", "0.0033", "0.0041"),
    *("0.0050", "0.0058", "0.0066", "0.0075", "0.0083"),
)


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    cycles = evidence.cycles
    second = _SecondWay(evidence)
    return (
        _prediction(cycles, second),
        _two_limit_cycles(cycles, second),
        _ten_gaps(cycles, second),
        _stable(evidence),
        _second_limit_cycle(evidence, second),
    )


class _SecondWay:
    """Predictions by Newton's method in 30 digits, from the exact coefficients of the derivation."""

    def __init__(self, evidence: Evidence) -> None:
        numerator = tuple(map(float, evidence.numbers.numerator))
        denominator = tuple(map(float, evidence.numbers.denominator))
        friction = evidence.cycles.friction
        self.stable = friction_by_newton(numerator, denominator, friction.stable)
        self.unstable = friction_by_newton(numerator, denominator, friction.unstable)


def _amplitude(printed: str, gap: float, right: LimitCycle, listing: LimitCycle, ratio: float) -> Part:
    return Part(
        "amplitude",
        PrintedDigits(printed, gap * right.amplitude, "m"),
        Confirmation("Newton's method in 30 digits", CloseNumbers(gap * ratio, gap * right.amplitude)),
        Slip(ROUNDED, gap * listing.amplitude, Verdict.EXPLAINED),
    )


def _frequency(
    label: str, printed: str, right: LimitCycle, listing: LimitCycle, omega: float, unit: str
) -> Part:
    divisor = TURN if unit == "Hz" else 1.0
    return Part(
        label,
        PrintedDigits(printed, right.omega / divisor, unit),
        Confirmation("Newton's method in 30 digits", CloseNumbers(omega, right.omega)),
        Slip(ROUNDED, listing.omega / divisor, Verdict.EXPLAINED),
    )


def _prediction(cycles: LimitCycleNumbers, second: _SecondWay) -> Claim:
    right, listing, both = (
        pair.stable for pair in (cycles.friction, cycles.friction_listing, cycles.friction_both_channels)
    )
    ratio, omega = second.stable
    return Claim(
        id="txt-5.2.1-prediction",
        parts=(
            _amplitude("3.3138e-05", SMALL_GAP, right, listing, ratio),
            _frequency("angular frequency", "4.6077e+03", right, listing, omega, "rad/s"),
            _frequency("frequency", "733.3", right, listing, omega, "Hz"),
        ),
        explanation=(
            f"With exact coefficients the prediction is $A = {1e6 * SMALL_GAP * right.amplitude:.4f}$ µm at "
            f"{right.frequency:.2f} Hz. The printed numbers come out with the coefficients that Listing A.9 "
            "has rounded to four digits; that moves the amplitude by "
            f"{100 * (listing.amplitude / right.amplitude - 1):.2f} %, because the loop passes close to $-1$."
        ),
        consequence=(
            "Every prediction of section 5.2.1 carries this shift. The velocity of the pin, which the loop "
            f"leaves out, weighs far more: with it the amplitude is {1e6 * SMALL_GAP * both.amplitude:.2f} "
            f"µm, {100 * (1 - both.amplitude / right.amplitude):.0f} % less, at {both.frequency:.2f} Hz."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _misread(frequency: float) -> float:
    """Return a frequency whose second digit 5 has been written as a 3."""
    digits = f"{frequency:.2f}"
    return float(f"{digits[0]}3{digits[2:]}")


def _two_limit_cycles(cycles: LimitCycleNumbers, second: _SecondWay) -> Claim:
    right, listing = cycles.friction, cycles.friction_listing
    ratio, omega = second.stable
    other_ratio, other_omega = second.unstable
    wrong = listing.unstable
    return Claim(
        id="tab-5.1",
        parts=(
            _labelled("first: ", _amplitude("3.3138e-4", LARGE_GAP, right.stable, listing.stable, ratio)),
            Part(
                "first: frequency",
                PrintedDigits("733.33", right.stable.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(omega, right.stable.omega)),
                Slip(
                    f"{ROUNDED}, and the last digit is cut off",
                    math.floor(100 * listing.stable.frequency) / 100,
                    Verdict.EXPLAINED,
                ),
            ),
            _labelled("second: ", _amplitude("2.1089e-5", LARGE_GAP, right.unstable, wrong, other_ratio)),
            Part(
                "second: frequency",
                PrintedDigits("533.22", right.unstable.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(other_omega, right.unstable.omega)),
                Slip(
                    f"{ROUNDED}, and the second digit is written 3 instead of 5",
                    _misread(wrong.frequency),
                    Verdict.ERRATUM,
                ),
            ),
        ),
        explanation=(
            f"With exact coefficients the second limit cycle lies at {right.unstable.frequency:.2f} Hz, with "
            f"those of Listing A.9 at {wrong.frequency:.2f} Hz; the printed 533.22 Hz has one digit wrong. "
            "The other cells come out with the rounded coefficients."
        ),
        consequence=(
            "The text repeats 533.22 Hz. The first limit cycle, on which the comparisons rest, is not "
            "touched."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _labelled(prefix: str, part: Part) -> Part:
    return Part(f"{prefix}{part.label}", part.comparison, part.confirmation, part.slip)


def _ten_gaps(cycles: LimitCycleNumbers, second: _SecondWay) -> Claim:
    right, listing = cycles.friction.stable, cycles.friction_listing.stable
    ratio, omega = second.stable
    parts = []
    for gap, printed in zip(TABLE_GAPS, TABLE_AMPLITUDES, strict=True):
        prefix = f"b = {gap} m, "
        parts += [
            _labelled(prefix, _amplitude(printed, float(gap), right, listing, ratio)),
            _labelled(prefix, _frequency("angular frequency", "4.6e3", right, listing, omega, "rad/s")),
            _labelled(prefix, _frequency("frequency", "733", right, listing, omega, "Hz")),
        ]
    return Claim(
        id="tab-5.2",
        parts=tuple(parts),
        explanation=(
            f"Every amplitude is {right.amplitude:.4f} times the gap and every frequency "
            f"{right.frequency:.2f} Hz, in any row. With the rounded coefficients of Listing A.9 they are "
            f"{listing.amplitude:.4f} and {listing.frequency:.2f} Hz, which gives all printed cells; with "
            "exact ones the rows for 5e-4 m and 8e-4 m and all frequencies round to another last digit."
        ),
        consequence=(
            "None beyond the last digit. The ten rows hold one result, since nothing but the scale changes."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _stable(evidence: Evidence) -> Claim:
    cycle, orbit = evidence.cycles.friction.stable, evidence.motion.closed.orbits.friction.stable
    largest = abs(orbit.nontrivial_multipliers).max()
    return Claim(
        id="txt-5.2.1-stable",
        parts=(
            Part(
                "by the describing function",
                Assertion(
                    statement="the limit cycle near 733 Hz is stable",
                    derived=bool(cycle.stable),
                    evidence=f"Loeb's criterion at {cycle.frequency:.2f} Hz",
                    method="Loeb's criterion, from analytic derivatives of both curves",
                ),
                by_floquet([orbit], stable=True),
            ),
            Part(
                "in the exact loop",
                Assertion(
                    statement="the limit cycle near 733 Hz is stable",
                    derived=orbit.stable,
                    evidence=(
                        f"no disturbance keeps more than {largest:.4f} of itself over a period of the orbit "
                        f"at {orbit.frequency:.2f} Hz"
                    ),
                    method="Floquet multipliers of the exact orbit",
                ),
                Confirmation(
                    "a motion that starts 0.1 % outside the unstable orbit ends on it",
                    CloseNumbers(evidence.motion.closed.orbits.left_by[1], orbit.amplitude, 1e-5),
                ),
            ),
        ),
        explanation=(
            "A larger amplitude moves $-1/N$ out of the locus, so the oscillation shrinks again, and a "
            "smaller one the other way. That is the thesis's own argument, a statement of the describing "
            "function; the multipliers of the exact limit cycle agree. Disturbances decay slowly, with "
            f"{-math.log(largest) / orbit.period:.0f}/s."
        ),
        source="trimmer/balance/stability.py",
    )


def _second_limit_cycle(evidence: Evidence, second: _SecondWay) -> Claim:
    cycles = evidence.cycles
    right, wrong = cycles.friction.unstable, cycles.friction_listing.unstable
    ratio, omega = second.unstable
    return Claim(
        id="txt-5.2.1-second-limit-cycle",
        parts=(
            _amplitude("2.1089e-5", LARGE_GAP, right, wrong, ratio),
            Part(
                "frequency",
                PrintedDigits("533.22", right.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(omega, right.omega)),
                Slip(
                    f"{ROUNDED}, and the second digit is written 3 instead of 5",
                    _misread(wrong.frequency),
                    Verdict.ERRATUM,
                ),
            ),
            Part(
                "stability",
                Assertion(
                    statement="it is unstable",
                    derived=not right.stable,
                    evidence="Loeb's criterion",
                    method="Loeb's criterion, from analytic derivatives of both curves",
                ),
                by_floquet([evidence.motion.closed.orbits.friction.unstable], stable=False),
            ),
            Part(
                "when it appears",
                Assertion(
                    statement="it is there only when the gap is large enough",
                    derived=len(limit_cycles(cycles.listing, FrictionBacklash(TINY_GAP))) < 2,
                    evidence=(
                        f"it has $A = {right.amplitude:.4f}\\,b$ for every gap, since $N$ depends on $b/A$ "
                        "alone"
                    ),
                    method="scaling of the describing function in the gap",
                ),
                at_the_tiny_gap(evidence.numbers.displacement_only, right),
            ),
        ),
        explanation=(
            "Scaling gap and amplitude by one factor changes nothing in $1 + NG = 0$, so both limit cycles "
            "exist for every gap or for none. The second one lies just above the edge of the dead band, $A = "
            "b/2$. The locus that Listing A.9 plots starts at $b/2 + 10^{-6}$ m and reaches it only for gaps "
            f"above {PLOT_OFFSET / (right.amplitude - 0.5):.1e} m: that is why it is missing for 4e-6 m and "
            "there for 4e-5 m."
        ),
        consequence=(
            "A trimmer with a small gap has the same two limit cycles as one with a large gap, in "
            "proportion. The unstable one is the threshold: what starts below it decays."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )
