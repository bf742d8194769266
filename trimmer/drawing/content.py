"""The content of the file of a picture, the same for the same picture."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

from matplotlib import rc_context

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DATELESS = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {}}
"""Metadata without a date, so that the same picture has the same bytes."""


def content_of(figure: Figure, file_format: str) -> bytes:
    """Return a figure as the content of a file: ``svg``, ``png`` or ``pdf``."""
    content = io.BytesIO()
    with rc_context({"svg.hashsalt": "trimmer", "svg.fonttype": "path"}):
        figure.savefig(content, format=file_format, metadata=DATELESS[file_format])
    return content.getvalue()
