"""A step of a derivation: prose, formulas, and the functions that do what it says.

Prose is Markdown of the simplest kind: text, TeX mathematics between dollar signs, code between backticks,
and punctuation behind a backslash, which then means nothing; ``latex_prose`` gives it as LaTeX.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Formula:
    """A displayed equation."""

    latex: str  # The equation in LaTeX, without delimiters
    thesis: str = ""  # Its number in the thesis; empty where it has none
    words: str = ""  # Prose before it, one paragraph; empty where it follows the formula above


@dataclass(frozen=True)
class NarrativeStep:
    """A step of a derivation."""

    id: str  # Identifier, unique among all steps
    title: str  # Heading, plain text
    text: str  # Prose, paragraphs separated by an empty line
    formulas: tuple[Formula, ...]  # Displayed equations, shown after the prose
    # The functions that do what the step says, in the order of the step
    code: tuple[Callable[..., Any], ...] = ()
    long: bool = False  # Whether the formulas are so long that a reader asks for them first
