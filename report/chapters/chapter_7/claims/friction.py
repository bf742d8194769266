"""Claims of chapter 7 on Coulomb friction, and on where its effect was shown."""

from __future__ import annotations

import numpy as np

from report.chapters.chapter_3.claims.driven_steady_motion import (
    METHOD,
    SOURCE,
    confirm_period,
    has_the_drives_period,
    period_in_words,
)
from report.chapters.chapter_3.claims.section_3_3_closed_loop import BIN, PEAK, PREDICTED
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.evidence import Evidence
from report.numbers.driven_motion import GAP
from report.numbers.friction_in_place import FrictionBranch
from report.numbers.released_motion import ReleasedRun

BRANCH_METHOD = "all solutions of harmonic balance over the whole range of forces"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_friction(evidence), _shown(evidence))


def _friction(evidence: Evidence) -> Claim:
    numbers, runs = evidence.cycles.equivalent, evidence.motion.released.by_force
    branch, both = numbers.in_place, numbers.in_place_both_channels
    force, with_both = (GAP * each.merger.force_per_gap for each in (branch, both))
    return Claim(
        id="txt-7-coulomb",
        parts=(
            _amplitude(branch, runs),
            _existence(branch, both, runs, evidence.numbers.parameters.k2),
        ),
        explanation=(
            "With friction in its place, between cutter and guard, and with its right sign, the conclusion "
            f"holds, with a number: it takes {branch.merger.force_per_gap:.0f} N per metre of gap, "
            f"{force:.2f} N for {1e6 * GAP:.0f} µm; with both channels of the pin "
            f"{both.merger.force_per_gap:.0f} N/m and {with_both:.2f} N. Section 5.2.5 says the opposite: "
            "with Listing A.6 the amplitude grows with the force, to "
            f"{1e3 * numbers.by_force[-1].amplitude:.0f} mm at 0.6 N. The rest position stays stable, as the "
            "text has it; the more friction, the larger a disturbance it survives, and beyond that force any."
        ),
        source="report/numbers/friction_in_place.py",
    )


def _amplitude(branch: FrictionBranch, runs: tuple[ReleasedRun, ...]) -> Part:
    merger = branch.merger
    lasting = [run for run in runs if run.goes_on]
    return Part(
        "amplitude",
        Assertion(
            statement="friction between cutter and guard makes the limit cycle smaller",
            derived=bool(np.all(np.diff(branch.stable.amplitude) < 0)),
            evidence=(
                f"from {branch.stable.amplitude[0]:.3f} gaps without friction to "
                f"{merger.amplitude:.3f} gaps at $F_c/b$ = {merger.force_per_gap:.0f} N/m"
            ),
            method=BRANCH_METHOD,
        ),
        Confirmation(
            "exact simulation of both channels",
            Assertion(
                statement="it becomes smaller from run to run",
                derived=bool(np.all(np.diff([run.amplitude for run in lasting]) < 0)),
                evidence=(
                    f"from {lasting[0].amplitude / GAP:.3f} to {lasting[-1].amplitude / GAP:.3f} gaps with "
                    f"{lasting[-1].force} N"
                ),
                method="exact simulation with the parameters of Listing A.1",
            ),
        ),
    )


def _existence(
    branch: FrictionBranch, both: FrictionBranch, runs: tuple[ReleasedRun, ...], k2: float
) -> Part:
    *_, before, last = runs
    largest = GAP * both.merger.force_per_gap
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
            method=BRANCH_METHOD,
        ),
        Confirmation(
            f"exact simulation of both channels, which lasts with {before.force} N and not with {last.force}",
            Assertion(
                statement="the largest force of harmonic balance lies between these two",
                derived=before.goes_on and not last.goes_on and before.force < largest < last.force,
                evidence=f"it is {largest:.3f} N",
                method="exact simulation with the parameters of Listing A.1",
            ),
        ),
    )


def _shown(evidence: Evidence) -> Claim:
    return Claim(
        id="txt-7-coulomb-evidence",
        parts=(
            Part(
                "the experiment",
                Assertion(
                    statement="it can show a limit cycle that friction suppresses",
                    derived=not has_the_drives_period(evidence),
                    evidence=period_in_words(evidence),
                    method=METHOD,
                ),
                confirm_period(evidence),
            ),
            Part(
                "section 3.3",
                Assertion(
                    statement="the peak that friction lowers there is where a limit cycle was predicted",
                    derived=abs(float(PEAK) - float(PREDICTED)) < BIN,
                    evidence=f"it is near {PEAK} Hz, and {PREDICTED} Hz was predicted for the same trimmer",
                    method="read in the text: the two printed frequencies",
                ),
            ),
        ),
        explanation=(
            "The answer rests on the findings of the experiment in section 3.3. That section holds "
            "simulations; the experiment is in section 3.2, was driven by its motor and has no limit cycle "
            "with any friction, so it cannot show one being suppressed. The simulated peak reads as a "
            "natural mode that dies out."
        ),
        consequence=(
            "That friction is wanted stands, by the calculation at the statement itself and not by "
            "measurement. To be measured it takes a loop in which the output moves the pin."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )
