"""Claims of the thesis, the judgement of a claim, and its verdict.

This module knows nothing of physics: a claim holds comparisons that were made elsewhere, and judging it
means asking each of them whether the printed side agrees with the derived one.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Any, Protocol, Self


class Verdict(Enum):
    """Agreement of a judgement, in rising order of severity."""

    REPRODUCED = "reproduced"
    EXPLAINED = "explained"
    NOT_CHECKABLE = "not-checkable"
    ERRATUM = "erratum"

    @property
    def severity(self) -> int:
        """Rank of the verdict: a claim with several parts takes the most severe one."""
        return list(Verdict).index(self)


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
    """How much it matters that a statement is wrong."""

    CONCLUSION = "conclusion"
    RESULT = "result"
    SLIP = "slip"
    NONE = "none"


class Certainty(Enum):
    """How sure a finding is: proven, computed in two ways, or depending on how the text is read."""

    PROVEN = "proven"
    COMPUTED = "computed"
    READING = "reading"


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
    """Whether printed and derived agree, and the method by which that was settled."""

    agrees: bool
    method: str


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
class Part:
    """One checkable part of a claim.

    ``printed_form`` and ``derived_form`` are shown in place of what the comparison holds, where it works
    on an instance of what is printed; ``item`` names the printed thing that the part judges.
    """

    label: str
    comparison: Comparison
    confirmation: Confirmation | None = None
    slip: Slip | None = None
    printed_form: Shown | None = None
    derived_form: Shown | None = None
    item: str = ""


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
    last of the passage in the text that was read; they, ``severity`` and ``certainty`` may be missing.
    """

    id: str
    parts: tuple[Part | Uncheckable, ...]
    explanation: str
    source: str
    impact: Impact = Impact.NONE
    consequence: str = ""
    lines: tuple[int, int] | None = None
    severity: Severity | None = None
    certainty: Certainty | None = None


@dataclass(frozen=True)
class JudgedPart:
    """A part with its verdict.

    ``slip`` names the slip that gives the printed form (empty if nothing is wrong, or if no slip gives it).
    """

    label: str
    verdict: Verdict
    printed: Shown
    derived: Shown
    method: str
    slip: str = ""


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


class ContradictionError(Exception):
    """Two independent derivations of this project disagree: nothing may be judged with either."""


def judge(claim: Claim, entry: Statement) -> Finding:
    """Judge every part of a claim and give it the most severe of their verdicts.

    Args:
        claim: what to judge.
        entry: the inventory's entry of the same id.

    Raises:
        ContradictionError: if a part's confirmation disagrees with its derivation.
        ValueError: if the claim has no parts.
    """
    if not claim.parts:
        raise ValueError(f"claim {claim.id} has no part to judge")
    parts = tuple(_judge_part(claim.id, part) for part in claim.parts)
    return Finding(
        id=claim.id,
        kind=entry.kind,
        section=entry.section,
        title=entry.title,
        verdict=max((part.verdict for part in parts), key=lambda verdict: verdict.severity),
        explanation=claim.explanation,
        consequence=claim.consequence,
        impact=claim.impact,
        source=claim.source,
        parts=parts,
    )


def _judge_part(claim_id: str, part: Part | Uncheckable) -> JudgedPart:
    if isinstance(part, Uncheckable):
        return JudgedPart(part.label, Verdict.NOT_CHECKABLE, part.printed, Words(part.missing), "not checked")
    outcome = part.comparison.compare()
    method = outcome.method
    if part.confirmation is not None:
        second = part.confirmation.comparison.compare()
        if not second.agrees:
            raise ContradictionError(
                f"{claim_id}, {part.label or 'only part'}: the derivation and its confirmation by "
                f"{part.confirmation.means} disagree ({second.method})"
            )
        method = f"{method}; confirmed by {part.confirmation.means}"
    verdict, slip = _verdict_of(part, outcome)
    printed = part.printed_form or part.comparison.printed_shown
    derived = part.derived_form or part.comparison.derived_shown
    return JudgedPart(part.label, verdict, printed, derived, method, slip)


def _verdict_of(part: Part, outcome: Agreement) -> tuple[Verdict, str]:
    if outcome.agrees:
        return Verdict.REPRODUCED, ""
    if part.slip is not None and part.comparison.with_derived(part.slip.derived).compare().agrees:
        return part.slip.verdict, part.slip.name
    return Verdict.ERRATUM, ""
