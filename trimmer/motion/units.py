"""Units of what is measured of a motion."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Units:
    """Units of measures of a motion by that of displacements: m, of rotations rad, or plain numbers."""

    length: str

    @property
    def speed(self) -> str:
        """Of a rate of displacements."""
        return f"{self.length or 1}/s"

    @property
    def acceleration(self) -> str:
        """Of the rate of a rate."""
        return f"{self.length or 1}/s²"

    @property
    def force(self) -> str:
        """Of a force, or a moment; empty for a number."""
        return {"m": "N", "rad": "N m"}.get(self.length, "")

    @property
    def work(self) -> str:
        """Of a work; empty for a number."""
        return "J" if self.length else ""

    @property
    def power(self) -> str:
        """Of a power."""
        return "W" if self.length else "1/s"


def with_unit(name: str, unit: str) -> str:
    """Return a name with its unit, as at the head of a column; alone if it has none."""
    return f"{name}, {unit}" if unit else name
