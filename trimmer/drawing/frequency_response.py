"""Magnitude and phase of a frequency response over frequency, with peaks and dips; responses over time."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator

from trimmer.arrays import Complexes, Reals
from trimmer.drawing.axes import add_legend, label
from trimmer.drawing.content import head, new_figure
from trimmer.drawing.dispatch import draw
from trimmer.drawing.frequencies import telling_frequencies
from trimmer.drawing.look import BLACK, DOTTED, line, plain_label
from trimmer.drawing.signals.samples import finish_time, thinned
from trimmer.drawing.units import name_axis
from trimmer.linear.in_time import TimeResponse
from trimmer.linear.summary import LinearSummary

TURN = 2.0 * np.pi
SIZE = (7.2, 6.0)
REACH = 10.0  # How far beyond the outermost roots a response is drawn


def decibels(gain: Complexes | Reals) -> Reals:
    """Return 20 log10 of the modulus."""
    return np.asarray(20.0 * np.log10(np.abs(gain)))


@draw.register(LinearSummary)
def draw_summary(summary: LinearSummary, axes: Axes) -> None:
    """Draw |G| in dB over frequency, Hz, with peaks and dips."""
    name = f"{summary.output.label} over the pin"
    omega = telling_frequencies(summary.factored, reach=REACH)
    axes.semilogx(omega / TURN, decibels(np.exp(summary.factored.log_gain(omega))), label=name, **line(0))
    for extrema, marker, kind in ((summary.peaks, "^", "peak"), (summary.antiresonances, "v", "dip")):
        places = [each for each in extrema if 0 < each.magnitude < np.inf]
        if places:
            levels = decibels(np.array([each.magnitude for each in places]))
            look: dict[str, Any] = {"color": BLACK, "fillstyle": "none", "linestyle": "none", "label": kind}
            axes.plot([each.omega / TURN for each in places], levels, marker, markersize=4, **look)
    for number, mode in enumerate(each for each in summary.modes if each.frequency > 0):
        axes.axvline(mode.frequency, label="" if number else "natural mode, damped", **DOTTED)
    axes.margins(x=0.0)
    label(axes, "frequency, Hz", "magnitude, dB")


def summary_figure(summary: LinearSummary) -> Figure:
    """Draw the Bode plot: magnitude and phase, degrees."""
    figure = new_figure(*SIZE)
    upper, lower = figure.subplots(2, sharex=True)
    draw_summary(summary, upper)
    upper.set_xlabel("")
    omega = telling_frequencies(summary.factored, reach=REACH)
    lower.semilogx(omega / TURN, np.degrees(summary.factored.phase(omega)), **line(0))
    label(lower, "frequency, Hz", "phase, degrees")
    lower.yaxis.set_major_locator(MultipleLocator(90.0))
    head(figure, f"From the pin to {summary.output.label}")
    return figure


@draw.register(TimeResponse)
def draw_time_response(response: TimeResponse, axes: Axes) -> None:
    """Draw inputs and outputs over time, s."""
    for number, (name, values) in enumerate(response.named.items()):
        axes.plot(*thinned(response.time, values), label=plain_label(name), **line(number))
    finish_time(axes)
    name_axis(axes.yaxis, "signal, in its unit", "")
    add_legend(axes)
