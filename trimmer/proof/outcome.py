"""What a check comes to: a theorem, or an error that says why there is none; and how long it may take."""

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from enum import StrEnum

LIMIT = 600.0  # Time in which a check ends or gives up, s, if no other is given
_END = ContextVar("end", default=(math.inf, math.inf))


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


class OutOfTimeError(UndecidedError):
    """Balls have not told in the time that was allowed."""


class RefutedError(UnprovenError):
    """Balls tell otherwise."""

    verdict = Verdict.REFUTED


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Let checks inside give up after a time, s, each at its next step."""
    token = _END.set((time.monotonic() + seconds, seconds))
    try:
        yield
    finally:
        _END.reset(token)


def require_time() -> None:
    """Give up if the time is over; long checks call this at each step."""
    end, seconds = _END.get()
    if time.monotonic() > end:
        raise OutOfTimeError(f"nothing was told within the limit of {seconds:g} s; allow more time")
