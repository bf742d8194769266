"""What is displayed between paragraphs: an equation, lines of code, a figure."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Equation:
    """A displayed equation: LaTeX without dollar signs.

    ``thesis`` is its number in the thesis, ``words`` Markdown prose before it; both may be empty.
    """

    latex: str
    thesis: str = ""
    words: str = ""


@dataclass(frozen=True)
class CodeLines:
    """A function or class of this project: path of its file, name, first and last line, and its text."""

    path: str
    name: str
    first: int
    last: int
    text: str


@dataclass(frozen=True)
class Figure:
    """A redrawn figure: its claim's id, Markdown caption, alternative text, and the SVG itself."""

    id: str
    title: str
    caption: str
    alternative_text: str
    svg: str
