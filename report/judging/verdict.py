"""What a judgement says: verdict, how far and how much a wrong statement matters, how sure that is."""

from __future__ import annotations

from enum import Enum


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
