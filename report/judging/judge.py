"""The judgement of a claim: each part is asked whether the printed side agrees with the derived one."""

from __future__ import annotations

from report.judging.claim import Agreement, Claim, ClaimPart, Statement, Uncheckable
from report.judging.finding import Finding, JudgedPart
from report.judging.shown import Words
from report.judging.verdict import Certainty, Severity, Verdict


class UngradedError(Exception):
    """A part is wrong, and neither it nor its statement says how much that matters."""


class ContradictionError(Exception):
    """Two independent derivations of this project disagree: nothing may be judged with either."""


def judge(claim: Claim, entry: Statement) -> Finding:
    """Judge every part of a claim, with its entry of the inventory, and give it their most severe verdict.

    Raises:
        ContradictionError: if a part's confirmation disagrees with its derivation.
        UngradedError: if a part is wrong and has no severity.
        ValueError: if the claim has no parts.
    """
    if not claim.parts:
        raise ValueError(f"claim {claim.id} has no part to judge")
    parts = tuple(_judge_part(claim, entry, part) for part in claim.parts)
    return Finding(
        id=claim.id,
        kind=entry.kind,
        section=entry.section,
        title=entry.title,
        verdict=max((part.verdict for part in parts), key=lambda verdict: verdict.rank),
        explanation=claim.explanation,
        consequence=claim.consequence,
        impact=entry.impact,
        source=entry.source,
        parts=parts,
        lines=entry.lines,
        paragraph=entry.paragraph,
    )


def _judge_part(claim: Claim, entry: Statement, part: ClaimPart | Uncheckable) -> JudgedPart:
    item = part.item or _own_item(claim, part)
    if isinstance(part, Uncheckable):
        return JudgedPart(
            part.label, Verdict.NOT_CHECKABLE, part.printed, Words(part.missing), "not checked", item=item
        )
    outcome = part.comparison.compare()
    verdict, slip = _verdict_of(part, outcome)
    return JudgedPart(
        label=part.label,
        verdict=verdict,
        printed=part.printed_form or part.comparison.printed_shown,
        derived=part.derived_form or part.comparison.derived_shown,
        method=_confirmed(claim.id, part, outcome.method),
        slip=slip,
        decided_by=part.copy_fault.decided_by if part.copy_fault and verdict is Verdict.COPY else "",
        item=item,
        severity=_severity(entry, part) if verdict.is_wrong else Severity.NONE,
        certainty=_certainty(entry, part, outcome, verdict),
    )


def _own_item(claim: Claim, part: ClaimPart | Uncheckable) -> str:
    """Name what a part judges that shares it with no other: the claim, and the part where it has several."""
    if len(claim.parts) == 1:
        return claim.id
    number = 1 + next(index for index, other in enumerate(claim.parts) if other is part)
    return f"{claim.id}, {part.label or f'part {number}'}"


def _severity(entry: Statement, part: ClaimPart) -> Severity:
    severity = part.severity or entry.severity
    if severity in (None, Severity.NONE):
        raise UngradedError(f"{entry.id}, {part.label or 'only part'}: it is wrong, and has no severity")
    return severity


def _certainty(entry: Statement, part: ClaimPart, outcome: Agreement, verdict: Verdict) -> Certainty:
    if verdict is Verdict.COPY:
        return Certainty.READING
    return part.certainty or entry.certainty or outcome.certainty


def _confirmed(claim_id: str, part: ClaimPart, method: str) -> str:
    """Return the method with the second way to the same, which has to agree."""
    if part.confirmation is None:
        return method
    second = part.confirmation.comparison.compare()
    if not second.agrees:
        raise ContradictionError(
            f"{claim_id}, {part.label or 'only part'}: the derivation and its confirmation by "
            f"{part.confirmation.means} disagree ({second.method})"
        )
    return f"{method}; confirmed by {part.confirmation.means}"


def _verdict_of(part: ClaimPart, outcome: Agreement) -> tuple[Verdict, str]:
    if outcome.agrees:
        return Verdict.REPRODUCED, ""
    if part.slip is not None and part.comparison.with_derived(part.slip.derived).compare().agrees:
        return part.slip.verdict, part.slip.name
    if part.copy_fault is not None and part.copy_fault.restored.compare().agrees:
        return Verdict.COPY, part.copy_fault.name
    return Verdict.ERRATUM, ""
