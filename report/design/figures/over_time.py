"""Motion over time, its lines over frequency, and the response of the linear mechanism."""

from collections.abc import Mapping
from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from report.design.quantities import Scale, quantity_words, scale_for
from report.pages.drawing.style import BLACK, FAINT, LINES, panels
from trimmer.arrays import Reals
from trimmer.design import FoundMotion, LinearState, LineKind, OutputSpectrum
from trimmer.design.analysis.motion_signals import MotionSignals, Spans
from trimmer.drawing.look import plain_label
from trimmer.mechanism.linear.outputs import Contacts

OUTPUT_HEIGHT, FORCE_HEIGHT, BAR_HEIGHT = 2.2, 1.7, 0.28
TALLEST = 7.0  # Height of all curves together, with which heading and words stand on the same page
BARS = {"contact": "#0072b2", "stick": "#d55e00"}


def motion_over_time(signals: MotionSignals) -> Figure:
    """Draw outputs above forces above bars of contact and stick, as far as there are any of them."""
    rows: list[tuple[str, str, Spans]] = [
        *((name, "contact", spans) for name, spans in signals.touching.items()),
        *((name, "stick", spans) for name, spans in signals.sticking.items()),
    ]
    curves = [
        *((OUTPUT_HEIGHT, each, unit) for unit, each in _by_unit(signals.outputs, signals.units, "m")),
        *((FORCE_HEIGHT, each, unit) for unit, each in _by_unit(signals.forces, signals.force_units, "N")),
    ]
    lower = TALLEST / max(sum(height for height, *_ in curves), TALLEST)
    heights = [*(lower * height for height, *_ in curves), *([0.4 + BAR_HEIGHT * len(rows)] if rows else [])]
    figure, all_axes = panels(
        sum(heights) + 0.4, len(heights), 1, sharex=True, height_ratios=heights, squeeze=False
    )
    time = scale_for(signals.times, "s")
    axes = list(all_axes[:, 0])
    for own, (_, found, unit) in zip(axes, curves, strict=False):
        _curves(own, signals.times / time.factor, found, quantity_words(unit), unit)
    if rows:
        _bars(axes[-1], rows, time)
    axes[-1].set_xlabel(f"time [{time.unit}]")
    axes[-1].set_xlim(0.0, float(signals.times[-1]) / time.factor)
    return figure


def _by_unit(
    curves: Mapping[str, Reals], units: Mapping[str, str], usual: str
) -> list[tuple[str, dict[str, Reals]]]:
    """Return curves that share axes: those of one unit."""
    of = {name: units.get(name, usual) for name in curves}
    return [
        (unit, {name: curves[name] for name in curves if of[name] == unit})
        for unit in dict.fromkeys(of.values())
    ]


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


def acceleration_of(motion: FoundMotion, body: str) -> Figure:
    """Draw the acceleration of a body over time, and below it its spectrum."""
    figure, (upper, lower) = panels(4.4, 2, 1)
    signals = motion.signals
    time = scale_for(signals.times, "s")
    _curves(upper, signals.times / time.factor, {body: signals.accelerations[body]}, "acceleration", "m/s²")
    upper.set_xlabel(f"time [{time.unit}]")
    found, colour = motion.hand_arm[body], LINES[0]["color"]
    there = found.amplitude > SMALLEST * found.amplitude.max(initial=0.0)
    frequency, sizes = found.frequency[there], found.amplitude[there]
    if motion.repeats:
        lower.vlines(frequency, sizes.min(initial=1.0) / 3, sizes, color=colour, linewidth=1.1)
        lower.plot(frequency, sizes, "o", color=colour, markersize=3, linestyle="none")
    else:
        lower.plot(frequency, sizes, linewidth=0.8, color=colour)
    lower.set(yscale="log", xlabel="frequency [Hz]", ylabel="amplitude [m/s²]")
    lower.set_xlim(left=0.0)
    return figure


SMALLEST = 1e-4  # Line of an acceleration, relative to the largest, from which on it is drawn
MARKS = {
    LineKind.DRIVE: ("o", "#0072b2", "drive"),
    LineKind.HARMONIC: ("s", "#009e73", "harmonic of the drive"),
    LineKind.FRACTION: ("^", "#d55e00", "fraction of the drive"),
    LineKind.OWN: ("D", "#0072b2", "line of the motion itself"),
}


def line_spectrum(spectra: list[tuple[str, OutputSpectrum]]) -> Figure:
    """Draw the lines of an output, or before and after a change; each has a name, empty for a single one."""
    figure, axes = panels(2.9)
    every = [line for _, each in spectra for line in each.lines]
    frequency = scale_for((line.frequency for line in every), "Hz")
    amplitude = scale_for((line.amplitude for line in every), spectra[0][1].unit)
    for number, (name, each) in enumerate(spectra):
        _stems(axes, each, frequency, amplitude, name, number)
    floor = min((line.amplitude for line in every), default=1.0) / amplitude.factor
    axes.set(yscale="log", xlabel=f"frequency [{frequency.unit}]", ylabel=f"amplitude [{amplitude.unit}]")
    axes.set_ylim(bottom=floor / 3)
    axes.set_xlim(left=0.0)
    axes.legend(loc="upper right")
    return figure


def _stems(
    axes: Axes, spectrum: OutputSpectrum, frequency: Scale, amplitude: Scale, name: str, number: int
) -> None:
    """Draw lines from the bottom; of a second spectrum dashed, with open marks."""
    for kind, (mark, colour, words) in MARKS.items():
        lines = [line for line in spectrum.lines if line.kind is kind]
        if not lines:
            continue
        places = [line.frequency / frequency.factor for line in lines]
        sizes = [line.amplitude / amplitude.factor for line in lines]
        bottom = min(line.amplitude for line in spectrum.lines) / amplitude.factor / 100
        style: Literal["dashed", "solid"] = "dashed" if number else "solid"
        axes.vlines(places, bottom, sizes, color=colour, linewidth=1.1, linestyles=style)
        label = f"{plain_label(name)}: {words}" if name else words
        face = "none" if number else colour
        axes.plot(
            places, sizes, mark, color=colour, markerfacecolor=face, linestyle="none", label=label,
            markersize=6 if number else 4.5, markeredgewidth=1.0 if number else 0.4,
            markeredgecolor=colour if number else BLACK,
        )  # fmt: skip


NAMES = {Contacts.CLOSED: "contacts closed", Contacts.OPEN: "contacts open"}


def transfer_functions(
    states: tuple[LinearState, ...], drive: str, output: str, frequency: float | None
) -> Figure:
    """Draw modulus and phase of one transfer function in each state of the contacts."""
    figure, (modulus, phase) = panels(3.9, 2, 1, sharex=True, height_ratios=(2, 1))
    unit = ""
    for state, look in zip(states, LINES, strict=False):
        for each in state.transfer:
            if (each.drive, each.output) == (drive, output) and abs(each.response).max() > 0:
                unit = each.per_unit or f"{each.unit}/{each.unit}"
                name = NAMES[state.contacts] if len(states) > 1 else None
                modulus.plot(each.frequency, abs(each.response), label=name, **look)
                phase.plot(each.frequency, np.degrees(np.angle(each.response)), **look)
    modulus.set(xscale="log", yscale="log", ylabel=f"modulus [{unit}]")
    phase.set(xscale="log", xlabel="frequency [Hz]", ylabel="phase [°]", yticks=(-180, -90, 0, 90, 180))
    if frequency is not None:
        for axes in (modulus, phase):
            axes.axvline(frequency, **FAINT)
    if len(states) > 1:
        modulus.legend(loc="best")
    return figure
