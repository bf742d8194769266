"""The picture of a measured motion over a simulated one: spectra, and waveforms over a period."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from trimmer.drawing.axes import finish, label
from trimmer.drawing.content import new_figure
from trimmer.drawing.dispatch import draw
from trimmer.drawing.look import BLACK, COLOURS
from trimmer.drawing.signals.spectrum import outline
from trimmer.spectra import MotionComparison, amplitude_spectrum

SIZE = (7.2, 6.8)
SAMPLES = 2000  # Measured samples that are shown in a period
MEASURED, SIMULATED = "0.45", COLOURS[1]


def comparison_figure(comparison: MotionComparison) -> Figure:
    """Draw spectra over each other, and waveforms aligned in time."""
    figure = new_figure(*SIZE)
    above, below = figure.subplots(2)
    draw_comparison(comparison, above)
    draw_waveforms(comparison, below)
    return figure


@draw.register(MotionComparison)
def draw_comparison(comparison: MotionComparison, axes: Axes) -> None:
    """Draw the measured spectrum and the lines of both."""
    signal = comparison.signal
    spectrum = amplitude_spectrum(signal.values, signal.sample_rate)
    frequency, amplitude = outline(spectrum, float(comparison.frequencies[-1]))
    axes.semilogy(frequency, amplitude, color=MEASURED, linewidth=0.9, label="measured")
    lines = comparison.frequencies, abs(comparison.measured)
    axes.plot(*lines, "o", linestyle="none", color=BLACK, markersize=4, label="its lines")
    lines = comparison.frequencies, abs(comparison.simulated)
    axes.plot(*lines, "x", linestyle="none", color=SIMULATED, markersize=6, label="simulated lines")
    axes.set_ylim(bottom=max(0.3 * float(np.median(amplitude)), 1e-7 * float(amplitude.max()) or 1e-30))
    label(axes, "frequency, Hz", f"amplitude, {signal.unit}")


def draw_waveforms(comparison: MotionComparison, axes: Axes) -> None:
    """Draw samples, and the lines of both added up, over a period of the simulation."""
    signal = comparison.signal
    times, measured, simulated = comparison.waveforms()
    places = np.linspace(0, signal.values.size - 1, min(SAMPLES, signal.values.size)).astype(int)
    folded = np.mod(places / signal.sample_rate, comparison.period)
    rest = signal.values[places] - float(signal.values.mean())
    axes.plot(folded, rest, ".", color="0.75", markersize=2, linestyle="none", label="samples")
    axes.plot(times, measured, color=BLACK, linewidth=1.2, label="measured lines")
    axes.plot(times, simulated, "--", color=SIMULATED, linewidth=1.4, label="simulated, shifted")
    axes.set_title(
        f"shifted by {1e3 * comparison.shift:.4g} ms; difference {100 * comparison.residual:.3g} % rms",
        fontsize="small",
    )
    finish(axes, ("time in the period", "s"), (f"{signal.quantity.word} about its mean", signal.unit))
