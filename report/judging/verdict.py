"""What a judgement says: verdict and grade, how far and how much what is wrong matters, how sure that is."""

from __future__ import annotations

from enum import Enum
from typing import Protocol


class Ranked(Enum):
    """A word that has a place among the others."""

    @property
    def rank(self) -> int:
        """Place in the order in which they are written, from 0 on."""
        return list(type(self)).index(self)


class Verdict(Ranked):
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
    def is_wrong(self) -> bool:
        """Whether something is wrong in the thesis, and has a severity."""
        return self in (Verdict.EXPLAINED, Verdict.ERRATUM)


class Impact(Enum):
    """How far a wrong statement reaches; ``NONE`` for what is right."""

    NONE = "none"
    NOTATION = "notation"
    LOCAL = "local"
    DOWNSTREAM = "downstream"


class Severity(Ranked):
    """How much it matters that a statement is wrong, the gravest first.

    It changes a conclusion; a number or formula is wrong; a slip without effect; nothing is wrong.
    """

    CONCLUSION = "conclusion"
    RESULT = "result"
    SLIP = "slip"
    NONE = "none"


class Certainty(Ranked):
    """How sure a finding is, the surest first: proven, computed in two ways, or as the text is read."""

    PROVEN = "proven"
    COMPUTED = "computed"
    READING = "reading"


class Grade(Enum):
    """What a finding is counted, coloured and filtered by, the gravest first."""

    CONCLUSION = "conclusion"
    RESULT = "result"
    SLIP = "slip"
    COPY = "copy"
    NOT_CHECKABLE = "not-checkable"
    REPRODUCED = "reproduced"


class Judged(Protocol):
    """What has a verdict and a severity: a finding, a part of it, a printed thing."""

    @property
    def verdict(self) -> Verdict:
        """Whether it agrees."""
        ...

    @property
    def severity(self) -> Severity:
        """How much it matters."""
        ...


def grade(judged: Judged) -> Grade:
    """Return the severity of what is wrong, and the verdict of all else."""
    return Grade(judged.severity.value if judged.verdict.is_wrong else judged.verdict.value)
