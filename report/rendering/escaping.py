"""Filters that bring data into pandoc Markdown without letting it act as markup."""

from __future__ import annotations

import re

_PUNCTUATION = re.compile(r"([!-/:-@\[-`{-~])")
_MATHEMATICS = re.compile(r"(\$(?=\S)[^$]+(?<=\S)\$(?!\d))")
_DECIMAL = re.compile(r"(?P<mantissa>[+-]?\d+(?:\.\d*)?)(?:[eE](?P<exponent>[+-]?\d+))?")


def plain(text: str) -> str:
    """Escape plain text so that pandoc shows each of its characters as it is."""
    return _escaped(" ".join(text.split()))


def plain_with_mathematics(text: str) -> str:
    """Escape plain text, but leave TeX mathematics between dollar signs as it is."""
    pieces = _MATHEMATICS.split(" ".join(text.split()))
    return "".join(piece if position % 2 else _escaped(piece) for position, piece in enumerate(pieces))


def prose(text: str) -> str:
    """Trim Markdown prose; blank lines inside it still part paragraphs."""
    return text.strip()


def attribute(text: str) -> str:
    """Quote plain text as the value of a pandoc attribute."""
    escaped = " ".join(text.split()).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def inline_mathematics(latex: str) -> str:
    """Wrap LaTeX as mathematics inside a line; see ``checked`` for the errors."""
    return f"${checked(latex)}$"


def display_mathematics(latex: str) -> str:
    """Wrap LaTeX as displayed mathematics; see ``checked`` for the errors."""
    return f"$${checked(latex)}$$"


def digits(text: str) -> str:
    """Show printed digits as a number: a true minus sign, and a power of ten in place of an ``e``."""
    match = _DECIMAL.fullmatch(text.strip())
    if match is None:
        return plain(text)
    exponent = match["exponent"]
    power = "" if exponent is None else rf" \times 10^{{{int(exponent)}}}"
    return inline_mathematics(match["mantissa"] + power)


def checked(latex: str) -> str:
    """Return LaTeX in one line.

    Raises:
        ValueError: if it is empty, its braces do not match, or it holds a bare dollar sign.
    """
    flat = " ".join(latex.split())
    if not flat:
        raise ValueError("an equation of the report is empty: give it LaTeX, or leave the equation out")
    if re.search(r"(?<!\\)\$", flat):
        raise ValueError(f"an equation of the report holds a dollar sign, write it without: {flat}")
    braces = re.sub(r"\\.", "", flat)
    if braces.count("{") != braces.count("}"):
        raise ValueError(f"an equation of the report opens and closes braces unequally often: {flat}")
    return flat


def _escaped(text: str) -> str:
    return _PUNCTUATION.sub(r"\\\1", text)
