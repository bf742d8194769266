"""The bounds of backlash's slopes against what they are made of, by quadrature and on fine grids."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from trimmer.elements.backlashes.backlash_bounds import LARGEST_LAG, BacklashBox

GAMMAS = [(0.01, 0.012), (0.4, 0.5), (1.0, 1.0), (3.0, 4.0), (80.0, 90.0), (0.05, 2.0), (1.0, 100.0)]
FLIGHTS = [(0.0, 0.001), (0.1, 0.4), (1.0, 1.2), (2.5, 3.1)]
"""From the separation at the earliest and the latest, both counted from that of the highest gamma."""


def box(gammas: tuple[float, float], flights: tuple[float, float]) -> BacklashBox:
    separation = math.atan(1.0 / gammas[1])
    angles = (separation + flight for flight in flights)
    return BacklashBox(*(np.array([value]) for value in (*gammas, *angles)))


def lag(x: float) -> float:
    """h(x) = 1 - (1 + x) exp(-x), without loss of digits for small x."""
    return x**2 / 2 - x**3 / 3 if x < 1e-4 else 1.0 - (1.0 + x) * math.exp(-x)


def test_the_largest_lag_is_rounded_up() -> None:
    found = minimize_scalar(lambda x: -lag(x) / x, bounds=(1.0, 3.0), method="bounded")
    assert found.x == pytest.approx(1.7933, abs=1e-4)
    assert 0.0 <= LARGEST_LAG + found.fun < 2e-5


@pytest.mark.parametrize("gammas", GAMMAS)
@pytest.mark.parametrize("flights", FLIGHTS)
def test_the_slope_by_gamma_is_bounded_by_the_smaller_of_two_integrals(
    gammas: tuple[float, float], flights: tuple[float, float]
) -> None:
    """(2/pi) ∫ sin θ_s s² f ds with the lowest gamma in θ_s and the highest in f, or LARGEST_LAG s cos θ."""
    lowest, highest = gammas
    sine, cosine = 1.0 / math.hypot(1.0, lowest), highest / math.hypot(1.0, highest)
    falling = (
        sine * quad(lambda s: lag(s / highest) * highest**2, 0.0, flights[1], epsabs=0.0, epsrel=1e-11)[0]
    )
    expected = 2.0 / math.pi * min(falling, LARGEST_LAG * cosine * flights[1] ** 2 / 2.0)
    found = float(box(gammas, flights).slope_by_log_gamma()[0])
    # Below a hundredth of gamma f is taken as 1/2, which is at most 2/3 of a hundredth too much.
    # The flight is taken to be 1e-9 longer than it was computed.
    allowed = 1e-2 if flights[1] < 0.01 * highest else 2e-9 + 4e-9 / flights[1]
    assert found / expected * (1.0 + 1e-5 * (flights[1] < 0.01)) >= 1.0
    assert found / expected < 1.0 + allowed


@pytest.mark.parametrize("gammas", GAMMAS)
@pytest.mark.parametrize("flights", [*FLIGHTS, (0.2, 0.2), (-0.5, 3.14)])
def test_the_slope_by_the_ratio_changes_by_the_chord_between_two_phases(
    gammas: tuple[float, float], flights: tuple[float, float]
) -> None:
    """It is (2/pi) exp(-jθ): from θ to θ' that is a chord, and for more than half a turn the diameter."""
    turn = flights[1] - flights[0]
    chord = abs(np.exp(1j * turn) - 1.0) if turn < math.pi else 2.0
    found = float(box(gammas, flights).change_of_slope_by_ratio()[0])
    assert found == pytest.approx(2.0 / math.pi * chord, rel=3e-9, abs=2e-9)
    assert found >= 2.0 / math.pi * chord


@pytest.mark.parametrize("gammas", GAMMAS)
@pytest.mark.parametrize("flights", FLIGHTS)
def test_the_slope_by_gamma_changes_by_no_more_than_its_parts(
    gammas: tuple[float, float], flights: tuple[float, float]
) -> None:
    """max p and max |dp/d(ln gamma)| on a grid of the box; the bound may exceed them, but not by much."""
    gamma = np.linspace(*gammas, 41)[:, None]
    x = np.linspace(0.0, flights[1], 801) / gamma
    cosine, sine_squared = gamma / np.hypot(1.0, gamma), 1.0 / (1.0 + gamma**2)
    h = np.where(x < 1e-4, x**2 / 2 - x**3 / 3, 1.0 - (1.0 + x) * np.exp(-x))
    p = gamma * cosine * h
    by_gamma = gamma * cosine * ((1.0 + sine_squared) * h + (sine_squared - x) * x * np.exp(-x))
    parts = p.max() * (flights[1] - flights[0])
    parts += np.abs(by_gamma).max() * flights[1] * math.log(gammas[1] / gammas[0])
    found = float(box(gammas, flights).change_of_slope_by_log_gamma()[0])
    assert found / (2.0 / math.pi * parts) >= 1.0 - 1e-3 * (flights[1] < 0.01)
    if gammas[1] < 1.5 * gammas[0]:
        assert found / (2.0 / math.pi * parts) < 8.0


@pytest.mark.parametrize(
    ("gamma", "decay", "lag", "drift"),
    [
        (0.01, 0.2, 0.02, 0.2 / 1.0001),
        (0.01, 0.5, 0.125, math.exp(-1.0) / 1.0001),
        (0.01, 10.0, 1.0, 4.0 * math.exp(-2.0)),
        (0.1, 2.0, 2.0 * LARGEST_LAG, 4.0 * math.exp(-2.0)),
        (3.0, 0.5, 0.125, 0.25),
    ],
)
def test_the_change_by_gamma_has_the_bound_that_its_docstring_derives(
    gamma: float, decay: float, lag: float, drift: float
) -> None:
    """Of h <= min(1, L x, x²/2) and of sin² θ_s x exp(-x) or x² exp(-x), whichever is larger."""
    highest, flight = 1.2 * gamma, decay * gamma
    separation = math.atan(1.0 / highest)
    latest, earliest = separation + flight, separation + 0.3 * flight
    found = BacklashBox(*(np.array([each]) for each in (gamma, highest, earliest, latest)))
    sine_squared = 1.0 / (1.0 + gamma**2)
    change = lag * 0.7 * flight + ((1.0 + sine_squared) * lag + drift) * flight * math.log(1.2)
    expected = 2.0 / math.pi * highest**2 / math.hypot(1.0, highest) * change
    assert found.change_of_slope_by_log_gamma() == pytest.approx([expected], rel=1e-6)


def test_outside_of_the_domain_the_flight_is_the_longest_there_may_be() -> None:
    """Without a latest impact the flight is half a turn from the separation of the lowest gamma."""
    whole = BacklashBox(*(np.array([each]) for each in (0.5, 0.8, 1.2, np.nan)))
    longest = BacklashBox(*(np.array([each]) for each in (0.5, 0.8, 1.2, math.atan(2.0) + math.pi)))
    assert whole.slope_by_log_gamma() == pytest.approx(longest.slope_by_log_gamma(), rel=1e-12)
    assert whole.change_of_slope_by_log_gamma() == pytest.approx(
        longest.change_of_slope_by_log_gamma(), rel=1e-12
    )
    # Without an earliest one either it may begin at once, at the separation of the highest gamma.
    nothing = BacklashBox(*(np.array([each]) for each in (0.5, 0.8, np.nan, np.nan)))
    at_once = BacklashBox(
        *(np.array([each]) for each in (0.5, 0.8, math.atan(1.25), math.atan(2.0) + math.pi))
    )
    assert nothing.change_of_slope_by_log_gamma() == pytest.approx(
        at_once.change_of_slope_by_log_gamma(), rel=1e-12
    )
    assert nothing.change_of_slope_by_log_gamma() > whole.change_of_slope_by_log_gamma()


def test_no_flight_is_longer_than_half_a_turn() -> None:
    late, later = (
        BacklashBox(*(np.array([each]) for each in (0.5, 0.8, 1.2, 1.2 + turn))) for turn in (4.0, 5.0)
    )
    assert late.slope_by_log_gamma() == later.slope_by_log_gamma()
