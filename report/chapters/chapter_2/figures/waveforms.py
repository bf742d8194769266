"""Waveforms of the three kinds of backlash under a sinusoidal pin (thesis, figures 2.9 to 2.11), drawn again.

Lengths are in amplitudes of the pin and time is its phase. The load's line is solid and thick where the
bridge is in contact with the pin, and dashed where it is let go.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np

from report.drawing.style import LINES, new_figure, style
from report.drawing.ticks import few_ticks
from trimmer.elements.contact_equation import steady_motion
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from trimmer.elements.backlash import Backlash

    Reals = NDArray[np.float64]

GAP: Final = 0.6
"""Total clearance over the amplitude."""
GAMMAS: Final = (0.3, 1.0, 4.0)
"""M omega / D of the loads in figure 2.11."""
PHASES: Final = np.linspace(0, 2 * np.pi, 481)
_CONTACT: Final[dict[str, Any]] = {"color": LINES[0].colour, "linestyle": "solid", "linewidth": 2.4}
_LET_GO: Final[dict[str, Any]] = LINES[1].keywords
_PIN: Final[dict[str, Any]] = {"color": "#444444", "linestyle": (0, (1.5, 1.5)), "linewidth": 1.2}
_MARK: Final[dict[str, Any]] = {"color": "#999999", "linestyle": "solid", "linewidth": 0.6, "zorder": 0.5}
_SHADE: Final[dict[str, Any]] = {"color": "#56b4e9", "alpha": 0.18, "linewidth": 0}


def flight(element: Backlash) -> tuple[float, float]:
    """Return the phases of separation and of the impact that follows, rad, at amplitude one and 1 rad/s."""
    motion = steady_motion(element.gap, np.ones(1), element.gamma(np.ones(1)))
    return float(np.arctan2(motion.sine, motion.cosine)[0]), float(motion.impact_phase[0])


def friction_controlled() -> Figure:
    """Draw characteristic, output and input so that they line up (thesis, figure 2.9)."""
    element = FrictionBacklash(GAP)
    phases = PHASES + np.pi / 2
    pin, load = np.sin(phases), element.waveform(phases, 1.0)
    contact = _in_contact(pin, load)
    with style():
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
        _explanation(figure.add_subplot(grid[1, 1]))
    return figure


def _corners(characteristic: Axes, output: Axes, drive: Axes) -> None:
    """Mark the four corners of the loop in all three panels, and join the places that belong together."""
    half, gamma = GAP / 2, float(np.arcsin(1 - GAP))
    phases = (np.pi / 2, np.pi - gamma, 3 * np.pi / 2, 2 * np.pi - gamma, 5 * np.pi / 2)
    names = (r"$\pi/2$", r"$\pi-\gamma$", r"$3\pi/2$", r"$2\pi-\gamma$", r"$5\pi/2$")
    inputs = (1.0, 1.0 - GAP, -1.0, GAP - 1.0, 1.0)
    heights = (1 - half, 1 - half, half - 1, half - 1, 1 - half)
    for letter, phase, x, y in zip("BCDEB", phases, inputs, heights, strict=True):
        beside = (4 if letter in "BE" else -12, 4 if y > 0 else -14)
        for axes, across, up in ((characteristic, x, y), (output, phase, y), (drive, x, phase)):
            axes.plot([across], [up], "o", color="black", markersize=3.5)
            axes.annotate(f"${letter}$", (across, up), beside, textcoords="offset points")
        _joined(characteristic, (x, y), drive, (x, phase))
    _joined(characteristic, (1.0, 1 - half), output, (phases[0], 1 - half))
    _joined(characteristic, (GAP - 1.0, half - 1), output, (phases[2], half - 1))
    output.set_xticks(phases, names)
    output.tick_params(labelleft=False)
    drive.set_yticks(phases, names)
    characteristic.set_yticks((half - 1, 0, 1 - half), ("$-(A-b)/A$", "$0$", "$(A-b)/A$"))
    characteristic.set_ylim(-1.05, 1.2)
    characteristic.annotate(
        "", (1 - GAP, 1.0), (1.0, 1.0), arrowprops={"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0}
    )
    characteristic.text(1 - half, 1.02, "$2b/A$", ha="center", va="bottom")


def _joined(start: Axes, place: tuple[float, float], end: Axes, other: tuple[float, float]) -> None:
    """Draw a thin line from a place in one panel to a place in another."""
    from matplotlib.patches import ConnectionPatch

    start.figure.add_artist(ConnectionPatch(place, other, "data", axesA=start, axesB=end, **_MARK))


def _explanation(axes: Axes) -> None:
    """Fill an empty panel with the legend."""
    axes.set_axis_off()
    axes.plot([], [], label="in contact: the load follows the pin", **_CONTACT)
    axes.plot([], [], label="let go: the load stays where it is", **_LET_GO)
    axes.legend(loc="upper left", title="Total clearance $2b = 0.6\\,A$", alignment="left")


def inertia_controlled() -> Figure:
    """Draw positions, velocities and the characteristic of a load without friction (thesis, figure 2.10)."""
    element = InertiaBacklash(GAP)
    pin, load = np.sin(PHASES), element.waveform(PHASES, 1.0)
    _, meeting = flight(element)
    phases = (0.0, meeting, np.pi, np.pi + meeting, 2 * np.pi)
    names = ("$0$", r"$\phi$", r"$\pi$", r"$\pi+\phi$", r"$2\pi$")
    with style():
        figure = new_figure(4.4)
        grid = figure.add_gridspec(2, 2, width_ratios=(1.25, 1))
        positions = figure.add_subplot(grid[0, 0])
        velocities = figure.add_subplot(grid[1, 0], sharex=positions)
        characteristic = figure.add_subplot(grid[:, 1])
        _motion(positions, velocities, load)
        velocities.set_xticks(phases, names)
        positions.tick_params(labelbottom=False)
        velocities.set_xlabel(r"phase of the pin, $\omega t$")
        positions.set(title="(a) waveforms", ylabel="position$/A$")
        velocities.set_ylabel(r"velocity$/(\omega A)$")
        characteristic.set(title="(b) characteristic", xlabel="pin, $x/A$", ylabel="load, $y/A$")
        characteristic.set_yticks((-1, -GAP / 2, 0, GAP / 2, 1), ("$-1$", "$-b/2A$", "$0$", "$b/2A$", "$1$"))
        _load(characteristic, pin, load, _in_contact(pin, load))
        few_ticks(characteristic.xaxis)
        _turning_sense(characteristic, pin, load, (53, 200, 294, 440))
        figure.legend(*positions.get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


def viscous_controlled() -> Figure:
    """Draw positions and velocities of loads with inertia and friction (thesis, figure 2.11)."""
    with style():
        figure = new_figure(4.4)
        grid = figure.subplots(2, len(GAMMAS), sharex="col", sharey="row")
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


def _motion(positions: Axes, velocities: Axes, load: Reals) -> None:
    """Draw pin and load over one period, and the play in which the load can be."""
    pin = np.sin(PHASES)
    contact = _in_contact(pin, load)
    positions.fill_between(PHASES, pin - GAP / 2, pin + GAP / 2, label="where the play lets it be", **_SHADE)
    positions.plot(PHASES, pin, label="pin", **_PIN)
    velocities.plot(PHASES, np.cos(PHASES), **_PIN)
    _load(positions, PHASES, load, contact)
    _load(velocities, PHASES, _velocity(load, contact), contact)
    positions.set_xlim(0, 2 * np.pi)
    few_ticks(positions.yaxis, velocities.yaxis)


def _in_contact(pin: Reals, load: Reals) -> NDArray[np.bool_]:
    """Say where the load touches the pin: half of the gap away from it."""
    return np.isclose(np.abs(pin - load), GAP / 2, rtol=0, atol=1e-9)


def _load(axes: Axes, across: Reals, up: Reals, contact: NDArray[np.bool_]) -> None:
    """Draw the load's line, thick where it is in contact."""
    free = ~contact
    joined = free | np.roll(free, 1) | np.roll(free, -1)
    axes.plot(across, np.where(joined, up, np.nan), label="load, let go", **_LET_GO)
    axes.plot(across, np.where(contact, up, np.nan), label="load, in contact", **_CONTACT)


def _velocity(load: Reals, contact: NDArray[np.bool_]) -> Reals:
    """Return the load's velocity; differences are taken on one side only, so that none bridges an impact."""
    slope = np.diff(load) / np.diff(PHASES)
    forward, backward = np.append(slope, slope[0]), np.insert(slope, 0, slope[-1])
    ends_here = ~contact & np.append(contact[1:], contact[0])
    return np.where(contact, np.cos(PHASES), np.where(ends_here, backward, forward))


def _turning_sense(axes: Axes, pin: Reals, load: Reals, places: tuple[int, ...]) -> None:
    """Put arrows of rising time on a loop, at samples of the period."""
    for place in places:
        axes.annotate(
            "",
            (pin[place + 3], load[place + 3]),
            (pin[place], load[place]),
            arrowprops={"arrowstyle": "-|>", "color": "black", "mutation_scale": 11},
        )
