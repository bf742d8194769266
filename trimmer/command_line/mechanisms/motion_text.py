"""A simulated motion of a mechanism, as text for people and as JSON for machines."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from trimmer.command_line.json_values import document, picked
from trimmer.command_line.mechanisms.respond_text import rest_lines
from trimmer.command_line.motion_summary import amplitudes, last_times, summary_lines
from trimmer.command_line.table import or_rounding, table
from trimmer.mechanism.cut_waveforms import told_of_waveforms, waveforms_left_out
from trimmer.messages import listed
from trimmer.motion.units import with_unit
from trimmer.response.results.response_json import rest_json

if TYPE_CHECKING:
    from trimmer.response import MechanismEnergy, MechanismMotion

_WORKS = ("pins", "forces", "controllers")
_LOSSES = {
    "dampers": "lost in damper",
    "contacts": "lost in contact",
    "frictions": "lost in friction",
    "walls": "lost at wall",
    "structures": "lost in structure",
}


def as_text(motion: MechanismMotion) -> str:
    """Return a summary of a motion: outcome, events of each part, outputs at the end, energy."""
    events = ((event.part, event.kind.value) for event in motion.events)
    lines = summary_lines(motion.duration, motion.message, events)
    if motion.chatter_completed:
        lines.append("An infinite chatter on a wall was completed, once next to no time was left of it.")
    if motion.walls_together:
        lines.append("Walls acted together, without rebound, since their impacts would not have ended.")
    units = motion.signals if motion.mechanism.outputs else {}
    alike = len(set(units.values())) <= 1
    rows = [
        (name if alike else with_unit(name, units[name]), f"{v:.6g}") for name, v in _ranges(motion).items()
    ]
    lines += table(("output", next(iter(units.values()), "m") if alike else ""), rows)
    lines += _closings(motion)
    if motion.rest is not None:
        lines += ["It is at rest:", *rest_lines(motion.rest)]
    return "\n".join([*lines, *told_of_waveforms(motion.mechanism), *_energy_text(motion.energy)])


def as_json(motion: MechanismMotion) -> str:
    """Return a motion as JSON: outcome, every event, outputs at the end, energy; SI units."""
    return document(motion_json(motion))


def motion_json(motion: MechanismMotion) -> dict[str, Any]:
    """Return a motion as a dictionary that JSON can hold."""
    content: dict[str, Any] = {
        "duration": motion.duration,
        **picked(motion, "outcome", "success", "message"),
        "events": [
            picked(each, "time", "kind", "part", "speed", "rate", "impulse") for each in motion.events
        ],
        "final": motion.final,
        "closings": {name: vars(each) for name, each in motion.closings.items()},
        "rest": None if motion.rest is None else rest_json(motion.rest),
        "last_amplitudes": _ranges(motion),
        "energy": picked(motion.energy, "kinetic", "stored", *_WORKS, *_LOSSES, "residual"),
        **picked(motion, "undetermined_frictions", "chatter_completed", "walls_together"),
    }
    if shares := waveforms_left_out(motion.mechanism):
        content["waveforms_left_out"] = shares
    return content


def _closings(motion: MechanismMotion) -> list[str]:
    """Return how contacts close, as of a machine that switches; nothing where it may go on for ever."""
    driven = motion.mechanism.frequency is not None or motion.mechanism.controllers
    if (driven and motion.rest is None) or not motion.closings:
        return []
    units = {name: motion.flow.units_of_part(name) for name in motion.closings}
    rows = [
        (
            name,
            f"{each.closing_time:.6g}",
            str(each.touches),
            f"{each.bounce_time:.6g}",
            f"{each.impact_speed:.6g} {units[name].speed}",
            f"{'closed' if each.closed else 'open'}, {each.force:.6g} {units[name].force}",
        )
        for name, each in motion.closings.items()
    ]
    return table(("contact", "closes at, s", "touches", "bounces for, s", "impact speed", "at the end"), rows)


def _ranges(motion: MechanismMotion) -> dict[str, float]:
    times = last_times(motion.duration)
    return amplitudes({name: motion.output(name, times) for name in motion.mechanism.outputs})


def _energy_text(energy: MechanismEnergy) -> list[str]:
    told = {**dict.fromkeys(_WORKS, "work of"), **_LOSSES}
    terms = [
        (f"{what} {name}", value)
        for key, what in told.items()
        for name, value in getattr(energy, key).items()
    ]
    gained = energy.kinetic[1] + energy.stored[1] - energy.kinetic[0] - energy.stored[0]
    rows = [*terms, ("gained by bodies and springs", gained)]
    closing = f"It closes to {or_rounding(energy.residual, '.1e')} of its largest term."
    if energy.undetermined:
        closing += (
            f" While {listed(energy.undetermined)} stick, the motion gives only the sum of their forces; the "
            "work of each pin is that of the share with the least squares relative to their limits."
        )
    return [
        "Energy over the whole motion:",
        *table(("", "J"), [(name, f"{value:.6g}") for name, value in rows]),
        closing,
    ]
