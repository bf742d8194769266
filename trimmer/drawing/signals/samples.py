"""Sampled signals over time."""

import numpy as np
from matplotlib.axes import Axes

from trimmer.arrays import Reals
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import line, plain_label
from trimmer.drawing.units import name_axis
from trimmer.signals.signal import Signal

MOST_POINTS = 8000  # Samples up to which each is drawn; of more, the lowest and the highest of each block


@draw.register(Signal)
def draw_signal(signal: Signal, axes: Axes) -> None:
    """Draw samples over time, s."""
    axes.plot(*thinned(signal.times, signal.values), label=plain_label(signal.name), linewidth=1.0, **line(0))
    finish_time(axes)
    name_axis(axes.yaxis, signal.name, signal.unit)


def thinned(times: Reals, values: Reals) -> tuple[Reals, Reals]:
    """Return samples as they are drawn: all, or the lowest and the highest of each block in their order."""
    if values.size <= MOST_POINTS:
        return times, values
    block = -(-2 * values.size // MOST_POINTS)
    begins = np.arange(0, values.size, block)
    ends = np.append(begins[1:], values.size)
    places = [
        begin + place(values[begin:end])
        for begin, end in zip(begins, ends, strict=True)
        for place in (np.argmin, np.argmax)
    ]
    kept = np.unique([0, *places, values.size - 1])
    return times[kept], values[kept]


def finish_time(axes: Axes) -> None:
    """Name the axis of time, which has no margins."""
    axes.margins(x=0.0)
    name_axis(axes.xaxis, "time", "s")
    axes.grid(alpha=0.3)
