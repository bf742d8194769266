"""Writing a report in the forms that are wanted."""

from collections.abc import Callable, Mapping
from pathlib import Path

from report.cache.stage_store import StageStore
from report.document.document import Document
from report.octave.archive import files
from report.pages.formats import Format, Paper, made_together
from report.pages.links import leading_elsewhere
from report.pages.pdf import Head, typeset
from report.pages.pieces import Converter
from report.rendering.errata import to_csv
from report.rendering.html import to_html
from report.rendering.json import to_json
from report.rendering.markdown import REPORT, to_markdown
from report.rendering.pictures.drawings import drawings
from report.rendering.request import WHOLE_REPORT, Request
from trimmer.files import write_atomically

NAMES = {
    Format.HTML: "report.html",
    Format.PDF: "report.pdf",
    Format.CARDS: "cards.pdf",
    Format.JSON: "claims.json",
    Format.CSV: "errata.csv",
}
"""Name of the file of each form."""


def render(
    document: Document, directory: Path, request: Request = WHOLE_REPORT, store: StageStore | None = None
) -> Mapping[Format, Path]:
    """Write the report in the forms that are wanted; return the path of each.

    All of them are made before the first is written, so that a failure leaves the files of the last build.
    Converted pieces are kept in the store for the next rendering; without one all are converted.

    Raises:
        BrokenLinkError: if a link inside the report leads nowhere or two places share an identifier.
        PandocError: if pandoc cannot read the text or its mathematics.
        TypesettingError: if the PDF cannot be set, for instance because a formula does not fit the page.
        FileWriteError: if a file cannot be written, or a piece cannot be kept.
    """
    converter = Converter.keeping(store) if store else Converter()
    wanted = request.formats & {Format.HTML, Format.CARDS}
    text = converter.parsed(to_markdown(document)) if wanted else {}
    # The PDFs take longest: their source comes first, so that Typst works while pandoc writes the HTML.
    report, cards = pdf_sources(converter, text) if Format.CARDS in request.formats else ("", "")
    makers: dict[Format, Callable[[], str | bytes]] = {
        Format.CARDS: lambda: to_pdf(document, Format.CARDS, cards, request.paper, store),
        Format.PDF: lambda: to_pdf(document, Format.PDF, report, request.paper, store),
        Format.HTML: lambda: to_html(document, converter.html(text), request.copy),
        Format.JSON: lambda: to_json(document),
        Format.CSV: lambda: to_csv(document),
    }
    contents = made_together(makers, request.formats)
    paths = {form: directory / name for form, name in NAMES.items() if form in contents}
    for form, path in paths.items():
        write_atomically(path, contents[form], overwrite=request.overwrite)
    return paths


def pdf_sources(converter: Converter, text: Mapping[str, bytes]) -> tuple[str, str]:
    """Return the source of the report to be read and of its cards; a link to the other one names its file.

    Raises:
        PandocError: if pandoc cannot write a piece.
    """
    read = {name: piece for name, piece in text.items() if name in REPORT}
    cards = {name: piece for name, piece in text.items() if name not in REPORT}
    return (
        leading_elsewhere(converter.typst(read), NAMES[Format.CARDS]),
        leading_elsewhere(converter.typst(cards), NAMES[Format.PDF]),
    )


def to_pdf(
    document: Document, form: Format, body: str, paper: Paper = Paper.A4, store: StageStore | None = None
) -> bytes:
    """Return the report or its cards as PDF; the same document gives the same bytes on every machine.

    The PDF is kept in the store, and taken from there if nothing has changed.

    Raises:
        TypesettingError: if Typst cannot set it; the message names a formula that does not fit.
        FileWriteError: if the PDF cannot be kept.
    """
    drawn = {f"figures/{name}.svg": svg.encode() for name, svg in drawings(document).items()}
    programs = {f"octave/{name}": text.encode() for name, text in files(document.programs).items()}
    named = {name: content for name, content in drawn.items() if f'"{name}"' in body}
    title = document.title + (": the cards" if form is Format.CARDS else "")
    head = Head(title, document.subtitle, document.provenance.date, name=form.word)
    return typeset(head, body, named | programs, paper, store)
