"""The motion over time: outputs, forces of contacts, and when parts touch and stick."""

from __future__ import annotations

from typing import TYPE_CHECKING

from report.design.quantities import scale_for
from report.pages.drawing.style import LINES, panels
from trimmer.drawing.look import plain_label

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from report.design.quantities import Scale
    from trimmer.arrays import Reals
    from trimmer.design.found_motion import FoundMotion, Spans

OUTPUT_HEIGHT, FORCE_HEIGHT, BAR_HEIGHT = 2.2, 1.7, 0.28
BARS = {"contact": "#0072b2", "stick": "#d55e00"}


def motion_over_time(motion: FoundMotion) -> Figure:
    """Draw outputs above forces above bars of contact and stick, as far as there are any of them."""
    signals = motion.signals
    rows: list[tuple[str, str, Spans]] = [
        *((name, "contact", spans) for name, spans in signals.touching.items()),
        *((name, "stick", spans) for name, spans in signals.sticking.items()),
    ]
    curves = [
        *([(OUTPUT_HEIGHT, signals.outputs, "displacement", "m")] if signals.outputs else []),
        *([(FORCE_HEIGHT, signals.forces, "force", "N")] if signals.forces else []),
    ]
    heights = [
        *(height for height, *_ in curves),
        *([0.4 + BAR_HEIGHT * len(rows)] if rows else []),
    ]
    figure, all_axes = panels(
        sum(heights) + 0.4, len(heights), 1, sharex=True, height_ratios=heights, squeeze=False
    )
    time = scale_for(signals.times, "s")
    axes = list(all_axes[:, 0])
    for own, (_, found, name, unit) in zip(axes, curves, strict=False):
        _curves(own, signals.times / time.factor, found, name, unit)
    if rows:
        _bars(axes[-1], rows, time)
    axes[-1].set_xlabel(f"time [{time.unit}]")
    axes[-1].set_xlim(0.0, float(signals.times[-1]) / time.factor)
    return figure


def _curves(axes: Axes, times: Reals, curves: Mapping[str, Reals], name: str, unit: str) -> None:
    every = [float(value) for curve in curves.values() for value in (curve.min(), curve.max())]
    scale = scale_for(every, unit)
    for (label, curve), look in zip(curves.items(), LINES * 4, strict=False):
        axes.plot(times, curve / scale.factor, label=plain_label(label), **look)
    axes.set_ylabel(f"{name} [{scale.unit}]")
    if len(curves) > 1:
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))


def _bars(axes: Axes, rows: list[tuple[str, str, Spans]], time: Scale) -> None:
    for place, (_, kind, spans) in enumerate(rows):
        bars = [(begin / time.factor, length / time.factor) for begin, length in spans]
        axes.broken_barh(bars, (place - 0.35, 0.7), facecolors=BARS[kind])
    axes.set_yticks(range(len(rows)), [f"{plain_label(name)}, {kind}" for name, kind, _ in rows])
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.grid(visible=False, axis="y")
