"""Maps as text for people and as JSON for machines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.table import table
from trimmer.maps.cell_motion import described
from trimmer.motion.units import with_unit
from trimmer.showing.shown import counted

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.maps.result import MotionMap
    from trimmer.maps.special_curve import Meeting, SpecialCurve, SpecialCurves

_MOST_FAILURES = 5  # Failures that the text lists; the JSON has all
_MOST_ROWS = 200  # Values of the only number up to which there is a table over it


def as_text(
    result: MotionMap, searched: str, special: SpecialCurves | None, targets: Mapping[str, float | None]
) -> str:
    """Return what is where in how many cells, ranges of measures, what was searched; a line has a table."""
    subject, cells = result.inputs.subject, len(result.cells)
    lines = [f"{subject.title or 'Mechanism'}: what it settles to over"]
    for place, values, unit in zip(result.places, result.values, result.units, strict=True):
        reach = f"{values[0]:g} to {values[-1]:g} {unit}".rstrip()
        lines.append(f"  {place} from {reach}, {counted(len(values), 'value')}")
    rows = [(name, str(count), f"{count / cells:.1%}") for name, count in result.counts.items()]
    lines += table(("motion", "cells", "share"), rows)
    lines += table(("measure", "smallest", "median", "largest", "unit"), _ranges(result))
    if len(result.places) == 1 and cells <= _MOST_ROWS:
        lines += _over_the_number(result)
    for key, target in targets.items():
        if target is not None:
            below = int((result.chosen[key] <= target).sum())
            value = f"{target:g} {result.chosen_units[key]}".rstrip()
            lines.append(f"{key} is at most {value} in {below} of {counted(cells, 'cell')}")
    several = int((result.motion_count > 1).sum())
    if several:
        lines.append(f"several motions coexist in {counted(several, 'cell')}")
    for (row, column), failure in list(result.failures.items())[:_MOST_FAILURES]:
        numbers = result.inputs.cell_values(row * result.shape[1] + column)
        at = ", ".join(f"{place} = {value:g}" for place, value in zip(result.places, numbers, strict=True))
        lines.append(f"failed at {at}: {failure}")
    if len(result.failures) > _MOST_FAILURES:
        lines.append(f"and {len(result.failures) - _MOST_FAILURES} more failed, which --json lists")
    if result.passing:
        lines.append(f"{result.passing}; --periods waits longer")
    lines.append(f"searched: {searched}")
    return "\n".join([*lines, *([] if special is None else _curves(special))])


def _over_the_number(result: MotionMap) -> list[str]:
    """Return the table over the only number: motion, strokes, impacts, and what was asked for."""
    measures = [
        *(
            (f"{name}, peak to peak", each, result.outputs[name])
            for name, each in result.peak_to_peak.items()
        ),
        ("impacts", result.impacts, ""),
        ("impact speed", result.impact_speed, result.measured_in.speed),
        *((key, each, result.chosen_units[key]) for key, each in result.chosen.items()),
    ]
    heads = (result.places[0], "motion", *(with_unit(name, unit) for name, _, unit in measures))
    rows = [
        (
            f"{value:.6g}",
            described(cell.motions[0]),
            *(f"{values[0, place]:.6g}" for _, values, _ in measures),
        )
        for place, (value, cell) in enumerate(zip(result.values[0], result.cells, strict=True))
    ]
    return table(heads, rows)


def _curves(special: SpecialCurves) -> list[str]:
    lines = []
    for curve in special.curves:
        repeats = "" if curve.periods == 1 else f", of motions of {curve.periods} drive periods"
        lines.append(f"{curve.name}{repeats}: {counted(len(curve.values), 'point')}")
        lines += [f"  {side.message}" for side in curve.ends]
    lines += [_told_meeting(special, each) for each in special.meetings]
    return [*lines, f"special points: {special.searched}"]


def _told_meeting(special: SpecialCurves, meeting: Meeting) -> str:
    first, second = (special.curves[number] for number in meeting.curves)
    place, other = first.sides[0].places
    at = f"{place} = {meeting.values[0]:.6g} and {other} = {meeting.values[1]:.6g}"
    how = f"meets {second.name}, where one of them ends" if meeting.ends else f"crosses {second.name}"
    return f"{first.name} {how}, near {at}"


def _ranges(result: MotionMap) -> list[tuple[str, ...]]:
    units, power = result.outputs, result.measured_in.power
    measures = [
        *((f"{name}, peak to peak", each, units[name]) for name, each in result.peak_to_peak.items()),
        (f"impacts per {result.inputs.counted}", result.impacts, ""),
        ("largest impact speed", result.impact_speed, result.measured_in.speed),
        *(
            (f"{name}, rms acceleration", each, result.acceleration_unit(name))
            for name, each in result.rms_acceleration.items()
        ),
        *((f"{name}, wear power", each, power) for name, each in result.wear_power.items()),
        *((key, each, result.chosen_units[key]) for key, each in result.chosen.items()),
    ]
    return [_range(name, values, unit) for name, values, unit in measures if np.isfinite(values).any()]


def _range(name: str, values: Reals, unit: str) -> tuple[str, ...]:
    numbers = np.nanmin(values), np.nanmedian(values), np.nanmax(values)
    return (name, *(f"{number:.4g}" for number in numbers), unit)


def as_json(result: MotionMap, searched: str, special: SpecialCurves | None = None) -> str:
    """Return a map as JSON: arrays as lists of rows, full precision, SI units; what is not there is null."""
    chosen, units = result.chosen, result.chosen_units
    content: dict[str, Any] = {
        "title": result.inputs.subject.title,
        **picked(result, "places", "values"),
        "settings": asdict(result.inputs.settings),
        "kind": result.kind,
        "period_count": [[count or None for count in row] for row in result.period_count.tolist()],
        "drive_periods": result.periods,
        **picked(result, "motion_count", "largest_multiplier", "lyapunov"),
        "events_per_period": result.events,
        "impacts_per_period": result.impacts,
        "impact_speed": result.impact_speed,
        "outputs": {name: {"peak_to_peak": each} for name, each in result.peak_to_peak.items()},
        "bodies": {name: {"rms_acceleration": each} for name, each in result.rms_acceleration.items()},
        "frictions": {name: {"wear_power": each} for name, each in result.wear_power.items()},
        "measures": {key: {"unit": units[key], "values": each} for key, each in chosen.items()},
        "failures": [
            {"row": row, "column": column, "message": message}
            for (row, column), message in result.failures.items()
        ],
        "passing": result.passing or None,
        "searched": searched,
        "special": None if special is None else _special(special),
    }
    return document(content)


def _special(special: SpecialCurves) -> dict[str, Any]:
    return {
        "curves": [_curve(each) for each in special.curves],
        "meetings": [picked(each, "curves", "values", "ends", "distance") for each in special.meetings],
        "searched": special.searched,
    }


def _curve(curve: SpecialCurve) -> dict[str, Any]:
    return {
        **picked(curve, "kind", "parts"),
        "drive_periods": curve.periods,
        **picked(curve, "values", "residual"),
        "ends": [picked(side, "reason", "message") for side in curve.ends],
    }
