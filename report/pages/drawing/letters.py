"""Letters of panels: one rule for all figures, so that captions can name them."""

import re
from string import ascii_lowercase
from typing import Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

_COLOUR_BAR: Final = "<colorbar>"
_LETTERED: Final = re.compile(r"^\([a-z]\)(?: |$)")


def panels_of(figure: Figure) -> list[Axes]:
    """Return what a reader sees as panels: no insets, no colour bars, nothing that only holds a legend."""
    return [
        axes for axes in figure.axes if axes.get_label() != _COLOUR_BAR and (axes.axison or title_of(axes))
    ]


def title_of(axes: Axes) -> str:
    """Return the title of a panel, wherever above it that stands."""
    return axes.get_title() or axes.get_title(loc="left")


def letter_panels(figure: Figure) -> None:
    """Begin the title of each panel with its letter, at the left; a figure with one panel needs none."""
    shown = panels_of(figure)
    if len(shown) < 2:
        return
    for letter, axes in zip(ascii_lowercase, shown, strict=False):
        title = _LETTERED.sub("", title_of(axes))
        axes.set_title("")
        axes.set_title(f"({letter}) {title}".rstrip(), loc="left")
