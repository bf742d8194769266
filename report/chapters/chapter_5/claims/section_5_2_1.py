"""Claims of section 5.2.1 on predictions for friction-controlled backlash."""

from __future__ import annotations

import math

from report.chapters.chapter_5.claims.section_5_2_1_scaling import PLOT_OFFSET, TINY_GAP, at_the_tiny_gap
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power_of
from report.comparisons.second_ways import by_floquet
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import LimitCycleNumbers, friction_exactly
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.elements.friction_backlash import FrictionBacklash

SOURCE = "trimmer/balance/solve.py"
ROUNDED = "the coefficients of Listing A.9, rounded to four digits, are used"
TURN = 2 * math.pi
SMALL_GAP, LARGE_GAP = 4e-6, 4e-5


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    cycles = evidence.cycles
    second = SecondWay(evidence)
    return (_prediction(cycles, second), _stable(evidence), _second_limit_cycle(evidence, second))


class SecondWay:
    """Predictions by Newton's method in 30 digits, from the exact coefficients of the derivation."""

    def __init__(self, evidence: Evidence) -> None:
        friction = evidence.cycles.friction
        self.stable = friction_exactly(evidence.numbers, friction.stable)
        self.unstable = friction_exactly(evidence.numbers, friction.unstable)


def predicted_amplitude(
    printed: str, gap: float, right: LimitCycle, listing: LimitCycle, ratio: float
) -> Part:
    """Return the part on a predicted amplitude, m; ``ratio`` is that over the gap in a second way."""
    return Part(
        "amplitude",
        PrintedDigits(printed, gap * right.amplitude, "m"),
        Confirmation("Newton's method in 30 digits", CloseNumbers(gap * ratio, gap * right.amplitude)),
        Slip(ROUNDED, gap * listing.amplitude, Verdict.EXPLAINED),
    )


def predicted_frequency(
    label: str, printed: str, right: LimitCycle, listing: LimitCycle, omega: float, unit: str
) -> Part:
    """Return the part on a predicted frequency, Hz or rad/s; ``omega`` is that in a second way, rad/s."""
    divisor = TURN if unit == "Hz" else 1.0
    return Part(
        label,
        PrintedDigits(printed, right.omega / divisor, unit),
        Confirmation("Newton's method in 30 digits", CloseNumbers(omega, right.omega)),
        Slip(ROUNDED, listing.omega / divisor, Verdict.EXPLAINED),
    )


def _prediction(cycles: LimitCycleNumbers, second: SecondWay) -> Claim:
    right, listing, both = (
        pair.stable for pair in (cycles.friction, cycles.friction_listing, cycles.friction_both_channels)
    )
    ratio, omega = second.stable
    return Claim(
        id="txt-5.2.1-prediction",
        parts=(
            predicted_amplitude("3.3138e-05", SMALL_GAP, right, listing, ratio),
            predicted_frequency("angular frequency", "4.6077e+03", right, listing, omega, "rad/s"),
            predicted_frequency("frequency", "733.3", right, listing, omega, "Hz"),
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


def misread(frequency: float) -> float:
    """Return a frequency whose second digit 5 has been written as a 3."""
    digits = f"{frequency:.2f}"
    return float(f"{digits[0]}3{digits[2:]}")


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


def _second_limit_cycle(evidence: Evidence, second: SecondWay) -> Claim:
    cycles = evidence.cycles
    right, wrong = cycles.friction.unstable, cycles.friction_listing.unstable
    ratio, omega = second.unstable
    return Claim(
        id="txt-5.2.1-second-limit-cycle",
        parts=(
            predicted_amplitude("2.1089e-5", LARGE_GAP, right, wrong, ratio),
            Part(
                "frequency",
                PrintedDigits("533.22", right.frequency, "Hz"),
                Confirmation("Newton's method in 30 digits", CloseNumbers(omega, right.omega)),
                Slip(
                    f"{ROUNDED}, and the second digit is written 3 instead of 5",
                    misread(wrong.frequency),
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
            _when_it_appears(evidence),
        ),
        explanation=(
            "Scaling gap and amplitude by one factor changes nothing in $1 + NG = 0$, so both limit cycles "
            "exist for every gap or for none. The second one lies just above the edge of the dead band, $A = "
            "b/2$. The locus that Listing A.9 plots starts at $b/2 + 10^{-6}$ m and reaches it only for gaps "
            f"above {power_of(PLOT_OFFSET / (right.amplitude - 0.5), 1)} m: that is why it is missing for "
            "$4\\times10^{-6}$ m and there for $4\\times10^{-5}$ m."
        ),
        consequence=(
            "A trimmer with a small gap has the same two limit cycles as one with a large gap, in "
            "proportion. The unstable one is the threshold: what starts below it decays."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _when_it_appears(evidence: Evidence) -> Part:
    cycles = evidence.cycles
    right = cycles.friction.unstable
    return Part(
        "when it appears",
        Assertion(
            statement="it is there only when the gap is large enough",
            derived=len(limit_cycles(cycles.listing, FrictionBacklash(TINY_GAP))) < 2,
            evidence=(
                f"it has $A = {right.amplitude:.4f}\\,b$ for every gap, since $N$ depends on $b/A$ alone"
            ),
            method="scaling of the describing function in the gap",
        ),
        at_the_tiny_gap(evidence.numbers.displacement_only, right),
    )
