"""The report as PDF, set by Typst."""

from __future__ import annotations

from report.cache.stage_store import StageStore
from report.document.document import Document
from report.octave.archive import files
from report.pages.formats import Paper
from report.pages.pdf import Head, typeset
from report.rendering.pictures.drawings import drawings


def to_pdf(document: Document, body: str, paper: Paper = Paper.A4, store: StageStore | None = None) -> bytes:
    """Return the report as PDF; the same document gives the same bytes on every machine.

    Args:
        document: the report.
        body: its text, as ``Converter.typst`` returns it.
        paper: size of the pages.
        store: where the PDF is kept, and taken from if nothing has changed.

    Raises:
        TypesettingError: if Typst cannot set it; the message names a formula that does not fit.
        FileWriteError: if the PDF cannot be kept.
    """
    more = {
        **{f"figures/{name}.svg": svg.encode() for name, svg in drawings(document).items()},
        **{f"octave/{name}": text.encode() for name, text in files(document.programs).items()},
    }
    head = Head(document.title, document.subtitle, document.provenance.date)
    return typeset(head, body, more, paper, store)
