"""A picture with what stands beside it, as the templates take it."""

from collections.abc import Callable

from matplotlib.figure import Figure as Drawing

from report.pages.drawing.style import style
from report.pages.drawing.svg import to_svg
from report.pages.figure import Figure


def drawn(
    identifier: str, title: str, caption: str, alternative_text: str, draw: Callable[[], Drawing]
) -> Figure:
    """Draw a picture in the look of all reports.

    Args:
        identifier: Name of the picture, unique in the report.
        title: Its title, plain text.
        caption: What is shown; plain text, or Markdown by its type.
        alternative_text: What a reader who cannot see it must know, plain text.
        draw: Draws it.
    """
    with style():
        svg = to_svg(draw(), identifier, title, alternative_text)
    return Figure(identifier, title, caption, alternative_text, svg)
