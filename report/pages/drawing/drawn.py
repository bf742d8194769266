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

    The identifier is unique in the report. The caption is plain text or Markdown by its type; the alternative
    text says what a reader who cannot see it must know.
    """
    with style():
        svg = to_svg(draw(), identifier, title, alternative_text)
    return Figure(identifier, title, caption, alternative_text, svg)
