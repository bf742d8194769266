"""A claim that was judged."""

from __future__ import annotations

from dataclasses import dataclass

from report.judging.claim import Kind
from report.judging.shown import Shown
from report.judging.verdict import Certainty, Impact, Severity, Verdict


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
