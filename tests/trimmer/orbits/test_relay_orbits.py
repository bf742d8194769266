"""Orbits of a relay that are known in closed form, and which loops have the equation that finds them all."""

import math

import control
import numpy as np
import pytest

from trimmer import OrbitSearch, Preload, Relay, Saturation, ViscousFriction, periodic_orbits
from trimmer.elements import CoulombFriction, DeadZone, Element, FrictionBacklash

NEVER = OrbitSearch("never")
GAIN, RATE, LEVEL, THRESHOLD = 4.0, 0.7, 1.5, 0.9
LAG = control.ss([[-RATE]], [[GAIN]], [[0.5]], [[0.0]])  # x' = -0.7 x + 4 u, of which half is the output
REST, AT_SWITCH = GAIN * LEVEL / RATE, THRESHOLD / 0.5
HALF = math.log((REST + AT_SWITCH) / (REST - AT_SWITCH)) / RATE


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_hysteresis_around_a_lag_of_first_order() -> None:
    orbits = periodic_orbits(LAG, Relay(LEVEL, THRESHOLD), [], NEVER)
    (orbit,), search = orbits, orbits.search.relay
    assert orbit.period == pytest.approx(2 * HALF, rel=1e-11)
    assert orbit.amplitude == pytest.approx(THRESHOLD, rel=1e-11)
    assert np.diff(orbit.switching_times) == pytest.approx([HALF], rel=1e-10)
    assert (orbit.prediction, orbit.success) == (None, True)
    assert (search.zeros, search.undecided, search.grid) == (1, (), 0)
    # The output is a square wave, 6/(pi n) at odd n, here from the middle of its positive half on.
    numbers = np.arange(1, 16)
    square = np.where(numbers % 2, 6.0 / np.pi / numbers, 0.0)
    through = -square * 0.5 * GAIN / (1j * numbers * orbit.omega + RATE)
    turned = through * np.exp(
        1j * numbers * (math.pi / 2 - orbit.omega * (orbit.switching_times[0] - HALF / 2))
    )
    np.testing.assert_allclose(orbit.harmonics, turned, atol=1e-10)
    nothing = periodic_orbits(
        LAG, Relay(LEVEL, THRESHOLD), [], OrbitSearch("never", half_periods=(1.1 * HALF, 9))
    )
    assert (len(nothing), nothing.search.relay.zeros) == (0, 0)


@pytest.mark.parametrize(
    ("element", "grid"),
    [
        (Relay(1.0), 48),
        (Relay(1.0, 0.03), 0),
        (-CoulombFriction(1.0), 48),
        (0.2 * ViscousFriction(2.0) + Relay(1.0), 48),
        (DeadZone(1.0, 2.0) + Saturation(1.0, 2.0) + Relay(1.0), None),
        (Relay(1.0) + Relay(2.0), None),
        (Relay(1.0) + Relay(2.0, 0.3), None),
        (Relay(1.0, 0.3, 1.7), None),
        (FrictionBacklash(1.0), None),
        (ViscousFriction(1.0), None),
    ],
)
def test_one_relay_beside_what_is_linear_has_an_equation(element: Element, grid: int | None) -> None:
    plant = control.tf([1.0], [1.0, 3.0, 2.0, 0.0])
    relay = periodic_orbits(plant, element, [], OrbitSearch("never", half_periods=(1.0, 4.0))).search.relay
    assert (None if relay is None else relay.grid) == grid


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_a_preload_at_the_critical_gain_has_no_orbit() -> None:
    """Closed by the slope 1, it has the poles -2 and ±i; N is more than that slope at any amplitude."""
    found = periodic_orbits(control.tf([2.0], [1.0, 2.0, 1.0, 0.0]), Preload(0.3, 1.0), [], NEVER)
    turns = [
        part[0] <= math.pi * (2 * k + 1) <= part[1] for k, part in enumerate(found.search.relay.undecided)
    ]
    assert (len(found), turns) == (0, [True] * 25)


OMEGA = 691.0
INTERVALS = {
    "poles -2 and -50, zero -26": (([[-2, 0], [0, -50]], [1, 1], [1, 1]), (0.01 / 50, 40 / 2)),
    "an undamped mode": (([[0, 1], [-(OMEGA**2), 0]], [0, 1], [1, 0]), (0.01 / OMEGA, 50 * np.pi / OMEGA)),
    "a lightly damped mode": (
        ([[0, 1], [-400.25, -1]], [0, 1], [1, 0]),
        (0.01 / math.sqrt(400.25), 50 * np.pi / math.sqrt(400.25)),
    ),
    "an undamped mode beside a fast pole": (
        ([[0, 3, 0], [-3, 0, 0], [0, 0, -20]], [0, 1, 1], [1, 0, 1]),
        (0.01 / 20, 50 * np.pi / 3),
    ),
    "a zero at -500": (([[-1, 0], [0, -2]], [1, 1], [499, -498]), (0.01 / 500, 40.0)),
    "a zero at -5000, too far": (([[-1, 0], [0, -2]], [1, 1], [4999, -4998]), (0.01 / 2, 40.0)),
    "an integrator beside a pole": (([[0, 0], [0, -4]], [1, 1], [1, 0]), (0.01 / 4, 10.0)),
    "two integrators and a zero at -3": (([[0, 1], [0, 0]], [0, 1], [3, 1]), (0.01 / 3, 40 / 3)),
}


@pytest.mark.parametrize("name", INTERVALS)
def test_the_interval_that_is_searched_spans_the_time_constants(name: str) -> None:
    (A, b, row), interval = INTERVALS[name]
    system = control.ss(A, np.transpose([b]), -np.array([row], dtype=float), 0)
    search = periodic_orbits(system, Relay(1.0), [], NEVER).search.relay
    assert search.half_periods == pytest.approx(interval, rel=1e-9)
