"""Claim of section 3.3 that friction lowers an oscillation's amplitude but not its frequency."""

from __future__ import annotations

import numpy as np

from report.chapters.chapter_3.claims.driven_steady_motion import (
    METHOD,
    confirm_period,
    has_the_drives_period,
)
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.evidence import Evidence
from report.numbers.driven_motion import GAP

SOURCE = "report/numbers/released_motion.py"
UNMOVED = 0.005
"""Share by which a frequency may change and still be called unaffected."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_frequency(evidence),)


def _frequency(evidence: Evidence) -> Claim:
    lasting = [run for run in evidence.motion.released.by_force if run.goes_on]
    without, weak, *_, strong = lasting
    predicted = evidence.cycles.equivalent.in_place_both_channels.stable
    balance = np.interp(weak.force / GAP, predicted.force_per_gap, predicted.frequency)
    return Claim(
        id="txt-3.3-friction-frequency",
        parts=(
            Part(
                "oscillations of the driven trimmer",
                Assertion(
                    statement="friction leaves their frequency",
                    derived=has_the_drives_period(evidence),
                    evidence="they are harmonics of the drive, whatever the friction",
                    method=METHOD,
                ),
                confirm_period(evidence),
            ),
            Part(
                "self-sustained oscillation",
                Assertion(
                    statement="friction leaves its frequency",
                    derived=without.frequency - strong.frequency < UNMOVED * without.frequency,
                    evidence=", ".join(f"{run.frequency:.1f} Hz with {run.force:g} N" for run in lasting),
                    method="exact simulation with the parameters of Listing A.1, gap 0.2 mm",
                ),
                Confirmation(
                    f"harmonic balance at {weak.force} N", CloseNumbers(balance, weak.frequency, 1e-3)
                ),
            ),
        ),
        explanation=(
            "What is observed, peaks that friction lowers and does not move, is right and is what harmonics "
            "of the drive do. The reason given, that a self-sustained oscillation loses amplitude and not "
            "frequency, does not hold: backlash acts by the ratio of amplitude and gap, so a smaller "
            f"oscillation is slower, by {without.frequency - strong.frequency:.0f} Hz at {strong.force} N."
        ),
        consequence=(
            "A peak that stays in its place while friction changes speaks for a harmonic of the drive and "
            "against a limit cycle; the text takes it for the opposite."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )
