"""A page of HTML that needs nothing beside it: its frame, styles, scripts, font, contents and drawings."""

from __future__ import annotations

import base64
import functools
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from report.pages.figure_colours import variables
from report.pages.pieces import TEMPLATES
from report.pages.policy import policy

FONT = Path(__file__).parent.parent / "fonts" / "stix-two-math.woff2"
THEME = "theme.js"  # Script that runs before the first paint
_HEADING = re.compile(r'<h([23]) id="([^"]+)">(.*?)</h\1>', re.DOTALL)
_DRAWING = re.compile(r'<img src="figures/(?P<id>[^"]+)\.svg"[^>]*>')


@dataclass(frozen=True)
class ContentsEntry:
    """A line of the table of contents: where it leads, its HTML, and the lines below it."""

    identifier: str
    heading: str
    inner: tuple[ContentsEntry, ...]


@dataclass(frozen=True)
class Look:
    """What a page is dressed in: styles, scripts, drawings that follow its colours, and an own script."""

    styles: tuple[str, ...]
    scripts: tuple[str, ...]
    drawings: Iterable[str]
    own_script: str = ""


def page(template: str, look: Look, body: str, **values: object) -> str:
    """Return one page with its styles, scripts and font inside.

    Its template extends ``frame.html.j2`` and asks for values, the ``document`` with title and subtitle too.
    """
    styles = [_font_face(), "\n".join([*_templates(look.styles), variables(look.drawings)])]
    scripts = [*filter(None, [look.own_script]), "\n".join(_templates(look.scripts))]
    (theme,) = _templates([THEME])
    return (
        html_templates()
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
    source = f'url("data:font/woff2;base64,{as_base64(FONT.read_bytes())}") format("woff2")'
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


def as_base64(content: bytes) -> str:
    """Return bytes as text for an address of data."""
    return base64.b64encode(content).decode("ascii")


@functools.cache
def html_templates() -> Environment:
    """Return the environment of the templates of HTML."""
    return Environment(
        loader=FileSystemLoader(TEMPLATES), undefined=StrictUndefined, autoescape=True, trim_blocks=True
    )
