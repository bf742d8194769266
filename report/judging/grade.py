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
    if judged.verdict.is_wrong:
        return _BY_SEVERITY[judged.severity]
    return _BY_VERDICT[judged.verdict]


_BY_SEVERITY = {
    Severity.CONCLUSION: Grade.CONCLUSION,
    Severity.RESULT: Grade.RESULT,
    Severity.SLIP: Grade.SLIP,
}
_BY_VERDICT = {
    Verdict.COPY: Grade.COPY,
    Verdict.NOT_CHECKABLE: Grade.NOT_CHECKABLE,
    Verdict.REPRODUCED: Grade.REPRODUCED,
}
