"""Backlash and Coulomb friction under a sinusoidal pin: characteristics and waveforms (figures 2.8 to 2.12).

Time is the phase of the pin, and from figure 2.9 on lengths are in amplitudes of the pin. The load's line is
solid and thick where the bridge is in contact with the pin, and dashed where it is let go.
"""

from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.pages.drawing.marks import arrow, beside, few_ticks, span
from report.pages.drawing.style import BLACK, LINES, new_figure, panels
from trimmer import CoulombFriction, FrictionBacklash, InertiaBacklash, ViscousBacklash
from trimmer.arrays import Flags, Reals
from trimmer.elements.backlashes.backlash import Backlash
from trimmer.elements.backlashes.contact_equation import steady_motion

AMPLITUDES: Final = (2.0, 3.5)  # Amplitudes of the two loops of figure 2.8, in half gaps b
GAP: Final = 0.6  # Total clearance over the amplitude from figure 2.9 on
GAMMAS: Final = (0.3, 1.0, 4.0)  # M omega / D of the loads in figure 2.11
PHASES: Final = np.linspace(0, 2 * np.pi, 481)
CONTACT: Final[dict[str, Any]] = {"color": LINES[0]["color"], "linestyle": "solid", "linewidth": 2.4}
LET_GO: Final[dict[str, Any]] = LINES[1]
PIN: Final[dict[str, Any]] = {"color": "#444444", "linestyle": (0, (1.5, 1.5)), "linewidth": 1.2}
JOIN: Final[dict[str, Any]] = {"color": "#999999", "linestyle": "solid", "linewidth": 0.6, "zorder": 0.5}
SHADE: Final[dict[str, Any]] = {"color": "#56b4e9", "alpha": 0.18, "linewidth": 0}


@figure("fig-2.8")
def backlash_characteristic(_: Evidence) -> Figure:
    phases = np.linspace(0, 2 * np.pi, 721)
    small, large = AMPLITUDES
    top, back = large - 1, large - 2
    figure, axes = panels(4.4, width=5.6)
    for amplitude, line in ((large, LINES[0]), (small, LINES[1])):
        path = FrictionBacklash(2.0).waveform(phases, amplitude)
        axes.plot(amplitude * np.sin(phases), path, label=f"$A = {amplitude:g}\\,b$", **line)
    axes.plot([0, 1, large], [0, 0, top], label="first rise, $OAB$", **LINES[3])
    for letter, place, offset in (
        ("O", (0.0, 0.0), (-12, 4)),
        ("A", (1.0, 0.0), (3, -13)),
        ("B", (large, top), (5, 2)),
        ("C", (back, top), (-12, 4)),
        ("D", (-large, -top), (-14, -8)),
        ("E", (-back, -top), (4, -13)),
    ):
        axes.plot(*place, "o", color=BLACK, markersize=3.5)
        beside(axes, f"${letter}$", place, offset)
    arrow(axes, (2.6, top), (2.45, top))
    arrow(axes, (0.0, 1.0), (-0.1, 0.9))
    arrow(axes, (-2.6, -top), (-2.45, -top))
    arrow(axes, (0.4, -0.6), (0.5, -0.5))
    span(axes, (large, top + 0.3), (back, top + 0.3), "$2b$")
    span(axes, (large + 0.35, top), (large + 0.35, 0))
    axes.text(large + 0.4, top / 2, "$A - b$", ha="left", va="center")
    axes.set(xlabel="input, $x/b$", ylabel="output, $y/b$", xlim=(-4.2, 4.6), ylim=(-3.2, 3.5))
    axes.set_aspect("equal")
    few_ticks(axes.xaxis, axes.yaxis, intervals=8)
    axes.legend(loc="upper left")
    return figure


@figure("fig-2.9")
def friction_controlled(_: Evidence) -> Figure:
    element, phases = FrictionBacklash(GAP), PHASES + np.pi / 2
    pin, load = np.sin(phases), element.waveform(phases, 1.0)
    contact = _in_contact(pin, load)
    figure = new_figure(5.4)
    grid = figure.add_gridspec(2, 2, width_ratios=(1, 1.3), height_ratios=(1, 1.3))
    characteristic = figure.add_subplot(grid[0, 0])
    output = figure.add_subplot(grid[0, 1], sharey=characteristic)
    drive = figure.add_subplot(grid[1, 0], sharex=characteristic)
    for axes, across, up in ((characteristic, pin, load), (output, phases, load), (drive, pin, phases)):
        _load(axes, across, up, contact)
    _corners(characteristic, output, drive)
    _turning_sense(characteristic, pin, load, (60, 150, 300, 430))
    characteristic.set(ylabel="output, $y/A$", title="characteristic")
    output.set(xlabel=r"phase, $\omega t$", title="output")
    drive.set(xlabel="input, $x/A$", ylabel=r"phase, $\omega t$", title="input", xlim=(-1.3, 1.25))
    drive.invert_yaxis()
    few_ticks(characteristic.xaxis)
    legend = figure.add_subplot(grid[1, 1])
    legend.set_axis_off()
    legend.plot([], [], label="in contact: the load follows the pin", **CONTACT)
    legend.plot([], [], label="let go: the load stays where it is", **LET_GO)
    legend.legend(loc="upper left", title="Total clearance $2b = 0.6\\,A$", alignment="left")
    return figure


def _corners(characteristic: Axes, output: Axes, drive: Axes) -> None:
    """Mark the four corners of the loop in all three panels, and join the places that belong together."""
    half, gamma = GAP / 2, float(np.arcsin(1 - GAP))
    phases = (np.pi / 2, np.pi - gamma, 3 * np.pi / 2, 2 * np.pi - gamma, 5 * np.pi / 2)
    names = (r"$\pi/2$", r"$\pi-\gamma$", r"$3\pi/2$", r"$2\pi-\gamma$", r"$5\pi/2$")
    inputs = (1.0, 1.0 - GAP, -1.0, GAP - 1.0, 1.0)
    heights = (1 - half, 1 - half, half - 1, half - 1, 1 - half)
    for letter, phase, x, y in zip("BCDEB", phases, inputs, heights, strict=True):
        offset = (4 if letter in "BE" else -12, 4 if y > 0 else -14)
        for axes, across, up in ((characteristic, x, y), (output, phase, y), (drive, x, phase)):
            axes.plot([across], [up], "o", color=BLACK, markersize=3.5)
            beside(axes, f"${letter}$", (across, up), offset)
        _joined(characteristic, (x, y), drive, (x, phase))
    _joined(characteristic, (1.0, 1 - half), output, (phases[0], 1 - half))
    _joined(characteristic, (GAP - 1.0, half - 1), output, (phases[2], half - 1))
    output.set_xticks(phases, names)
    output.tick_params(labelleft=False)
    drive.set_yticks(phases, names)
    characteristic.set_yticks((half - 1, 0, 1 - half), ("$-(A-b)/A$", "$0$", "$(A-b)/A$"))
    characteristic.set_ylim(-1.05, 1.2)
    span(characteristic, (1.0, 1.0), (1 - GAP, 1.0))
    characteristic.text(1 - half, 1.02, "$2b/A$", ha="center", va="bottom")


def _joined(start: Axes, place: tuple[float, float], end: Axes, other: tuple[float, float]) -> None:
    """Draw a thin line from a place in one panel to a place in another."""
    from matplotlib.patches import ConnectionPatch

    start.figure.add_artist(ConnectionPatch(place, other, "data", axesA=start, axesB=end, **JOIN))


@figure("fig-2.10")
def inertia_controlled(_: Evidence) -> Figure:
    element = InertiaBacklash(GAP)
    pin, load = np.sin(PHASES), element.waveform(PHASES, 1.0)
    meeting = flight(element)[1]
    phases = (0.0, meeting, np.pi, np.pi + meeting, 2 * np.pi)
    figure = new_figure(4.4)
    grid = figure.add_gridspec(2, 2, width_ratios=(1.25, 1))
    positions = figure.add_subplot(grid[0, 0])
    velocities = figure.add_subplot(grid[1, 0], sharex=positions)
    characteristic = figure.add_subplot(grid[:, 1])
    _motion(positions, velocities, load)
    velocities.set_xticks(phases, ("$0$", r"$\phi$", r"$\pi$", r"$\pi+\phi$", r"$2\pi$"))
    positions.tick_params(labelbottom=False)
    positions.set(title="positions", ylabel="position$/A$")
    velocities.set(
        xlabel=r"phase of the pin, $\omega t$", ylabel=r"velocity$/(\omega A)$", title="velocities"
    )
    characteristic.set(title="characteristic", xlabel="pin, $x/A$", ylabel="load, $y/A$")
    characteristic.set_yticks((-1, -GAP / 2, 0, GAP / 2, 1), ("$-1$", "$-b/2A$", "$0$", "$b/2A$", "$1$"))
    _load(characteristic, pin, load, _in_contact(pin, load))
    few_ticks(characteristic.xaxis)
    _turning_sense(characteristic, pin, load, (53, 200, 294, 440))
    figure.legend(*positions.get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


@figure("fig-2.11")
def viscous_controlled(_: Evidence) -> Figure:
    figure, grid = panels(4.4, 2, len(GAMMAS), sharex="col", sharey="row")
    for gamma, (positions, velocities) in zip(GAMMAS, grid.T, strict=True):
        element = ViscousBacklash(GAP, gamma)
        _motion(positions, velocities, element.waveform(PHASES, 1.0, 1.0))
        velocities.set_xticks((*flight(element), 2 * np.pi), (r"$\phi_s$", r"$\phi_c$", r"$2\pi$"))
        positions.set_title(rf"$\gamma = {gamma:g}$")
        velocities.set_xlabel(r"$\omega t$")
    grid[0, 0].set_ylabel("position$/A$")
    grid[1, 0].set_ylabel(r"velocity$/(\omega A)$")
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


def flight(element: Backlash) -> tuple[float, float]:
    """Return the phases of separation and of the impact that follows, rad, at amplitude one and 1 rad/s."""
    motion = steady_motion(element.gap, np.ones(1), element.gamma(np.ones(1)))
    return float(np.arctan2(motion.sine, motion.cosine)[0]), float(motion.impact_phase[0])


def _motion(positions: Axes, velocities: Axes, load: Reals) -> None:
    """Draw pin and load over one period, and the play in which the load can be."""
    pin = np.sin(PHASES)
    contact = _in_contact(pin, load)
    positions.fill_between(PHASES, pin - GAP / 2, pin + GAP / 2, label="where the play lets it be", **SHADE)
    positions.plot(PHASES, pin, label="pin", **PIN)
    velocities.plot(PHASES, np.cos(PHASES), **PIN)
    _load(positions, PHASES, load, contact)
    _load(velocities, PHASES, _velocity(load, contact), contact)
    positions.set_xlim(0, 2 * np.pi)
    few_ticks(positions.yaxis, velocities.yaxis)


def _in_contact(pin: Reals, load: Reals) -> Flags:
    """Say where the load touches the pin: half of the gap away from it."""
    return np.isclose(np.abs(pin - load), GAP / 2, rtol=0, atol=1e-9)


def _load(axes: Axes, across: Reals, up: Reals, contact: Flags) -> None:
    """Draw the load's line, thick where it is in contact."""
    free = ~contact
    joined = free | np.roll(free, 1) | np.roll(free, -1)
    axes.plot(across, np.where(joined, up, np.nan), label="load, let go", **LET_GO)
    axes.plot(across, np.where(contact, up, np.nan), label="load, in contact", **CONTACT)


def _velocity(load: Reals, contact: Flags) -> Reals:
    """Return the load's velocity; differences are taken on one side only, so that none bridges an impact."""
    slope = np.diff(load) / np.diff(PHASES)
    forward, backward = np.append(slope, slope[0]), np.insert(slope, 0, slope[-1])
    ends_here = ~contact & np.append(contact[1:], contact[0])
    return np.where(contact, np.cos(PHASES), np.where(ends_here, backward, forward))


def _turning_sense(axes: Axes, pin: Reals, load: Reals, places: tuple[int, ...]) -> None:
    """Put arrows of rising time on a loop, at samples of the period."""
    for place in places:
        arrow(axes, (pin[place], load[place]), (pin[place + 3], load[place + 3]))


@figure("fig-2.12")
def coulomb_friction(_: Evidence) -> Figure:
    phases = np.linspace(0, 2 * np.pi, 721)
    force = CoulombFriction(1.0).waveform(phases, 1.0)
    figure, (by_velocity, by_displacement, by_time) = panels(2.7, 1, 3, sharey=True)
    for side in (-1.0, 1.0):
        by_velocity.plot([0, side], [side, side], **LINES[0])
    by_velocity.plot([0, 0], [-1, 1], color=LINES[0]["color"], linestyle=":")
    by_displacement.plot([-1, 1, 1, -1, -1], [1, 1, -1, -1, 1], **LINES[0])
    arrow(by_displacement, (-0.1, 1.0), (0.2, 1.0))
    arrow(by_displacement, (0.1, -1.0), (-0.2, -1.0))
    by_time.plot(phases, np.sin(phases), label="displacement$/A$", **LINES[2])
    by_time.plot(phases, np.cos(phases), label=r"velocity$/(\omega A)$", **LINES[1])
    by_time.plot(phases, force, label="force$/F_c$", **LINES[0])
    by_velocity.set(
        title="velocity: a relay", xlabel=r"velocity, $\dot x/(\omega A)$", ylabel="force, $F/F_c$"
    )
    by_displacement.set(title="displacement: a loop", xlabel="displacement, $x/A$")
    by_time.set(title="over a period", xlabel=r"phase, $\omega t$", ylim=(-1.3, 1.3))
    few_ticks(by_velocity.xaxis, by_velocity.yaxis, by_displacement.xaxis)
    by_time.set_xticks(np.pi / 2 * np.arange(5), ("$0$", r"$\pi/2$", r"$\pi$", r"$3\pi/2$", r"$2\pi$"))
    figure.legend(*by_time.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure
