"""The text of the report, piece by piece: read from Markdown and written as HTML and as Typst.

A piece is the front, a chapter or the back. Each form of it is kept for the next build, which then converts
only the pieces that have changed.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from importlib.metadata import version
from pathlib import Path
from typing import TypeVar

from report.building.source_closure import digest
from report.building.stage_store import StageStore
from report.rendering.mathml import repaired
from report.rendering.pandoc import read, write

Piece = TypeVar("Piece", str, bytes)
Form = TypeVar("Form", str, bytes)

TEMPLATES = Path(__file__).parent.parent / "templates"
HTML_FILTER = TEMPLATES / "html.lua"
TYPST_FILTER = TEMPLATES / "typst.lua"


def parsed(pieces: Mapping[str, str], store: StageStore | None = None) -> dict[str, bytes]:
    """Return pieces of Markdown, by name, in pandoc's own form.

    Raises:
        PandocError: if pandoc fails or warns.
        FileWriteError: if a piece cannot be kept.
    """
    return _each(pieces, "text", read, store)


def html(text: Mapping[str, bytes], store: StageStore | None = None) -> str:
    """Return what ``parsed`` has returned as the inside of an HTML page; for the errors see there."""
    return "".join(_each(text, "html", _html, store).values())


def typst(text: Mapping[str, bytes], store: StageStore | None = None) -> str:
    """Return what ``parsed`` has returned as Typst source; for the errors see there."""
    return "".join(_each(text, "typst", _typst, store).values())


def _html(content: bytes) -> str:
    return repaired(write(content, "html5", ["--mathml", f"--lua-filter={HTML_FILTER}"]))


def _typst(content: bytes) -> str:
    return write(content, "typst-smart", ["--shift-heading-level-by=-1", f"--lua-filter={TYPST_FILTER}"])


def _each(
    pieces: Mapping[str, Piece], form: str, make: Callable[[Piece], Form], store: StageStore | None
) -> dict[str, Form]:
    """Make a form of each piece, the longest first; pandoc works outside of the interpreter's lock."""
    converter = _converter() if store else ""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        begun = {
            name: pool.submit(_made, f"{form}-{name}", partial(make, piece), (converter, piece), store)
            for name, piece in sorted(pieces.items(), key=lambda item: -len(item[1]))
        }
        return {name: begun[name].result() for name in pieces}


def _made(
    stage: str, make: Callable[[], Form], depends: tuple[str, str | bytes], store: StageStore | None
) -> Form:
    if store is None:
        return make()
    return store.made(stage, hashlib.sha256(repr(depends).encode()).hexdigest(), make)


def _converter() -> str:
    """Return a digest of what turns pieces into their forms."""
    filters = [path.read_bytes() for path in (HTML_FILTER, TYPST_FILTER)]
    return digest([__name__], version("pypandoc-binary"), filters)
