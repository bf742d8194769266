"""Relay and friction in the loop (figures 5.19, 5.20), and backlash with friction (figures 5.21 to 5.24)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from report.judging.record import figure
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

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN_FROM, SHOWN_TIME = 1e-8, 40e-6
"""First and last time that is shown of the loop with friction, s."""
EVERY: Final = 5
"""One of so many swings is drawn."""
LOADS: Final = (0.15, 0.25, 0.5)
"""F_c/(k2 b) of the right contours: friction ends the limit cycles at 0.27."""
NEAR_MODES: Final = (150.0, 850.0)
"""Frequencies of figure 5.23b, Hz."""


@figure(
    "fig-5.19",
    "Relay in the loop",
    caption="""Swings after an impulse, in the loop with an ideal relay (thesis, figure 5.19): (a) their size,
    (b) their frequency. They never stop becoming smaller and faster; runs end after 3000 switchings. Dotted:
    what a simulation keeps up that looks at the relay's input once in 10 µs.""",
    alternative_text="""Falling lines of size and rising lines of frequency over time on logarithmic scales,
    ever steeper in the end; a dotted level lies across each panel.""",
)
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


@figure(
    "fig-5.20",
    "Coulomb and viscous friction in the loop",
    caption="""Which signal enters the block is not said (thesis, figure 5.20). (a) The output: a square wave
    that kept itself up would need $y = 0$ where it jumps; $y$ is zero only at the edges of the grey strip,
    and there in phase with it, which does not keep it up. (b) The output's velocity: the loop moves a little,
    then sticks or creeps to rest (points).""",
    alternative_text="""Left, two nearly equal curves with peaks at low frequency that fall as a straight line
    on logarithmic scales. Right, three curves that rise to their last value, where a point marks the end:
    after one microsecond for the weakest impulse, later for the stronger ones.""",
)
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
        times = np.geomspace(SHOWN_FROM, min(run.last_turn, SHOWN_TIME), 401)
        output = friction_motion(system, run.impulse).output(times)
        label = f"10$^{{{np.log10(run.impulse):.0f}}}$ s"
        motion.plot(1e6 * times, output / output[-1], label=label, **line)
        if run.last_turn < SHOWN_TIME:
            motion.plot([1e6 * run.last_turn], [1], "o", color=line["color"], markersize=5)
    motion.set(xscale="log", xlabel="time [µs]", ylabel="$y$ over its last value")
    motion.set(title="block on the output's velocity", ylim=(0, 1.1))
    motion.legend(loc="upper left", title="impulse over force")
    return figure


@figure(
    "fig-5.21",
    "Backlash and friction together",
    caption="""$G$ with $-1/N$ by Listing A.6 for 0.15 N, 200π rad/s and a gap of 2 mm, and with one of them
    changed (thesis, figure 5.21; the values beside those are ours). (d) The right friction term, over
    $k_2$. The wrong sign bends the curves to the right, the right one bends them up.""",
    alternative_text="""Three panels in which curves from minus one bend from the curve without friction to
    the lower right; a fourth in which they bend to the left and upwards, until they no longer meet G.""",
)
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
    figure, grid = panels(6.4, 2, 2)
    for axes, (title, family) in zip(grid.flat, families.items(), strict=True):
        locus(axes, known.numbers.displacement_only)
        element_curve(axes, FrictionBacklash(1.0), "no friction", LINES[5])
        for line, (name, element) in zip(LINES[1:], family.items(), strict=False):
            element_curve(axes, element, name, line)
        frame(axes, title, (-6, 3), (-9, 9), left=axes in grid[:, 0])
        axes.legend(loc="upper left", ncols=2)
    return figure


@figure(
    "fig-5.22",
    "Equivalent nonlinearity without friction",
    caption=r"""$G$ with $-1/N$ for $b$ = $4\times10^{-6}$ m and $F_c$ = 0 (thesis, figure 5.22). Listing A.6
    gives backlash without friction and its two limit cycles, stable (full point) and unstable (open).
    Equation 5.14, whose real part lacks a factor, gives a curve along the negative real axis.""",
    alternative_text="""A dashed curve with two marked intersections, at 2.11 and 33.26 micrometres; a
    dash-dotted straight line along the negative real axis meets G nowhere.""",
)
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


@figure(
    "fig-5.23",
    "Equivalent nonlinearity with 0.6 N",
    caption=r"""(a), (b) $G$ with $-1/N$ for $b$ = $4\times10^{-6}$ m and $F_c$ = 0.6 N (thesis, figure 5.23).
    By Listing A.6 there is one intersection, with an amplitude of 16.9 mm, which would be stable (full
    point). With the right sign the curve leaves $-1$ upwards and meets $G$ nowhere. (c) Spectrum of the exact
    loop with that gap and force, all bodies displaced alike at the start; dotted: natural modes of the loop
    without play and friction, with what the thesis reads.""",
    alternative_text="""Two half circles from minus one to zero, one below the real axis, which crosses G
    close to minus one, and one above it, which does not. Below, a spectrum with three rounded peaks at 222,
    370 and 737 hertz, the same for three starts.""",
)
def one_force(known: Evidence) -> Figure:
    system, k2 = known.numbers.displacement_only, known.numbers.parameters.k2
    (cycle,) = known.cycles.equivalent.listing
    figure = new_figure(6.2)
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


@figure(
    "fig-5.24",
    "Contours for several forces, and what friction does",
    caption=r"""(a) Listing A.6 for $b$ = $4\times10^{-6}$ m and several $F_c$ (thesis, figure 5.24); the
    intersection, stable (full points), moves to the right and stops. (b) Amplitude over force for friction
    between cutter and guard; the stable and the unstable limit cycle (dotted) meet (diamond), and beyond that
    force there is none. Exact orbits: “The thesis's loop over friction and gap”, in the chapter on the real
    trimmer.""",
    alternative_text="""Left, five curves from minus one cross G at points that crowd together. Right, for
    each of two loops a falling solid curve and a rising dotted one that end in one point, at 8.1 and 6.3
    kilonewton per metre of gap.""",
)
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
