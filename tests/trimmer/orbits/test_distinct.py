"""When two orbits are one, the shortest return of a motion, and the scale of each state of it."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import control
import numpy as np
import pytest

from trimmer import ClosedLoop, Drive, FrictionBacklash, OpenLoop, Relay, forced_orbit, periodic_orbits
from trimmer.orbits import distinct
from trimmer.orbits.describe import _multipliers, orbit_of
from trimmer.orbits.distinct import same, shortest
from trimmer.orbits.forced_orbit import _sizes
from trimmer.orbits.shooting import Return, solve

LOOP = ClosedLoop(control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0))


def told(period: float, lowest: float, highest: float) -> SimpleNamespace:
    return SimpleNamespace(period=period, extremes=(lowest, highest), amplitude=0.5 * (highest - lowest))


def test_orbits_are_one_if_periods_and_extremes_are_or_one_is_the_mirror_image(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(distinct, "_extremes", lambda orbit: orbit.extremes)
    orbit = told(0.25, -1.0, 3.0)  # of amplitude 2
    assert same(orbit, orbit)
    assert same(orbit, told(0.25, -3.0, 1.0))
    assert not same(orbit, told(0.25, 1.0, 3.0))
    assert not same(orbit, told(0.25, -1.0, 1.0))
    assert not same(orbit, told(0.25, -3.0, 3.0))
    for period, one in ((0.25 * (1 + 5e-7), True), (0.25 * (1 + 2e-6), False), (0.5, False)):
        assert same(orbit, told(period, -1.0, 3.0)) is one
    for shift, one in ((1.5e-6, True), (2.5e-6, False)):
        assert same(orbit, told(0.25, -1.0 + shift, 3.0)) is one
        assert same(orbit, told(0.25, -1.0, 3.0 - shift)) is one
        assert same(orbit, told(0.25, -3.0, 1.0 + shift)) is one


@pytest.fixture(scope="module")
def orbit():
    """Of a relay with two switches; its half is its own mirror image."""
    (found,) = periodic_orbits(LOOP)
    return found


def problem_of(orbit, **changes) -> Return:
    sizes = abs(orbit.motion.log.state).max(axis=0)
    sizes[sizes == 0.0] = 1.0
    return Return(orbit.motion.loop.modes, **{"mirrored": False, "driven": False, "sizes": sizes, **changes})


@pytest.mark.parametrize("periods", [1, 2, 3, 6])
def test_the_shortest_return_is_that_of_half_a_period_with_the_signs_changed(orbit, periods: int) -> None:
    log, problem = orbit.motion.log, problem_of(orbit)
    shot = solve(problem, int(log.mode[0]), log.state[0], periods * orbit.period)
    found, half = shortest(problem, shot)
    assert (found.mirrored, found.driven) == (True, False)
    assert found.sizes is problem.sizes
    assert half.span == pytest.approx(orbit.period / 2, rel=1e-10)


def test_an_odd_number_of_half_periods_is_cut_down_to_one(orbit) -> None:
    log, problem = orbit.motion.log, problem_of(orbit, mirrored=True)
    for halves in (1, 3, 5, 9):
        shot = solve(problem, int(log.mode[0]), log.state[0], halves * orbit.period / 2)
        found, half = shortest(problem, shot)
        assert found is problem
        assert half.span == pytest.approx(orbit.period / 2, rel=1e-10)


def test_a_driven_motion_keeps_the_period_of_the_drive() -> None:
    loop = OpenLoop(
        control.ss([[-0.7]], [[2.0]], [[1.0]], [[0.0]]), FrictionBacklash(0.5), Drive(2.0, 3.0, 0.4)
    )
    driven = forced_orbit(loop)
    log, problem = driven.motion.log, problem_of(driven, driven=True)
    shot = solve(problem, int(log.mode[0]), log.state[0], driven.period)
    found, whole = shortest(problem, shot)
    assert found is problem
    assert whole is shot
    assert orbit_of(loop, problem, shot, None).driven


def test_multipliers_do_not_depend_on_the_units_of_states(orbit) -> None:
    log, problem = orbit.motion.log, problem_of(orbit)
    shot = solve(problem, int(log.mode[0]), log.state[0], orbit.period)
    found = _multipliers(problem, shot)
    assert found.dtype == complex
    assert abs(found).tolist() == sorted(abs(found), reverse=True)
    values = np.linalg.eigvals(shot.slope[:3, :3])
    np.testing.assert_allclose(np.sort(abs(found)), np.sort(abs(values)), rtol=1e-9, atol=1e-12)
    other = replace(problem, sizes=problem.sizes * np.linspace(1e-6, 1e3, len(problem.sizes)))
    np.testing.assert_allclose(np.sort(abs(_multipliers(other, shot))), np.sort(abs(found)), atol=1e-9)
    # Over half a period each is the root of that over a whole one.
    half = solve(replace(problem, mirrored=True), int(log.mode[0]), log.state[0], orbit.period / 2)
    over_whole = _multipliers(replace(problem, mirrored=True), half)
    np.testing.assert_allclose(over_whole, found, atol=1e-8)


def test_a_state_that_does_not_move_has_the_scale_one() -> None:
    plant = control.ss([[-0.7, 0.0], [0.0, -3.0]], [[2.0], [0.0]], [[1.0, 1.0]], [[0.0]])
    loop = OpenLoop(plant, FrictionBacklash(0.5), Drive(2.0, 3.0, 0.4))
    log = forced_orbit(loop).motion.log
    sizes = _sizes(loop, int(log.mode[0]), log.state[0])
    order = loop.modes.layout.order
    assert not log.state[:, :order].all()
    moved = abs(log.state).max(axis=0)
    np.testing.assert_allclose(sizes, np.where(moved == 0.0, 1.0, moved), rtol=1e-9)
