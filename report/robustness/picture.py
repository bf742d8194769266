"""The effects of the parameters as bars, the largest first, with what nine of ten samples give."""

from collections.abc import Sequence
from typing import Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from report.pages.drawing.style import BLACK, LINES, panels
from report.robustness.variation import PredictionSensitivity

BARS: Final = 4  # Parameters shown for each quantity
COLUMNS: Final = 2
ROW_HEIGHT: Final = 1.15


def bars(sensitivities: Sequence[PredictionSensitivity]) -> Figure:
    """Draw a panel for each quantity: a bar for each of the parameters with the largest effect."""
    rows = -(-len(sensitivities) // COLUMNS)
    figure, axes = panels(ROW_HEIGHT * rows, rows, COLUMNS)
    for panel, sensitivity in zip(axes.flat, sensitivities, strict=False):
        _panel(panel, sensitivity)
    for empty in axes.flat[len(sensitivities) :]:
        _legend(empty)
    return figure


def _panel(axes: Axes, sensitivity: PredictionSensitivity) -> None:
    for row, effect in enumerate(sensitivity.effects[:BARS]):
        for end, colour, hatch in ((effect.lowered, LINES[0], ""), (effect.raised, LINES[1], "////")):
            axes.barh(
                row,
                end - sensitivity.nominal,
                left=sensitivity.nominal,
                color=colour["color"] if not hatch else "none",
                edgecolor=colour["color"],
                hatch=hatch,
                height=0.7,
            )
    axes.plot(sensitivity.band, (BARS, BARS), color=BLACK, linewidth=3, solid_capstyle="butt")
    axes.axvline(sensitivity.nominal, color=BLACK, linewidth=0.8)
    names = [f"${effect.parameter[0]}_{effect.parameter[1]}$" for effect in sensitivity.effects[:BARS]]
    axes.set_yticks(range(BARS + 1), [*names, "all"])
    axes.invert_yaxis()
    axes.grid(visible=False, axis="y")
    unit = f", {sensitivity.quantity.unit}" if sensitivity.quantity.unit else ""
    axes.set_title(f"{sensitivity.quantity.name}{unit}", fontsize=9, loc="left")


def _legend(axes: Axes) -> None:
    axes.axis("off")
    lower, higher = LINES[0]["color"], LINES[1]["color"]
    axes.legend(
        handles=[
            Patch(facecolor=lower, edgecolor=lower, label="parameter 10 % lower"),
            Patch(facecolor="none", edgecolor=higher, hatch="////", label="parameter 10 % higher"),
            Line2D([], [], color=BLACK, linewidth=3, linestyle="solid", label="all at random: nine tenths"),
        ],
        loc="center left",
    )
