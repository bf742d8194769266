"""The linear trimmer in time and in frequency (figures 5.1 to 5.4)."""

import control
import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.numbers.linear_numbers import lightly_damped, pin_and_output, sum_of_displacements
from report.pages.drawing.marks import arrow, beside
from report.pages.drawing.plane import LEADER, critical_point
from report.pages.drawing.read_out import Along, plot_along
from report.pages.drawing.style import BLACK, LINES, panels
from trimmer import resonance_peaks, response_at
from trimmer.arrays import Reals
from trimmer.drawing.frequency_response import decibels
from trimmer.linear import bandwidth_crossings, gain_crossings

OMEGA = np.geomspace(1e2, 1e5, 3000)  # Frequencies of the Bode plots, rad/s; peaks are added to them


@figure("fig-5.1")
def linear_time_response(known: Evidence) -> Figure:
    times = np.linspace(0, 0.06, 6001)
    pin, output = pin_and_output(known.numbers.parameters, times)
    figure, (upper, lower) = panels(3.6, 2, sharex=True, height_ratios=(2, 1))
    upper.plot(1e3 * times, 1e3 * pin, label="pin, $u$", **LINES[1])
    upper.plot(1e3 * times, 1e3 * output, label="output from rest, $q_2 - q_4$", **LINES[0])
    upper.set(ylabel="displacement [mm]", ylim=(-1.8, 2.6))
    upper.legend(loc="upper right", ncols=2)
    lower.plot(1e3 * times, 1e3 * (output - pin), **LINES[2])
    lower.set(xlabel="time [ms]", ylabel="output − pin [mm]", xlim=(0, 60))
    return figure


@figure("fig-5.2")
def bode_plot(known: Evidence) -> Figure:
    system, both = known.numbers.displacement_only, known.numbers.both_channels
    figure, (upper, lower) = panels(4.0, 2, sharex=True)
    for each, label, line in (
        (system, "displacement only (thesis)", LINES[0]),
        (both, "displacement and velocity", LINES[1]),
    ):
        omega = _with_peaks(each)
        phase = np.unwrap(np.angle(response_at(each, omega)))
        upper.semilogx(omega, _decibels(each, omega), label=label, **line)
        lower.semilogx(omega, np.degrees(phase), **line)
    unity, cutoff = gain_crossings(system)[-1], bandwidth_crossings(system)[-1]
    slope = np.array([2e4, 1e5])
    level, start = (float(each) for each in _decibels(system, np.array([cutoff, slope[0]])))
    upper.plot([unity], [0], "o", color=BLACK, markersize=5)
    upper.annotate("0 dB, quoted as cutoff", (unity, 0), (8e3, 14), arrowprops={"arrowstyle": "-"})
    upper.plot([cutoff], [level], "s", color=BLACK, markersize=5)
    upper.annotate("−3 dB", (cutoff, level), (1.2e3, -22), arrowprops={"arrowstyle": "-"})
    upper.plot(slope, start + 6 - 40 * np.log10(slope / slope[0]), color="#555555", linestyle=":")
    upper.text(2.4e4, start + 12, "−40 dB per decade", color="#333333")
    upper.set_ylabel("magnitude [dB]")
    upper.legend(loc="lower left")
    lower.set(xlabel="angular frequency [rad/s]", ylabel="phase [degrees]", xlim=(OMEGA[0], OMEGA[-1]))
    return figure


@figure("fig-5.3")
def nyquist_locus(known: Evidence) -> Figure:
    system = known.numbers.displacement_only
    # Each resonance is followed closely, where the locus moves fastest.
    modes, around = known.numbers.modes, np.sinh(np.linspace(-5, 5, 400))
    near = [mode.omega_damped - mode.eigenvalue.real * around for mode in modes]
    omega = np.sort(np.concatenate([OMEGA, np.linspace(1, 1e4, 1500), *near]))
    omega = omega[omega > 0]
    response, thin = response_at(system, omega), LINES[1] | {"linewidth": 0.9}
    figure, (whole, enlarged) = panels(3.4, 1, 2)
    for axes in (whole, enlarged):
        plot_along(axes, response, Along("ω", "rad/s", omega), label=r"$\omega > 0$", **LINES[0])
        plot_along(axes, response.conj(), Along("ω", "rad/s", -omega), label=r"$\omega < 0$", **thin)
        critical_point(axes)
        beside(axes, "$-1$", (-1, 0), (-24, 30), ha="right", arrowprops=LEADER)
        for place in (2150.0, 3350.0, 3600.0, 4400.0):
            arrow(axes, *response_at(system, place * np.array([1, 1.004])), color=LINES[0]["color"])
    enlarged.set(xlim=(-3, 3), ylim=(-3, 3), title="near the critical point", xlabel="real part")
    whole.set(title="whole locus", xlabel="real part", ylabel="imaginary part")
    whole.set_aspect("equal", adjustable="datalim")
    enlarged.set_aspect("equal", adjustable="box")
    whole.legend(loc="upper right")
    return figure


@figure("fig-5.4")
def bode_plot_light_damping(known: Evidence) -> Figure:
    light = sum_of_displacements(lightly_damped(known.numbers.parameters))
    full = sum_of_displacements(known.numbers.parameters)
    figure, axes = panels(3.2)
    for system, label, line in ((light, "a thousandth of the damping", 0), (full, "all damping", 1)):
        omega = _with_peaks(system)
        axes.semilogx(omega, _decibels(system, omega), label=label, **LINES[line])
    for mode in known.numbers.undamped:
        axes.axvline(mode.omega, color="#777777", linewidth=0.7, linestyle=":")
        axes.text(mode.omega, 88, f"{mode.omega:.0f}", ha="center", va="bottom", fontsize=8)
    axes.set(xlabel="angular frequency [rad/s]", ylabel="magnitude of $q_1 + q_2 + q_3 + q_4$ [dB]")
    axes.set(xlim=(300, 2e4), ylim=(-60, 86))
    axes.legend(loc="lower left")
    return figure


def _decibels(system: control.TransferFunction, omega: Reals) -> Reals:
    return decibels(response_at(system, omega))


def _with_peaks(system: control.TransferFunction) -> Reals:
    near = [peak.omega * (1 + np.linspace(-0.01, 0.01, 81)) for peak in resonance_peaks(system)]
    return np.sort(np.concatenate([OMEGA, *near]))
