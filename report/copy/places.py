"""Where things stand in a text copy: sections, paragraphs, and what carries a number."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from report.copy.blocks import CAPTION, CHAPTER, SECTION, Block, BlockKind, blocks

Range = tuple[int, int]  # First and last line, counted from 1
NUMBER = re.compile(r"(?:\\quad|\\tag\s*\{?)\s*\(?([A-E\d]+\.\d+)\)?\}?\s*\$*$")
OPEN_END = re.compile(r"[a-z,-]$")  # How a paragraph ends that a page's end or a figure has parted


@dataclass(frozen=True)
class Paragraph:
    """Running text of a section: the section's number, which of its paragraphs it is, and its lines."""

    section: str
    number: int
    first: int
    last: int
    begins: str


@dataclass(frozen=True)
class Places:
    """The places of a text copy, by its lines."""

    lines: Sequence[str]

    @cached_property
    def blocks(self) -> tuple[Block, ...]:
        """All blocks, in order."""
        return blocks(self.lines)

    @cached_property
    def sections(self) -> Mapping[str, Range]:
        """Lines of each chapter and section with all that is in it, by its number or letter."""
        heads = [(_heading(block), block.first) for block in self.blocks if block.kind is BlockKind.HEADING]
        ranges: dict[str, Range] = {}
        for index, (number, first) in enumerate(heads):
            ends = (start - 1 for other, start in heads[index + 1 :] if not other.startswith(f"{number}."))
            ranges.setdefault(number, (first, next(ends, len(self.lines))))
        return ranges

    @cached_property
    def paragraphs(self) -> tuple[Paragraph, ...]:
        """Running text, counted anew after each numbered heading.

        What is parted by a page's end, a figure or a footnote in the middle of a sentence is one paragraph;
        what goes on after a displayed formula is the next one.
        """
        found: list[Paragraph] = []
        section, number, open_ = "", 0, False
        for block in self.blocks:
            if block.kind is BlockKind.HEADING:
                section, number, open_ = _heading(block), 0, False
            elif block.kind in (BlockKind.FORMULA, BlockKind.SUBHEADING, BlockKind.CODE):
                open_ = False
            elif block.kind is BlockKind.TEXT and section:
                if not open_:
                    number += 1
                found.append(Paragraph(section, number, block.first, block.last, block.text[:60]))
                open_ = bool(OPEN_END.search(block.text))
        return tuple(found)

    @cached_property
    def numbered(self) -> Mapping[str, Range]:
        """Lines of each numbered equation, figure, table and listing, by an id such as ``eq-2.36``.

        A figure is its caption; a table and a listing are their captions with what follows.
        """
        found: dict[str, Range] = {}
        for index, block in enumerate(self.blocks):
            if block.kind is BlockKind.FORMULA and (number := NUMBER.search(block.text)):
                found.setdefault(f"eq-{number[1]}", (block.first, block.last))
            elif block.kind is BlockKind.CAPTION and (caption := CAPTION.match(block.text)):
                kind, name = caption.groups()
                last = self._last_of(kind, index)
                found.setdefault(f"{PREFIXES[kind]}-{name}", (block.first, last))
        return found

    def unnumbered_formulas(self, section: str) -> tuple[Range, ...]:
        """Return the lines of each displayed formula of a section that carries no number, in order."""
        first, last = self.sections[section]
        return tuple(
            (block.first, block.last)
            for block in self.blocks
            if block.kind is BlockKind.FORMULA
            and first <= block.first <= last
            and not NUMBER.search(block.text)
        )

    def paragraph_at(self, line: int) -> Paragraph | None:
        """Return the paragraph that a line is in; after its end, the last one before it in its section."""
        before = [paragraph for paragraph in self.paragraphs if paragraph.first <= line]
        heads = [first for first, _ in self.sections.values() if first <= line]
        if not before or (heads and before[-1].first < max(heads)):
            return None
        return before[-1]

    def _last_of(self, kind: str, index: int) -> int:
        follows = {"Table": BlockKind.ROWS, "Listing": BlockKind.CODE}.get(kind)
        last = self.blocks[index].last
        for block in self.blocks[index + 1 :]:
            if block.kind is not follows:
                break
            last = block.last
        return last


PREFIXES = {"Figure": "fig", "Table": "tab", "Listing": "lst"}


def _heading(block: Block) -> str:
    if chapter := CHAPTER.fullmatch(block.text):
        return chapter[1]
    section = SECTION.match(block.text)
    if section is None:
        raise ValueError(f"line {block.first} is no heading: {block.text!r}")
    return section[1] + section[2]
