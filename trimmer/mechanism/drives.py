"""What drives a mechanism beside its frequency, and after how many periods of that all returns together."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from trimmer.mechanism.controls.references import SineReference
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Force, Pin
from trimmer.mechanism.waves import Wave, is_driven, waves_of
from trimmer.ties import MOST_TURNS, common_return

RETURNS = MOST_TURNS  # Periods of the frequency after which all drives return together at most


def drive_frequency(mechanism: Mechanism) -> float | None:
    """Return the frequency of the drive, Hz; None where nothing drives.

    It is its own, or else that of the first sine that is followed, or else that of the slowest samples.
    """
    if mechanism.frequency is not None:
        return mechanism.frequency
    slowest = min(clocks_in(mechanism).values(), default=None)
    return next((each.frequency for each in sines_in(mechanism).values()), slowest)


def clocks_in(mechanism: Mechanism) -> dict[str, float]:
    """Return the frequencies at which controllers sample, Hz, by name."""
    samples = {name: each.sample for name, each in mechanism.controllers.items()}
    return {name: 1.0 / sample for name, sample in samples.items() if sample is not None}


def sines_in(mechanism: Mechanism) -> dict[str, SineReference]:
    """Return the sines that controllers follow, by name."""
    names = (each.reference for each in mechanism.controllers.values())
    followed = {name: mechanism.references[name] for name in names if name is not None}
    return {name: each for name, each in followed.items() if isinstance(each, SineReference)}


class Drives(NamedTuple):
    """What drives a mechanism beside its frequency."""

    periods: int  # Periods of the frequency after which all that is used returns; 0 if that takes too long
    # Frequency of each that is used over that of the mechanism; a fraction, if all returns
    ratios: Mapping[str, float]


def drives_of(mechanism: Mechanism) -> Drives:
    """Return what drives a mechanism beside its frequency."""
    parts: list[Pin | Force] = [*mechanism.pins.values(), *mechanism.forces.values()]
    used = dict.fromkeys(part.drive for part in parts if part.drive is not None and is_driven(part))
    frequency = drive_frequency(mechanism)
    if frequency is None:
        return Drives(1, {})
    ratios = {name: mechanism.drives[name] / frequency for name in used}
    sines = {_of_sine(name): each.frequency for name, each in sines_in(mechanism).items()}
    clocks = {f"controllers.{name}": each for name, each in clocks_in(mechanism).items()}
    ratios |= {name: each / frequency for name, each in (sines | clocks).items() if each != frequency}
    if not ratios:
        return Drives(1, {})
    if (found := common_return(list(ratios.values()))) is None:
        return Drives(0, ratios)
    periods, turns = found
    return Drives(periods, {name: each / periods for name, each in zip(ratios, turns, strict=True)})


def waves_of_sine(mechanism: Mechanism, name: str) -> tuple[Wave, ...]:
    """Return the wave of a sine that is followed, in orders of the drive's frequency."""
    sine = sines_in(mechanism)[name]
    order = drives_of(mechanism).ratios.get(_of_sine(name), 1.0)
    return (Wave(int(order) if float(order).is_integer() else order, sine.sine, sine.phase),)


def _of_sine(name: str) -> str:
    """Return the name of a sine among drives."""
    return f"references.{name}"


def waves_in(mechanism: Mechanism, part: Pin | Force) -> tuple[Wave, ...]:
    """Return the waves of a pin, m, or of a force, N, in orders of the frequency of the drive."""
    omega = 2 * np.pi * (drive_frequency(mechanism) or 0.0)
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
