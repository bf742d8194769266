"""The trimmer and its parts as the text describes them (thesis, figures 1.1, 2.1, 2.2 and 2.7).

The thesis's own drawings are not at hand; shapes and proportions are free, connections are the text's.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from report.chapters.chapter_2.figures.block_diagrams import canvas
from report.drawing.mechanical_symbols import body, called, damper, displacement, span, spring, wall
from report.drawing.style import BLACK, LINES, new_figure, style
from report.drawing.ticks import few_ticks

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOTOR: Final = "#d6e6f2"
_BRIDGE: Final = "#f7dfc8"
_HOUSING: Final = "#d9ead9"
_GUARD: Final = "#eadbe7"
_PLAIN: Final = "#f2f2f2"
_PIN_ANGLE: Final = math.radians(35)


def components() -> Figure:
    """Draw the parts between motor and guard, in the plane of the motion (thesis, figure 1.1)."""
    with style():
        figure, axes = canvas(6.5, 4.0)
        body(axes, (0.5, 0.2), (5.5, 0.35), "plastic housing", _PLAIN)
        body(axes, (2.2, 0.55), (1.5, 0.75), "motor", _MOTOR)
        body(axes, (2.6, 1.3), (0.7, 0.4), "shell", "#f5ecb0")
        body(axes, (3.0, 1.7), (0.16, 0.55), "", "#bbbbbb")
        _bridge_and_cutter(axes)
        body(axes, (1.3, 3.05), (3.4, 0.3), "guard", _GUARD)
        body(axes, (5.0, 0.55), (0.8, 2.8), "guard\nhousing", _HOUSING)
        spring(axes, 4.4, 5.0, 2.8, "")
        axes.plot([4.7, 5.0], [3.2, 3.2], color=BLACK, linestyle="solid", linewidth=3)
        called(axes, "eccentric pin", (3.08, 1.85), (4.2, 1.55))
        called(axes, "play", (2.92, 2.08), (1.95, 1.75))
        called(axes, "coil spring", (4.7, 2.74), (4.5, 2.2))
        called(axes, "friction", (1.5, 3.05), (0.6, 2.75))
        displacement(axes, 2.0, 3.65, "motion of cutter and bridge")
    return figure


def _bridge_and_cutter(axes: Axes) -> None:
    """Draw the two raised edges, the bridge between them, and the cutter fixed to it."""
    for x in (2.62, 3.26):
        body(axes, (x, 1.95), (0.28, 0.5), "", _BRIDGE)
    body(axes, (2.2, 2.45), (1.8, 0.25), "driving bridge", _BRIDGE)
    body(axes, (1.5, 2.7), (2.9, 0.35), "cutter", _BRIDGE)


def free_body_diagram() -> Figure:
    """Draw the four masses with their springs, dampers and the driving pin (thesis, figure 2.1b)."""
    with style():
        figure, axes = canvas(6.5, 3.2)
        wall(axes, 0.2, 1.5, 2.8, -1)
        wall(axes, 6.3, 0.2, 2.8, 1)
        body(axes, (1.0, 1.7), (0.75, 0.9), "$m_1$", _MOTOR)
        body(axes, (3.25, 1.7), (0.75, 0.9), "$m_2$", _BRIDGE)
        body(axes, (4.85, 0.3), (0.6, 2.3), "$m_3$", _HOUSING)
        body(axes, (3.25, 0.3), (0.75, 0.9), "$m_4$", _GUARD)
        for left, right, y, number in ((0.2, 1.0, 2.35, 1), (2.45, 3.25, 2.35, 2), (5.45, 6.3, 1.85, 3)):
            spring(axes, left, right, y, f"$k_{number}$")
            damper(axes, left, right, y - 0.4, f"$c_{number}$")
        spring(axes, 4.0, 4.85, 0.95, "$k_4$")
        damper(axes, 4.0, 4.85, 0.55, "$c_4$")
        spring(axes, 4.0, 4.85, 2.15, "$k_5$")
        _driving_pin(axes)
        for number, x, y in ((1, 1.2, 2.8), (2, 3.45, 2.8), (3, 4.95, 2.8), (4, 2.5, 0.75)):
            displacement(axes, x, y, f"$q_{number}$")
        for x, y, name in (
            (1.37, 1.55, "motor"),
            (2.45, 1.65, "pin"),
            (3.62, 1.55, "cutter with bridge"),
            (3.62, 0.15, "guard"),
            (5.15, 0.15, "guard housing"),
        ):
            axes.text(x, y, name, ha="center", va="center", fontsize=9)
    return figure


def _driving_pin(axes: Axes) -> None:
    """Draw the pin between motor and bridge: a bar at q1 + u that carries spring and damper."""
    axes.plot([2.45, 2.45], [1.8, 2.5], color=BLACK, linestyle="solid", linewidth=2.2)
    span(axes, (1.75, 2.15), (2.45, 2.15), "$u(t)$")


def eccentric_pin() -> Figure:
    """Draw the shaft from above, and the pin's displacement over a turn (thesis, figure 2.2)."""
    angles = np.linspace(0, 2 * np.pi, 241)
    turned = math.sin(_PIN_ANGLE)
    with style():
        figure = new_figure(3.0)
        shaft, motion = figure.subplots(1, 2, width_ratios=(1, 1.35))
        shaft.plot(1.6 * np.cos(angles), 1.6 * np.sin(angles), color=BLACK, linestyle="solid", linewidth=1.1)
        shaft.plot(np.cos(angles), np.sin(angles), color="#888888", linestyle=":", linewidth=1.0)
        _pin_in_bridge(shaft)
        motion.plot(angles / (2 * np.pi), np.sin(angles), **LINES[0].keywords)
        place = _PIN_ANGLE / (2 * np.pi)
        motion.plot([place, place], [0, turned], color=BLACK, linestyle="solid", linewidth=0.8)
        motion.plot([place], [turned], "o", color=BLACK, markersize=5)
        motion.annotate("$x_i$", (place, turned / 2), (4, -4), textcoords="offset points")
        span(motion, (0.25, 0.0), (0.25, 1.0), "")
        motion.annotate("$A$", (0.25, 0.5), (4, -4), textcoords="offset points")
        motion.set(xlabel="time in turns, $ft$", ylabel="displacement of the pin, $x_i/A$", xlim=(0, 1))
        few_ticks(motion.xaxis, motion.yaxis)
    return figure


def _pin_in_bridge(axes: Axes) -> None:
    """Draw the pin at an angle from the upright, between the flat edges of the bridge."""
    from matplotlib.patches import Circle

    radius, x, y = 0.22, math.sin(_PIN_ANGLE), math.cos(_PIN_ANGLE)
    axes.add_patch(Circle((x, y), radius, facecolor="#bbbbbb", edgecolor=BLACK, zorder=3))
    for side in (-1, 1):
        axes.plot(
            [x + side * radius] * 2, [-1.7, 1.7], color=LINES[1].colour, linestyle="solid", linewidth=2.0
        )
    axes.plot([0, x], [0, y], color=BLACK, linestyle="solid", linewidth=1.1)
    axes.plot([0, 0], [-0.1, 1.6], color=BLACK, linestyle=":", linewidth=0.9)
    axes.plot([0], [0], "+", color=BLACK, markersize=8)
    axes.text(0.18, 0.5, "$A$", ha="center", va="center")
    arc = np.linspace(0, _PIN_ANGLE, 20)
    axes.plot(1.25 * np.sin(arc), 1.25 * np.cos(arc), color=BLACK, linestyle="solid", linewidth=0.9)
    axes.text(-0.08, 1.15, r"$2\pi f t$", ha="right", va="center", fontsize=9)
    span(axes, (0, -1.2), (x, -1.2), "")
    axes.text(0.28, -1.27, "$x_i$", ha="right", va="top")
    axes.text(x + radius + 0.1, 1.65, "bridge", fontsize=9)
    axes.set(xlim=(-1.9, 1.9), ylim=(-1.8, 1.8))
    axes.set_aspect("equal")
    axes.set_axis_off()


def motor_and_load() -> Figure:
    """Draw a motor that moves a load with inertia and friction through play (thesis, figure 2.7)."""
    with style():
        figure, axes = canvas(6.5, 2.1)
        body(axes, (0.3, 0.2), (1.1, 0.6), "motor", _MOTOR)
        axes.plot([1.4, 2.7], [0.5, 0.5], color=BLACK, linestyle="solid", linewidth=2.0)
        body(axes, (2.6, 0.4), (0.2, 0.75), "", "#bbbbbb")
        for x in (2.05, 3.2):
            body(axes, (x, 0.85), (0.15, 0.6), "", _BRIDGE)
        body(axes, (2.05, 1.45), (2.3, 0.35), "load $M$", _BRIDGE)
        damper(axes, 4.35, 5.6, 1.62, "$D$")
        wall(axes, 5.6, 1.2, 2.0, 1)
        span(axes, (2.2, 1.0), (2.6, 1.0), "$b$")
        span(axes, (2.8, 1.0), (3.2, 1.0), "$b$")
        displacement(axes, 0.6, 1.0, r"$A\,\sin\omega t$")
        displacement(axes, 3.5, 1.25, "$y$")
    return figure
