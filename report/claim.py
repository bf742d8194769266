"""Claims of the thesis, the judgement of a claim, and its verdict.

This module knows nothing of physics: a claim holds comparisons that were made elsewhere, and judging it
means asking each of them whether the printed side agrees with the derived one.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Any, Protocol, Self


class Verdict(Enum):
    """Agreement of a judgement; the later ones prevail over the earlier.

    ``COPY`` is what a page read by machine explains: a fault of the text that was read, perhaps not of the
    thesis.
    """

    REPRODUCED = "reproduced"
    COPY = "copy"
    EXPLAINED = "explained"
    NOT_CHECKABLE = "not-checkable"
    ERRATUM = "erratum"

    @property
    def rank(self) -> int:
        """Place in the order: a claim with several parts takes the verdict of the highest rank."""
        return list(Verdict).index(self)

    @property
    def is_wrong(self) -> bool:
        """Whether something is wrong in the thesis, and has a severity."""
        return self in (Verdict.EXPLAINED, Verdict.ERRATUM)


class Kind(Enum):
    """What sort of thing in the thesis a claim is."""

    EQUATION = "equation"
    FIGURE = "figure"
    TABLE = "table"
    LISTING = "listing"
    STATEMENT = "statement"


@dataclass(frozen=True)
class Statement:
    """A statement to judge: its kind, where it stands in the thesis, and what it is about."""

    id: str
    kind: Kind
    section: str
    title: str

    @property
    def chapter(self) -> str:
        """Number or letter of the chapter that holds the statement."""
        return self.section.split(".")[0]


class Impact(Enum):
    """How far a wrong statement reaches; ``NONE`` for what is right."""

    NONE = "none"
    NOTATION = "notation"
    LOCAL = "local"
    DOWNSTREAM = "downstream"


class Severity(Enum):
    """How much it matters that a statement is wrong, the gravest first.

    It changes a conclusion; a number or formula is wrong; a slip without effect; nothing is wrong.
    """

    CONCLUSION = "conclusion"
    RESULT = "result"
    SLIP = "slip"
    NONE = "none"

    @property
    def rank(self) -> int:
        """Place in the order, 0 for the gravest."""
        return list(Severity).index(self)


class Certainty(Enum):
    """How sure a finding is, the surest first: proven, computed in two ways, or as the text is read."""

    PROVEN = "proven"
    COMPUTED = "computed"
    READING = "reading"

    @property
    def rank(self) -> int:
        """Place in the order, 0 for the surest."""
        return list(Certainty).index(self)


@dataclass(frozen=True)
class Mathematics:
    """A formula to show, as LaTeX without dollar signs."""

    latex: str

    def __str__(self) -> str:
        return self.latex


@dataclass(frozen=True)
class Number:
    """A number to show, as the digits themselves, with its unit as plain text (empty if it has none)."""

    digits: str
    unit: str = ""

    def __str__(self) -> str:
        return f"{self.digits} {self.unit}".strip()


@dataclass(frozen=True)
class Words:
    """A sentence to show, as pandoc Markdown."""

    text: str

    def __str__(self) -> str:
        return self.text


Shown = Mathematics | Number | Words


@dataclass(frozen=True)
class Agreement:
    """Whether printed and derived agree, the method by which that was settled, and how sure that is."""

    agrees: bool
    method: str
    certainty: Certainty = Certainty.COMPUTED


class Check(Protocol):
    """Whether two sides agree; its tolerance lives in it."""

    def compare(self) -> Agreement:
        """Say whether the two sides agree."""
        ...


class Comparison(Check, Protocol):
    """One way of holding a printed thing against a derived one."""

    def with_derived(self, derived: Any) -> Self:
        """Return the same printed side, held against another derived one."""
        ...

    @property
    def printed_shown(self) -> Shown:
        """The printed side, to show."""
        ...

    @property
    def derived_shown(self) -> Shown:
        """The derived side, to show."""
        ...


@dataclass(frozen=True)
class Slip:
    """A named slip that, when it is repeated, gives what is printed.

    ``derived`` is what the comparison derives when the slip is made; ``verdict`` is ``ERRATUM`` when the slip
    was made in this very place, ``EXPLAINED`` when the place repeats it faithfully from somewhere else.
    """

    name: str
    derived: Any
    verdict: Verdict


@dataclass(frozen=True)
class Confirmation:
    """A second, independent derivation of the derived side; it has to agree, or judging stops."""

    means: str
    comparison: Check


@dataclass(frozen=True)
class CopyFault:
    """What the machine that read the page may have lost.

    ``name`` says what; ``restored`` holds what the page then said against what is derived, and has to agree;
    ``decided_by`` says what would decide it.
    """

    name: str
    restored: Check
    decided_by: str


@dataclass(frozen=True)
class Part:
    """One checkable part of a claim.

    ``printed_form`` and ``derived_form`` are shown in place of what the comparison holds, where it works
    on an instance of what is printed. ``item`` names the printed thing that the part judges; parts of any
    claims with the same item count once. ``severity`` and ``certainty`` stand in place of those of the claim.
    """

    label: str
    comparison: Comparison
    confirmation: Confirmation | None = None
    slip: Slip | None = None
    printed_form: Shown | None = None
    derived_form: Shown | None = None
    item: str = ""
    copy_fault: CopyFault | None = None
    severity: Severity | None = None
    certainty: Certainty | None = None


@dataclass(frozen=True)
class Uncheckable:
    """A part that cannot be checked, the words printed, and exactly which data are missing for it."""

    label: str
    printed: Shown
    missing: str
    item: str = ""


@dataclass(frozen=True)
class Claim:
    """A statement of the thesis with all that is needed to judge it.

    ``explanation`` and ``consequence`` are pandoc Markdown with TeX mathematics between dollar signs;
    ``source`` names the file of this project that derives the right side. ``lines`` are the first and the
    last of the passage in the text that was read, ``paragraph`` its number in the section. ``severity`` is
    that of the parts that are wrong, ``certainty`` that of all parts where they do not say it themselves.
    """

    id: str
    parts: tuple[Part | Uncheckable, ...]
    explanation: str
    source: str
    impact: Impact = Impact.NONE
    consequence: str = ""
    lines: tuple[int, int] | None = None
    paragraph: int | None = None
    severity: Severity | None = None
    certainty: Certainty | None = None


@dataclass(frozen=True)
class JudgedPart:
    """A part with its verdict.

    ``slip`` names the slip that gives the printed form (empty if nothing is wrong, or if no slip gives it),
    or what the copy may have lost; ``decided_by`` then says what would decide that.
    """

    label: str
    verdict: Verdict
    printed: Shown
    derived: Shown
    method: str
    slip: str = ""
    decided_by: str = ""
    item: str = ""
    severity: Severity = Severity.NONE
    certainty: Certainty | None = None


@dataclass(frozen=True)
class Finding:
    """A claim with its verdict, and its place in the thesis; ``parts`` is never empty."""

    id: str
    kind: Kind
    section: str
    title: str
    verdict: Verdict
    explanation: str
    consequence: str
    impact: Impact
    source: str
    parts: tuple[JudgedPart, ...]
    lines: tuple[int, int] | None = None
    paragraph: int | None = None

    @property
    def severity(self) -> Severity:
        """Severity of the gravest part; none of a finding that is not wrong."""
        if not self.verdict.is_wrong:
            return Severity.NONE
        return min((part.severity for part in self.parts), key=lambda severity: severity.rank)

    @property
    def certainty(self) -> Certainty | None:
        """Certainty of the least sure part, of the wrong ones if there are any; None if none is checked."""
        wrong = [part for part in self.parts if part.verdict.is_wrong]
        known = [part.certainty for part in wrong or self.parts if part.certainty is not None]
        return max(known, key=lambda certainty: certainty.rank, default=None)


class UngradedError(Exception):
    """A part is wrong, and neither it nor its claim says how much that matters."""


class ContradictionError(Exception):
    """Two independent derivations of this project disagree: nothing may be judged with either."""


def judge(claim: Claim, entry: Statement) -> Finding:
    """Judge every part of a claim and give it the most severe of their verdicts.

    Args:
        claim: what to judge.
        entry: the inventory's entry of the same id.

    Raises:
        ContradictionError: if a part's confirmation disagrees with its derivation.
        UngradedError: if a part is wrong and has no severity.
        ValueError: if the claim has no parts.
    """
    if not claim.parts:
        raise ValueError(f"claim {claim.id} has no part to judge")
    parts = tuple(_judge_part(claim, part) for part in claim.parts)
    return Finding(
        id=claim.id,
        kind=entry.kind,
        section=entry.section,
        title=entry.title,
        verdict=max((part.verdict for part in parts), key=lambda verdict: verdict.rank),
        explanation=claim.explanation,
        consequence=claim.consequence,
        impact=claim.impact,
        source=claim.source,
        parts=parts,
        lines=claim.lines,
        paragraph=claim.paragraph,
    )


def _judge_part(claim: Claim, part: Part | Uncheckable) -> JudgedPart:
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
        severity=_severity(claim, part) if verdict.is_wrong else Severity.NONE,
        certainty=_certainty(claim, part, outcome, verdict),
    )


def _own_item(claim: Claim, part: Part | Uncheckable) -> str:
    """Name what a part judges that shares it with no other: the claim, and the part where it has several."""
    if len(claim.parts) == 1:
        return claim.id
    number = 1 + next(index for index, other in enumerate(claim.parts) if other is part)
    return f"{claim.id}, {part.label or f'part {number}'}"


def _severity(claim: Claim, part: Part) -> Severity:
    severity = part.severity or claim.severity
    if severity is None:
        raise UngradedError(f"{claim.id}, {part.label or 'only part'}: it is wrong, and has no severity")
    return severity


def _certainty(claim: Claim, part: Part, outcome: Agreement, verdict: Verdict) -> Certainty:
    if verdict is Verdict.COPY:
        return Certainty.READING
    return part.certainty or claim.certainty or outcome.certainty


def _confirmed(claim_id: str, part: Part, method: str) -> str:
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


def _verdict_of(part: Part, outcome: Agreement) -> tuple[Verdict, str]:
    if outcome.agrees:
        return Verdict.REPRODUCED, ""
    if part.slip is not None and part.comparison.with_derived(part.slip.derived).compare().agrees:
        return part.slip.verdict, part.slip.name
    if part.copy_fault is not None and part.copy_fault.restored.compare().agrees:
        return Verdict.COPY, part.copy_fault.name
    return Verdict.ERRATUM, ""
