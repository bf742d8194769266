"""A line of advice as a box of numbers that others can test, and the file that holds all of them."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf
from typing import Any, final

NAME = "advice.json"  # Of the file, beside the report


@final
@dataclass(frozen=True)
class Bound:
    """What a line of advice says of one measure."""

    says: str  # In words, plain text
    measure: str  # A key of ``respond --json``, with dots
    # at_most, at_least: Bounds of the measure, SI units; None where there is none
    at_most: float | None = None
    at_least: float | None = None

    def spare(self, value: float | None) -> float:
        """Return what is left from a value to the bound, as a share of it; minus infinity without a value."""
        if value is None:
            return -inf
        low = inf if self.at_least is None else value / self.at_least - 1
        return min(low, inf if self.at_most is None else 1 - value / self.at_most)

    def told(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        ends = {"at_most": self.at_most, "at_least": self.at_least}
        return {"measure": self.measure} | {name: end for name, end in ends.items() if end is not None}


@final
@dataclass(frozen=True)
class Advice:
    """What holds at every point of a box, of the motion that ``trimmer respond`` settles to from rest."""

    id: str  # Its name
    where: str  # What to do or not to do, plain text
    scope: str  # What else the box holds, as a sentence; the first screen says it once for all lines
    wanted: bool  # Whether it says what to do; otherwise what not to do
    fixed: Mapping[str, float]  # Values of places, SI units, that the box does not vary
    over: Mapping[str, tuple[float, float]]  # Lowest and highest value of each place that it varies, SI units
    kinds: tuple[str, ...]  # Words of the kinds of motion that may occur
    bounds: tuple[Bound, ...]  # What holds there

    @property
    def text(self) -> str:
        """The sentence of the first screen."""
        return f"{self.where}: {', '.join(bound.says for bound in self.bounds)}."

    def told(self) -> list[dict[str, Any]]:
        """Return it as JSON has it, an entry for each bound."""
        box = {"set": dict(self.fixed), "over": {place: list(ends) for place, ends in self.over.items()}}
        return [
            {
                "text": f"{self.where}: {bound.says}. {self.scope}",
                **box,
                **bound.told(),
                "kinds": list(self.kinds),
            }
            for bound in self.bounds
        ]


def advice_json(lines: Sequence[Advice]) -> str:
    """Return all lines as a list in JSON."""
    told = [entry for line in lines for entry in line.told()]
    return json.dumps(told, indent=2, ensure_ascii=False) + "\n"
