"""Displacements of the trimmer that can be an output: of a body, absolute or relative to another body."""

from __future__ import annotations

import re
from dataclasses import dataclass

from trimmer.choices import Choice
from trimmer.errors import TrimmerError
from trimmer.messages import did_you_mean


class DisplacementError(TrimmerError, ValueError):
    """A displacement that does not exist, with what to write instead."""


class TrimmerBody(Choice):
    """A body of the trimmer; the value is the number of its coordinate, as in q1."""

    MOTOR = 1
    CUTTER = 2
    HOUSING = 3
    GUARD = 4

    @property
    def word(self) -> str:
        """The coordinate: q1 to q4."""
        return self.coordinate

    @property
    def coordinate(self) -> str:
        """Name of the coordinate: q1 to q4."""
        return f"q{self.value}"

    @property
    def index(self) -> int:
        """Place of the coordinate in a vector that counts from 0."""
        return self.value - 1


@dataclass(frozen=True)
class Displacement:
    """Displacement of a body, m.

    Attributes:
        of: The body.
        relative_to: The body from which it is measured; None for the ground.

    A body may also be given by its coordinate, such as ``q2``.

    Raises:
        ChoiceError: if there is no such body.
        DisplacementError: if both bodies are the same.
    """

    of: TrimmerBody
    relative_to: TrimmerBody | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "of", TrimmerBody.chosen(self.of, "body"))
        if self.relative_to is not None:
            object.__setattr__(self, "relative_to", TrimmerBody.chosen(self.relative_to, "body"))
        if self.of is self.relative_to:
            raise DisplacementError(
                f"{self.label} is zero: a displacement relative to a body needs another body"
            )

    @classmethod
    def parse(cls, text: Displacement | str) -> Displacement:
        """Read a displacement such as ``q2`` or ``q2-q4``; spaces and capitals do not matter.

        What is a displacement already is returned as it is.

        Raises:
            DisplacementError: if the text is neither.
        """
        if isinstance(text, Displacement):
            return text
        pattern = r"\s*[qQ]([1-4])\s*(?:-\s*[qQ]([1-4])\s*)?"
        match = re.fullmatch(pattern, text, flags=re.ASCII) if isinstance(text, str) else None
        if match is None:
            meanings = ", ".join(f"{body.coordinate} {body.name.lower()}" for body in TrimmerBody)
            advice = did_you_mean(_meant(text) if isinstance(text, str) else ()) or (
                f"write a coordinate (q2) or a difference of two (q2-q4); coordinates: {meanings}"
            )
            raise DisplacementError(f"{text!r} is not a displacement: {advice}")
        of, relative_to = match.groups()
        return cls(TrimmerBody(int(of)), TrimmerBody(int(relative_to)) if relative_to else None)

    def __repr__(self) -> str:
        """Return the displacement as its label reads."""
        return f"<Displacement {self.label}>"

    @property
    def label(self) -> str:
        """Short name, such as ``q2-q4``; ``parse`` reads it back."""
        if self.relative_to is None:
            return self.of.coordinate
        return f"{self.of.coordinate}-{self.relative_to.coordinate}"

    @property
    def row(self) -> tuple[float, float, float, float]:
        """Factors of q1 to q4 in this displacement: 1, -1 or 0."""
        factors = [0.0] * len(TrimmerBody)
        factors[self.of.index] += 1.0
        if self.relative_to is not None:
            factors[self.relative_to.index] -= 1.0
        return (factors[0], factors[1], factors[2], factors[3])


def _meant(text: str) -> list[str]:
    """Return the displacement that was meant: its bodies by number, or by what they are called."""
    numbered = text.lower()
    for body in TrimmerBody:
        numbered = numbered.replace(body.name.lower(), str(body.value))
    numbers = re.findall(r"[0-9]+", numbered)
    if not 1 <= len(numbers) <= 2 or len(text) > _LONGEST:
        return []
    bodies = dict.fromkeys(int(digit) for number in numbers for digit in number)
    if bodies.keys() - {body.value for body in TrimmerBody} or len(bodies) > 2:
        return []
    return ["-".join(f"q{number}" for number in bodies)]


_LONGEST = 40  # Characters of a text in which a displacement is looked for

CUTTER_RELATIVE_TO_GUARD = Displacement(TrimmerBody.CUTTER, TrimmerBody.GUARD)
"""The output of the thesis, y = q2 - q4 (equation 2.14)."""
