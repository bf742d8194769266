"""Claims of chapter 7 on what play does to the stability of the loop."""

from __future__ import annotations

import control
import numpy as np

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.evidence import Evidence

SOURCE = "report/numbers/exact_orbits.py"
CLOSE = 1e-3
"""Share by which the amplitude of a motion may differ from that of the limit cycle it ends on."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_only_stable(evidence), _stability(evidence))


def _only_stable(evidence: Evidence) -> Claim:
    cycle = evidence.cycles.friction.unstable
    orbit = evidence.motion.closed.orbits.friction.unstable
    growth = abs(orbit.nontrivial_multipliers).max()
    return Claim(
        id="txt-7-only-stable",
        parts=(
            Part(
                "",
                Assertion(
                    statement="all predicted limit cycles are stable",
                    derived=bool(cycle.stable),
                    evidence=(
                        f"besides the stable one each gap $b$ has one of {cycle.amplitude:.4f} $b$ at "
                        f"{cycle.frequency:.2f} Hz, which is not"
                    ),
                    method="all solutions of harmonic balance, Loeb's criterion",
                ),
                Confirmation(
                    "a Floquet multiplier of the exact orbit outside of the unit circle",
                    Assertion(
                        statement="the orbit is stable",
                        derived=orbit.stable,
                        evidence=f"a disturbance grows {growth:.1f} times in a period",
                        method="Floquet multipliers",
                        asserted=False,
                    ),
                ),
            ),
        ),
        explanation=(
            "Harmonic balance has two solutions for every gap, and the smaller one is unstable: a deviation "
            f"from the exact orbit grows {growth:.1f} times in each period. Table 5.1 lists it, and the "
            "answers of this chapter speak of unstable limit cycles, so the summary contradicts both."
        ),
        consequence=(
            "The unstable one decides whether the stable one is reached: what starts inside of it comes to "
            "rest."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _stability(evidence: Evidence) -> Claim:
    stable = evidence.motion.closed.orbits.friction.stable
    slowest = slowest_growth(evidence)
    return Claim(
        id="txt-7-play-stability",
        parts=(
            Part(
                "the loop without play and with it",
                Assertion(
                    statement="play does not alter whether the loop comes to rest from every start",
                    derived=(slowest < 0) == (not stable.stable),
                    evidence=(
                        f"without play every motion decays, as $e^{{{slowest:.1f}\\,t}}$ or faster; with "
                        f"play there is a stable limit cycle of {stable.amplitude:.4f} gaps"
                    ),
                    method="eigenvalues of the closed linear loop; Floquet multipliers of the exact orbit",
                ),
                Confirmation(
                    "a motion from 0.1 % outside of the unstable orbit, which ends on it",
                    CloseNumbers(evidence.motion.closed.orbits.left_by[1], stable.amplitude, 1e-5),
                ),
            ),
            _both_ways(evidence),
        ),
        explanation=(
            "The rest position stays stable, in that the text is right. But a loop that without play comes "
            "to rest from any start, with play does so only from small ones: beyond the unstable limit cycle "
            "it goes on for ever. The unstable one does not shift towards the stable one; it is left on "
            "either side, as section 2.3.6 itself says."
        ),
        consequence=(
            "The answer to the second sub-question has to read: an oscillation smaller than the unstable "
            f"limit cycle, {evidence.motion.closed.orbits.friction.unstable.amplitude:.2f} gaps, dies out, a "
            f"larger one ends at {stable.amplitude:.2f} gaps."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _both_ways(evidence: Evidence) -> Part:
    orbits = evidence.motion.closed.orbits
    inside, outside = orbits.left_by
    outward = [each for each in orbits.friction.unstable.nontrivial_multipliers if abs(each) > 1]
    return Part(
        "what starts at the unstable limit cycle",
        Assertion(
            statement="it goes to the stable one",
            derived=all(abs(each / orbits.friction.stable.amplitude - 1) < CLOSE for each in orbits.left_by),
            evidence=(
                f"started 0.1 % inside it ends with {inside:.2f} gaps, 0.1 % outside with {outside:.2f} gaps"
            ),
            method="exact simulation",
        ),
        Confirmation(
            "the one multiplier outside of the unit circle, which is real and positive",
            Assertion(
                statement="it is left in one direction, to either side",
                derived=len(outward) == 1 and bool(np.isreal(outward[0])) and outward[0].real > 1,
                evidence=", ".join(f"{each.real:.3f}" for each in outward),
                method="Floquet multipliers",
            ),
        ),
    )


def slowest_growth(evidence: Evidence) -> float:
    """Return the largest real part of the poles of the loop closed without play, 1/s."""
    closed = control.feedback(evidence.numbers.displacement_only, 1)
    return float(max(pole.real for pole in control.poles(closed)))
