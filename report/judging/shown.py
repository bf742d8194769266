"""What a claim shows of its two sides: a formula, a number, or words."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Mathematics:
    """A formula to show, as LaTeX without dollar signs."""

    latex: str

    def __str__(self) -> str:
        return self.latex


@dataclass(frozen=True)
class Number:
    """A number to show, as the digits themselves, with its unit as plain text (empty if it has none)."""

    digits: str
    unit: str = ""

    def __str__(self) -> str:
        return f"{self.digits} {self.unit}".strip()


@dataclass(frozen=True)
class Words:
    """A sentence to show, as pandoc Markdown."""

    text: str

    def __str__(self) -> str:
        return self.text


Shown = Mathematics | Number | Words
