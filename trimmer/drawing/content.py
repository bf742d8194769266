"""The content of the file of a picture, the same for the same picture."""

import io
import re
import textwrap
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.errors import LetterWarning
from trimmer.messages import shown_value

DATELESS = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "png": {}}
"""Metadata without a date, so that the same picture has the same bytes."""
SIZE = (7.2, 4.6)
CHARACTERS = 11  # About as many of a title stand side by side on an inch
DPI = 160  # Dots per inch of a PNG
_MISSING = re.compile(r"Glyph (\d+) .*missing from font", flags=re.DOTALL)
_NO_ROOM = ("constrained_layout not applied", "Tight layout not applied")


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure of a size in inches, which pyplot does not know of."""
    return Figure(figsize=(width, height), layout="constrained")


def figure_of(draw: Callable[[Axes], object], title: str = "", size: tuple[float, float] = SIZE) -> Figure:
    """Return a figure of some size, inches, with one picture, such as a result's ``plot``, and its title."""
    figure = new_figure(*size)
    draw(figure.add_subplot())
    head(figure, title)
    return figure


def head(figure: Figure, title: str) -> None:
    """Write a title above a figure, in several lines if it is wider."""
    if title:
        lines = textwrap.fill(title, int(CHARACTERS * figure.get_figwidth()))
        figure.suptitle(lines, fontsize="medium", parse_math=False)


@contextmanager
def unwarned() -> Iterator[None]:
    """Leave out Matplotlib's warnings of names that leave axes no room, and tell missing letters in one."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        yield
    letters = set()
    for each in told:
        text = str(each.message)
        if found := _MISSING.match(text):
            letters.add(chr(int(found[1])))
        elif not text.startswith(_NO_ROOM):
            warnings.warn_explicit(each.message, each.category, each.filename, each.lineno)
    if letters:
        shown = shown_value("".join(sorted(letters)))
        warnings.warn(
            f"boxes stand in pictures for letters that none of their fonts has: {shown}", LetterWarning, 3
        )


def content_of(figure: Figure, file_format: str) -> bytes:
    """Return a figure as the content of a file: ``svg``, ``png`` or ``pdf``."""
    content = io.BytesIO()
    with unwarned(), rc_context({"svg.hashsalt": "trimmer", "svg.fonttype": "path"}):
        figure.savefig(content, format=file_format, metadata=DATELESS[file_format], dpi=DPI)
    return content.getvalue()
