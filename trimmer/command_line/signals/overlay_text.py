"""A measured motion beside a simulated one as text and as JSON."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.signals.recording_text import notes_of, recording_json, signal_json, wrapped
from trimmer.command_line.table import table

if TYPE_CHECKING:
    from trimmer.command_line.signals.signal_options import ChosenRecording
    from trimmer.spectra.comparison import MotionComparison

_OTHER_FREQUENCY = 2e-3
_SMALLEST = 1e-4


@dataclass(frozen=True)
class Compared:
    """A comparison with what its text and JSON say of the two motions, and what they settle to."""

    file: Path
    against: Path | None
    output: str
    settled: str
    chosen: ChosenRecording
    comparison: MotionComparison
    driven: bool


def as_text(compared: Compared) -> str:
    """Return what was compared, how it was aligned, and the lines side by side."""
    return "\n\n".join(
        "\n".join(part) for part in (_head(compared), _alignment(compared), line_rows(compared.comparison))
    )


def as_json(compared: Compared) -> str:
    """Return the comparison as JSON: full precision, SI units, rad."""
    comparison = compared.comparison
    content = {
        **picked(compared, "file", "against", "output", "settled"),
        "signal": signal_json(comparison.signal),
        **recording_json(compared.chosen),
        "frequency": comparison.frequency,
        "frequency_found": comparison.found,
        **picked(comparison, "simulated_frequency", "period_count", "shift", "residual"),
        **picked(comparison, "inverted_residual", "rest", "uncertainty"),
        "lines": [line_json(comparison, place) for place in range(comparison.measured.size)],
        "notes": _notes(compared),
    }
    return document(content)


def line_json(comparison: MotionComparison, place: int) -> dict[str, Any]:
    """Return a line of both motions, by its place, as data for JSON."""
    return {
        "order": [place + 1, comparison.period_count],
        "frequency": comparison.frequencies[place],
        "measured": abs(comparison.measured[place]),
        "simulated": abs(comparison.simulated[place]),
        "decibels": comparison.decibels[place],
        "phase_difference": comparison.phase_differences[place],
    }


def _notes(compared: Compared) -> list[str]:
    from trimmer.signals.faults import faults

    comparison = compared.comparison
    wrong = [fault.sentence for fault in (*compared.chosen.faults, *faults(comparison.signal))]
    notes = notes_of(compared.chosen, compared.chosen.signal, wrong)
    apart = comparison.frequency / comparison.simulated_frequency - 1.0
    if compared.driven and abs(apart) > _OTHER_FREQUENCY:
        notes.append(
            f"the measured drive is {100 * apart:+.3g} % off that of the simulation; lines are compared "
            f"order by order, so simulate at the measured one (--set frequency={comparison.frequency:.6g}Hz)"
        )
    if comparison.opposite:
        notes.append(
            f"with the opposite sign of the measurement the difference would be "
            f"{100 * comparison.inverted_residual:.3g} % instead of {100 * comparison.residual:.3g} %: is "
            "the sensor mounted the other way round (--scale -1)?"
        )
    return notes


def _head(compared: Compared) -> Iterator[str]:
    signal, comparison = compared.comparison.signal, compared.comparison
    yield (
        f"measured: {signal.heading} of {compared.file}, {signal.values.size} samples at "
        f"{signal.sample_rate:.9g} Hz, {signal.duration:.6g} s"
    )
    yield f"simulated: {compared.output} of {compared.against or 'the loop'}, as {signal.quantity.word}"
    yield from wrapped(compared.settled, "  ", "  ")
    how = "found in the measurement" if comparison.found else "as given"
    what = "drive" if compared.driven else "vibration by itself"
    measured, simulated = comparison.frequency, comparison.simulated_frequency
    yield f"{what}: {measured:.8g} Hz measured ({how}), {simulated:.8g} Hz simulated"
    for note in _notes(compared):
        yield from wrapped(f"note: {note}", "", "  ")


def _alignment(compared: Compared) -> Iterator[str]:
    comparison = compared.comparison
    degrees = 360.0 * comparison.shift * comparison.frequency
    cycle = "the drive" if compared.driven else "its cycle"
    began = "in the drive's period" if compared.driven else "in the cycle"
    size = comparison.measured.size
    yield "Waveforms, aligned in time"
    yield from wrapped(
        f"the simulation is shifted by {comparison.shift:.6g} s, {degrees:.4g} deg of {cycle}, where the "
        f"squares of the difference are least: when the measurement began {began} is not known",
        "  ",
        "  ",
    )
    yield from wrapped(
        f"the difference of the {size} lines is {100 * comparison.residual:.4g} % rms of the measured ones; "
        f"the lines leave {comparison.rest:.3g} {comparison.signal.unit} rms of the measurement",
        "  ",
        "  ",
    )


def line_rows(comparison: MotionComparison) -> Iterator[str]:
    """Yield a table of the lines of both motions; fractions of the drive are reduced."""
    unit, count = comparison.signal.unit, comparison.period_count
    largest = max(float(np.abs(comparison.measured).max()), float(np.abs(comparison.simulated).max()))
    rows = [
        (
            str(Fraction(place + 1, count)),
            f"{comparison.frequencies[place]:.6g}",
            f"{measured:.5g}",
            f"{simulated:.5g}",
            f"{comparison.decibels[place]:+.2f}",
            f"{math.degrees(comparison.phase_differences[place]):+.1f}",
            "" if measured > 3.0 * comparison.uncertainty else "within noise",
        )
        for place, (measured, simulated) in enumerate(
            zip(np.abs(comparison.measured), np.abs(comparison.simulated), strict=True)
        )
        if max(measured, simulated) > _SMALLEST * largest
    ]
    told = f"{comparison.uncertainty:.2g} {unit} (standard deviation, white noise)"
    yield f"Lines, measured amplitudes to {told}"
    heads = ("order", "Hz", f"measured, {unit}", f"simulated, {unit}", "dB", "phase, deg", "")
    yield from table(heads, rows)
