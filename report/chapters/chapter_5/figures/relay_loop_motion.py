"""The loop with a relay, and with friction (thesis, figures 5.19 and 5.20), drawn again."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from report.drawing.style import BLACK, LINES, new_figure, style
from report.evidence import Evidence
from report.numbers.relay_loop import HALF_PERIODS, IMPULSES, STEP, VISCOUS, friction_motion, output_at_jump
from trimmer.linear import InputChannels, pin_model

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN_TIME: Final = 40e-6
"""Time that is shown of the loop with friction, s."""
EVERY: Final = 5
"""One of so many swings is drawn."""


def relay_swings(evidence: Evidence) -> Figure:
    """Draw size and frequency of the swings of the loop with a relay (thesis, figure 5.19)."""
    numbers = evidence.motion.closed.relay
    with style():
        figure = new_figure(3.4)
        sizes, frequencies = figure.subplots(1, 2)
        for run, line in zip(numbers.runs, LINES, strict=False):
            middles = 1e3 * ((run.times[:-1] + run.times[1:]) / 2)[::EVERY]
            label = f"10$^{{{np.log10(run.impulse):.0f}}}$ s"
            sizes.plot(middles, run.swings[::EVERY], label=label, **line.keywords)
            frequencies.plot(middles, run.frequencies[::EVERY], label=label, **line.keywords)
        kept, amplitude = numbers.sampled
        for axes, value in ((sizes, amplitude), (frequencies, kept)):
            axes.axhline(value, color=BLACK, linestyle=":", linewidth=0.9)
            axes.set_yscale("log")
            axes.set(xlabel="time [ms]", xlim=(0, 220))
        frequencies.annotate(
            f"dotted: kept up by\na step of {1e6 * STEP:.0f} µs",
            (0.98, 0.03),
            xycoords="axes fraction",
            ha="right",
            fontsize=8,
        )
        sizes.set(ylabel="swing over relay output", title="they become smaller")
        frequencies.set(ylabel="frequency [Hz]", title="and faster")
        sizes.legend(loc="upper right", title="impulse over relay")
    return figure


def friction_and_condition(evidence: Evidence) -> Figure:
    """Draw the condition for a periodic motion, and the loop with friction (thesis, figure 5.20)."""
    system = pin_model(evidence.numbers.parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    A, B, C = system.A, system.B, system.C
    with style():
        figure = new_figure(3.4)
        condition, motion = figure.subplots(1, 2)
        for gain, line in zip((0.0, VISCOUS), LINES, strict=False):
            values = output_at_jump(A - gain * B @ C, B[:, 0], C[0], HALF_PERIODS)
            name = "relay" if gain == 0 else f"relay and gain {gain}"
            below = np.where(values < 0, -values, np.nan)
            condition.plot(0.5 / HALF_PERIODS, below, label=name, **line.keywords)
        condition.axvspan(*sorted(evidence.motion.closed.relay.alone.frequencies), color="#dddddd")
        condition.set_xscale("log")
        condition.set_yscale("log")
        condition.set(
            title="on the output",
            xlabel="frequency of the square wave [Hz]",
            ylabel="$-y$ at its jump up",
            xlim=(50, 1e5),
            ylim=(1e-9, 1e3),
        )
        condition.legend(loc="upper right")
        times = np.linspace(0, SHOWN_TIME, 801)
        for impulse, line in zip(IMPULSES, LINES, strict=False):
            output = friction_motion(system, impulse).output(times)
            label = f"10$^{{{np.log10(impulse):.0f}}}$ s"
            motion.plot(1e6 * times, output / np.abs(output).max(), label=label, **line.keywords)
        motion.set(title="on its velocity", xlabel="time [µs]", ylabel="$y$ over its largest", xlim=(0, 40))
        motion.legend(loc="lower right", title="impulse over force")
    return figure
