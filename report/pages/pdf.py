"""Typst source as PDF, below the head that all reports share."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from importlib.metadata import version
from tempfile import TemporaryDirectory
from typing import Any

from report.cache.stage_store import StageStore
from report.pages.formats import Paper
from report.pages.pieces import TEMPLATES

_PAPERS = {Paper.A4: "a4", Paper.LETTER: "us-letter"}


class TypesettingError(RuntimeError):
    """Typst refused the report, for instance because a formula runs off the page."""


@dataclass(frozen=True)
class Head:
    """What stands above the text of a report."""

    title: str  # Of the document
    subtitle: str  # The line below it
    date: str  # ISO date of what it was made from, or on which it was made
    strict: bool = True  # Whether a formula that can only be set too small to be read is an error
    name: str = "pdf"  # Under which it is kept


def typeset(
    head: Head, body: str, more: Mapping[str, bytes], paper: Paper = Paper.A4, store: StageStore | None = None
) -> bytes:
    """Return Typst source as PDF, below the head that all reports share.

    It holds the label ``end-of-report`` and names no files but those given. The PDF is kept in the store, and
    taken from there if nothing has changed.

    Raises:
        TypesettingError: if Typst cannot set it; the message names a formula that does not fit.
        FileWriteError: if the PDF cannot be kept.
    """
    source = {"main": _source(head, body, paper).encode(), **more}
    timestamp = _timestamp(head.date)
    make = partial(_set, source, timestamp)
    if store is None:
        return make()
    depends = repr((version("typst"), timestamp, source))
    return store.made(f"{head.name}-{paper.value}", hashlib.sha256(depends.encode()).hexdigest(), make)


def _source(head: Head, body: str, paper: Paper) -> str:
    settings = {"title": head.title, "version": head.subtitle, "paper": _PAPERS[paper]}
    defined = "".join(f"#let {name} = {_string(value)}\n" for name, value in settings.items())
    defined += f"#let strict = {str(head.strict).lower()}\n"
    return f"{defined}{(TEMPLATES / 'report.typ').read_text(encoding='utf-8')}\n{body}"


def _string(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def _set(source: dict[str, bytes], timestamp: int) -> bytes:
    import typst  # here: the module holds a whole typesetter

    # Typst's annotations leave out that its input may be a dictionary of files, with the main one first.
    files_of_source: Any = source
    try:
        # What is not in the dictionary Typst would look for below its root.
        with TemporaryDirectory() as empty:
            return typst.compile(
                files_of_source, format="pdf", root=empty, ignore_system_fonts=True, timestamp=timestamp
            )
    except typst.TypstError as error:
        raise TypesettingError(f"the PDF could not be set: {error}") from error


def _timestamp(date: str) -> int:
    """Return seconds since 1970 of an ISO date or time; without a time zone it is taken as UTC."""
    moment = datetime.fromisoformat(date)
    if moment.tzinfo is None:
        moment = moment.replace(tzinfo=UTC)
    return int(moment.timestamp())
