"""A line of advice as a box of numbers that others can test, and the file that holds all of them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, final

NAME = "advice.json"
"""Of the file, beside the report."""


@final
@dataclass(frozen=True)
class Advice:
    """What holds at every point of a box, of the motion that ``trimmer respond`` settles to from rest.

    Attributes:
        id: Its name.
        text: The sentence of the first screen, plain text.
        scope: What else the box holds, as a sentence; the first screen says it once for all lines.
        wanted: Whether it says what to do; otherwise what not to do.
        fixed: Values of places, SI units, that the box does not vary.
        over: Lowest and highest value of each place that it varies, SI units.
        measure: A key of ``respond --json``, with dots.
        at_most, at_least: Bounds of the measure, SI units; None where there is none.
        kinds: Words of the kinds of motion that may occur.
    """

    id: str
    text: str
    scope: str
    wanted: bool
    fixed: Mapping[str, float]
    over: Mapping[str, tuple[float, float]]
    measure: str
    kinds: tuple[str, ...]
    at_most: float | None = None
    at_least: float | None = None

    def holds(self, kind: str, value: float | None) -> bool:
        """Return whether a motion of a kind with a value of the measure is as the line says."""
        if kind not in self.kinds or value is None:
            return False
        low = self.at_least is None or value >= self.at_least
        return low and (self.at_most is None or value <= self.at_most)

    def told(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        bounds = {"at_most": self.at_most, "at_least": self.at_least}
        return {
            "text": f"{self.text} {self.scope}".strip(),
            "set": dict(self.fixed),
            "over": {place: list(ends) for place, ends in self.over.items()},
            "measure": self.measure,
            **{name: value for name, value in bounds.items() if value is not None},
            "kinds": list(self.kinds),
        }


def advice_json(lines: Sequence[Advice]) -> str:
    """Return all lines as a list in JSON."""
    return json.dumps([line.told() for line in lines], indent=2, ensure_ascii=False) + "\n"
