"""The one look of all figures; nothing here changes Matplotlib for anybody else."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Final

from matplotlib.figure import Figure

from trimmer.drawing.look import BLACK as BLACK
from trimmer.drawing.look import DOTTED as DOTTED
from trimmer.drawing.look import FAINT as FAINT
from trimmer.drawing.look import LINES as LINES
from trimmer.drawing.look import Look as Look

WIDTH: Final = 6.5  # Width of a figure that fills the page, in inches


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
                "font.family": ["STIXGeneral", "DejaVu Sans"],  # the second where the first has no letter
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
