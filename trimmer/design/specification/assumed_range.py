"""How large a number may be that a file calls unknown, as far as the rest of the mechanism says."""

import math

from trimmer.mechanism.coordinates import inertia_of, weights_of_ends
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.waves import reach_of

SHARE_OF_STROKE = 0.1  # Largest gap that is assumed, as a share of the largest stroke of a pin
LARGEST_DAMPING_RATIO = 0.1
"""Largest damping that is assumed, relative to the critical one of its spring and the masses it joins."""


def assumed_range(mechanism: Mechanism, place: tuple[str, ...]) -> tuple[float, float] | None:
    """Return the range of a number that nobody knows, in SI units; None if nothing says how large it is.

    A gap goes up to a tenth of the largest stroke of a pin; a dry friction up to the force that moves the
    lighter of its bodies with that stroke at the drive's frequency; a damping up to a tenth of the critical
    one. Masses, stiffnesses and all else are not guessed.
    """
    section, name, key = place if len(place) == 3 else ("", "", "")
    kind = mechanism.kind_of(section, name) if section else Kind.TRANSLATION
    alike = (pin for each, pin in mechanism.pins.items() if mechanism.kinds[each] is kind)
    stroke = max((reach_of(pin) for pin in alike), default=0.0)
    highest = 0.0
    if key == "gap":
        highest = SHARE_OF_STROKE * 2 * stroke
    elif section == "frictions" and key == "force" and mechanism.frequency is not None:
        mass = min(_masses(mechanism, mechanism.frictions[name].between))
        highest = mass * (2 * math.pi * mechanism.frequency) ** 2 * stroke
    elif key == "damping":
        part = getattr(mechanism, section)[name]
        masses = _masses(mechanism, part.between)
        reduced = 1 / sum(1 / mass for mass in masses)
        highest = LARGEST_DAMPING_RATIO * 2 * math.sqrt(part.stiffness * reduced)
    return (0.0, highest) if highest > 0 else None


def _masses(mechanism: Mechanism, between: tuple[str, str]) -> list[float]:
    """Return what a force on each of two ends moves, kg, or kg m² of rotations; the ground is not moved."""
    weights, inertia = weights_of_ends(mechanism), inertia_of(mechanism)
    moved = (weights[end] @ inertia.accelerations(weights[end]) for end in between)
    return [1 / float(each) for each in moved if each > 0]
