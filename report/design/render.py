"""Writing the report on a design as HTML and PDF."""

from collections.abc import Callable, Mapping

from report.design.report import Report
from report.pages.figure import Figure
from report.pages.figure_colours import with_variables
from report.pages.formats import Format, Paper, made_together
from report.pages.html import Look, page, with_drawings
from report.pages.pdf import Head, typeset
from report.pages.pieces import Converter

STYLES = ("page.css", "tables.css", "sliders.css", "print.css")
SCRIPTS = (
    *("search.js", "design/find.js", "contents.js", "sliders.js", "design/solved.js"),
    *("zoom.js", "figures.js", "page.js"),
)


def rendered(
    document: Report, pieces: Mapping[str, str], formats: frozenset[Format], paper: Paper
) -> dict[Format, str | bytes]:
    """Return the report, whose text is in pieces, in the forms that are wanted.

    Raises:
        PandocError: if pandoc cannot read the text or its mathematics.
        TypesettingError: if the PDF cannot be set.
    """
    converter = Converter()
    text = converter.parsed(pieces)
    source = converter.typst(text) if Format.PDF in formats else ""
    makers: dict[Format, Callable[[], str | bytes]] = {
        Format.PDF: lambda: _pdf(document, source, document.figures, paper),
        Format.HTML: lambda: _html(document, converter.html(text), document.figures),
    }
    return made_together(makers, formats)


def _html(document: Report, body: str, figures: Mapping[str, Figure]) -> str:
    svg = {name: with_variables(each.svg) for name, each in figures.items()}
    moved = document.explorable.script if document.explorable else ""
    look = Look(STYLES, SCRIPTS, [each.svg for each in figures.values()], moved)
    return page("design/page.html.j2", look, with_drawings(body, svg), document=document)


def _pdf(document: Report, body: str, figures: Mapping[str, Figure], paper: Paper) -> bytes:
    more = {f"figures/{name}.svg": each.svg.encode() for name, each in figures.items()}
    head = Head(document.title, document.subtitle, document.origin.date, strict=False)
    return typeset(head, body, more, paper, None)
