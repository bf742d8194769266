"""Harmonic balance of the thesis's loop with more and more harmonics, against its exact limit cycles."""

from typing import Any, Final

from report.numbers.future_work.kept import KeptAnswer
from trimmer import (
    FrictionBacklash,
    InertiaBacklash,
    TrimmerParameters,
    limit_cycles,
    multi_harmonic_balance,
    periodic_orbits,
    pin_model,
)
from trimmer.linear import InputChannels

ORDERS: Final = (1, 3, 5, 7, 9, 11, 15, 21, 31, 41)
ELEMENTS: Final = {"friction": FrictionBacklash(1.0), "inertia": InertiaBacklash(1.0)}
"""The two limits of the load, with a gap of one metre."""


def rows_of(name: str, orders: tuple[int, ...] = ORDERS) -> list[list[Any]]:
    """Return play, stability, order, frequency (Hz) and amplitude in gaps; order 0 is the exact orbit."""
    system = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
    element, rows = ELEMENTS[name], []
    predicted = limit_cycles(system, element)
    orbits = periodic_orbits(system, element, predicted)
    for cycle in predicted:
        orbit = min(orbits, key=lambda each: abs(each.frequency - cycle.frequency))
        rows.append([name, cycle.stable, 0, orbit.frequency, orbit.amplitude])
        for found in multi_harmonic_balance(system, element, cycle, orders=orders):
            rows.append([name, cycle.stable, found.order, found.frequency, found.amplitude])
    return rows


HARMONICS: Final = KeptAnswer(
    "harmonics",
    [list(ORDERS), list(ELEMENTS)],
    lambda: {"solutions": [row for name in ELEMENTS for row in rows_of(name)]},
)
