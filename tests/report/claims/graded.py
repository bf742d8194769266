"""Statements that can be judged whatever turns out wrong in them."""

from dataclasses import replace

from report.judging.claim import Statement
from report.judging.verdict import Severity


def graded(entry: Statement) -> Statement:
    """Return a statement of which anything may be wrong; the table grades only what is known to be."""
    return replace(entry, severity=entry.severity or Severity.RESULT)
