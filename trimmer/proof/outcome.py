"""What a check comes to: a verdict, and what is proven or why nothing is."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Verdict(StrEnum):
    """Whether a statement is proven; each equals its word."""

    PROVEN = "proven"
    UNDECIDED = "undecided"
    REFUTED = "refuted"


@dataclass(frozen=True)
class Outcome:
    """What a check comes to.

    Attributes:
        verdict: Proven, undecided or refuted.
        theorem: What is proven, a sentence; empty if nothing is.
        reason: Why nothing is proven, or what is wrong, without a full stop; empty if it is proven.
    """

    verdict: Verdict
    theorem: str
    reason: str
