"""Claim of chapter 7 on Coulomb friction."""

from __future__ import annotations

import numpy as np

from report.claim import Claim, Part
from report.comparisons.assertion import Assertion
from report.evidence import Evidence
from report.friction_in_place import FrictionBranch

EXPERIMENT_GAP = 200e-6


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_friction(evidence),)


def _friction(evidence: Evidence) -> Claim:
    numbers = evidence.cycles.equivalent
    branch, both = numbers.in_place, numbers.in_place_both_channels
    merger, listing = branch.merger, numbers.by_force
    experiment = EXPERIMENT_GAP * merger.force_per_gap
    return Claim(
        id="txt-7-coulomb",
        parts=(
            _amplitude(branch),
            _existence(branch, evidence.numbers.parameters.k2),
        ),
        explanation=(
            "With friction in its place, between cutter and guard, and with its right sign, the conclusion "
            f"holds, with a number: it takes {merger.force_per_gap:.0f} N per metre of gap "
            f"({both.merger.force_per_gap:.0f} N/m with both channels of the pin), that is {experiment:.1f} "
            f"N for {1e6 * EXPERIMENT_GAP:.0f} µm. Section 5.2.5 says the opposite: with Listing A.6 the "
            f"amplitude grows with the force, to {1e3 * listing[-1].amplitude:.0f} mm at 0.6 N. At rest "
            "nothing changes, so the stability of the rest position is unaltered, as the text has it."
        ),
        source="report/friction_in_place.py",
    )


def _existence(branch: FrictionBranch, k2: float) -> Part:
    return Part(
        "existence",
        Assertion(
            statement="enough friction ends it",
            derived=bool(
                np.all(np.diff(branch.stable.force_per_gap) > 0)
                and np.all(np.diff(branch.unstable.force_per_gap) > 0)
            ),
            evidence=(
                f"at $F_c$ = {branch.merger.force_per_gap / k2:.4f} $k_2 b$ it meets the unstable one, and "
                "beyond there is none"
            ),
            method="all solutions of harmonic balance over the whole range of forces",
        ),
    )


def _amplitude(branch: FrictionBranch) -> Part:
    merger = branch.merger
    return Part(
        "amplitude",
        Assertion(
            statement="friction between cutter and guard makes the limit cycle smaller",
            derived=bool(np.all(np.diff(branch.stable.amplitude) < 0)),
            evidence=(
                f"from {branch.stable.amplitude[0]:.3f} gaps without friction to "
                f"{merger.amplitude:.3f} gaps at $F_c/b$ = {merger.force_per_gap:.0f} N/m"
            ),
            method="all solutions of harmonic balance over the whole range of forces",
        ),
    )
