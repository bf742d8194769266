"""What drives a mechanism beside its frequency, and after how many periods of that all returns together."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Force, Pin
from trimmer.mechanism.waves import Wave, is_driven, waves_of

RETURNS = 64
"""Periods of the frequency after which all drives return together at most."""
A_TURN = 1e-9
"""Share of a turn by which a phase may miss its return."""


class Drives(NamedTuple):
    """What drives a mechanism beside its frequency.

    Attributes:
        periods: Periods of the frequency after which all that is used returns; 0 if that takes too long.
        ratios: Frequency of each that is used over that of the mechanism; a fraction, if all returns.
    """

    periods: int
    ratios: Mapping[str, float]


def drives_of(mechanism: Mechanism) -> Drives:
    """Return what drives a mechanism beside its frequency."""
    parts: list[Pin | Force] = [*mechanism.pins.values(), *mechanism.forces.values()]
    used = dict.fromkeys(part.drive for part in parts if part.drive is not None and is_driven(part))
    if not used or mechanism.frequency is None:
        return Drives(1, {})
    ratios = {name: mechanism.drives[name] / mechanism.frequency for name in used if name is not None}
    for periods in range(1, RETURNS + 1):
        turns = {name: round(periods * ratio) for name, ratio in ratios.items()}
        if all(turns[name] and abs(periods * each - turns[name]) <= A_TURN for name, each in ratios.items()):
            return Drives(periods, {name: each / periods for name, each in turns.items()})
    return Drives(0, ratios)


def waves_in(mechanism: Mechanism, part: Pin | Force) -> tuple[Wave, ...]:
    """Return the waves of a pin, m, or of a force, N, in orders of the frequency of the mechanism."""
    omega = 2 * np.pi * (mechanism.frequency or 0.0)
    if part.drive is None or not is_driven(part):
        return waves_of(part, omega)
    ratio = drives_of(mechanism).ratios[part.drive]
    return tuple(each._replace(order=ratio * each.order) for each in waves_of(part, ratio * omega))


def apart(orders: tuple[float, ...], ratios: tuple[float, ...]) -> list[tuple[float, list[int]]]:
    """Return the drives by their ratios, 1 for the frequency, each with the places of its orders."""
    found: dict[float, list[int]] = {1.0: [], **{each: [] for each in ratios}}
    for place, order in enumerate(orders):
        found[min(found, key=lambda ratio: abs(order / ratio - round(order / ratio)))].append(place)
    return [(ratio, places) for ratio, places in found.items() if places]


def told_of_drives(periods: int) -> str:
    """Say that drives do not return together."""
    return f"its drives do not return together within {periods} periods of its frequency"
