"""Stable orbits that harmonic balance does not predict, or that its first harmonic does not lead to."""

from __future__ import annotations

import control
import numpy as np
import pytest
import scipy.signal

from tests.quick import quick
from tests.trimmer.loops.reference.peers import Course, Plant, play, switch
from trimmer import InertiaBacklash, Relay, periodic_orbits
from trimmer.elements import Element

LOAD = ([20, 8.5], [1, 4.7, 0], InertiaBacklash(0.64), [0.3, -0.7])
GROWING = ([-63.2], [1, 0.386, 3.45, 0.37, 1.94], Relay(2.5), [300, 100, 50, 10])
SECOND = ([0.781, 1], [1, 1.467, 8.244, 9, 3.618, 1.247], Relay(2.09), [3, -3, 3, 3, 3])


def system_of(numerator: list[float], denominator: list[float]) -> control.StateSpace:
    return control.ss(*scipy.signal.tf2ss(numerator, denominator))


def followed(system: control.StateSpace, element: Element, start: list[float], end: float) -> Course:
    """Follow a motion by SciPy's `solve_ivp`, from the laws of the element alone."""
    plant = Plant(system.A, system.B[:, 0], system.C[0])
    state = np.array(start, dtype=float)
    if isinstance(element, Relay):
        return switch(plant, element.level, False, state, end)
    assert isinstance(element, InertiaBacklash)
    return play(plant, element.gap, np.inf, state, end)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("loop", "duration", "amplitude", "precision"),
    quick([(LOAD, 45.0, 0.15034, 3e-4), (GROWING, 240.0, 247.1, 2e-3), (SECOND, 120.0, 0.6931, 1e-3)], 2),
    ids=["load that bounces", "relay without prediction", "second orbit of a relay"],
)
def test_a_stable_orbit_that_a_long_motion_leads_to_is_found(
    loop: tuple[list[float], list[float], Element, list[float]],
    duration: float,
    amplitude: float,
    precision: float,
) -> None:
    numerator, denominator, element, start = loop
    system = system_of(numerator, denominator)
    course = followed(system, element, start, duration)
    times = np.linspace(duration - 12.0, duration, 4001)
    inputs = [-float(system.C[0] @ course.state(time, len(system.A))) for time in times]
    assert float(np.ptp(inputs)) / 2 == pytest.approx(amplitude, rel=precision)
    found = [orbit.amplitude for orbit in periodic_orbits(system, element) if orbit.stable]
    assert min(abs(each / amplitude - 1) for each in [*found, np.inf]) < 3e-4
