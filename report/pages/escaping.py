"""Text enters pandoc Markdown here, and acts as markup only where a type says that it is Markdown already."""

from __future__ import annotations

import re
import string
from collections.abc import Iterable
from typing import Any

from markupsafe import Markup

_PUNCTUATION = re.compile(r"([!-/:-@\[-`{-~])")
_UNSEEN = re.compile(
    r"[^\S ]+|[\x00-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff0-\uffff]"
)
"""Space that ends lines, and what no font shows: controls, and marks that turn the direction of others."""
_MATHEMATICS = re.compile(r"(\$(?=\S)[^$]+(?<=\S)\$(?!\d))")
_DECIMAL = re.compile(r"(?P<mantissa>[+-]?\d+(?:\.\d*)?)(?:[eE](?P<exponent>[+-]?\d+))?")
_IDENTIFIER = re.compile(r"[\w.:-]+", re.ASCII)


class Markdown(str):
    """Text that is Markdown already; what is added to it is escaped, unless it is Markdown too.

    Every other operation of text gives plain text, which is escaped once more when it is printed.
    """

    __slots__ = ()

    def __add__(self, other: str, /) -> Markdown:
        return Markdown("").join((self, other))

    def __radd__(self, other: str, /) -> Markdown:
        return Markdown("").join((other, self))

    def join(self, parts: Iterable[str], /) -> Markdown:
        """Join parts, each escaped unless it is Markdown."""
        return Markdown(str(self).join(map(escaped, parts)))


class _Escaping(string.Formatter):
    def format_field(self, value: Any, format_spec: str) -> str:
        return escaped(format(value, format_spec) if format_spec else value)


def markdown(text: str, /, *values: object, **named: object) -> Markdown:
    """Put values into Markdown, as ``str.format`` does; each is escaped unless it is Markdown."""
    return Markdown(_Escaping().vformat(text, values, named))


def escaped(value: object) -> Markdown:
    """Return Markdown that shows each character of a value as it is; what is Markdown stays so.

    Line ends and what no font shows become spaces, and several spaces one: four would begin a block of code.
    ``Markup`` is what Jinja gives for its own macros.
    """
    if isinstance(value, Markdown | Markup):
        return Markdown(value)
    return Markdown(_PUNCTUATION.sub(r"\\\1", re.sub(" +", " ", shown_characters(str(value)))))


def shown_characters(text: str) -> str:
    """Return text in one line, without characters that are not seen or turn the direction of others."""
    return _UNSEEN.sub(" ", text).encode("utf-8", "replace").decode()


def plain(text: str) -> Markdown:
    """Return ``escaped`` without spaces around it, and with single ones inside."""
    return text if isinstance(text, Markdown) else escaped(" ".join(shown_characters(text).split()))


def plain_with_mathematics(text: str) -> Markdown:
    """Escape plain text, but leave TeX mathematics between dollar signs as it is."""
    pieces = _MATHEMATICS.split(" ".join(shown_characters(text).split()))
    return Markdown("").join(
        Markdown(piece) if position % 2 else piece for position, piece in enumerate(pieces)
    )


def identifier(name: object) -> Markdown:
    """Return the name of a place of the report, for attributes and addresses.

    Raises:
        ValueError: if it is none.
    """
    text = str(name)
    if _IDENTIFIER.fullmatch(text) is None:
        raise ValueError(f"{text!r} names no place of a report: write letters, digits and -_.:")
    return Markdown(text)


def prose(text: str) -> Markdown:
    """Trim Markdown prose of our own; blank lines inside it still part paragraphs."""
    return Markdown(text.strip())


def attribute(text: str) -> Markdown:
    """Quote plain text as the value of a pandoc attribute."""
    quoted = " ".join(shown_characters(text).split()).replace("\\", "\\\\").replace('"', '\\"')
    return Markdown(f'"{quoted}"')


def code(text: str) -> Markdown:
    """Return text as code inside a line, between more backticks than stand in it."""
    flat = shown_characters(text)
    fence = "`" * (1 + max(map(len, re.findall("`+", flat)), default=0))
    return Markdown(f"{fence} {flat} {fence}" if "`" in flat else f"`{flat}`")


def inline_mathematics(latex: str) -> Markdown:
    """Wrap LaTeX as mathematics inside a line; see ``checked`` for the errors."""
    return Markdown(f"${checked(latex)}$")


def display_mathematics(latex: str) -> Markdown:
    """Wrap LaTeX as displayed mathematics; see ``checked`` for the errors."""
    return Markdown(f"$${checked(latex)}$$")


def digits(text: str) -> Markdown:
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
