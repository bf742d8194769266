"""Figures 5.1 to 5.4 of the thesis drawn again: the linear trimmer in time and in frequency."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from report.drawing.read_out import Along, plot_along
from report.drawing.style import LINES, new_figure, style
from report.numbers.light_damping import lightly_damped, sum_of_displacements
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, LinearNumbers
from trimmer import (
    Extremum,
    InputChannels,
    bandwidth_crossings,
    frequency_response,
    gain_crossings,
    pin_model,
    resonance_peaks,
    time_response,
)

if TYPE_CHECKING:
    import control
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

SHOWN_TIME = 0.06
SAMPLES = 6001
OMEGA = np.geomspace(1e2, 1e5, 3000)
"""Frequencies of the Bode plots, rad/s; peaks are added to them."""


def linear_time_response(numbers: LinearNumbers) -> Figure:
    """Draw the pin, the output from rest and their difference (thesis, figure 5.1)."""
    times = np.linspace(0, SHOWN_TIME, SAMPLES)
    pin = DRIVE_AMPLITUDE * np.sin(2 * math.pi * DRIVE_FREQUENCY * times)
    system = pin_model(numbers.parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    output = time_response(system, pin, times).output
    with style():
        figure = new_figure(3.6)
        upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
        upper.plot(1e3 * times, 1e3 * pin, label="pin, $u$", **LINES[1].keywords)
        upper.plot(1e3 * times, 1e3 * output, label="output from rest, $q_2 - q_4$", **LINES[0].keywords)
        upper.set_ylabel("displacement [mm]")
        upper.legend(loc="upper right", ncols=2)
        upper.set_ylim(-1.8, 2.6)
        lower.plot(1e3 * times, 1e3 * (output - pin), **LINES[2].keywords)
        lower.set(xlabel="time [ms]", ylabel="output − pin [mm]", xlim=(0, 1e3 * SHOWN_TIME))
    return figure


def bode_plot(numbers: LinearNumbers) -> Figure:
    """Draw the Bode plot of q2 − q4 for both ways of feeding the pin (thesis, figure 5.2)."""
    system, both = numbers.displacement_only, numbers.both_channels
    with style():
        figure = new_figure(4.6)
        upper, lower = figure.subplots(2, 1, sharex=True)
        _bode_lines(upper, lower, system, "displacement only (thesis)", 0)
        _bode_lines(upper, lower, both, "displacement and velocity", 1)
        unity, cutoff = gain_crossings(system)[-1], bandwidth_crossings(system)[-1]
        upper.plot([unity], [0], "o", color="black", markersize=5)
        upper.annotate("0 dB, quoted as cutoff", (unity, 0), (8e3, 14), arrowprops={"arrowstyle": "-"})
        level = 20 * np.log10(abs(frequency_response(system, cutoff)))
        upper.plot([cutoff], [level], "s", color="black", markersize=5)
        upper.annotate("−3 dB", (cutoff, float(level)), (1.2e3, -22), arrowprops={"arrowstyle": "-"})
        slope = np.array([2e4, 1e5])
        start = 20 * np.log10(abs(frequency_response(system, slope[0])))
        upper.plot(slope, start + 6 - 40 * np.log10(slope / slope[0]), color="#555555", linestyle=":")
        upper.text(2.4e4, float(start) + 12, "−40 dB per decade", color="#333333")
        upper.set_ylabel("magnitude [dB]")
        upper.legend(loc="lower left")
        lower.set(xlabel="angular frequency [rad/s]", ylabel="phase [degrees]", xlim=(OMEGA[0], OMEGA[-1]))
    return figure


def bode_plot_light_damping(numbers: LinearNumbers) -> Figure:
    """Draw |q1 + q2 + q3 + q4| with a thousandth of the damping (thesis, figure 5.4)."""
    light = sum_of_displacements(lightly_damped(numbers.parameters))
    full = sum_of_displacements(numbers.parameters)
    with style():
        figure = new_figure(3.2)
        axes = figure.subplots()
        for system, label, line in ((light, "a thousandth of the damping", 0), (full, "all damping", 1)):
            omega = _with_peaks(resonance_peaks(system))
            axes.semilogx(omega, _decibels(system, omega), label=label, **LINES[line].keywords)
        for mode in numbers.undamped:
            axes.axvline(mode.omega, color="#777777", linewidth=0.7, linestyle=":")
            axes.text(mode.omega, 88, f"{mode.omega:.0f}", ha="center", va="bottom", fontsize=8)
        axes.set(
            xlabel="angular frequency [rad/s]",
            ylabel="magnitude of $q_1 + q_2 + q_3 + q_4$ [dB]",
            xlim=(300, 2e4),
            ylim=(-60, 86),
        )
        axes.legend(loc="lower left")
    return figure


def nyquist_locus(numbers: LinearNumbers) -> Figure:
    """Draw the Nyquist locus, whole and near the critical point (thesis, figure 5.3)."""
    system = numbers.displacement_only
    omega = _locus_frequencies(numbers)
    with style():
        figure = new_figure(3.4)
        whole, near = figure.subplots(1, 2)
        for axes in (whole, near):
            _locus(axes, system, omega)
        near.set(xlim=(-3, 3), ylim=(-3, 3), title="near the critical point", xlabel="real part")
        whole.set(title="whole locus", xlabel="real part", ylabel="imaginary part")
        whole.set_aspect("equal", adjustable="datalim")
        near.set_aspect("equal", adjustable="box")
        whole.legend(loc="upper right")
    return figure


def _locus(axes: Axes, system: control.TransferFunction, omega: NDArray[np.float64]) -> None:
    response = frequency_response(system, omega)
    plot_along(axes, response, Along("ω", "rad/s", omega), label=r"$\omega > 0$", **LINES[0].keywords)
    thin = LINES[1].keywords | {"linewidth": 0.9}
    plot_along(axes, response.conj(), Along("ω", "rad/s", -omega), label=r"$\omega < 0$", **thin)
    axes.plot([-1], [0], "+", color="black", markersize=9, markeredgewidth=1.6)
    axes.annotate("$-1$", (-1, 0), (-8, 8), textcoords="offset points", ha="right")
    for place in (2150.0, 3350.0, 3600.0, 4400.0):
        start, end = frequency_response(system, np.array([place, place * 1.004]))
        axes.annotate(
            "",
            (end.real, end.imag),
            (start.real, start.imag),
            arrowprops={"arrowstyle": "-|>", "color": LINES[0].colour, "mutation_scale": 11},
            annotation_clip=True,
        )


def _locus_frequencies(numbers: LinearNumbers) -> NDArray[np.float64]:
    """Return frequencies that follow each resonance closely, where the locus moves fastest."""
    near = [
        mode.omega_damped - mode.eigenvalue.real * np.sinh(np.linspace(-5, 5, 400)) for mode in numbers.modes
    ]
    omega = np.sort(np.concatenate([OMEGA, np.linspace(1, 1e4, 1500), *near]))
    return np.asarray(omega[omega > 0])


def _bode_lines(upper: Axes, lower: Axes, system: control.TransferFunction, label: str, line: int) -> None:
    omega = _with_peaks(resonance_peaks(system))
    phase = np.unwrap(np.angle(frequency_response(system, omega)))
    upper.semilogx(omega, _decibels(system, omega), label=label, **LINES[line].keywords)
    lower.semilogx(omega, np.degrees(phase), **LINES[line].keywords)


def _decibels(system: control.TransferFunction, omega: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(20 * np.log10(np.abs(frequency_response(system, omega))))


def _with_peaks(peaks: Sequence[Extremum]) -> NDArray[np.float64]:
    near = [peak.omega * (1 + np.linspace(-0.01, 0.01, 81)) for peak in peaks]
    return np.sort(np.concatenate([OMEGA, *near]))
