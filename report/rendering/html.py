"""Markdown to one HTML file that needs nothing beside it."""

from __future__ import annotations

import base64
import functools
import re
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from report.document import Document
from report.rendering.markdown import TEMPLATES
from report.rendering.mathml import repaired
from report.rendering.pandoc import convert

FONT = Path(__file__).parent.parent / "fonts" / "stix-two-math.woff2"
_CONTENTS_END = "<!-- end of contents -->"
_DRAWING = re.compile(r'<img src="figures/(?P<id>[^"]+)\.svg"[^>]*>')


def to_html(document: Document, markdown: str) -> str:
    """Return the report as one HTML page with its style, script, font and figures inside."""
    converted = convert(
        markdown,
        "html5",
        [
            "--standalone",
            "--wrap=none",
            "--mathml",
            "--toc",
            "--toc-depth=3",
            "--shift-heading-level-by=0",
            f"--template={TEMPLATES / 'fragment.html'}",
            f"--lua-filter={TEMPLATES / 'html.lua'}",
            "--metadata=title=-",
        ],
    )
    contents, body = repaired(converted).split(_CONTENTS_END)
    return (
        _environment()
        .get_template("page.html.j2")
        .render(
            document=document,
            contents=contents,
            body=_with_drawings(body, {figure.id: figure.svg for figure in document.figures}),
            style=(TEMPLATES / "page.css").read_text(encoding="utf-8"),
            script=(TEMPLATES / "page.js").read_text(encoding="utf-8"),
            font=base64.b64encode(FONT.read_bytes()).decode("ascii"),
        )
    )


def _with_drawings(body: str, drawings: dict[str, str]) -> str:
    """Put each drawing in the place of the image that names it."""
    return _DRAWING.sub(lambda match: drawings[match["id"]], body)


@functools.cache
def _environment() -> Environment:
    return Environment(
        loader=FileSystemLoader(TEMPLATES), undefined=StrictUndefined, autoescape=True, trim_blocks=True
    )
