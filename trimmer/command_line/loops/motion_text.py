"""A simulated motion as text for people and as JSON for machines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.motion_summary import SHARE, amplitudes, last_times, summary_lines
from trimmer.loops.components.switched_component import EventKind

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.loops.motion import LoopMotion

REPEATING = (EventKind.IMPACT, EventKind.SWITCH)
ONE_SIDE = ("upper contact", "plus")


def as_text(motion: LoopMotion) -> str:
    """Return a summary of a motion: outcome, number of events of each kind, amplitudes (m) at the end."""
    events = ((event.component, event.kind.value) for event in motion.events)
    lines = summary_lines(motion.duration, motion.outcome.value, events)
    lines += [f"  {name:<8}{value:.6g} m" for name, value in _ranges(motion).items()]
    frequency = _frequency(motion)
    if frequency is not None:
        lines.append(f"  impacts on one side, or reversals in one direction: {frequency:.6g} per second")
    return "\n".join(lines)


def as_json(motion: LoopMotion) -> str:
    """Return a motion as JSON: outcome, every event, and the amplitudes at the end; SI units."""
    content = {
        "duration": motion.duration,
        "outcome": motion.outcome.name.lower(),
        **picked(motion, "success", "message", "touches"),
        "events": [
            {"time": each.time, "kind": each.kind.value, **picked(each, "component", "mode")}
            for each in motion.events
        ],
        "last_amplitudes": _ranges(motion),
        "last_frequency": _frequency(motion),
    }
    return document(content)


def displacements(motion: LoopMotion, times: Reals) -> dict[str, Reals]:
    """Return the output, and input and output of the backlash, m, by their names."""
    return {
        motion.loop.model.output_labels[0]: motion.output(times),
        "pin": motion.element_input(times),
        "bridge": motion.element_output(times),
    }


def _ranges(motion: LoopMotion) -> dict[str, float]:
    return amplitudes(displacements(motion, last_times(motion.duration)))


def _frequency(motion: LoopMotion) -> float | None:
    """Return how often an event repeats at the end, Hz; None if a drive sets it or it happens once.

    Impacts on one side of the gap and reversals in one direction happen once in a simple period.
    """
    if motion.loop.modes.system.interconnection.drives:
        return None
    begin = (1.0 - SHARE) * motion.duration
    times = [
        event.time
        for event in motion.events
        if event.time >= begin and event.kind in REPEATING and event.mode in ONE_SIDE
    ]
    return None if len(times) < 2 or times[0] == times[-1] else (len(times) - 1) / (times[-1] - times[0])
