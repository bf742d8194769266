"""Extremes of polynomials and of motions step by step, and harmonics arc by arc."""

from __future__ import annotations

import control
import numpy as np
import pytest

from trimmer import ClosedLoop, Relay, periodic_orbits
from trimmer.motion.taylor import DEGREE
from trimmer.orbits.measures import _candidates, _extremes_of, extremes, extremes_of, harmonics
from trimmer.orbits.orbit_measures import _pieces, harmonics_by_quadrature
from trimmer.orbits.return_map import Arc, arcs, follow

LAG = ClosedLoop(control.ss([[-0.5]], [[4.0]], [[0.5]], [[0.0]]), Relay(1.5, 0.9))


def polynomial(*coefficients: float) -> np.ndarray:
    return np.array([*coefficients, *[0.0] * (DEGREE + 1 - len(coefficients))])


def test_an_extreme_on_a_point_of_the_grid_counts() -> None:
    # 2 - x + x^2 has its minimum at 1/2, between the 16th and the 17th of 32 parts.
    assert _extremes_of(polynomial(2.0, -1.0, 1.0), 1.0) == pytest.approx([2.0, 2.0, 1.75], rel=1e-14)
    assert min(_extremes_of(polynomial(2.0, 1.0, -1.0), 0.75)) == 2.0
    assert max(_extremes_of(polynomial(2.0, 1.0, -1.0), 0.75)) == pytest.approx(2.25, rel=1e-14)


def test_two_extremes_in_neighbouring_parts_are_told_apart() -> None:
    first, second = 10.5 / 32, 11.6 / 32
    # The slope is (x - first) (x - second).
    found = polynomial(0.0, first * second, -0.5 * (first + second), 1.0 / 3.0)

    def at(x: float) -> float:
        return x * (first * second - 0.5 * (first + second) * x + x * x / 3)

    *_, one, other = _extremes_of(found, 1.0)
    assert (one, other) == (pytest.approx(at(first), rel=1e-12), pytest.approx(at(second), rel=1e-12))
    assert one - other == pytest.approx((second - first) ** 3 / 6, rel=1e-6)


def lag(duration_in_steps: float, state: float = 3.0) -> tuple[Arc, float]:
    modes = LAG.modes
    modes.tabulate(0)
    step = float(modes.tables.step[0])
    extended = np.zeros(modes.layout.size)
    extended[0], extended[-1] = state, 1.0
    return Arc(duration_in_steps * step, 0, extended, -1, np.eye(modes.layout.size), 0), step


def test_an_arc_is_looked_at_step_by_step() -> None:
    modes = LAG.modes
    arc, step = lag(2.5)
    mode = modes.mode(0)
    rest = -mode.matrix[0, -1] / mode.matrix[0, 0]
    at = [rest + (3.0 - rest) * np.exp(-0.5 * step * k) for k in (0, 1, 1, 2, 2, 2.5)]
    row = np.zeros(modes.layout.size)
    row[0], row[-1] = 2.0, 7.0
    found = _candidates(modes, arc, row)
    assert found == pytest.approx([2.0 * x + 7.0 for x in at], rel=1e-12)
    assert extremes_of(modes, [arc], lambda each: row) == pytest.approx((min(found), max(found)))
    assert len(_candidates(modes, lag(1.0)[0], row)) == 2
    # The input of the relay is half of the state, with the other sign.
    lowest, highest = extremes(modes, [arc])
    assert (lowest, highest) == pytest.approx(sorted((-0.5 * at[0], -0.5 * at[-1])), rel=1e-12)


def test_the_harmonics_of_a_relay_and_a_lag_are_known() -> None:
    (orbit,) = periodic_orbits(LAG)
    numbers = np.arange(1, 16)
    modes = LAG.modes
    found = harmonics(modes, arcs(modes, orbit.motion.log, orbit.period))
    # The motion begins in the middle of the positive output: 6/(pi n) at odd n, a quarter of a period early.
    square = np.where(numbers % 2, 6.0 / np.pi / numbers, 0.0) * np.exp(0.5j * np.pi * numbers)
    expected = -square * 2.0 / (1j * numbers * orbit.omega + 0.5)
    np.testing.assert_allclose(found, expected, atol=1e-11)
    by_quadrature = harmonics_by_quadrature(orbit.motion, lambda mode: mode.signals[0].input)
    np.testing.assert_allclose(by_quadrature, expected, atol=1e-11)
    # From another instant on each is turned by its number.
    later = 0.3 * orbit.period
    begun = follow(modes, int(orbit.motion.log.mode[0]), orbit.motion.log.state[0], later)
    last = arcs(modes, begun, later)[-1]
    state = np.append(orbit.motion.state(later), np.ones(modes.layout.size - 1))
    turned = harmonics(modes, arcs(modes, follow(modes, last.mode, state, orbit.period), orbit.period))
    np.testing.assert_allclose(turned, expected * np.exp(2j * np.pi * 0.3 * numbers), atol=1e-10)


def test_a_motion_is_integrated_over_the_steps_of_its_arcs() -> None:
    (orbit,) = periodic_orbits(LAG)
    pieces = list(_pieces(orbit.motion))
    chain, step = arcs(LAG.modes, orbit.motion.log, orbit.period), LAG.modes.tables.step
    assert [len(times) for times, _ in pieces] == [
        48 * int(np.ceil(arc.duration / step[arc.mode])) for arc in chain
    ]
    ends = np.cumsum([arc.duration for arc in chain])
    for (times, weights), end, arc in zip(pieces, ends, chain, strict=True):
        assert end - arc.duration < times.min() < times.max() < end
        assert weights.sum() == pytest.approx(arc.duration, rel=1e-13)
        assert weights @ times**5 == pytest.approx((end**6 - (end - arc.duration) ** 6) / 6, rel=1e-12)
    table = orbit._table()
    rows = np.array([list(row) for row in table.rows()], dtype=float)
    np.testing.assert_allclose(rows[:, 0], np.arange(1, 16))
    np.testing.assert_allclose(rows[:, 1], orbit.frequency * np.arange(1, 16))
    np.testing.assert_allclose(rows[:, 2], abs(orbit.harmonics))
    np.testing.assert_allclose(rows[:, 3], np.angle(orbit.harmonics))
