"""Whether the place that a claim gives holds what the claim is about."""

import re
from collections.abc import Iterator

from report.copy.places import Places
from report.judging.claim import Kind, Statement

NAMES = {Kind.FIGURE: "Figure", Kind.TABLE: "Table", Kind.LISTING: "Listing"}


def faults(
    statement: Statement, lines: tuple[int, int], paragraph: int | None, places: Places, section: str = ""
) -> Iterator[str]:
    """Yield what is wrong with the lines and the paragraph that a claim gives.

    Args:
        statement: The inventory's entry of the claim.
        lines: First and last line, counted from 1.
        paragraph: Of the section; None if the claim gives none.
        places: Those of the text copy.
        section: The one the claim stands in, if it is not the statement's: the inventory has figures by
            chapter alone.
    """
    first, last = lines
    if not 1 <= first <= last <= len(places.lines):
        yield f"{statement.id}: the copy has no lines {first} to {last}"
        return
    text = "\n".join(places.lines[first - 1 : last])
    if not text.strip():
        yield f"{statement.id}: nothing stands on the lines {first} to {last}"
    section = section or statement.section
    begins, ends = places.sections[section]
    if statement.kind is Kind.STATEMENT and not begins <= first <= last <= ends:
        yield f"{statement.id}: section {section} has the lines {begins} to {ends}, not {first} to {last}"
    if (number := _number(statement, places)) and not number.search(text):
        yield f"{statement.id}: the lines {first} to {last} do not hold its number"
    if paragraph is not None:
        found = (places.paragraph_at(line) for line in range(first, last + 1))
        if (section, paragraph) not in {(each.section, each.number) for each in found if each}:
            yield f"{statement.id}: the lines {first} to {last} are not in paragraph {paragraph} of {section}"


def _number(statement: Statement, places: Places) -> re.Pattern[str] | None:
    """Return what finds the number of a numbered thing; some equations have none in the thesis."""
    number = re.escape(statement.id.partition("-")[2])
    if statement.kind is Kind.EQUATION:
        is_numbered = statement.id in places.numbered
        return re.compile(rf"\({number}\)|\\tag\s*\{{{number}\}}") if is_numbered else re.compile(r"\$\$")
    if statement.kind in NAMES:
        return re.compile(rf"{NAMES[statement.kind]} {number}(?!\.?\d)")
    return None
