"""Taking some chapters out of a report."""

import re
from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import Any

from report.document.document import Document
from report.document.thesis import Chapter
from trimmer import TrimmerError
from trimmer.messages import near_match


class UnknownChapterError(TrimmerError, ValueError):
    """A chapter was asked for that the report does not have."""


def chapter_name(number: str) -> str:
    """Return what a chapter is called on the command line: ``ch5`` or ``appA``."""
    return f"ch{number}" if number.isdigit() else f"app{number}"


def chapter_numbers(names: Sequence[str], known: Collection[str]) -> frozenset[str]:
    """Return the numbers and letters of known chapters that are named as ``ch5`` or ``appA``, in either case.

    Raises:
        UnknownChapterError: if a name is none of a known chapter; the message lists those.
    """
    by_name = {chapter_name(number).lower(): number for number in known}
    for name in names:
        if name.lower() not in by_name:
            choices = [chapter_name(number) for number in sorted(known)]
            advice = near_match(name, choices) or f"choose from {', '.join(choices)}"
            raise UnknownChapterError(f"--only {name}: there is no such chapter; {advice}")
    return frozenset(by_name[name.lower()] for name in names)


def select(document: Document, names: Sequence[str]) -> Document:
    """Return the document with the named chapters only, and with what rests on their claims.

    Without names it is the whole document. The derivations, and what extra chapters say of the whole report,
    are left out of a part.

    Raises:
        UnknownChapterError: if a name is none of a chapter with findings.
    """
    if not names:
        return document
    numbers = chapter_numbers(names, {chapter.number for chapter in document.chapters})
    chosen = tuple(chapter for chapter in document.chapters if chapter.number in numbers)
    kept = {finding.id for chapter in chosen for finding in chapter.findings}
    extras: dict[str, Any] = {name: chapter.part(kept) for name, chapter in document.extras.items()}
    return replace(
        document,
        chapters=chosen,
        omitted=tuple(chapter for chapter in document.chapters if chapter.number not in numbers),
        figures=tuple(figure for figure in document.figures if figure.id in kept),
        programs=tuple(program for program in document.programs if program.claim in kept),
        derivation=(),
        describing_functions=(),
        solution=(),
        step_of={},
        spread=(),
        **extras,
    )


def without_links_to(text: str, omitted: Sequence[Chapter]) -> str:
    """Turn Markdown links to places in omitted chapters into their words."""
    places = {place for chapter in omitted for place in (chapter.id, *(f.id for f in chapter.findings))}
    return re.sub(
        r"\[([^\[\]]*)\]\(#([^)\s]+)\)", lambda link: link[1] if link[2] in places else link[0], text
    )
