"""The picture of a sweep: peak to peak both ways beside the exact branch; waterfalls, or own frequency."""

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.drawing.axes import finish
from trimmer.drawing.cells import draw_values
from trimmer.drawing.content import head, new_figure
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import FAINT, Look, colour
from trimmer.drawing.mechanisms.branch import draw_branch
from trimmer.drawing.units import name_axis
from trimmer.maps.plateau import ORDERS
from trimmer.maps.swept import Sweep, SweepPoint

WIDTH, HEIGHT = 7.2, 3.6
RANGE = 60.0  # Decibels below the largest line that a waterfall shows
WAYS = (("run-up", "o"), ("way back", "v"))  # What the ways are called, and their marks


def sweep_figure(sweep: Sweep) -> Figure:
    """Draw peak to peak of the output that is swept, and below it a waterfall of each way.

    What moves by itself has its frequency there.
    """
    legs = sweep.legs()
    panels = 2 if sweep.by_itself else 1 + len(legs)
    figure = new_figure(WIDTH, HEIGHT * panels)
    first, *others = figure.subplots(panels, sharex=True)
    draw_sweep(sweep, first)
    if sweep.by_itself:
        _draw_ways(sweep, others[0], lambda point: 1 / (point.motion.period or np.nan))
        finish(others[0], (sweep.place, sweep.unit), ("frequency", "Hz"))
        others = []
    for axes, leg, (way, _) in zip(others, legs, WAYS, strict=False):
        _draw_waterfall(sweep, axes, sweep.output(None), leg)
        axes.set_title(way, fontsize="small")
    head(figure, sweep.subject.title)
    return figure


@draw.register(Sweep)
def draw_sweep(sweep: Sweep, axes: Axes, output: str | None = None) -> None:
    """Draw peak to peak of an output over the number that is varied."""
    name = sweep.output(output)
    if sweep.branch is not None:
        draw_branch(sweep.branch, axes, name)
    _draw_ways(sweep, axes, lambda point: point.peak_to_peak(name))
    for jump in sweep.jumps:
        if jump.output == name:
            axes.axvline(0.5 * (jump.before + jump.after), **FAINT, label="jump")
    finish(axes, (sweep.place, sweep.unit), (f"{name}, peak to peak", sweep.units[name]))


def _draw_ways(sweep: Sweep, axes: Axes, size: Callable[[SweepPoint], float]) -> None:
    for number, (leg, (way, mark)) in enumerate(zip(sweep.legs(), WAYS, strict=False)):
        look: Look = {"color": colour(number + 1), "fillstyle": "none", "markersize": 3}
        values = [point.value for point in leg]
        axes.plot(values, [size(point) for point in leg], mark, linestyle="none", label=way, **look)


def _draw_waterfall(sweep: Sweep, axes: Axes, name: str, leg: tuple[SweepPoint, ...]) -> None:
    """Draw amplitudes over value and order, in decibels of the largest one."""
    seen = [point for point in leg if name in point.motion.outputs]
    if seen:
        order = np.argsort([point.value for point in seen])
        values = np.array([seen[place].value for place in order])
        sizes = np.array([seen[place].motion.spectra[name] for place in order]).T
        largest = sizes.max() or 1.0
        decibels = 20.0 * np.log10(np.maximum(sizes / largest, 10.0 ** (-RANGE / 20.0)))
        steps = np.linspace(0.0, ORDERS, len(sizes))
        label = f"{name}, dB of {largest:.3g} {sweep.units[name]}".rstrip()
        draw_values(axes, values, steps, decibels, label, {"cmap": "magma", "vmin": -RANGE, "vmax": 0.0})
    axes.set_ylim(0.0, ORDERS)
    axes.set_ylabel("order of the drive")
    name_axis(axes.xaxis, sweep.place, sweep.unit)
