"""Claims of section 3.2 on what the two experiments show of harmonics and limit cycles."""

from __future__ import annotations

import numpy as np
import sympy

from derivations.symbols import velocities
from report.chapters.chapter_2.claims.figures_1_and_2_2 import MOVING_PARTS
from report.chapters.chapter_3.claims.driven_harmonics import confirm_friction
from report.chapters.chapter_3.claims.driven_steady_motion import (
    METHOD,
    SOURCE,
    confirm_odd,
    confirm_period,
    has_odd_harmonics_only,
    has_the_drives_period,
    period_in_words,
)
from report.claim import Claim, Confirmation, Impact, Part, Uncheckable, Words
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.printed import power_of
from report.evidence import Evidence

RAW_DATA = "the recorded motions of the three measurements, which are confidential"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_odd_harmonics(evidence), _play(evidence), _predicted(evidence), _no_limit_cycle(evidence))


def _odd_harmonics(evidence: Evidence) -> Claim:
    runs = evidence.motion.driven.with_gap(0.0)
    thirds, fifths = ([1e6 * run.harmonics[order] for run in runs] for order in (3, 5))
    return Claim(
        id="txt-3.2-odd-harmonics",
        parts=(
            Part(
                "no even ones",
                Assertion(
                    statement="without play the spectrum holds odd multiples of the drive's frequency only",
                    derived=has_odd_harmonics_only(evidence),
                    evidence=(
                        "linear parts and friction are odd and all motions end with the same velocities, "
                        "which therefore change sign after half a period; in the runs up to "
                        f"{power_of(max(run.mirror for run in evidence.motion.driven.runs))} of the output"
                    ),
                    method=METHOD,
                ),
                confirm_odd(evidence),
            ),
            Part(
                "where they come from",
                Assertion(
                    statement="they come from Coulomb friction",
                    derived=bool(np.all(np.diff(thirds) > 0) and np.all(np.diff(fifths) > 0)),
                    evidence=(
                        "without friction the model is linear and has none; with 0.25, 0.5 and 0.75 N the "
                        f"third has {_list(thirds)} µm and the fifth {_list(fifths)} µm, beside 1.51 mm"
                    ),
                    method="exact simulation with the parameters of Listing A.1",
                ),
                confirm_friction(evidence),
            ),
        ),
        explanation=(
            "For friction between any of the bodies and a sinusoidal pin the model has odd harmonics only. "
            "The fifth is larger than the third because it meets the natural mode at "
            f"{evidence.numbers.modes[2].frequency:.1f} Hz."
        ),
        source=SOURCE,
    )


def _list(values: list[float]) -> str:
    return ", ".join(f"{value:.0f}" for value in values)


def _play(evidence: Evidence) -> Claim:
    bodies = sympy.hessian(evidence.derivation.kinetic_energy, velocities).rank()
    return Claim(
        id="txt-3.2-play-place",
        parts=(
            Part(
                "experiment 2",
                Assertion(
                    statement="the play lies between driving bridge and cutter",
                    derived=bodies == len(MOVING_PARTS),
                    evidence=(
                        "sections 1.1, 2.1 and 3.1 have it between pin and driving bridge; bridge and cutter "
                        f"are one of the {bodies} bodies, with one displacement, so there is no joint "
                        "between them that could have play"
                    ),
                    method="rank of the mass matrix against the parts that the text names",
                ),
                Confirmation(
                    "a count of the bodies",
                    CloseNumbers(len(evidence.derivation.mechanism.bodies), bodies),
                ),
            ),
        ),
        explanation=(
            "The text says that backlash was added between the driving bridge and the cutter. Section 1.1 "
            "calls these two rigidly connected, section 3.1 announces play between pin and bridge, and every "
            "model of the thesis has it there. It is taken for a slip of the pen."
        ),
        consequence=(
            "If the gap of 200 µm was where this sentence has it, no model of the thesis describes the "
            "second experiment: the bridge would need a mass of its own."
        ),
        impact=Impact.LOCAL,
        source="derivations/mechanism.py",
    )


def expected_peak(evidence: Evidence) -> Part:
    """Return the part on the peak of a limit cycle that the text expects of the driven experiment."""
    return Part(
        "a peak in the spectrum of the driven trimmer",
        Assertion(
            statement="a limit cycle that the describing function predicts is to be expected there",
            derived=not has_the_drives_period(evidence),
            evidence=period_in_words(evidence),
            method=METHOD,
        ),
        confirm_period(evidence),
    )


def _predicted(evidence: Evidence) -> Claim:
    pair = evidence.cycles.friction
    return Claim(
        id="txt-3.2-predicted-488",
        parts=(
            Uncheckable(
                "frequency of the prediction",
                Words("488 Hz"),
                "the parameters of the experiment's trimmer (table C.1) and figure C.3, both confidential",
            ),
        ),
        explanation=(
            "The number cannot be checked; with Listing A.1 the two limit cycles lie at "
            f"{pair.unstable.frequency:.1f} and {pair.stable.frequency:.1f} Hz. It belongs to a loop whose "
            "play is moved by $-y$. In the experiment and in open loop a motor moves the pin, nothing leads "
            "from $y$ back to it, and in the thesis's model no motion of its own frequency can last. So that "
            "no peak was found at 488 Hz neither contradicts the describing function nor shows that friction "
            "suppressed a limit cycle, as chapter 6 concludes; see the statement on the missing limit cycle."
        ),
        source=SOURCE,
    )


def _no_limit_cycle(evidence: Evidence) -> Claim:
    none = Assertion(
        statement="there is no limit cycle",
        derived=has_the_drives_period(evidence),
        evidence="every motion of the driven model ends in one that repeats with the drive",
        method=METHOD,
    )
    return Claim(
        id="txt-3.2-no-limit-cycle",
        parts=(
            Part("experiment 1, friction alone", none, confirm_period(evidence)),
            Part("experiment 2, play and friction", none, confirm_period(evidence)),
            Uncheckable(
                "the spectra hold no further frequency", Words("No additional frequencies"), RAW_DATA
            ),
            expected_peak(evidence),
        ),
        explanation=(
            "The observation is what the model demands, with or without play, for every gap and friction: a "
            "driven trimmer has none. So it does not say whether friction, or play, could keep up a limit "
            "cycle in a loop. The proof is for play that displaces the bridge; a bridge that rattles in its "
            "play with a mass of its own is outside of the thesis's model."
        ),
        consequence=(
            "The experiment cannot test the describing function; a loop with feedback would have to be built."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )
