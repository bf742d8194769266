"""Claims that can be judged whatever turns out wrong in them."""

from __future__ import annotations

from dataclasses import replace

from report.judging.claim import Claim
from report.judging.verdict import Severity


def graded(claim: Claim) -> Claim:
    """Return a claim in which anything may be wrong; a record grades only what is known to be."""
    return replace(claim, severity=claim.severity or Severity.RESULT)
