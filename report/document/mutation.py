"""How many changes of the program itself were noticed."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class MutationMeasurement:
    """How many changes of this program, made at random, were noticed.

    Attributes:
        date: When it was measured, year-month-day.
        command: With what.
        drawn: How many changes were made.
        equivalent: How many of them have no effect.
        claims: How many another verdict, or a check that stopped the report, has shown first.
        tests: How many a test has shown first.
        nothing: How many nothing has shown, of those with an effect.
        interval: 95 % interval of the share that is noticed among those with an effect.
    """

    date: str
    command: str
    drawn: int
    equivalent: int
    claims: int
    tests: int
    nothing: int
    interval: tuple[float, float]

    @property
    def noticed(self) -> int:
        """How many were noticed."""
        return self.claims + self.tests
