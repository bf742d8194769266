"""Relay and friction in the loop (figures 5.19, 5.20), and backlash with friction (figures 5.21 to 5.24)."""

from typing import Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers import equivalent_nonlinearity as model
from report.numbers.evidence import Evidence
from report.numbers.record import line_amplitudes
from report.numbers.relay_loop import HALF_PERIODS, VISCOUS, friction_motion, output_at_jump
from report.numbers.released_bodies import RECORD
from report.numbers.thesis import DRIVE_OMEGA, LARGER_GAP, RELEASED_PEAKS, SMALL_GAP
from report.pages.drawing.marks import beside
from report.pages.drawing.plane import curve, element_curve, frame, locus, mark
from report.pages.drawing.style import BLACK, DOTTED, LINES, new_figure, panels
from trimmer import FrictionBacklash, pin_model
from trimmer.linear import InputChannels

SHOWN_FROM = 1e-8  # First time that is shown of the loop with friction, s
EVERY: Final = 5  # One of so many swings is drawn
LOADS: Final = (0.15, 0.25, 0.5)  # F_c/(k2 b) of the right contours: friction ends the limit cycles at 0.27
NEAR_MODES: Final = (150.0, 850.0)  # Frequencies of figure 5.23b, Hz


@figure("fig-5.19")
def relay_swings(known: Evidence) -> Figure:
    numbers = known.motion.closed.relay
    figure, (sizes, frequencies) = panels(3.4, 1, 2)
    for run, line in zip(numbers.runs, LINES, strict=False):
        middles = 1e3 * ((run.times[:-1] + run.times[1:]) / 2)[::EVERY]
        look = {"label": f"10$^{{{np.log10(run.impulse):.0f}}}$ s"} | line
        sizes.plot(middles, run.swings[::EVERY], **look)
        frequencies.plot(middles, run.frequencies[::EVERY], **look)
    kept, amplitude = numbers.sampled
    for axes, value in ((sizes, amplitude), (frequencies, kept)):
        axes.axhline(value, **DOTTED)
        axes.set(xscale="log", yscale="log", xlabel="time [ms]")
    sizes.set(ylabel="swing over the relay's output", title="size of the swings")
    frequencies.set(ylabel="frequency [Hz]", title="their frequency")
    figure.legend(
        *sizes.get_legend_handles_labels(),
        loc="outside lower center",
        ncols=3,
        title="impulse over the relay's output",
    )
    return figure


@figure("fig-5.20")
def friction_and_condition(known: Evidence) -> Figure:
    system = pin_model(known.numbers.parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    A, B, C = system.A, system.B, system.C
    figure, (condition, motion) = panels(3.4, 1, 2)
    for gain, line in zip((0.0, VISCOUS), LINES, strict=False):
        values = output_at_jump(A - gain * B @ C, B[:, 0], C[0], HALF_PERIODS)
        name = "relay" if gain == 0 else f"relay with gain {gain}"
        condition.plot(0.5 / HALF_PERIODS, np.where(values < 0, -values, np.nan), label=name, **line)
    condition.axvspan(*sorted(known.motion.closed.relay.alone.frequencies), color="#dddddd")
    condition.set(xscale="log", yscale="log")
    condition.set(xlabel="frequency of a square wave [Hz]", ylabel="$-y$ where the wave jumps up")
    condition.set(title="block on the output", xlim=(50, 1e5), ylim=(1e-9, 1e3))
    condition.legend(loc="upper right")
    for run, line in zip(known.motion.closed.relay.friction, LINES, strict=False):
        times = np.geomspace(SHOWN_FROM, run.last_turn, 401)
        output = friction_motion(system, run.impulse).output(times)
        label = f"10$^{{{np.log10(run.impulse):.0f}}}$ s"
        motion.plot(1e6 * times, output / output[-1], label=label, **line)
        motion.plot([1e6 * run.last_turn], [1], "o", color=line["color"], markersize=5)
    motion.set(xscale="log", xlabel="time [µs]", ylabel="$y$ over its last value")
    motion.set(title="block on the output's velocity", ylim=(0, 1.1))
    motion.legend(loc="upper left", title="impulse over force")
    return figure


@figure("fig-5.21")
def three_panels(known: Evidence) -> Figure:
    k2, force, gap = known.numbers.parameters.k2, model.OTHER_FORCE, LARGER_GAP
    listing, right = model.listing_element, model.right_element
    families = {
        r"Listing A.6, change in $\omega$": {
            f"{omega:.0f} rad/s": listing(force, gap, omega) for omega in (30.0, DRIVE_OMEGA, 6000.0)
        },
        "Listing A.6, change in $F_c$": {f"{each:g} N": listing(each, gap) for each in (0.03, force, 0.6)},
        "Listing A.6, change in $b$": {
            f"{1e3 * each:g} mm": listing(force, each) for each in (5e-4, gap, 1e-2)
        },
        "right term, change in $F_c/(k_2 b)$": {f"{load:g}": right(load * k2, k2, 1.0) for load in LOADS},
    }
    figure, grid = panels(5.4, 2, 2)
    for axes, (title, family) in zip(grid.flat, families.items(), strict=True):
        locus(axes, known.numbers.displacement_only)
        element_curve(axes, FrictionBacklash(1.0), "no friction", LINES[5])
        for line, (name, element) in zip(LINES[1:], family.items(), strict=False):
            element_curve(axes, element, name, line)
        frame(axes, title, (-6, 3), (-9, 9), left=axes in grid[:, 0])
        axes.legend(loc="upper left", ncols=3, handlelength=1.2, columnspacing=0.8)
    return figure


@figure("fig-5.22")
def without_force(known: Evidence) -> Figure:
    system, friction = known.numbers.displacement_only, known.cycles.friction
    cycles = (friction.unstable, friction.stable)
    texts = [f"{1e6 * SMALL_GAP * each.amplitude:.2f} µm" for each in cycles]
    amplitudes = SMALL_GAP + np.geomspace(1e-9, 40, 500)
    printed = np.array([-1 / model.printed_function(float(a), 0.0) for a in amplitudes])
    figure, (whole, near) = panels(3.6, 1, 2)
    for axes, first in ((whole, 0), (near, 1)):
        locus(axes, system)
        element_curve(axes, FrictionBacklash(SMALL_GAP), "$-1/N$, Listing A.6", LINES[1])
        curve(axes, printed, "$-1/N$, equation 5.14", LINES[2])
        mark(axes, system, cycles[first:], texts[first:], ((9, 6), (7, -14))[first:])
    frame(whole, "$b$ = 4 µm, $F_c$ = 0", (-9, 3), (-20, 8))
    frame(near, "near $-1$", (-1.15, -0.9), (-0.16, 0.02), left=False)
    whole.legend(loc="upper left")
    return figure


@figure("fig-5.23")
def one_force(known: Evidence) -> Figure:
    system, k2 = known.numbers.displacement_only, known.numbers.parameters.k2
    (cycle,) = known.cycles.equivalent.listing
    figure = new_figure(4.8)
    whole, near, spectrum = figure.subplot_mosaic([[0, 1], [2, 2]], height_ratios=(5, 4)).values()
    for axes in (whole, near):
        locus(axes, system)
        element_curve(axes, model.listing_element(model.FORCE), "$-1/N$, Listing A.6", LINES[1])
        element_curve(axes, model.right_element(model.FORCE, k2), "$-1/N$, right term over $k_2$", LINES[2])
    text = f"{cycle.frequency:.2f} Hz\n{1e3 * cycle.amplitude:.1f} mm"
    mark(near, system, (cycle,), (text,), ((9, -24),))
    frame(whole, f"$b$ = 4 µm, $F_c$ = {model.FORCE} N", (-2, 1), (-1.5, 2.2))
    frame(near, "near $-1$", (-1.1, -0.9), (-0.13, 0.05), left=False)
    whole.legend(loc="upper left")
    numbers = known.motion.closed.released_bodies
    for run, line in zip(numbers.runs, LINES, strict=False):
        sizes = line_amplitudes(run.output) / run.displacement
        frequencies = RECORD.bin_width * np.arange(sizes.size)
        shown = (frequencies > NEAR_MODES[0]) & (frequencies < NEAR_MODES[1])
        spectrum.plot(frequencies[shown], 1e3 * sizes[shown], label=f"{run.displacement:g} m", **line)
    for frequency, printed in zip(numbers.modes, RELEASED_PEAKS, strict=False):
        spectrum.axvline(frequency, **DOTTED)
        text, look = f"mode {frequency:.2f} Hz\nprinted {printed} Hz", {"va": "top", "fontsize": 8}
        beside(spectrum, text, (frequency, 0.97), (5, 0), xycoords=("data", "axes fraction"), **look)
    spectrum.set_title("free vibration after all bodies were displaced alike")
    spectrum.set(xlabel="frequency [Hz]", ylabel="amplitude over start [10$^{-3}$]")
    spectrum.set(xlim=NEAR_MODES, ylim=(0, 23))
    spectrum.legend(loc="center", bbox_to_anchor=(0.6, 0.6), title="displaced by")
    return figure


@figure("fig-5.24")
def several_forces(known: Evidence) -> Figure:
    numbers, system = known.cycles.equivalent, known.numbers.displacement_only
    figure, (near, branches) = panels(3.8, 1, 2)
    locus(near, system)
    element_curve(near, FrictionBacklash(SMALL_GAP), "no friction", LINES[5])
    for force, line in zip(model.FORCES, LINES[1:], strict=False):
        element_curve(near, model.listing_element(force), f"{force:g} N", line)
    mark(near, system, numbers.by_force, [""] * len(model.FORCES), [(1, 1)] * len(model.FORCES))
    frame(near, "Listing A.6, $b$ = 4 µm", (-1.06, -0.94), (-0.16, 0.06))
    near.legend(loc="upper right", ncols=2)
    for branch, name, line in (
        (numbers.in_place, "thesis's loop", LINES[0]),
        (numbers.in_place_both_channels, "both channels of the pin", LINES[2]),
    ):
        stable, unstable, end = branch.stable, branch.unstable, branch.merger
        branches.plot(stable.force_per_gap / 1e3, stable.amplitude, label=name, **line)
        branches.plot(unstable.force_per_gap / 1e3, unstable.amplitude, color=line["color"], linestyle=":")
        branches.plot([end.force_per_gap / 1e3], [end.amplitude], "D", color=BLACK, markersize=4.5)
    branches.plot([], [], color=BLACK, linestyle=":", label="unstable")
    branches.set(title="friction between cutter and guard", xlabel="$F_c/b$ [kN/m]")
    branches.set(ylabel="amplitude over gap", xlim=(0, 9), ylim=(0, 9))
    branches.legend(loc="upper right")
    return figure
