"""The picture of a sweep: peak to peak both ways beside the exact branch, and a waterfall over orders."""

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
    """Draw peak to peak of the output that is swept, and below it a waterfall of each way."""
    legs = sweep.legs()
    figure = new_figure(WIDTH, HEIGHT * (1 + len(legs)))
    first, *others = figure.subplots(1 + len(legs), sharex=True)
    draw_sweep(sweep, first)
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
    for number, (leg, (way, mark)) in enumerate(zip(sweep.legs(), WAYS, strict=False)):
        sizes = [point.peak_to_peak(name) for point in leg]
        values = [point.value for point in leg]
        look: Look = {"color": colour(number + 1), "fillstyle": "none", "markersize": 3}
        axes.plot(values, sizes, mark, linestyle="none", label=way, **look)
    for jump in sweep.jumps:
        if jump.output == name:
            axes.axvline(0.5 * (jump.before + jump.after), **FAINT, label="jump")
    finish(axes, (sweep.place, sweep.unit), (f"{name}, peak to peak", sweep.units[name]))


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
