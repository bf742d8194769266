"""Claim of chapter 7 on a limit cycle at the frequency of a resonance."""

from __future__ import annotations

import math
from collections.abc import Sequence

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.exact_response import gain
from trimmer import Extremum, frequency_response, resonance_peaks

THIRD = 3
"""Order of the lowest harmonic that an odd element adds."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_resonance(evidence),)


def _left_of_third(evidence: Evidence, omega: float) -> float:
    """Return |G| at three times an angular frequency (rad/s) over |G| at it."""
    system = evidence.numbers.displacement_only
    third, first = (abs(complex(frequency_response(system, order * omega))) for order in (THIRD, 1))
    return float(third / first)


def _resonance(evidence: Evidence) -> Claim:
    numbers, pair = evidence.numbers, evidence.cycles.friction
    peaks = resonance_peaks(numbers.displacement_only)
    highest = max(peaks, key=lambda peak: peak.magnitude)
    mode = min(numbers.modes, key=lambda mode: abs(mode.eigenvalue.imag - highest.omega))
    width = -2 * mode.eigenvalue.real
    distance = pair.unstable.omega - highest.omega
    height = float(gain(numbers, pair.unstable.omega) / gain(numbers, highest.omega))
    return Claim(
        id="txt-7-resonance",
        parts=(
            Part(
                "where the limit cycles lie",
                Assertion(
                    statement="no limit cycle lies at a resonance",
                    derived=abs(distance) > width / 2,
                    evidence=(
                        f"the unstable one, at {pair.unstable.frequency:.1f} Hz, is "
                        f"{distance / (2 * math.pi):.1f} Hz from the highest peak, which is "
                        f"{width / (2 * math.pi):.1f} Hz wide"
                    ),
                    method="all solutions of harmonic balance; peaks of the gain; the mode's damping",
                ),
                second_way(
                    f"the exact gain there, {100 * height:.0f} % of the peak's, where half power has 71 %",
                    (height > math.sqrt(0.5)) == (abs(distance) <= width / 2),
                ),
            ),
            _magnified(evidence, peaks, highest),
        ),
        explanation=(
            "Taken to the letter, no two numbers are ever precisely equal; to the width of a peak, the "
            "unstable limit cycle lies at the highest one. That does no harm: a resonance magnifies the "
            "first harmonic, so the others are weaker beside it, and of all peaks this one filters best. "
            "Only at the two lowest, flat peaks does the third harmonic pass unweakened; what spoils "
            "filtering is a resonance at three or five times the frequency, which the argument leaves out."
        ),
        consequence=(
            "Harmonic balance is not endangered by the resonances near its two limit cycles. A drive of 110 "
            "Hz is: its fifth harmonic meets the highest peak."
        ),
        impact=Impact.LOCAL,
        source="trimmer/extrema.py",
    )


def _magnified(evidence: Evidence, peaks: Sequence[Extremum], highest: Extremum) -> Part:
    numbers, stable = evidence.numbers, evidence.cycles.friction.stable
    shares = [_left_of_third(evidence, peak.omega) for peak in peaks]
    exact = float(gain(numbers, THIRD * highest.omega) / gain(numbers, highest.omega))
    return Part(
        "what a resonance would do",
        Assertion(
            statement="at a resonance the harmonics are not attenuated",
            derived=min(shares) > 1,
            evidence=(
                "against the first harmonic $G$ passes the third by "
                + ", ".join(
                    f"{share:.2g} at {peak.omega / (2 * math.pi):.1f} Hz"
                    for peak, share in zip(peaks, shares, strict=True)
                )
                + f"; at the stable limit cycle by {_left_of_third(evidence, stable.omega):.2g}"
            ),
            method="gain at three times each peak's frequency over the peak",
        ),
        Confirmation(
            "exact coefficients, 40 digits",
            CloseNumbers(exact, _left_of_third(evidence, highest.omega)),
        ),
    )
