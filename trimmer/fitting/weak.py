"""What a measurement cannot tell apart: changes of the numbers that hardly change the fit."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.fitting.unknowns import Unknown
from trimmer.messages import listed

TOLD = math.log(1.1)  # Change of a coordinate, 10 % of the number, that a measurement should tell from none
PART = 0.15  # Share of the largest change below which a number does not take part in a combination


@dataclass(frozen=True)
class WeakDirection:
    """A change of numbers that changes the fit by less than the noise.

    Attributes:
        places: Dotted places of the numbers that take part, largest change first.
        changes: By how much each coordinate changes, that of the largest change by ln 1.1.
        chi_square: By how much that changes chi-square.
        message: The same as a sentence without a full stop.
    """

    places: tuple[str, ...]
    changes: tuple[float, ...]
    chi_square: float
    message: str


def weak_directions(
    unknowns: Sequence[Unknown], jacobian: Reals, allowed: float
) -> tuple[WeakDirection, ...]:
    """Return the changes of numbers by 10 % that change chi-square by less than the noise does.

    They are singular vectors of the whitened derivative, (residuals, unknowns), in coordinates in which
    10 % of each number count alike; least chi-square first.
    """
    _, sizes, directions = np.linalg.svd(jacobian, full_matrices=False)
    found = []
    for size, direction in zip(sizes[::-1], directions[::-1], strict=True):
        scaled = TOLD * direction / direction[np.argmax(abs(direction))]
        changed = float(size * np.linalg.norm(scaled)) ** 2
        if changed < allowed:
            found.append(_described(unknowns, scaled, changed))
    return tuple(found)


def _described(unknowns: Sequence[Unknown], scaled: Reals, changed: float) -> WeakDirection:
    taking = [int(place) for place in np.argsort(-abs(scaled)) if abs(scaled[place]) >= PART * TOLD]
    places = tuple(unknowns[place].place for place in taking)
    changes = tuple(float(scaled[place]) for place in taking)
    names = [unknowns[place].short for place in taking]
    if len(taking) == 1:
        moved = [_change(unknowns[taking[0]], changes[0], names[0])]
        told = f"the measurement says little of the {names[0]}: {moved[0]}"
        told += " changes the fit by less than the noise"
        return WeakDirection(places, changes, changed, told)
    moved = [
        _change(unknowns[place], by, name) for place, by, name in zip(taking, changes, names, strict=True)
    ]
    told = f"{listed(names)} cannot be told apart: {listed(moved)} changes the fit by less than the noise"
    return WeakDirection(places, changes, changed, told)


def _change(unknown: Unknown, by: float, name: str) -> str:
    verb = "raising" if by > 0 else "lowering"
    if unknown.positive:
        return f"{verb} the {name} by {100 * abs(math.expm1(by)):.2g} %"
    return f"{verb} the {name} by {abs(by) * unknown.scale:.2g} {unknown.unit}".rstrip()
