"""What a text copy consists of: headings, running text, displayed formulas, captions, listings, footnotes."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import Enum, auto


class BlockKind(Enum):
    """What a block of a text copy is."""

    HEADING = auto()
    SUBHEADING = auto()
    TEXT = auto()
    FORMULA = auto()
    CAPTION = auto()
    ROWS = auto()
    CODE = auto()
    FOOTNOTE = auto()


@dataclass(frozen=True)
class Block:
    """Lines that belong together: first and last, counted from 1, and what stands in them."""

    kind: BlockKind
    first: int
    last: int
    text: str


CAPTION = re.compile(r"\W*(?:\([a-z]\).*?)?\**(Figure|Table|Listing) ([A-E\d]+\.\d+):")
CHAPTER = re.compile(r"(?:Chapter|Appendix) ([A-Z]|\d+)")
SECTION = re.compile(r"([A-Z]|\d+)((?:\.\d+)+) +[A-Z]")
PANEL = re.compile(r"\([a-z]\) [A-Z]")
FOOTNOTE = re.compile(r"[\u00b9\u00b2\u00b3\u2070\u2074-\u2079]+\S")
MOST_WORDS = 5  # A line of more words is no heading without a number
FENCE, DOLLARS = "```", "$$"


def blocks(lines: Sequence[str]) -> tuple[Block, ...]:
    """Return the blocks of a text copy, in order.

    A block is what stands between empty lines; a listing, or a formula between double dollar signs, is one
    block also where an empty line is in it. What follows the number of a chapter is its title.
    """
    found: list[Block] = []
    for first, last in _ranges(lines):
        text = "\n".join(lines[first - 1 : last]).strip()
        title = bool(found) and CHAPTER.fullmatch(found[-1].text)
        found.append(Block(BlockKind.SUBHEADING if title else _kind(text), first, last, text))
    return tuple(found)


def _ranges(lines: Sequence[str]) -> Iterator[tuple[int, int]]:
    """Yield first and last line of each block."""
    first, closing = 0, ""
    for number, line in enumerate(lines, start=1):
        stripped = line.strip()
        if closing:
            if stripped.endswith(closing):
                yield first, number
                first, closing = 0, ""
            continue
        opening = next((mark for mark in (FENCE, DOLLARS) if stripped.startswith(mark)), "")
        if first and (opening or not stripped):
            yield first, number - 1
            first = 0
        if not stripped:
            continue
        first = first or number
        if opening and (len(stripped) <= len(opening) or not stripped.endswith(opening)):
            closing = opening
        elif opening:
            yield first, number
            first = 0
    if first:
        yield first, len(lines)


def _kind(text: str) -> BlockKind:
    if text.startswith(FENCE):
        return BlockKind.CODE
    if text.startswith(DOLLARS):
        return BlockKind.FORMULA
    if CHAPTER.fullmatch(text) or ("\n" not in text and SECTION.match(text)):
        return BlockKind.HEADING
    if CAPTION.match(text) or PANEL.match(text):
        return BlockKind.CAPTION
    if "\t" in text:
        return BlockKind.ROWS
    if FOOTNOTE.match(text):
        return BlockKind.FOOTNOTE
    short = "\n" not in text and len(text.split()) <= MOST_WORDS
    return (
        BlockKind.SUBHEADING if short and text[0].isupper() and text[-1] not in ".:;,!?" else BlockKind.TEXT
    )
