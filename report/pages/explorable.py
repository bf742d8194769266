"""What a reader can move on a page, and the drawings that follow."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Slider:
    """A number that a reader can move."""

    name: str  # What the script calls it
    label: str  # What the reader is told it is, as plain text
    minimum: float  # Least value; of the decimal logarithm if ``logarithmic``
    maximum: float  # Largest value, likewise
    value: float  # Value to begin with, likewise
    logarithmic: bool  # Whether the slider moves the decimal logarithm
    factor: float  # From the SI unit to the unit that is shown
    unit: str  # The unit that is shown, as plain text


@dataclass(frozen=True)
class Panel:
    """A drawing of the explorable: title, least and largest x and y, and what it shows, as plain text."""

    title: str
    limits: tuple[float, float, float, float]
    description: str
