"""The first screen: what holds and what does not, the five findings that matter most, and what to do."""

from __future__ import annotations

from collections.abc import Sequence

from report.claim import Finding, Verdict
from report.document import Highlight, Opening
from report.evidence import Evidence
from report.items import items
from report.text import filled
from report.thesis import EXPERIMENT_GAP

BOUND = 1.0
"""Of friction in the thesis, N."""


def opening(known: Evidence, findings: Sequence[Finding]) -> Opening:
    """Return the first screen; its counts are over printed things."""
    judged = items(findings)
    reproduced = sum(item.verdict is Verdict.REPRODUCED for item in judged)
    return Opening(
        sentences=filled(
            """
            The derivations hold but for slips: [[ reproduced ]] of [[ total ]] printed things follow as
            printed. The predictions do not: their loop is in no trimmer. So the trimmer with contact both
            ways was computed.
            """,
            reproduced=reproduced,
            total=len(judged),
        ),
        highlights=_highlights(known),
        do=_do(),
        do_not=_do_not(known),
    )


def _highlights(known: Evidence) -> tuple[Highlight, ...]:
    in_place = known.cycles.equivalent.in_place.merger.force_per_gap * EXPERIMENT_GAP
    return (
        _highlight(
            "txt-3.1-output-sign",
            """
            No trimmer has the loop with the limit cycles; with its output as section 3.1 has it, it has none.
            """,
            "Do not look for [[ frequency | f0 ]] Hz.",
            frequency=known.cycles.friction.stable.frequency,
        ),
        _highlight(
            "txt-3.3-open-loop-odd",
            "The measured spectra have even harmonics; the model has none for any parameters.",
            "Model contact that pushes back.",
        ),
        _highlight(
            "txt-6.3-friction-dominates",
            "Friction does not dominate the cutter's inertia.",
            "Let it fly in the gap.",
        ),
        _highlight(
            "txt-7-coulomb-evidence",
            "Friction below [[ bound | f0 ]] N does not end the predicted cycle at 0.2 mm.",
            "Allow for [[ force | f1 ]] N.",
            bound=BOUND,
            force=in_place,
        ),
    )


def _highlight(place: str, sentence: str, action: str, /, **numbers: object) -> Highlight:
    said = {name: value for name, value in numbers.items() if f"[[ {name} " in sentence}
    done = {name: value for name, value in numbers.items() if name not in said}
    return Highlight(place, filled(sentence, **said), filled(action, **done))


def _do() -> tuple[str, ...]:
    return (
        "Compute your trimmer with contact both ways (`trimmer respond`).",
        "Look for lines between the harmonics of the drive.",
    )


def _do_not(known: Evidence) -> tuple[str, ...]:
    return (
        "Tune against a limit cycle of the thesis.",
        filled(
            "Expect a gap small enough to be harmless: the cycle has [[ ratio | f1 ]] gaps.",
            ratio=known.cycles.friction.stable.amplitude,
        ),
    )
