"""What a reader can move on a page, and the drawings that follow."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Slider:
    """A number that a reader can move.

    Attributes:
        name: What the script calls it.
        label: What the reader is told it is, as plain text.
        minimum: Least value; of the decimal logarithm if ``logarithmic``.
        maximum: Largest value, likewise.
        value: Value to begin with, likewise.
        logarithmic: Whether the slider moves the decimal logarithm.
        factor: From the SI unit to the unit that is shown.
        unit: The unit that is shown, as plain text.
    """

    name: str
    label: str
    minimum: float
    maximum: float
    value: float
    logarithmic: bool
    factor: float
    unit: str


@dataclass(frozen=True)
class Panel:
    """A drawing of the explorable: title, least and largest x and y, and what it shows, as plain text."""

    title: str
    limits: tuple[float, float, float, float]
    description: str
