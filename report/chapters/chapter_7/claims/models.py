"""Claim of chapter 7 that all models predict one limit cycle, and on which of them to use."""

from __future__ import annotations

import numpy as np

from report.chapters.chapter_5.claims.section_5_2_4 import on_the_imaginary_axis
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.second_ways import by_floquet, second_way
from report.evidence import Evidence
from trimmer import frequency_response, real_axis_crossings

OMEGAS = np.geomspace(1.0, 1e5, 20_001)
"""Angular frequencies over which the phase of G is looked at, rad/s."""
ALIKE = 0.1
"""Share by which frequencies may differ and still be called approximately equal."""
BELOW = 0.05
"""Share by which the recommended model's amplitude may stay below another's and still stand for it."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_models(evidence),)


def _models(evidence: Evidence) -> Claim:
    friction = evidence.cycles.friction.stable
    loads = [cycle for found in evidence.cycles.viscous for cycle in found if cycle.stable]
    smallest, largest = min(cycle.amplitude for cycle in loads), evidence.cycles.largest_viscous.amplitude
    return Claim(
        id="txt-7-models",
        parts=(
            _with_play(evidence),
            _friction_alone(evidence),
            _frequencies(evidence),
            Part(
                "friction-controlled backlash in place of the others",
                Assertion(
                    statement="its limit cycle is not much smaller than that of any load",
                    derived=largest < (1 + BELOW) * friction.amplitude,
                    evidence=(
                        f"it has {friction.amplitude:.2f} gaps, other loads have {smallest:.2f} to "
                        f"{largest:.2f}"
                    ),
                    method="all solutions of harmonic balance, $M/D$ from 1 µs to 1 s",
                ),
                Confirmation(
                    "the exact orbit without inertia",
                    CloseNumbers(
                        evidence.motion.closed.orbits.friction.stable.amplitude, friction.amplitude, 0.005
                    ),
                ),
            ),
        ),
        explanation=(
            "Every kind of play has one stable limit cycle, and their frequencies lie closer together than "
            "the thesis's own, which are 11 % apart. Coulomb friction alone has none, as section 5.2.4 says; "
            "if all models with play are meant, the sentence is right. The recommendation to use "
            "friction-controlled backlash holds: its frequency is within 3 % of any other load's, its "
            f"amplitude at most {100 * (largest / friction.amplitude - 1):.1f} % too small and, for "
            f"a load of inertia alone, {100 * (friction.amplitude / smallest - 1):.0f} % too large."
        ),
        consequence="A designer may use the simplest model: but for a few percent it is on the safe side.",
        impact=Impact.LOCAL,
        source="report/numbers/limit_cycle_numbers.py",
    )


def _with_play(evidence: Evidence) -> Part:
    counts = {sum(cycle.stable for cycle in found) for found in evidence.cycles.viscous}
    orbits = evidence.motion.closed.orbits
    return Part(
        "models with play",
        Assertion(
            statement="each has a stable limit cycle",
            derived=min(counts) > 0,
            evidence=f"{max(counts)} for each of {len(evidence.cycles.viscous)} loads between the limits",
            method="all solutions of harmonic balance, $M/D$ from 1 µs to 1 s",
        ),
        by_floquet([orbits.friction.stable, orbits.inertia.stable], stable=True),
    )


def _friction_alone(evidence: Evidence) -> Part:
    response = np.asarray(frequency_response(evidence.numbers.displacement_only, OMEGAS))
    on_the_real_axis = [each.value for each in real_axis_crossings(evidence.numbers.displacement_only)]
    phase = np.degrees(np.unwrap(np.angle(response)))
    return Part(
        "Coulomb friction",
        Assertion(
            statement="it has a stable limit cycle",
            derived=bool(phase.min() <= -180 or phase.max() >= 90),
            evidence=(
                f"the phase of $G$ stays between {phase.min():.1f} and {phase.max():.1f} degrees; a relay "
                "for displacement asks for -180, friction for 90"
            ),
            method="phase of the frequency response",
        ),
        second_way(
            "all roots of real and imaginary part: $G$ meets neither of the two half axes",
            max(on_the_imaginary_axis(evidence.numbers)) < 0 < min(on_the_real_axis),
        ),
    )


def _frequencies(evidence: Evidence) -> Part:
    merger = evidence.cycles.equivalent.in_place.merger
    loads = [cycle.frequency for found in evidence.cycles.viscous for cycle in found if cycle.stable]
    inertia, orbit = evidence.cycles.inertia.stable, evidence.motion.closed.orbits.inertia.stable
    lowest, highest = min(*loads, merger.frequency), max(loads)
    return Part(
        "frequencies",
        Assertion(
            statement="they are approximately equal",
            derived=highest < (1 + ALIKE) * lowest,
            evidence=(
                f"{min(loads):.1f} to {highest:.1f} Hz with play alone, down to {merger.frequency:.1f} Hz "
                "with as much friction as leaves a limit cycle"
            ),
            method="all solutions of harmonic balance for every load and every force",
        ),
        Confirmation(
            "the exact orbit with inertia alone", CloseNumbers(orbit.frequency, inertia.frequency, 0.02)
        ),
    )
