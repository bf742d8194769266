"""What moves, as data: what a mechanism and a loop have in common."""

from collections.abc import Mapping
from typing import Protocol, Self


class Subject(Protocol):
    """A mechanism or a loop: numbers at dotted places, which may be others."""

    @property
    def title(self) -> str:
        """What it is, in a few words."""

    @property
    def frequency(self) -> float | None:
        """Frequency of the drive, Hz; None without one."""

    @property
    def places(self) -> Mapping[str, str]:
        """The unit of every number, by its dotted place."""

    def value(self, place: str) -> float:
        """Return the number at a dotted place, in its unit."""

    def with_value(self, place: str, value: float | str) -> Self:
        """Return the same with another number at a dotted place."""
