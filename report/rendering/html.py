"""The report as one HTML file that needs nothing beside it."""

from __future__ import annotations

import base64
import functools
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from report.copy.reading import ReaderCopy
from report.document.document import Document
from report.judging.grade import grade
from report.octave.archive import archive
from report.rendering.markdown import ARCHIVE
from report.rendering.passages import passages
from report.rendering.pictures.drawings import drawings
from report.rendering.pictures.figure_colours import variables, with_variables
from report.rendering.pieces import TEMPLATES
from report.rendering.policy import policy
from report.rendering.sources import sources
from report.rendering.summary import GRADES, SYMBOLS

FONT = Path(__file__).parent.parent / "fonts" / "stix-two-math.woff2"
STYLES = ("page.css", "tables.css", "student.css", "print.css")
THEME = "theme.js"
"""Script that runs before the first paint."""
SCRIPTS = (
    "search.js",
    "claims.js",
    "contents.js",
    "explorable.js",
    "zoom.js",
    "figures.js",
    "page.js",
    "sources.js",
    "cards.js",
)
_HEADING = re.compile(r'<h([23]) id="([^"]+)">(.*?)</h\1>', re.DOTALL)
_PLACE_OF_PASSAGE = re.compile(r"<!-- passage (?P<claim>\S+) -->")
_PLACE_OF_COPY = re.compile("<!-- reader's copy -->")
_DRAWING = re.compile(r'<img src="figures/(?P<id>[^"]+)\.svg"[^>]*>')


@dataclass(frozen=True)
class ContentsEntry:
    """A line of the table of contents: where it leads, its HTML, and the lines below it."""

    identifier: str
    heading: str
    inner: tuple[ContentsEntry, ...]


def to_html(document: Document, body: str, copy: ReaderCopy | None = None) -> str:
    """Return the report as one HTML page with its style, script, font, figures, programs and sources inside.

    Args:
        document: the report.
        body: its text, as ``Converter.html`` returns it.
        copy: the reader's own copy, whose passages are then shown; it comes into the page here and is kept
            nowhere else.

    Raises:
        BrokenLinkError: if a finding names a source file that is not there.
    """
    figures = {figure.id: figure.svg for figure in document.drawings}
    svg = drawings(document) | {id: with_variables(each) for id, each in figures.items()}
    code = _environment().get_template("sources.html.j2").render(sources=sources(document))
    return page(
        "page.html.j2",
        Look(STYLES, SCRIPTS, figures.values(), document.explorable.formulas if document.explorable else ""),
        _with_copy(_with_programs(with_drawings(body, svg), document), document, copy) + code,
        document=document,
        symbols=SYMBOLS,
        grades={grade(finding) for finding in document.findings},
        grade_words=GRADES,
    )


@dataclass(frozen=True)
class Look:
    """What a page is dressed in: styles, scripts, drawings that follow its colours, and an own script."""

    styles: tuple[str, ...]
    scripts: tuple[str, ...]
    drawings: Iterable[str]
    own_script: str = ""


def page(template: str, look: Look, body: str, **values: object) -> str:
    """Return one page with its styles, scripts and font inside.

    Args:
        template: name of the template; it extends ``frame.html.j2``.
        look: what the page is dressed in.
        body: the inside of the page.
        values: what the template asks for, the ``document`` with its title and subtitle among it.
    """
    styles = [_font_face(), "\n".join([*_templates(look.styles), variables(look.drawings)])]
    scripts = [*filter(None, [look.own_script]), "\n".join(_templates(look.scripts))]
    (theme,) = _templates([THEME])
    return (
        _environment()
        .get_template(template)
        .render(
            values,
            policy=policy([theme, *scripts], styles),
            contents=contents(body),
            body=body,
            styles=styles,
            scripts=scripts,
            theme=theme,
        )
    )


def _font_face() -> str:
    source = f'url("data:font/woff2;base64,{_base64(FONT.read_bytes())}") format("woff2")'
    return f'@font-face {{ font-family: "STIX Two Math"; src: {source}; }}'


def _templates(names: Iterable[str]) -> list[str]:
    return [(TEMPLATES / name).read_text(encoding="utf-8") for name in names]


def contents(body: str) -> tuple[ContentsEntry, ...]:
    """Return the table of contents: each heading of level 2 that has an identifier, with those of level 3."""
    entries: list[ContentsEntry] = []
    for level, identifier, heading in _HEADING.findall(body):
        if level == "2":
            entries.append(ContentsEntry(identifier, heading, ()))
        elif entries:
            entries[-1] = replace(
                entries[-1], inner=(*entries[-1].inner, ContentsEntry(identifier, heading, ()))
            )
    return tuple(entries)


def with_drawings(body: str, svg: dict[str, str]) -> str:
    """Put each drawing in the place of the image that names it."""
    return _DRAWING.sub(lambda match: svg[match["id"]], body)


def _with_programs(body: str, document: Document) -> str:
    """Put the archive of the programs into the link that downloads it."""
    address = f"data:application/zip;base64,{_base64(archive(document.programs))}"
    return body.replace(f'href="{ARCHIVE}"', f'href="{address}"', 1)


def _with_copy(body: str, document: Document, copy: ReaderCopy | None) -> str:
    """Put what the reader's copy has into the places for it; without a copy they stay empty."""
    if copy is None:
        return _PLACE_OF_COPY.sub("", _PLACE_OF_PASSAGE.sub("", body))
    template = _environment().get_template("passage.html.j2")
    shown = {claim: template.render(passage=passage) for claim, passage in passages(document, copy).items()}
    notice = _environment().get_template("reader_copy.html.j2").render(copy=copy)
    noticed = _PLACE_OF_COPY.sub(lambda _: notice, body)
    return _PLACE_OF_PASSAGE.sub(lambda match: shown[match["claim"]], noticed)


def _base64(content: bytes) -> str:
    return base64.b64encode(content).decode("ascii")


@functools.cache
def _environment() -> Environment:
    return Environment(
        loader=FileSystemLoader(TEMPLATES), undefined=StrictUndefined, autoescape=True, trim_blocks=True
    )
