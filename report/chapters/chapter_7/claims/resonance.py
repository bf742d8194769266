"""Claims of chapter 7 on damping, on where the resonances lie, and on a limit cycle at one of them."""

from __future__ import annotations

import math

from report.chapters.second_ways import EXACTLY
from report.claim import Impact
from report.evidence import Evidence
from report.numbers.independent.exact_response import gain, gain_ratio
from report.numbers.linear_numbers import lightly_damped_response
from report.parts import assertion, close, so
from report.record import Record, claim, text
from report.thesis import DRIVE_FREQUENCY, TURN
from trimmer import resonance_peaks, response_at

THIRD = 3
"""Order of the lowest harmonic that an odd element adds."""


@claim("txt-7-damping", source="trimmer/linear/extrema.py", impact=Impact.LOCAL)
def damping(known: Evidence) -> Record:
    numbers, damped = known.numbers, resonance_peaks(known.numbers.displacement_only)
    light = lightly_damped_response(numbers.parameters)
    highest, without = (max(peak.magnitude for peak in peaks) for peaks in (damped, resonance_peaks(light)))
    exact = max(float(gain(numbers, peak.omega)) for peak in damped)
    yield assertion(
        "",
        "damping increases the magnitude of the resonances",
        highest > without,
        f"the highest peak is {highest:.1f} with damping and {without:.0f} with a thousandth of it",
        method="all local maxima of the gain for both dampings",
        second=close(EXACTLY, exact, highest),
    )
    yield text("""
        Damping lowers every resonance, as section 5.1.3 itself says. The answer to the first research
        question states the opposite.

        The answer has to read: damping lowers the resonances, and moves them by two percent at most.
    """)


@claim("txt-7-operating-frequency", source="trimmer/linear/modes.py", impact=Impact.LOCAL)
def operating_frequency(known: Evidence) -> Record:
    lowest = min(mode.frequency for mode in known.numbers.modes)
    undamped = min(mode.omega for mode in known.numbers.undamped) / TURN
    yield assertion(
        "",
        "the resonances lie below the operating frequency",
        lowest < DRIVE_FREQUENCY,
        f"the lowest is at {lowest:.2f} Hz, the drive at {DRIVE_FREQUENCY:.0f} Hz",
        method="eigenvalues",
        second=close("the undamped eigenvalue problem", undamped, lowest, 1e-3),
    )
    yield text("""
        It is the other way round: all resonances lie above the operating frequency, as section 5.1.3 says.
        That does not make them irrelevant, because the harmonics of the drive reach them.

        None on numbers; the answer to the first research question contradicts chapter 5.
    """)


@claim("txt-7-resonance", source="trimmer/linear/extrema.py", impact=Impact.LOCAL)
def resonance(known: Evidence) -> Record:
    numbers, pair = known.numbers, known.cycles.friction
    peaks = resonance_peaks(numbers.displacement_only)
    highest = max(peaks, key=lambda peak: peak.magnitude).omega
    mode = min(numbers.modes, key=lambda mode: abs(mode.eigenvalue.imag - highest))
    width, distance = -2 * mode.eigenvalue.real, pair.unstable.omega - highest
    height = float(gain(numbers, pair.unstable.omega) / gain(numbers, highest))
    means = f"the exact gain there, {100 * height:.0f} % of the peak's, where half power has 71 %"
    away = abs(distance) > width / 2
    yield assertion(
        "where the limit cycles lie",
        "no limit cycle lies at a resonance",
        away,
        """
        the unstable one, at [[ frequency | f1 ]] Hz, is [[ distance | f1 ]] Hz from the highest peak, which
        is [[ width | f1 ]] Hz wide
        """,
        numbers={"frequency": pair.unstable.frequency, "distance": distance / TURN, "width": width / TURN},
        method="all solutions of harmonic balance; peaks of the gain; the mode's damping",
        second=so(means, (height > math.sqrt(0.5)) == (not away)),
    )
    shares = {peak.omega: share_of_third(known, peak.omega) for peak in peaks}
    at_peaks = ", ".join(f"{share:.2g} at {omega / TURN:.1f} Hz" for omega, share in shares.items())
    exact = gain_ratio(numbers, highest, THIRD)
    yield assertion(
        "what a resonance would do",
        "at a resonance the harmonics are not attenuated",
        min(shares.values()) > 1,
        """
        against the first harmonic $G$ passes the third by [[ at_peaks ]]; at the stable limit cycle by
        [[ stable | g2 ]]
        """,
        numbers={"at_peaks": at_peaks, "stable": share_of_third(known, pair.stable.omega)},
        method="gain at three times each peak's frequency over the peak",
        second=close(EXACTLY, exact, shares[highest]),
    )
    yield text("""
        Taken to the letter, no two numbers are ever precisely equal; to the width of a peak, the unstable
        limit cycle lies at the highest one. That does no harm: a resonance magnifies the first harmonic, so
        the others are weaker beside it, and of all peaks this one filters best. Only at the two lowest, flat
        peaks does the third harmonic pass unweakened; what spoils filtering is a resonance at three or five
        times the frequency, which the argument leaves out.

        Harmonic balance is not endangered by the resonances near its two limit cycles. A drive of 110 Hz is:
        its fifth harmonic meets the highest peak.
    """)


def share_of_third(known: Evidence, omega: float) -> float:
    """Return |G| at three times an angular frequency (rad/s) over |G| at it."""
    system = known.numbers.displacement_only
    third, first = (abs(complex(response_at(system, order * omega))) for order in (THIRD, 1))
    return float(third / first)
