"""The picture of a measured motion over the fitted one: waveform over a period, lines, and what is left."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.arrays import Reals
from trimmer.drawing.axes import add_legend, finish
from trimmer.drawing.content import new_figure
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, COLOURS
from trimmer.drawing.units import name_axis
from trimmer.fitting.result import Fit

WIDTH, HEIGHT = 6.6, 8.0  # Inches of the picture of one output
BINS = 200  # Places of a period at which samples are averaged
MEASURED, SIMULATED = BLACK, COLOURS[1]


def fit_figure(fit: Fit) -> Figure:
    """Draw waveform, what is left of it, and lines, of each output in a column of its own."""
    outputs = fit.measured.outputs
    figure = new_figure(WIDTH * len(outputs), HEIGHT)
    panels = figure.subplots(3, len(outputs), squeeze=False, height_ratios=(3, 1.4, 3))
    for column, output in enumerate(outputs):
        draw_waveform(fit, output, panels[0, column])
        draw_rest(fit, output, panels[1, column])
        draw_lines(fit, output, panels[2, column])
    return figure


@draw.register(Fit)
def draw_fit(fit: Fit, axes: Axes) -> None:
    """Draw the first output over a period."""
    draw_waveform(fit, fit.measured.outputs[0], axes)


def draw_waveform(fit: Fit, output: str, axes: Axes) -> None:
    """Draw the measurement averaged over its periods, and the fitted motion."""
    signal = fit.measured.signals[output]
    times, _, simulated = fit.waveforms(output)
    folded, means = averaged(fit, output)
    count = int(fit.measured.periods / fit.measured.period_count)
    told = f"measured,\nmean of {count} periods"
    axes.plot(folded, means, "o", color=MEASURED, linestyle="none", markersize=3, label=told)
    axes.plot(times, simulated, color=SIMULATED, linewidth=1.4, label="fitted")
    finish(axes, ("time in the period", "s"), (f"{output}, {signal.quantity.word}", signal.unit))


def draw_rest(fit: Fit, output: str, axes: Axes) -> None:
    """Draw averaged measurement less fitted motion over a period, and how much noise that mean has."""
    signal = fit.measured.signals[output]
    place = fit.measured.outputs.index(output)
    times, measured, simulated = fit.waveforms(output)
    noise = float(np.linalg.norm(fit.measured.deviations[:, place]))
    axes.axhspan(-2 * noise, 2 * noise, color="0.85", linewidth=0, label="noise of the lines,\ntwice its rms")
    axes.plot(
        times, measured - simulated, color=MEASURED, linewidth=1.0, label="lines: measured\nless fitted"
    )
    finish(axes, ("time in the period", "s"), ("left", signal.unit))


def draw_lines(fit: Fit, output: str, axes: Axes) -> None:
    """Draw measured and fitted lines, what is left of them, and the noise between them."""
    signal = fit.measured.signals[output]
    place = fit.measured.outputs.index(output)
    frequencies = fit.measured.frequencies
    measured, simulated = fit.measured.lines[:, place], fit.simulated[:, place]
    noise = np.sqrt(2.0) * fit.measured.deviations[:, place]
    axes.semilogy(frequencies, noise, color="0.6", linestyle=":", label="noise, rms")
    axes.plot(
        frequencies, abs(measured), "o", color=MEASURED, linestyle="none", markersize=4, label="measured"
    )
    axes.plot(
        frequencies, abs(simulated), "x", color=SIMULATED, linestyle="none", markersize=7, label="fitted"
    )
    left = abs(measured - simulated)
    axes.plot(
        *(frequencies, left, "s"),
        color=COLOURS[0],
        linestyle="none",
        markersize=4,
        markerfacecolor="none",
        label="left",
    )
    axes.set_ylim(bottom=max(0.1 * float(noise.min()), 1e-9 * float(abs(measured).max())))
    name_axis(axes.xaxis, "frequency", "Hz")
    axes.set_ylabel(f"amplitude, {signal.unit}", parse_math=False)
    axes.grid(alpha=0.3)
    add_legend(axes)


def averaged(fit: Fit, output: str) -> tuple[Reals, Reals]:
    """Return times in the period, s, and means of the samples near them about the mean of all."""
    signal = fit.measured.signals[output]
    turns = np.arange(signal.values.size) / (signal.sample_rate * fit.period) % 1.0
    cells = (turns * BINS).astype(int)
    counts = np.bincount(cells, minlength=BINS)
    with np.errstate(invalid="ignore"):
        means = np.bincount(cells, signal.values - signal.values.mean(), BINS) / counts
        middles = np.bincount(cells, turns, BINS) / counts
    seen = counts > 0
    return np.asarray(middles[seen] * fit.period), np.asarray(means[seen])
