"""Claims of the thesis: statements with the comparisons that judge their parts.

This module knows nothing of physics: the comparisons were made elsewhere.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Any, Protocol, Self

from report.judging.shown import Shown
from report.judging.verdict import Certainty, Impact, Severity, Verdict


class Kind(Enum):
    """What sort of thing in the thesis a claim is."""

    EQUATION = "equation"
    FIGURE = "figure"
    TABLE = "table"
    LISTING = "listing"
    STATEMENT = "statement"


@dataclass(frozen=True)
class Statement:
    """A statement to judge, and what is known of it as data.

    Attributes:
        id: Unique.
        kind: What sort of thing it is.
        section: Where it stands.
        title: What it is about.
        source: Path of the file of this project that derives the right side.
        impact: How far a wrong statement reaches.
        lines: First and last line of the passage in the text that was read; None where they are not given.
        paragraph: Of the section, as counted in that text.
        severity: How much it matters that a part is wrong, where the part does not say it itself.
        certainty: How sure the finding is, where it is not what the comparisons of the parts say.
    """

    id: str
    kind: Kind
    section: str
    title: str
    source: str = ""
    impact: Impact = Impact.NONE
    lines: tuple[int, int] | None = None
    paragraph: int | None = None
    severity: Severity | None = None
    certainty: Certainty | None = None

    @property
    def chapter(self) -> str:
        """Number or letter of the chapter that holds the statement."""
        return self.section.split(".")[0]


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
class ClaimPart:
    """One checkable part of a claim.

    ``printed_form`` and ``derived_form`` are shown in place of what the comparison holds, where it works
    on an instance of what is printed. ``item`` names the printed thing that the part judges; parts of any
    claims with the same item count once. ``severity`` and ``certainty`` stand in place of the statement's.
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
    """What a statement is held against: its parts, and what is said of them.

    ``explanation`` and ``consequence`` are pandoc Markdown with TeX mathematics between dollar signs.
    """

    id: str
    parts: tuple[ClaimPart | Uncheckable, ...]
    explanation: str
    consequence: str = ""
