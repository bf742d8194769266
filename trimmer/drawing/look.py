"""Colours and dashes of all pictures; no two lines differ by their colour alone."""

from typing import Any, Final

Look = dict[str, Any]  # Keyword arguments for ``Axes.plot``
BLACK: Final = "#000000"
LINES: Final[tuple[Look, ...]] = (
    {"color": "#0072b2", "linestyle": "solid"},  # blue
    {"color": "#d55e00", "linestyle": (0, (6, 2))},  # vermilion
    {"color": "#009e73", "linestyle": (0, (6, 2, 1.5, 2))},  # green
    {"color": "#cc79a7", "linestyle": (0, (1.5, 1.5))},  # purple
    {"color": "#e69f00", "linestyle": (0, (9, 2, 1.5, 2, 1.5, 2))},  # orange
    {"color": BLACK, "linestyle": (0, (3, 1.5))},
)
"""Lines in the order they are to be used, none told apart by its colour alone (Okabe and Ito, 2008)."""
COLOURS: Final = tuple(str(line["color"]) for line in LINES[:5])
"""Where dashes mean something else, such as stability; black is for marks."""
DOTTED: Final[Look] = {"color": BLACK, "linestyle": ":", "linewidth": 0.9}
FAINT: Final[Look] = {"color": "#555555", "linestyle": ":", "linewidth": 1.0}
"""Lines that only mark a place."""
STABLE: Final = "solid"
UNSTABLE: Final = (0, (4, 2))  # Dashes of motions that are stable and not
LONGEST_LABEL: Final = 60  # Characters of a name that a picture shows


def line(number: int) -> Look:
    """Return the look of a line by its number; there are as many as are wanted, with repetition."""
    return LINES[number % len(LINES)]


def colour(number: int) -> str:
    """Return the colour of a line by its number, where its dashes mean something else."""
    return COLOURS[number % len(COLOURS)]


def plain_label(text: str, longest: int = LONGEST_LABEL) -> str:
    """Return a name of the user's as a label: cut if it is long, and nothing in it acts.

    Matplotlib takes what stands between dollar signs for mathematics, and hides a label that begins with _.
    """
    short = text if len(text) <= longest else f"{text[: longest - 1]}…"
    return f"{' ' if short.startswith('_') else ''}{short}".replace("$", r"\$")
