"""The one look of all figures; nothing here changes Matplotlib for anybody else."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Look = dict[str, Any]
"""Keyword arguments for ``Axes.plot``."""
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
DOTTED: Final[Look] = {"color": BLACK, "linestyle": ":", "linewidth": 0.9}
FAINT: Final[Look] = {"color": "#555555", "linestyle": ":", "linewidth": 1.0}
"""Lines that only mark a place."""
WIDTH: Final = 6.5
"""Width of a figure that fills the page, in inches."""


@contextmanager
def style() -> Iterator[None]:
    """Apply the look of the report's figures inside a ``with`` block."""
    import matplotlib
    from cycler import cycler

    cycle = cycler(**{key: [line[key] for line in LINES] for key in ("color", "linestyle")})
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(
            {
                "font.family": "STIXGeneral",
                "mathtext.fontset": "stix",
                "font.size": 10.0,
                "axes.titlesize": 10.0,
                "axes.labelsize": 10.0,
                "legend.fontsize": 9.0,
                "legend.frameon": False,
                "xtick.labelsize": 9.0,
                "ytick.labelsize": 9.0,
                "axes.prop_cycle": cycle,
                "axes.spines.top": False,
                "axes.spines.right": False,
                "axes.grid": True,
                "axes.linewidth": 0.7,
                "axes.formatter.use_mathtext": True,
                "grid.color": "#d9d9d9",
                "grid.linewidth": 0.5,
                "lines.linewidth": 1.4,
                "figure.facecolor": "white",
                "savefig.facecolor": "white",
                "svg.fonttype": "path",
            }
        )
        yield


def new_figure(height: float, width: float = WIDTH) -> Figure:
    """Return an empty figure of a size in inches; call it and draw on it inside ``style()``."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def panels(
    height: float, rows: int = 1, columns: int = 1, width: float = WIDTH, **keywords: Any
) -> tuple[Figure, Any]:
    """Return a new figure and its axes; for the keywords see ``Figure.subplots``."""
    figure = new_figure(height, width)
    return figure, figure.subplots(rows, columns, **keywords)
