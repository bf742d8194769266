"""Claims of section 5.2.2 on predictions for inertia-controlled backlash (equations 5.7 and 5.8)."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import sympy

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.comparisons.second_ways import by_division_back, by_floquet
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import inertia_by_newton
from trimmer.elements.inertia_backlash import InertiaBacklash

SOURCE = "trimmer/elements/inertia_backlash.py"
TURN = 2 * math.pi
OBSERVED = 660.0
ISOLATED = 1e-6
"""Distance of a Floquet multiplier from one below which orbits may stand side by side."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _harmonic_balance(),
        _band(evidence),
        _range(),
        _prediction(evidence),
        _stable(evidence),
        _error(evidence),
    )


def _harmonic_balance() -> Claim:
    element, linear = sympy.symbols("N G")
    loop = sympy.expand(1 - linear * (-element))
    return Claim(
        id="eq-5.7",
        parts=(Part("", SameExpression(total(element * linear, 1), loop)),),
        explanation=(
            "Equation 2.25 with the ratio $\\beta = b/A$ as variable, on which alone the describing function "
            "depends."
        ),
        source="report/chapters/chapter_5/claims/section_5_2_2.py",
    )


def _converted(label: str, printed: str, omega: float) -> Part:
    frequency = omega / TURN
    return Part(label, PrintedDigits(printed, frequency, "Hz"), by_division_back(omega, frequency))


def _band(evidence: Evidence) -> Claim:
    orbits = evidence.motion.closed.orbits
    orbit = orbits.inertia.stable
    multipliers = orbit.nontrivial_multipliers
    return Claim(
        id="eq-5.8",
        parts=(
            _converted("lower end, from 4600 rad/s", "732", 4.6e3),
            _converted("upper end, from 5380 rad/s", "856", 5.38e3),
            Part(
                "what higher harmonics do",
                Assertion(
                    statement="with them, stable limit cycles of one gap fill a band of frequencies",
                    derived=bool(np.abs(multipliers - 1).min() < ISOLATED),
                    evidence=(
                        f"with all harmonics there is one, at {orbit.frequency:.2f} Hz, and it stands alone: "
                        f"a disturbance keeps at most {np.abs(multipliers).max():.4f} of itself over a period"
                    ),
                    method="Floquet multipliers of the exact orbit",
                ),
                Confirmation(
                    "its frequency by two durations, with SciPy's matrix exponential",
                    CloseNumbers(orbits.inertia_by_durations, orbit.frequency, 1e-6),
                ),
            ),
        ),
        explanation=(
            "The conversions are right. The band is read from figure 5.15, whose thickness is assumed and "
            "which footnote 10 calls an example; the text still gives it as what stable limit cycles may "
            "have. The exact orbit holds all harmonics: it is one point, "
            f"{abs(orbit.frequency - evidence.cycles.inertia.stable.frequency):.2f} Hz beside the "
            "prediction, and multipliers below one exclude others next to it."
        ),
        consequence=(
            "Higher harmonics do not explain a peak 100 Hz away; see the error of 23.47 % in this section."
        ),
        impact=Impact.DOWNSTREAM,
        source="report/numbers/exact_orbits.py",
    )


def _range() -> Claim:
    largest = float(InertiaBacklash(1.0).domain(1.0))
    return Claim(
        id="txt-5.2.2-beta-range",
        parts=(
            Part(
                "largest $\\beta = b/A$, $b$ the total gap",
                PrintedDigits("2", largest),
                Confirmation(
                    "the contact equation at half a turn", CloseNumbers(math.pi - math.sin(math.pi), largest)
                ),
            ),
        ),
        explanation=(
            "The bound 2 is where the pin no longer reaches a bridge that stays put. A bridge with inertia "
            "keeps flying: it meets the other side within half a period as long as $\\phi - \\sin\\phi = "
            "\\beta$ has a root below $\\pi$, that is for $\\beta < \\pi$. Footnote 8 has the two "
            "conventions for the gap exchanged: half of it is used for friction, all of it for inertia."
        ),
        consequence=(
            "The range from 2 to $\\pi$ is left out, and with it a second, unstable limit cycle at "
            "$\\beta = 2.4$ that the section does not mention."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _prediction(evidence: Evidence) -> Claim:
    cycle, both = evidence.cycles.inertia.stable, evidence.cycles.inertia_both_channels.stable
    other = evidence.cycles.inertia.unstable
    width = cycle.frequency - evidence.cycles.friction.stable.frequency
    _, omega = inertia_by_newton(evidence.numbers, cycle)
    second = Confirmation("Newton's method in 30 digits", CloseNumbers(omega, cycle.omega))
    return Claim(
        id="txt-5.2.2-prediction",
        parts=(
            Part("angular frequency", PrintedDigits("5.12e3", cycle.omega, "rad/s"), second),
            Part("frequency", PrintedDigits("814.9", cycle.frequency, "Hz"), second),
            _converted("conversion of 5120 rad/s", "814.9", 5.12e3),
        ),
        explanation=(
            f"The stable solution lies at {cycle.omega:.1f} rad/s, {cycle.frequency:.2f} Hz, with $A = "
            f"{cycle.amplitude:.3f}\\,b$, for the thesis's own loop and its own describing function; with "
            f"the pin's velocity as second input at {both.frequency:.2f} Hz. There is a second, unstable one "
            f"at {other.frequency:.2f} Hz. Listing A.4, called with a second argument other than one, moves "
            "the intersection up to about 5050 rad/s; what gives 5120 rad/s could not be found."
        ),
        consequence=(
            "The gap between friction- and inertia-controlled backlash shrinks from 82 Hz to "
            f"{width:.1f} Hz, and with it the band of "
            "equation 5.10, which the conclusions quote."
        ),
        impact=Impact.DOWNSTREAM,
        source="trimmer/balance/solve.py",
    )


def _stable(evidence: Evidence) -> Claim:
    cycle = evidence.cycles.inertia.stable
    return Claim(
        id="txt-5.2.2-stable",
        parts=(
            Part(
                "",
                Assertion(
                    statement="the outer intersection is a stable limit cycle",
                    derived=bool(cycle.stable) and cycle.omega > evidence.cycles.inertia.unstable.omega,
                    evidence=f"Loeb's criterion at {cycle.frequency:.2f} Hz",
                    method="Loeb's criterion, from analytic derivatives of both curves",
                ),
                by_floquet([evidence.motion.closed.orbits.inertia.stable], stable=True),
            ),
        ),
        explanation=(
            "A growing amplitude is a falling $\\beta$, which moves $-1/N$ towards $-1$ and out of the "
            "locus, as the text says."
        ),
        source="trimmer/balance/stability.py",
    )


def _error(evidence: Evidence) -> Claim:
    printed = 100 * abs(814.9 - OBSERVED) / OBSERVED
    cycle, orbits = evidence.cycles.inertia.stable, evidence.motion.closed.orbits
    right = 100 * abs(cycle.frequency - OBSERVED) / OBSERVED
    _, omega = inertia_by_newton(evidence.numbers, cycle)
    exact, second = (
        100 * (cycle.frequency / each - 1)
        for each in (orbits.inertia.stable.frequency, orbits.inertia_by_durations)
    )
    return Claim(
        id="txt-5.2.2-error",
        parts=(
            Part(
                "arithmetic",
                PrintedDigits("23.47", printed, "%"),
                Confirmation(
                    "exact fractions", CloseNumbers(float(100 * (Fraction("814.9") / 660 - 1)), printed)
                ),
            ),
            Part(
                "error of the prediction itself",
                PrintedDigits("23.47", right, "%"),
                Confirmation(
                    "Newton's method in 30 digits",
                    CloseNumbers(100 * (omega / TURN / OBSERVED - 1), right),
                ),
            ),
            _against_the_exact_one(exact, second),
        ),
        explanation=(
            "The quotient is right for 814.9 and 660 Hz (the peak is quoted as 659 Hz just before). With the "
            f"right prediction the distance is {right:.1f} %. But the peak is not the limit cycle, which is "
            f"at {orbits.inertia.stable.frequency:.2f} Hz in the exact loop: the prediction misses it by "
            f"{exact:.3f} %, and filtering is as good as the method needs it."
        ),
        consequence=(
            "The section's conclusion that higher harmonics widen the curve rests on this difference."
        ),
        impact=Impact.DOWNSTREAM,
        source="trimmer/balance/solve.py",
    )


def _against_the_exact_one(exact: float, second: float) -> Part:
    return Part(
        "error of the prediction against the exact limit cycle",
        PrintedDigits("23.47", exact, "%"),
        Confirmation(
            "the exact limit cycle by two durations, with SciPy's matrix exponential",
            CloseNumbers(second, exact, 1e-6),
        ),
    )
