"""Outputs of every kind as rows of one mode."""

import numpy as np

from tests.mechanisms.dynamics import Mode, System
from trimmer import Friction, Link, Output
from trimmer.mechanism import OutputKind


def output_row(system: System, output: Output, mode: Mode) -> np.ndarray:
    """Return an output as a row; a force is positive where it pulls its ends together."""
    rows, dynamics = system.rows, system.dynamics(mode)
    if output.kind is OutputKind.FORCE:
        return force_row(system, output.part, mode)
    if output.kind is OutputKind.DISPLACEMENT:
        return sum(weight * rows.displacement(end) for end, weight in output.weights.items())
    velocity = sum(weight * rows.velocity(end) for end, weight in output.weights.items())
    return velocity if output.kind is OutputKind.VELOCITY else velocity @ dynamics.rates


def force_row(system: System, part: str, mode: Mode) -> np.ndarray:
    if part in system.mechanism.links:
        link = system.mechanism.links[part]
        stretch, rate = system.rows.distance(link.between), system.rows.rate(link.between)
        return link.stiffness * stretch + link.damping * rate + curve_row(system, link, mode)
    for contact, its in zip(system.contacts, mode.contacts, strict=True):
        if contact.name == part:
            return contact.force(its)
    (place,) = (place for place, each in enumerate(system.frictions) if each.name == part)
    smooth = curve_row(system, system.frictions[place].part, mode)
    return smooth - system.dynamics(mode).friction_forces[place]


def curve_row(system: System, part: Link | Friction, mode: Mode) -> np.ndarray:
    pairs = zip(system.curves, mode.curves, strict=True)
    return sum((each.tension(its) for each, its in pairs if each.part is part), system.rows.constant(0.0))
