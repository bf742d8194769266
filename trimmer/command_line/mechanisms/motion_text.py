"""A simulated motion of a mechanism, as text for people and as JSON for machines."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from trimmer.command_line.json_values import document
from trimmer.command_line.mechanisms.respond_text import rest_lines
from trimmer.command_line.motion_summary import amplitudes, last_times, summary_lines
from trimmer.command_line.table import table
from trimmer.mechanism.cut_waveforms import told_of_waveforms, waveforms_left_out
from trimmer.messages import listed
from trimmer.motion.units import with_unit
from trimmer.response.response_json import rest_json
from trimmer.showing.rounding import or_rounding

if TYPE_CHECKING:
    from trimmer.response.energy import MechanismEnergy
    from trimmer.response.motion import MechanismEvent, MechanismMotion


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
    energy = motion.energy
    content: dict[str, Any] = {
        "duration": motion.duration,
        "outcome": motion.outcome.word,
        "success": motion.success,
        "message": motion.message,
        "events": [_event(each) for each in motion.events],
        "final": {name: list(state) for name, state in motion.final.items()},
        "closings": {name: vars(each) for name, each in motion.closings.items()},
        "rest": None if motion.rest is None else rest_json(motion.rest),
        "last_amplitudes": _ranges(motion),
        "energy": {
            "kinetic": list(energy.kinetic),
            "stored": list(energy.stored),
            "pins": dict(energy.pins),
            "forces": dict(energy.forces),
            "controllers": dict(energy.controllers),
            "dampers": dict(energy.dampers),
            "contacts": dict(energy.contacts),
            "frictions": dict(energy.frictions),
            "walls": dict(energy.walls),
            "structures": dict(energy.structures),
            "residual": energy.residual,
        },
        "undetermined_frictions": list(motion.undetermined_frictions),
        "chatter_completed": motion.chatter_completed,
        "walls_together": motion.walls_together,
    }
    if shares := waveforms_left_out(motion.mechanism):
        content["waveforms_left_out"] = shares
    return content


def _event(event: MechanismEvent) -> dict[str, Any]:
    return {
        "time": event.time,
        "kind": event.kind.word,
        "part": event.part,
        "speed": event.speed,
        "rate": event.rate,
        "impulse": event.impulse,
    }


def _closings(motion: MechanismMotion) -> list[str]:
    """Return how contacts close, as of a machine that switches; nothing where a drive goes on for ever."""
    if (motion.mechanism.frequency is not None and motion.rest is None) or not motion.closings:
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
    given = (energy.pins, energy.forces, energy.controllers)
    works = [(f"work of {name}", value) for works in given for name, value in works.items()]
    losses = [
        *((f"lost in damper {name}", value) for name, value in energy.dampers.items()),
        *((f"lost in contact {name}", value) for name, value in energy.contacts.items()),
        *((f"lost in friction {name}", value) for name, value in energy.frictions.items()),
        *((f"lost at wall {name}", value) for name, value in energy.walls.items()),
        *((f"lost in structure {name}", value) for name, value in energy.structures.items()),
    ]
    gained = energy.kinetic[1] + energy.stored[1] - energy.kinetic[0] - energy.stored[0]
    rows = [*works, *losses, ("gained by bodies and springs", gained)]
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
