"""The report as PDF, through pandoc and Typst."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Any

from report.document import Document
from report.octave.archive import files
from report.rendering.markdown import TEMPLATES
from report.rendering.pandoc import write
from report.rendering.request import Paper
from report.rendering.verdict_picture import NAME, verdict_picture

_PAPERS = {Paper.A4: "a4", Paper.LETTER: "us-letter"}


class TypesettingError(RuntimeError):
    """Typst refused the report, for instance because a formula runs off the page."""


def to_typst(document: Document, content: Sequence[bytes], paper: Paper = Paper.A4) -> str:
    """Return the report as Typst source; figures and programs are named as files in it.

    Args:
        document: the report.
        content: its text, as ``pandoc.read`` returns it.
        paper: size of the pages.
    """
    source = document.provenance
    settings = {
        "title": document.title,
        "version": f"trimmer {source.version}, commit {source.commit}, {source.date[:10]}",
        "paper": _PAPERS[paper],
    }
    body = write(
        content,
        "typst-smart",
        ["--shift-heading-level-by=-1", f"--lua-filter={TEMPLATES / 'typst.lua'}"],
    )
    defined = "".join(f"#let {name} = {_string(value)}\n" for name, value in settings.items())
    return f"{defined}{(TEMPLATES / 'report.typ').read_text(encoding='utf-8')}\n{body}"


def _string(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def to_pdf(document: Document, content: Sequence[bytes], paper: Paper = Paper.A4) -> bytes:
    """Return the report as PDF; the same document gives the same bytes on every machine.

    Raises:
        TypesettingError: if Typst cannot set it; the message names a formula that does not fit.
    """
    import typst  # here: the module holds a whole typesetter

    figures = {f"figures/{figure.id}.svg": figure.svg.encode() for figure in document.figures}
    programs = {f"octave/{name}": text.encode() for name, text in files(document.programs).items()}
    # Typst's annotations leave out that its input may be a dictionary of files, with the main one first.
    source: Any = {
        "main": to_typst(document, content, paper).encode(),
        f"figures/{NAME}.svg": verdict_picture(document).encode(),
        **figures,
        **programs,
    }
    try:
        return typst.compile(
            source, format="pdf", ignore_system_fonts=True, timestamp=_timestamp(document.provenance.date)
        )
    except typst.TypstError as error:
        raise TypesettingError(f"the PDF could not be set: {error}") from error


def _timestamp(date: str) -> int:
    """Return seconds since 1970 of an ISO date or time; without a time zone it is taken as UTC."""
    moment = datetime.fromisoformat(date)
    if moment.tzinfo is None:
        moment = moment.replace(tzinfo=UTC)
    return int(moment.timestamp())
