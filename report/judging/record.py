"""A claim as one record: id, text and parts together, read from top to bottom.

    @claim("eq-5.6")
    def external_input(known: Evidence) -> Record:
        yield expression("", printed, derived, left=r)
        yield text(f"The eccentricity is {1e3 * amplitude:.1f} mm.")

``known`` is whatever the claims are judged with; ``report.building.collect`` finds the records.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, final

from report.judging.claim import Claim, ClaimPart, Confirmation, Uncheckable
from report.judging.text import RecordError, one_line

PARAGRAPH = re.compile(r"[ ]*\n[ ]*\n[ \n]*")
MOST_PARAGRAPHS = 2


@final
@dataclass(frozen=True)
class Text:
    """The text of a claim, as pandoc Markdown: one paragraph, or two.

    The first says what is printed, what is true, and why, in one to four sentences; the second what a wrong
    statement changes elsewhere.
    """

    prose: str

    @property
    def paragraphs(self) -> list[str]:
        """The paragraphs, each in one line.

        Raises:
            RecordError: if there are more than two.
        """
        found = list(map(one_line, PARAGRAPH.split(self.prose.strip())))
        if len(found) > MOST_PARAGRAPHS:
            raise RecordError(f"the text {found[0][:60]!r} has {len(found)} paragraphs, not one or two")
        return found


Item = ClaimPart | Uncheckable | Text
Record = Iterator[Item]
"""What the function of a claim yields: its parts in the order of the thesis, and one text."""


def said(name: str, items: Callable[[Any], Iterator[Any]], known: Any) -> tuple[list[str], list[Any]]:
    """Return the paragraphs of the one text that a record yields, and what it yields beside it.

    Raises:
        RecordError: with the record's name, if a part is none, or if there is not one text.
    """
    try:
        found = list(items(known))
        texts = [item.paragraphs for item in found if isinstance(item, Text)]
    except RecordError as error:
        raise RecordError(f"{name}: {error}") from error
    known_kinds = Text | ClaimPart | Uncheckable | Confirmation
    if strange := [item for item in found if not isinstance(item, known_kinds)]:
        raise RecordError(f"{name} yields {strange[0]!r}, which is no part; yield digits() or text()")
    if len(texts) != 1:
        raise RecordError(f"{name} has {len(texts)} texts; it needs one")
    return texts[0], [item for item in found if not isinstance(item, Text)]


@final
@dataclass(frozen=True)
class ClaimRecord:
    """A claim before anything is judged.

    Attributes:
        id: As in the inventory.
        items: Yields what the claim consists of.
    """

    id: str
    items: Callable[[Any], Record]

    def claim(self, known: Any) -> Claim:
        """Return the claim with its numbers.

        Raises:
            RecordError: naming the claim, if a part is none, or if there is not one text.
        """
        (explanation, *consequence), items = said(f"claim {self.id}", self.items, known)
        for item in items:
            if not isinstance(item, ClaimPart | Uncheckable):
                raise RecordError(
                    f"claim {self.id} yields {item!r}, which is no part; yield digits(), text() ..."
                )
        return Claim(self.id, tuple(items), explanation, "".join(consequence))


def claim(claim_id: str) -> Callable[[Callable[[Any], Record]], ClaimRecord]:
    """Make a claim of a function that yields what it consists of, and give it the function's name."""
    return lambda items: ClaimRecord(claim_id, items)


def text(prose: str) -> Text:
    """Return the text of a claim."""
    return Text(prose)
