"""What a check comes to: a theorem, or an error that says why there is none."""

from __future__ import annotations

from enum import StrEnum


class Verdict(StrEnum):
    """Whether a statement is proven; each equals its word."""

    PROVEN = "proven"
    UNDECIDED = "undecided"
    REFUTED = "refuted"


class UnprovenError(Exception):
    """What checks raise instead of returning a theorem; the message says why, without a full stop."""

    verdict = Verdict.UNDECIDED


class UndecidedError(UnprovenError):
    """Balls do not tell."""


class RefutedError(UnprovenError):
    """Balls tell otherwise."""

    verdict = Verdict.REFUTED
