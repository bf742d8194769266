"""How many random changes of this program are noticed: as ``make mutate`` has measured it last."""

import json
from dataclasses import dataclass
from datetime import date
from pathlib import Path

from trimmer.errors import TrimmerError

PATH = Path(__file__).parent / "mutation.json"
"""Written by ``python -m scripts.mutation summary --write``; absent until it is measured."""
COUNTS = ("drawn", "equivalent", "claims", "tests", "nothing")


@dataclass(frozen=True)
class MutationMeasurement:
    """How many changes of this program, made at random, were noticed."""

    date: str  # When it was measured, year-month-day
    command: str  # With what
    drawn: int  # How many changes were made
    equivalent: int  # How many of them have no effect
    claims: int  # How many another verdict, or a check that stopped the report, has shown first
    tests: int  # How many a test has shown first
    nothing: int  # How many nothing has shown, of those with an effect
    interval: tuple[float, float]  # 95 % interval of the share that is noticed among those with an effect

    @property
    def noticed(self) -> int:
        """How many were noticed."""
        return self.claims + self.tests


class MutationDataError(TrimmerError, ValueError):
    """The kept measurement is not what ``make mutate`` writes."""


def read_mutation(path: Path = PATH) -> MutationMeasurement | None:
    """Read the last measurement; None if there is none.

    Raises:
        MutationDataError: naming the file, if a key is missing, or if the counts do not belong together.
    """
    if not path.exists():
        return None
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        low, high = content["interval"]
        found = MutationMeasurement(
            date.fromisoformat(content["date"]).isoformat(),
            content["command"],
            **{name: int(content[name]) for name in COUNTS},
            interval=(float(low), float(high)),
        )
    except (ValueError, KeyError, TypeError) as error:
        raise MutationDataError(
            f"{path}: not a measurement of make mutate ({error!r}); measure again"
        ) from error
    parts = (found.equivalent, found.claims, found.tests, found.nothing)
    share = found.noticed / max(found.noticed + found.nothing, 1)
    if sum(parts) != found.drawn or min(parts) < 0 or not low <= share <= high:
        raise MutationDataError(f"{path}: the counts do not belong together; measure again")
    return found
