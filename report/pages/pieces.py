"""The text of the report, piece by piece: read from Markdown and written as HTML and as Typst.

A piece is the front, a section of a chapter, or a part of the back. Each form of it is kept for the next
build, which then converts only the pieces that have changed.
"""

import hashlib
import os
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from typing import Self, TypeVar

from report.cache.source_closure import SourceTree
from report.cache.stage_store import StageStore
from report.folders import templates
from report.pages.formulas.mathml import repaired
from report.pages.pandoc import read, write

Piece = TypeVar("Piece", str, bytes)
Form = TypeVar("Form", str, bytes)

TEMPLATES = templates()
HTML_FILTER = TEMPLATES / "html.lua"
TYPST_FILTER = TEMPLATES / "typst.lua"
UNITS_FILTER = TEMPLATES / "units.lua"


@dataclass(frozen=True)
class Converter:
    """Turns pieces into their forms."""

    # Where each form is kept, and taken from if nothing it depends on has changed; nowhere if None
    store: StageStore | None = None
    digest: str = ""  # Of what turns pieces into their forms

    @classmethod
    def keeping(cls, store: StageStore) -> Self:
        """Keep each form in a store.

        Raises:
            FileWriteError: if what the converter itself depends on cannot be kept.
        """
        filters = [path.read_bytes() for path in (HTML_FILTER, TYPST_FILTER, UNITS_FILTER)]
        return cls(store, SourceTree.kept(store).digest([__name__], version("pypandoc-binary"), filters))

    def parsed(self, pieces: Mapping[str, str]) -> dict[str, bytes]:
        """Return pieces of Markdown, by name, in pandoc's own form.

        Raises:
            PandocError: if pandoc fails or warns.
            FileWriteError: if a piece cannot be kept.
        """
        return self._each(pieces, "text", _text)

    def html(self, text: Mapping[str, bytes]) -> str:
        """Return what ``parsed`` has returned as the inside of an HTML page; for the errors see there."""
        return "".join(self._each(text, "html", _html).values())

    def typst(self, text: Mapping[str, bytes]) -> str:
        """Return what ``parsed`` has returned as Typst source; for the errors see there."""
        return "".join(self._each(text, "typst", _typst).values())

    def _each(self, pieces: Mapping[str, Piece], form: str, make: Callable[[Piece], Form]) -> dict[str, Form]:
        """Make a form of each piece, the longest first; pandoc works outside of the interpreter's lock."""
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            begun = {
                name: pool.submit(self._made, f"{form}-{name}", partial(make, piece), piece)
                for name, piece in sorted(pieces.items(), key=lambda item: -len(item[1]))
            }
            return {name: begun[name].result() for name in pieces}

    def _made(self, stage: str, make: Callable[[], Form], piece: str | bytes) -> Form:
        if self.store is None:
            return make()
        depends = repr((self.digest, piece))
        return self.store.made(stage, hashlib.sha256(depends.encode()).hexdigest(), make)


def _text(piece: str) -> bytes:
    return read(piece, UNITS_FILTER)


def _html(content: bytes) -> str:
    return repaired(write(content, "html5", ["--mathml", f"--lua-filter={HTML_FILTER}"]))


def _typst(content: bytes) -> str:
    return write(content, "typst-smart", ["--shift-heading-level-by=-1", f"--lua-filter={TYPST_FILTER}"])
