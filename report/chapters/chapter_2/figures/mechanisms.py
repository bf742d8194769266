"""Mechanisms as the text describes them (figures 2.1, 2.2 and 2.7).

The thesis's own drawings are not at hand; shapes and proportions are free, connections are the text's.
"""

import math
from typing import Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.numbers.evidence import Evidence
from report.pages.drawing import mechanical_symbols as draw
from report.pages.drawing.marks import beside, few_ticks, span
from report.pages.drawing.style import BLACK, DOTTED, LINES, panels

PIN_ANGLE: Final = math.radians(35)


@figure("fig-2.1")
def free_body_diagram(_: Evidence) -> Figure:
    figure, axes = draw.canvas(6.5, 3.2)
    draw.wall(axes, 0.2, 1.5, 2.8, -1)
    draw.wall(axes, 6.3, 0.2, 2.8, 1)
    draw.body(axes, (1.0, 1.7), (0.75, 0.9), "$m_1$", draw.MOTOR)
    draw.body(axes, (3.25, 1.7), (0.75, 0.9), "$m_2$", draw.BRIDGE)
    draw.body(axes, (4.85, 0.3), (0.6, 2.3), "$m_3$", draw.HOUSING)
    draw.body(axes, (3.25, 0.3), (0.75, 0.9), "$m_4$", draw.GUARD)
    for left, right, y, number in ((0.2, 1.0, 2.35, 1), (2.45, 3.25, 2.35, 2), (5.45, 6.3, 1.85, 3)):
        draw.spring(axes, left, right, y, f"$k_{number}$")
        draw.damper(axes, left, right, y - 0.4, f"$c_{number}$")
    draw.spring(axes, 4.0, 4.85, 0.95, "$k_4$")
    draw.damper(axes, 4.0, 4.85, 0.55, "$c_4$")
    draw.spring(axes, 4.0, 4.85, 2.15, "$k_5$")
    # The pin: a bar at q1 + u that carries the spring and the damper of the bridge.
    axes.plot([2.45, 2.45], [1.8, 2.5], color=BLACK, linestyle="solid", linewidth=2.2)
    span(axes, (1.75, 2.15), (2.45, 2.15), "$u(t)$")
    for number, x, y in ((1, 1.2, 2.8), (2, 3.45, 2.8), (3, 4.95, 2.8), (4, 2.5, 0.75)):
        draw.displacement(axes, x, y, f"$q_{number}$")
    names = {"motor": (1.37, 1.55), "pin": (2.45, 1.65), "cutter with bridge": (3.62, 1.55)}
    for name, place in (names | {"guard": (3.62, 0.15), "guard housing": (5.15, 0.15)}).items():
        axes.text(*place, name, ha="center", va="center", fontsize=9)
    return figure


@figure("fig-2.2")
def eccentric_pin(_: Evidence) -> Figure:
    from matplotlib.patches import Circle

    angles, radius = np.linspace(0, 2 * np.pi, 241), 0.22
    x, y = math.sin(PIN_ANGLE), math.cos(PIN_ANGLE)
    figure, (shaft, motion) = panels(3.0, 1, 2, width_ratios=(1, 1.35))
    shaft.plot(1.6 * np.cos(angles), 1.6 * np.sin(angles), **draw.LINE)
    shaft.plot(np.cos(angles), np.sin(angles), color="#888888", linestyle=":", linewidth=1.0)
    shaft.add_patch(Circle((x, y), radius, facecolor=draw.PIN, edgecolor=BLACK, zorder=3))
    for edge in (x - radius, x + radius):
        shaft.plot([edge, edge], [-1.7, 1.7], color=LINES[1]["color"], linestyle="solid", linewidth=2.0)
    shaft.plot([0, x], [0, y], **draw.LINE)
    shaft.plot([0, 0], [-0.1, 1.6], **DOTTED)
    shaft.plot([0], [0], "+", color=BLACK, markersize=8)
    shaft.text(0.18, 0.5, "$A$", ha="center", va="center")
    arc = np.linspace(0, PIN_ANGLE, 20)
    shaft.plot(1.25 * np.sin(arc), 1.25 * np.cos(arc), color=BLACK, linestyle="solid", linewidth=0.9)
    shaft.text(-0.08, 1.15, r"$2\pi f t$", ha="right", va="center", fontsize=9)
    span(shaft, (0, -1.2), (x, -1.2))
    shaft.text(0.28, -1.27, "$x_i$", ha="right", va="top")
    shaft.text(x + radius + 0.1, 1.65, "bridge", fontsize=9)
    shaft.set(xlim=(-1.9, 1.9), ylim=(-1.8, 1.8), title="shaft from above")
    shaft.set_aspect("equal")
    shaft.set_axis_off()
    motion.plot(angles / (2 * np.pi), np.sin(angles), **LINES[0])
    place = PIN_ANGLE / (2 * np.pi)
    motion.plot([place, place], [0, x], color=BLACK, linestyle="solid", linewidth=0.8)
    motion.plot([place], [x], "o", color=BLACK, markersize=5)
    beside(motion, "$x_i$", (place, x / 2), (4, -4))
    span(motion, (0.25, 0.0), (0.25, 1.0))
    beside(motion, "$A$", (0.25, 0.5), (4, -4))
    motion.set(xlabel="time in turns, $ft$", ylabel="displacement of the pin, $x_i/A$", xlim=(0, 1))
    motion.set_title("over a turn")
    few_ticks(motion.xaxis, motion.yaxis)
    return figure


@figure("fig-2.7")
def motor_and_load(_: Evidence) -> Figure:
    figure, axes = draw.canvas(6.5, 2.1)
    draw.body(axes, (0.3, 0.2), (1.1, 0.6), "motor", draw.MOTOR)
    axes.plot([1.4, 2.7], [0.5, 0.5], color=BLACK, linestyle="solid", linewidth=2.0)
    draw.body(axes, (2.6, 0.4), (0.2, 0.75), "", draw.PIN)
    for edge in (2.05, 3.2):
        draw.body(axes, (edge, 0.85), (0.15, 0.6), "", draw.BRIDGE)
    draw.body(axes, (2.05, 1.45), (2.3, 0.35), "load $M$", draw.BRIDGE)
    draw.damper(axes, 4.35, 5.6, 1.62, "$D$")
    draw.wall(axes, 5.6, 1.2, 2.0, 1)
    span(axes, (2.2, 1.0), (2.6, 1.0), "$b$")
    span(axes, (2.8, 1.0), (3.2, 1.0), "$b$")
    draw.displacement(axes, 0.6, 1.0, r"$A\,\sin\omega t$")
    draw.displacement(axes, 3.5, 1.25, "$y$")
    return figure
