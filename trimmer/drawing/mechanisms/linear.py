"""Frequency responses and mode shapes of a mechanism, with its contacts closed and open."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.design.analysis.linear import LinearState
from trimmer.drawing.axes import add_legend
from trimmer.drawing.content import head, new_figure
from trimmer.drawing.look import BLACK, FAINT, colour, line, plain_label
from trimmer.mechanism.mechanism import Mechanism

WIDTH = 7.2
RESPONSES, SHAPE = 3.4, 1.0  # Heights, inches: of all responses together, and of the shape of a mode
MOST_MODES = 12  # Modes of a state whose shapes are drawn, the lowest ones


def linear_figure(mechanism: Mechanism, states: Sequence[LinearState]) -> Figure:
    """Draw the responses of each drive and output over frequency, and below them the shapes of the modes."""
    rows = min(max((len(state.modes) for state in states), default=0), MOST_MODES)
    heights = [RESPONSES, *[SHAPE] * rows]
    figure = new_figure(WIDTH, sum(heights) + 0.6)
    grid = figure.add_gridspec(1 + rows, len(states), height_ratios=heights)
    _draw_responses(figure.add_subplot(grid[0, :]), mechanism, states)
    for column, state in enumerate(states):
        for row, mode in enumerate(state.modes[:MOST_MODES]):
            axes = figure.add_subplot(grid[1 + row, column])
            _draw_shape(axes, state, row, column)
            axes.set_title(
                f"{state.contacts.value}: {mode.frequency:.4g} Hz, damping ratio {mode.damping_ratio:.2g}",
                fontsize="small",
            )
    head(figure, mechanism.title)
    return figure


def _draw_responses(axes: Axes, mechanism: Mechanism, states: Sequence[LinearState]) -> None:
    for number, state in enumerate(states):
        for place, each in enumerate(state.transfer):
            name = plain_label(f"{each.drive} to {each.output}, {state.contacts.value}")
            look = {**line(number), "color": colour(place)}
            sizes = abs(each.response)
            if sizes.max() > 0:
                axes.plot(each.frequency, np.where(sizes > 0, sizes, np.nan), label=name, **look)
    if mechanism.frequency:
        axes.axvline(mechanism.frequency, label="drive", **FAINT)
    axes.set(xscale="log", yscale="log", xlabel="frequency, Hz", ylabel="output for one unit of the input")
    axes.margins(x=0.0)
    axes.grid(alpha=0.3)
    add_legend(axes)


def _draw_shape(axes: Axes, state: LinearState, mode: int, column: int) -> None:
    """Draw the share of each coordinate: what is in phase as a bar, what is at right angles as a ring."""
    shape = state.modes[mode].shape
    places = np.arange(len(shape))
    axes.axhline(0.0, color=BLACK, linewidth=0.6)
    axes.bar(places, shape.real, width=0.5, color=colour(column))
    axes.plot(places, shape.imag, "o", color=BLACK, fillstyle="none", markersize=4, linestyle="none")
    axes.set(ylim=(-1.1, 1.1), yticks=(-1, 0, 1), xlim=(-0.6, len(shape) - 0.4))
    last = mode == min(len(state.modes), MOST_MODES) - 1
    labels = [plain_label(name, 14) for name in state.bodies] if last else []
    axes.set_xticks(places if last else [], labels, fontsize="small", rotation=20 if len(shape) > 4 else 0)
