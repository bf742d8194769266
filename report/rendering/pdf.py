"""Markdown to PDF, through pandoc and Typst."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any

from report.document import Document
from report.rendering.markdown import TEMPLATES
from report.rendering.pandoc import convert


class TypesettingError(RuntimeError):
    """Typst refused the report, for instance because a formula runs off the page."""


def to_typst(document: Document, markdown: str) -> str:
    """Return the report as Typst source; figures are named as files in it."""
    source = document.provenance
    return convert(
        markdown,
        "typst-smart",
        [
            "--standalone",
            "--wrap=none",
            "--shift-heading-level-by=-1",
            f"--template={TEMPLATES / 'report.typ'}",
            f"--lua-filter={TEMPLATES / 'typst.lua'}",
            f"--metadata=title={document.title}",
            f"--metadata=version=trimmer {source.version}, commit {source.commit}, {source.date[:10]}",
        ],
    )


def to_pdf(document: Document, markdown: str) -> bytes:
    """Return the report as PDF; the same document gives the same bytes on every machine.

    Raises:
        TypesettingError: if Typst cannot set it; the message names a formula that does not fit.
    """
    import typst  # here: the module holds a whole typesetter

    figures = {f"figures/{figure.id}.svg": figure.svg.encode() for figure in document.figures}
    # Typst's annotations leave out that its input may be a dictionary of files, with the main one first.
    source: Any = {"main": to_typst(document, markdown).encode(), **figures}
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
