"""Prose of records: a text block of the source is one line of the report."""

from __future__ import annotations

import re

from trimmer.errors import TrimmerError

SPACE = re.compile(r"[ \n]+")
"""Spaces that may be one; not a no-break space."""


class RecordError(TrimmerError, ValueError):
    """A record of a claim or a figure cannot be used; the message says which one, and what to do."""


def one_line(prose: str) -> str:
    """Return prose in one line: a line break and the indent behind it are one space.

    Raises:
        RecordError: if a formula stands between two dollar signs on each side, which sets it apart.
    """
    if "$$" in prose:
        raise RecordError(f"a formula in prose stands between single dollar signs: {prose.strip()}")
    return SPACE.sub(" ", prose.strip(" \n"))
