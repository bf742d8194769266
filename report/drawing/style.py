"""The one look of all figures; nothing here changes Matplotlib for anybody else."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BLACK: Final = "#000000"
ORANGE: Final = "#e69f00"
SKY_BLUE: Final = "#56b4e9"
GREEN: Final = "#009e73"
YELLOW: Final = "#f0e442"
BLUE: Final = "#0072b2"
VERMILION: Final = "#d55e00"
PURPLE: Final = "#cc79a7"


@dataclass(frozen=True)
class LineStyle:
    """Colour and dashes of a line, so that no line is told apart by its colour alone."""

    colour: str
    dashes: str | tuple[int, tuple[float, ...]]

    @property
    def keywords(self) -> dict[str, Any]:
        """Keyword arguments for ``Axes.plot``."""
        return {"color": self.colour, "linestyle": self.dashes}


LINES: Final = (
    LineStyle(BLUE, "solid"),
    LineStyle(VERMILION, (0, (6, 2))),
    LineStyle(GREEN, (0, (6, 2, 1.5, 2))),
    LineStyle(PURPLE, (0, (1.5, 1.5))),
    LineStyle(ORANGE, (0, (9, 2, 1.5, 2, 1.5, 2))),
    LineStyle(BLACK, (0, (3, 1.5))),
)
"""Line styles in the order they are to be used (colours of Okabe and Ito, 2008)."""

WIDTH: Final = 6.5
"""Width of a figure that fills the page, in inches."""


@contextmanager
def style() -> Iterator[None]:
    """Apply the look of the report's figures inside a ``with`` block."""
    import matplotlib
    from cycler import cycler

    cycle = cycler(color=[line.colour for line in LINES]) + cycler(linestyle=[line.dashes for line in LINES])
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
