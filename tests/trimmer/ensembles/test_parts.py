"""Parts of the search of many trimmers: N by its lag, and the grid of frequencies."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.ensembles.known_responses import THREE
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.ensembles.frequencies import frequencies_near
from trimmer.ensembles.gain_by_phase import gain_by_lag
from trimmer.ensembles.grid import FrequencyGrid, grid_at, merged


# G = K/(s (s + 1)) twice, with other K, and 1/(s + 1) in between: N + 1/G = 0 for K = 4 at about 1 rad/s.
def grid(h: list[float], lag: float | list[float] = 0.4, loud: bool | list[bool] = True) -> FrequencyGrid:
    shape = (1, len(h))
    return FrequencyGrid(
        np.arange(1.0, len(h) + 1.0)[None],
        np.broadcast_to(np.array(loud), shape).copy(),
        np.broadcast_to(np.array(lag, float), shape).copy(),
        np.array([h], float),
    )


def test_the_table_tells_n_by_its_lag() -> None:
    u = np.array([0.01, 0.3, 1.0, 1.7, 1.99])
    gains = FrictionBacklash(1.0).describing_function(1.0 / u)
    lags = -np.angle(gains)
    table = gain_by_lag()
    assert table.u_at(lags) == pytest.approx(u, rel=1e-5)
    assert table.log_gain_at(lags) == pytest.approx(np.log(np.abs(gains)), abs=2e-5)
    assert table.u_at(np.array([-1.0, 0.0, 0.5 * math.pi, 2.0])) == pytest.approx(
        [0.0, 0.0, 2.0, 2.0], abs=1e-8
    )
    assert table.log_gain_at(np.array([[-1.0, 0.0]])).tolist() == [[0.0, 0.0]]
    assert table.log_gain[-1] < -8.0


def test_points_tell_how_far_n_is_from_the_inverse() -> None:
    omega = np.array([[0.5, 1.0, 30.0], [0.5, 1.0, 3.0], [0.5, 1.0, 2.0]])
    points = grid_at(THREE, omega)
    inverse = [-(1j * w) * (1j * w + 1.0) / 4.0 for w in omega[0]]
    assert points.loud.tolist()[0] == [abs(z) < math.exp(0.5) for z in inverse] == [True, True, False]
    assert points.lag[0, :2] == pytest.approx([-np.angle(z) for z in inverse[:2]])
    assert points.h[0, 2] == -0.5
    assert points.lag[0, 2] == 0.0
    for place in (0, 1):
        lag = -np.angle(inverse[place])
        expected = float(gain_by_lag().log_gain_at(np.array(lag))) - math.log(abs(inverse[place]))
        assert points.h[0, place] == pytest.approx(expected)
    assert points.inside.tolist()[0] == [True, True, False]
    # -(s + 1)(s + 2)/s for the second: at 0.5 rad/s it is -3 + 3.5j.
    second = -(1j * 0.5 + 1.0) * (1j * 0.5 + 2.0) / (1j * 0.5)
    assert abs(second) > math.exp(0.5)
    assert not points.loud[1, 0]


def test_a_point_is_loud_a_little_beyond_the_largest_gain_too() -> None:
    # |1/G| = omega sqrt(omega² + 1)/4 is 1.12 at 2 rad/s, 1.64 at 2.47 and 1.66 at 2.49; e**0.5 is 1.65.
    points = grid_at(THREE, np.repeat([[2.0, 2.47, 2.49]], 3, axis=0))
    assert points.loud[0].tolist() == [True, True, False]


def test_inside_is_where_n_has_such_a_lag() -> None:
    points = grid([0.0] * 6, [-0.1, 0.0, 0.1, 1.5, 0.5 * math.pi, 2.0])
    assert points.inside[0].tolist() == [False, False, True, True, False, False]
    quiet = grid([0.0, 0.0], 0.4, [True, False])
    assert quiet.inside[0].tolist() == [True, False]


def test_points_are_merged_in_order_with_their_values() -> None:
    one = FrequencyGrid(
        np.array([[1.0, 3.0]]), np.array([[True, False]]), np.array([[0.1, 0.3]]), np.array([[5.0, 7.0]])
    )
    other = FrequencyGrid(np.array([[2.0]]), np.array([[True]]), np.array([[0.2]]), np.array([[6.0]]))
    both = merged(one, other)
    assert [each[0].tolist() for each in both] == [
        [1.0, 2.0, 3.0],
        [True, True, False],
        [0.1, 0.2, 0.3],
        [5.0, 6.0, 7.0],
    ]


def test_frequencies_lie_close_beside_each_pole_and_far_beyond() -> None:
    poles = np.array([[-0.02 + 3j, -0.02 - 3j, -8.0 + 0.5j, -8.0 - 0.5j]])
    (omega,) = frequencies_near(poles)
    assert (np.diff(omega) >= 0).all()
    assert omega.size == 56 + 2 * 22
    smallest, largest = 3.0, math.hypot(8.0, 0.5)
    assert omega[0] == pytest.approx(np.abs(poles).min() / 20.0)
    assert omega[-1] == pytest.approx(max(largest * 20.0, 0.5 + 8.0 * math.tan(math.radians(84.0))))
    assert smallest < largest
    for angle in (-84.0, -4.0, 4.0, 84.0):
        assert np.abs(omega - (3.0 + 0.02 * math.tan(math.radians(angle)))).min() < 1e-12
    even = np.exp(np.linspace(math.log(omega[0]), math.log(20.0 * largest), 56))
    assert np.abs(omega[:, None] - even).min(axis=0) == pytest.approx(np.zeros(56), abs=1e-9)
    # Of the heavily damped pole the lower ones would be negative.
    assert (omega > 0).all()
