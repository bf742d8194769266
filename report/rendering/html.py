"""The report as one HTML file that needs nothing beside it."""

import re

from report.copy.reading import ReaderCopy
from report.document.document import Document
from report.judging.verdict import grade
from report.octave.archive import archive
from report.pages.figure_colours import with_variables
from report.pages.html import Look, as_base64, html_templates, page, with_drawings
from report.rendering.markdown import ARCHIVE
from report.rendering.passages import passages
from report.rendering.pictures.drawings import drawings
from report.rendering.sources import sources
from report.rendering.summary import GRADES, SYMBOLS

STYLES = ("page.css", "tables.css", "student.css", "sliders.css", "print.css")
SCRIPTS = (
    "search.js",
    "claims.js",
    "contents.js",
    "sliders.js",
    "explorable.js",
    "zoom.js",
    "figures.js",
    "page.js",
    "sources.js",
    "cards.js",
)
_PLACE_OF_PASSAGE = re.compile(r"<!-- passage (?P<claim>\S+) -->")
_PLACE_OF_COPY = re.compile("<!-- reader's copy -->")


def to_html(document: Document, body: str, copy: ReaderCopy | None = None) -> str:
    """Return the report as one HTML page with its style, script, font, figures, programs and sources inside.

    Passages of the reader's own copy come into the page here, and are kept nowhere else.

    Raises:
        BrokenLinkError: if a finding names a source file that is not there.
    """
    figures = {figure.id: figure.svg for figure in document.drawings}
    svg = drawings(document) | {id: with_variables(each) for id, each in figures.items()}
    code = html_templates().get_template("sources.html.j2").render(sources=sources(document))
    return page(
        "page.html.j2",
        Look(STYLES, SCRIPTS, figures.values(), document.explorable.formulas if document.explorable else ""),
        _with_copy(_with_programs(with_drawings(body, svg), document), document, copy) + code,
        document=document,
        symbols=SYMBOLS,
        grades={grade(finding) for finding in document.findings},
        grade_words=GRADES,
    )


def _with_programs(body: str, document: Document) -> str:
    """Put the archive of the programs into the link that downloads it."""
    address = f"data:application/zip;base64,{as_base64(archive(document.programs))}"
    return body.replace(f'href="{ARCHIVE}"', f'href="{address}"', 1)


def _with_copy(body: str, document: Document, copy: ReaderCopy | None) -> str:
    """Put what the reader's copy has into the places for it; without a copy they stay empty."""
    if copy is None:
        return _PLACE_OF_COPY.sub("", _PLACE_OF_PASSAGE.sub("", body))
    template = html_templates().get_template("passage.html.j2")
    whose = "reader’s copy" if document.subject.by_machine else document.subject.called
    shown = {
        claim: template.render(passage=passage, whose=whose)
        for claim, passage in passages(document, copy).items()
    }
    notice = html_templates().get_template("reader_copy.html.j2").render(copy=copy)
    noticed = _PLACE_OF_COPY.sub(lambda _: notice, body)
    return _PLACE_OF_PASSAGE.sub(lambda match: shown[match["claim"]], noticed)
