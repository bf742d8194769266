"""Whether a motion comes again, on series of states that are written down."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.response.recurrence import candidates, has_returned, settles_to

SIZES = np.array([2.0, 5.0])


def repeating(period: int, count: int) -> np.ndarray:
    """States that come again after some periods, to the last digit."""
    angles = 2 * np.pi * np.arange(period) / period
    orbit = np.array([np.cos(angles), np.sin(angles)]).T * SIZES
    return np.tile(orbit, (count // period + 1, 1))[:count]


@pytest.mark.parametrize("period", [1, 2, 5])
def test_the_first_close_return_is_the_period(period: int) -> None:
    assert candidates(repeating(period, 40), SIZES, 24) == [period]


def test_a_much_closer_return_goes_first() -> None:
    states = repeating(6, 40)
    states[-1 - 3] = states[-1] + 0.05 * SIZES
    assert candidates(states, SIZES, 24) == [6, 3]


def test_what_is_too_long_for_the_states_is_no_candidate() -> None:
    states = repeating(5, 10)
    assert candidates(states, SIZES, 24) == []
    assert candidates(repeating(5, 11), SIZES, 24) == [5]
    assert candidates(repeating(5, 40), SIZES, 4) == []
    assert candidates(states[:1], SIZES, 24) == []


def test_it_has_returned_after_three_returns_to_rounding() -> None:
    states = repeating(3, 12)
    assert has_returned(states, SIZES, 3)
    assert not has_returned(states[:9], SIZES, 3)
    assert not has_returned(states, SIZES, 2)
    for place in (-4, -7, -10):
        moved = states.copy()
        for by in (1e-9, -1e-9):
            moved[place] = states[place] + by * SIZES
            assert not has_returned(moved, SIZES, 3)
            moved[place] = states[place] + 0.09 * by * SIZES
            assert has_returned(moved, SIZES, 3)


def orbit(monodromy: np.ndarray, growth: float = 1.0) -> SimpleNamespace:
    flow = SimpleNamespace(reduced=lambda states: states)
    return SimpleNamespace(
        flow=flow,
        periods=1,
        sizes=SIZES,
        monodromy=monodromy,
        growth=growth,
        instant=SimpleNamespace(state=SIZES),
    )


LEANING = np.array([[0.5, 0.4], [0.0, 0.3]])


def approaching(matrix: np.ndarray, first: float = 0.05) -> np.ndarray:
    apart = [np.array([first, first])]
    for _ in range(6):
        apart.append(matrix @ apart[-1])
    return (1 + np.array(apart)) * SIZES


def test_a_motion_settles_as_the_derivative_of_its_return_says() -> None:
    assert settles_to(orbit(LEANING), approaching(LEANING))
    assert not settles_to(orbit(LEANING.T), approaching(LEANING))
    assert not settles_to(orbit(0.6 * LEANING), approaching(LEANING))


def test_far_away_multipliers_say_nothing() -> None:
    assert not settles_to(orbit(LEANING), approaching(LEANING, 5.0))
    assert not settles_to(orbit(LEANING, growth=1e4), approaching(LEANING))


def test_a_distance_of_rounding_is_none() -> None:
    near = np.tile(SIZES, (5, 1)) * (1 + 1e-10)
    assert settles_to(orbit(0 * LEANING), near)
    assert not settles_to(orbit(0 * LEANING), near[:3])
    assert not settles_to(orbit(0 * LEANING), np.tile(SIZES, (5, 1)) * (1 + 1e-6))


@pytest.mark.parametrize(
    ("apart", "growth", "settles"),
    [
        # What a linear return halves may grow up to the size on the way.
        ((0.1, 0.05, 0.025), 39.0, True),
        ((0.1, 0.05, 0.025), 41.0, False),
        ((-0.19, -0.095, -0.0475), 1.0, True),
        ((0.21, 0.105, 0.0525), 1.0, False),
        # Up to a tenth may be missed, at both returns and with either sign.
        ((0.1, 0.0599, 0.02995), 1.0, True),
        ((0.1, 0.0602, 0.0301), 1.0, False),
        ((0.1, 0.0398, 0.0199), 1.0, False),
        ((0.1, 0.05, 0.0299), 1.0, True),
        ((0.1, 0.05, 0.0301), 1.0, False),
        ((0.1, 0.05, 0.0199), 1.0, False),
        # A share of 0.04 is missed; grown from 0.027 it has to be less than a tenth of 0.1.
        ((0.1, 0.054, 0.027), 9.2, True),
        ((0.1, 0.054, 0.027), 9.3, False),
        ((1e-9, -1e-9, 1e-9), 1.0, True),
        ((5e-9, -5e-9, 5e-9), 1.0, False),
    ],
)
def test_how_much_a_return_may_differ_from_its_derivative(apart: tuple, growth: float, settles: bool) -> None:
    found = orbit(np.array([[0.5]]), growth)
    found.sizes, found.instant.state = np.array([20.0]), np.array([7.0])
    states = 7.0 + 20.0 * np.array([[9.0], [0.3], *([each] for each in apart)])
    assert settles_to(found, states) is settles


def test_returns_are_those_of_the_state_of_a_period_that_is_nearest() -> None:
    """Every third state halves its distance; those in between are on other parts of the orbit."""
    found = orbit(np.array([[0.5]]))
    found.periods, found.sizes, found.instant.state = 3, np.array([1.0]), np.array([0.0])
    parts = [0.08 * 0.5**k for k in range(4)]
    for before in range(3):
        states = [each for part in parts for each in (part, 0.7, -0.9)]
        shifted = np.array([[0.5]] * before + [[each] for each in states])[: 10 + before]
        assert settles_to(found, shifted)
        assert not settles_to(found, np.where(abs(shifted - parts[2]) < 1e-9, 1.3 * parts[2], shifted))
    assert not settles_to(found, np.array([[each] for each in states])[:9])


def test_the_nearest_state_is_that_whose_largest_distance_is_smallest() -> None:
    """Of two states a period one is at the orbit in its first entry, but far from it in its second."""
    found = orbit(np.array([[0.5, 0.0], [0.0, 0.25]]))
    found.periods, found.sizes, found.instant.state = 2, np.ones(2), np.zeros(2)
    near = [np.array([0.08 * 0.5**k, 0.04 * 0.25**k]) for k in range(4)]
    states = [each for part in near for each in (part, np.array([0.0, 0.9]))]
    assert settles_to(found, np.array(states[:7]))
    assert settles_to(found, np.array(states))
