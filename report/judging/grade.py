"""The grade of a finding: how much it matters that something is wrong, or why nothing is said to be wrong."""

from __future__ import annotations

from enum import Enum
from typing import Protocol

from report.judging.verdict import Severity, Verdict


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
