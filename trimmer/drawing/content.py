"""The content of the file of a picture, the same for the same picture."""

from __future__ import annotations

import io
import warnings
from contextlib import contextmanager
from typing import TYPE_CHECKING

from matplotlib import rc_context
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from matplotlib.axes import Axes

DATELESS = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {}}
"""Metadata without a date, so that the same picture has the same bytes."""
SIZE = (7.2, 4.6)
DPI = 160
"""Dots per inch of a PNG."""


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure of a size in inches, which pyplot does not know of."""
    return Figure(figsize=(width, height), layout="constrained")


def figure_of(draw: Callable[[Axes], object], title: str = "", size: tuple[float, float] = SIZE) -> Figure:
    """Return a figure with one picture.

    Args:
        draw: Draws into axes, such as a result's ``plot``.
        title: What stands above it.
        size: Width and height, inches.
    """
    figure = new_figure(*size)
    draw(figure.add_subplot())
    head(figure, title)
    return figure


def head(figure: Figure, title: str) -> None:
    """Write a title above a figure."""
    if title:
        figure.suptitle(title, fontsize="medium", parse_math=False)


@contextmanager
def unwarned() -> Iterator[None]:
    """Leave out Matplotlib's warnings of letters that no font has, and of names that leave axes no room."""
    with warnings.catch_warnings():
        for message in ("Glyph ", "constrained_layout not applied", "Tight layout not applied"):
            warnings.filterwarnings("ignore", message, UserWarning)
        yield


def content_of(figure: Figure, file_format: str) -> bytes:
    """Return a figure as the content of a file: ``svg``, ``png`` or ``pdf``."""
    content = io.BytesIO()
    with unwarned(), rc_context({"svg.hashsalt": "trimmer", "svg.fonttype": "path"}):
        figure.savefig(content, format=file_format, metadata=DATELESS[file_format], dpi=DPI)
    return content.getvalue()
