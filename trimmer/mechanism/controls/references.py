"""What controllers follow: references r over time, in the unit of the output that is measured."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import ClassVar

from trimmer.mechanism.parts import Row


@dataclass(frozen=True)
class StepReference:
    """A reference that is 0 before a time, and a value from then on.

    Attributes:
        step: The value.
        at: The time, s.
    """

    step: float
    at: float = 0.0

    word: ClassVar[str] = "step"


@dataclass(frozen=True)
class RampReference:
    """A reference that is 0 before a time, and then ramp (t - at).

    Attributes:
        ramp: The rate, 1/s.
        at: The time, s.
    """

    ramp: float
    at: float = 0.0

    word: ClassVar[str] = "ramp"


@dataclass(frozen=True)
class SineReference:
    """A reference that vibrates, sine sin(2 pi frequency t + phase).

    Attributes:
        sine: The amplitude.
        frequency: Hz.
        phase: rad.
    """

    sine: float
    frequency: float
    phase: float = 0.0

    word: ClassVar[str] = "sine"


@dataclass(frozen=True)
class ProfileReference:
    """A reference that is straight between points, constant before the first and after the last.

    Attributes:
        profile: Time, s, and value of each point.
    """

    profile: tuple[Row, ...]

    word: ClassVar[str] = "profile"


Reference = StepReference | RampReference | SineReference | ProfileReference

REFERENCES: Mapping[str, type[Reference]] = MappingProxyType(
    {each.word: each for each in (StepReference, RampReference, SineReference, ProfileReference)}
)
"""The kinds of references by the key that tells them in a file."""
