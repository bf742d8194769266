"""Parts of the search of many trimmers: N by its lag, and the grid of frequencies."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.ensembles.known_responses import THREE
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.ensembles.crossings import (
    _inserted,
    _open_ends,
    _touches,
    _urgency,
)
from trimmer.ensembles.frequencies import frequencies_near
from trimmer.ensembles.gain_by_phase import gain_by_lag
from trimmer.ensembles.grid import Grid, grid_at, merged


# G = K/(s (s + 1)) twice, with other K, and 1/(s + 1) in between: N + 1/G = 0 for K = 4 at about 1 rad/s.
def grid(h: list[float], lag: float | list[float] = 0.4, loud: bool | list[bool] = True) -> Grid:
    shape = (1, len(h))
    return Grid(
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


def test_a_table_that_does_not_rise_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    class Falling:
        def describing_function(self, amplitude: np.ndarray) -> np.ndarray:
            return np.exp(-1j / amplitude + 1e-3j / amplitude**2)

    class Bent:
        def describing_function(self, amplitude: np.ndarray) -> np.ndarray:
            return np.exp(-1j * np.sin(2.0 / amplitude))

    with monkeypatch.context() as patch:
        patch.setattr("trimmer.ensembles.gain_by_phase.PLAY", Bent())
        with pytest.raises(ArithmeticError, match="does not rise"):
            gain_by_lag.__wrapped__()
        patch.setattr("trimmer.ensembles.gain_by_phase.PLAY", Falling())
        gain_by_lag.__wrapped__()


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
    one = Grid(
        np.array([[1.0, 3.0]]), np.array([[True, False]]), np.array([[0.1, 0.3]]), np.array([[5.0, 7.0]])
    )
    other = Grid(np.array([[2.0]]), np.array([[True]]), np.array([[0.2]]), np.array([[6.0]]))
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


def test_a_touch_is_a_least_distance_between_points_of_one_sign() -> None:
    def found(h: list[float], lag: float | list[float] = 0.4) -> list[bool]:
        points = grid(h, lag)
        return _touches(points.h, points.inside)[0].tolist()

    assert found([0.2, 0.01, 0.2]) == [True]
    assert found([-0.2, -0.01, -0.2]) == [True]
    assert found([0.2, -0.01, 0.2]) == [False]
    assert found([-0.2, 0.01, 0.2]) == [False]
    assert found([0.2, 0.01, -0.2]) == [False]
    assert found([0.01, 0.2, 0.3]) == [False]
    assert found([0.01, 0.01, 0.01]) == [True]
    # Nearer by less than what the others are farther off: 0.1 < 0.15 - 0.1 + 0.02 is not so.
    assert found([0.15, 0.1, 0.12]) == [False]
    assert found([0.12, 0.1, 0.19]) == [True]
    assert found([0.19, 0.1, 0.12]) == [True]
    assert found([0.2, 0.01, 0.2], [2.0, 2.0, 2.0]) == [False]
    for place in range(3):
        lags = [2.0, 2.0, 2.0]
        lags[place] = 0.4
        assert found([0.2, 0.01, 0.2], lags) == [True]


def test_a_step_is_urgent_by_its_turn_if_both_its_ends_are_loud() -> None:
    lag = [0.1, 0.1, 0.8, 3.1, -3.1]
    assert _urgency(grid([0.9] * 5, lag))[0] == pytest.approx([0.0, 0.7, 2.3, 0.0])
    assert _urgency(grid([0.9] * 5, lag, [True, True, False, True, True]))[0].tolist() == [0.0] * 4
    assert _urgency(grid([0.9] * 4, [0.8, 0.1, 0.1, -0.9]))[0] == pytest.approx([0.7, 0.0, 1.0])
    # A touch counts half a turn for either step.
    assert _urgency(grid([0.3, 0.01, 0.3], 0.4))[0] == pytest.approx([math.pi, math.pi])
    assert _urgency(grid([0.3, 0.01, 0.3], 0.4, [True, False, True]))[0].tolist() == [0.0, 0.0]


def test_frequencies_are_inserted_within_the_most_urgent_steps() -> None:
    omega = np.array([[1.0, 2.0, 4.0, 5.0, 7.0, 13.0]])
    urgency = np.array([[0.1, 3.0, 0.0, 2.0, 1.0]])
    found = np.sort(_inserted(omega, urgency)[0])
    expected = [
        low + (high - low) * k / 6 for low, high in ((1, 2), (2, 4), (5, 7), (7, 13)) for k in range(1, 6)
    ]
    assert found == pytest.approx(expected)


def test_open_ends_are_where_the_loop_is_loud_enough_there() -> None:
    def is_open(h: list[float], loud: bool | list[bool] = True) -> bool:
        return bool(_open_ends(grid(h, 0.4, loud))[0])

    assert not is_open([-0.01, 5.0, -0.01])
    assert is_open([-0.004, 5.0, -0.01])
    assert is_open([-0.01, 5.0, -0.004])
    assert not is_open([0.1, 5.0, -0.01], [False, True, True])
