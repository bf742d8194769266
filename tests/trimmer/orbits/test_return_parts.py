"""Flows, arcs, derivatives and Newton's step of the return of a loop, beside exponentials and differences."""

from __future__ import annotations

import math
from dataclasses import replace

import control
import numpy as np
import pytest
import scipy.linalg

from trimmer import (
    ClosedLoop,
    Drive,
    FrictionBacklash,
    OpenLoop,
    Relay,
    ViscousBacklash,
    forced_orbit,
    limit_cycles,
    multi_harmonic_balance,
    periodic_orbits,
)
from trimmer.errors import OrbitNotFoundError
from trimmer.orbits.forced_orbit import _later, _sizes
from trimmer.orbits.return_map import arcs, derivative, flow, follow
from trimmer.orbits.settling import _quiet_state
from trimmer.orbits.shooting import Return, _improved, solve

PLANT = control.tf([1.0], [1.0, 3.0, 2.0, 0.0])
LOOP = ClosedLoop(PLANT, Relay(1.0))


@pytest.fixture(scope="module")
def orbit():
    """The only orbit of the relay, with two switches."""
    (found,) = periodic_orbits(LOOP)
    return found


def problem_of(orbit, mirrored: bool) -> Return:
    sizes = abs(orbit.motion.log.state).max(axis=0)
    sizes[sizes == 0] = 1.0
    return Return(orbit.motion.loop.modes, mirrored=mirrored, driven=False, sizes=sizes)


def test_the_flow_of_a_mode_is_an_exponential(orbit) -> None:
    modes, step = LOOP.modes, float(LOOP.modes.tables.step[0])
    for duration in (0.3 * step, step, 7.6 * step):
        expected = scipy.linalg.expm(modes.mode(0).matrix * duration)
        np.testing.assert_allclose(flow(modes, 0, duration), expected, rtol=1e-11, atol=1e-13)


def test_the_derivative_of_a_return_is_that_of_differences(orbit) -> None:
    log, modes = orbit.motion.log, LOOP.modes
    mode, state, span = int(log.mode[0]), log.state[0], 0.83 * orbit.period
    chain = arcs(modes, follow(modes, mode, state, span), span)
    assert sum(arc.duration for arc in chain) == pytest.approx(span, rel=1e-14)
    assert [arc.event_function < 0 for arc in chain] == [False] * (len(chain) - 1) + [True]
    slope, end = derivative(modes, chain)
    order = modes.layout.order
    shifts = 1e-6 * abs(log.state[:, :order]).max(axis=0)
    for entry in range(order):
        ends = []
        for sign in (1.0, -1.0):
            moved = state.copy()
            moved[entry] += sign * shifts[entry]
            last = arcs(modes, follow(modes, mode, moved, span), span)[-1]
            ends.append(flow(modes, last.mode, last.duration) @ last.state)
        np.testing.assert_allclose(
            slope[:order, entry], ((ends[0] - ends[1]) / (2 * shifts[entry]))[:order], rtol=1e-5, atol=1e-6
        )
    np.testing.assert_allclose(end[:order], orbit.motion.state(span), rtol=1e-10)


@pytest.mark.parametrize("mirrored", [True, False])
def test_the_step_of_newton_converges_with_the_square(orbit, mirrored: bool) -> None:
    problem, log = problem_of(orbit, mirrored), orbit.motion.log
    state = log.state[0].copy()
    state[: LOOP.modes.layout.order] *= [1.003, 0.998, 1.001]
    exact = orbit.period / (2 if mirrored else 1)
    shot = problem.shoot(int(log.mode[0]), state, 1.002 * exact)
    correction, longer = problem.step(shot)
    assert not correction[problem.count :].any()
    tangent = LOOP.modes.mode(shot.mode).matrix @ shot.state / problem.sizes
    assert abs(tangent @ (correction / problem.sizes)) < 1e-12
    better = _improved(problem, shot, 10.0 * exact)
    assert better.span == pytest.approx(shot.span + longer, rel=1e-14)
    np.testing.assert_allclose(better.state, shot.state + correction, rtol=1e-14)
    assert better.miss < 100 * shot.miss**2
    assert better.span == pytest.approx(exact, rel=1e-4)
    assert _improved(problem, shot, 0.5 * exact) is None
    assert solve(problem, shot.mode, shot.state, shot.span, 1) is None
    assert solve(problem, shot.mode, shot.state, shot.span).span == pytest.approx(exact, rel=1e-10)


def test_a_shot_gives_end_rate_and_miss_with_the_signs_of_the_return(orbit) -> None:
    log, order = orbit.motion.log, LOOP.modes.layout.order
    shots = [
        problem_of(orbit, mirrored).shoot(int(log.mode[0]), log.state[0], orbit.period / 2 + shift)
        for mirrored, shift in ((True, 0.0), (True, 1e-4), (True, -1e-4))
    ]
    assert shots[0].miss < 1e-9
    slopes = (shots[1].end - shots[2].end)[:order] / 2e-4
    np.testing.assert_allclose(shots[0].rate[:order], slopes, rtol=1e-5, atol=1e-6)
    apart = abs(shots[1].end - shots[1].state)[:order] / problem_of(orbit, True).sizes[:order]
    assert shots[1].miss == pytest.approx(float(apart.max()), rel=1e-9)
    # Half a period later the other sign of the output is on, which is no return with the same signs.
    assert problem_of(orbit, False).shoot(int(log.mode[0]), log.state[0], orbit.period / 2) is None


def test_the_share_of_a_velocity_keeps_its_sign_in_the_mirrored_motion() -> None:
    loop = ClosedLoop(PLANT, ViscousBacklash(0.5, 0.1))
    problem = Return(loop.modes, mirrored=True, driven=False, sizes=np.ones(loop.modes.layout.size))
    first = loop.modes.layout.first_states[0]
    expected = np.full(loop.modes.layout.size, -1.0)
    expected[first + 2] = 1.0
    assert problem.signs.tolist() == expected.tolist()
    assert problem.count == first + 3
    numbers = [loop.modes.number((each,)) for each in (0, 2, 1, 3)]
    assert [problem.final(loop.modes.number((each,))) for each in range(4)] == numbers
    assert [replace(problem, mirrored=False).final(each) for each in numbers] == numbers


def test_a_driven_loop_is_later_by_whole_periods() -> None:
    drive = Drive(2.0, 3.0, 0.4)
    loop = OpenLoop(control.ss([[-0.7]], [[2.0]], [[1.0]], [[0.0]]), FrictionBacklash(0.5), drive)
    orbit = forced_orbit(loop)
    log = orbit.motion.log
    state = log.state[0].copy()
    state[0] += 0.2
    mode = int(log.mode[0])
    assert _later(loop, mode, state, 0.0) == (mode, state)
    later_mode, later = _later(loop, mode, state, 3 * drive.period)
    assert later_mode == mode
    expected = log.state[0][0] + 0.2 * math.exp(-0.7 * 3 * drive.period)
    assert later[0] == pytest.approx(expected, rel=1e-9)
    assert later[-3:].tolist() == [math.sin(0.4), math.cos(0.4), 1.0]
    sizes = _sizes(loop, mode, log.state[0])
    assert sizes[0] == pytest.approx(abs(log.state[:, 0]).max(), rel=1e-9)
    assert (sizes > 0).all()
    assert forced_orbit(loop, settling=0).period == drive.period
    quick = forced_orbit(loop, settling=2)
    np.testing.assert_allclose(quick.motion.log.state[0], log.state[0], rtol=1e-8)
    assert quick.residual < 1e-10
    assert quick.prediction is None
    assert _quiet_state(loop, log, orbit.period)[0] == int(log.mode[-1])


def test_balanced_harmonics_balance_each_harmonic() -> None:
    """With the output of an ideal relay, 4/(pi n) exp(-j n x) at n, where x is the phase it switches at."""
    (cycle,) = limit_cycles(PLANT, Relay(1.5))
    solutions = multi_harmonic_balance(PLANT, Relay(1.5), cycle, (1, 3, 7))
    assert [each.order for each in solutions] == [1, 3, 7]
    found = solutions[-1]
    numbers = np.array([1, 3, 5, 7])
    assert found.harmonics.shape == (4,)
    assert found.residual < 1e-9
    # The motion of a symmetric square wave through the plant: all harmonics have the wave's own phase.
    through = -np.array([complex(PLANT(1j * n * found.omega)) for n in numbers]) * 6 / np.pi / numbers
    turned = through * np.exp(1j * numbers * (np.angle(found.harmonics[0]) - np.angle(through[0])))
    np.testing.assert_allclose(found.harmonics, turned, rtol=1e-7)
    grid = np.exp(1j * np.outer(np.linspace(0, 2 * np.pi, 100_001), numbers))
    assert found.amplitude == pytest.approx((grid @ found.harmonics).imag.max(), rel=1e-8)
    assert found.frequency == found.omega / (2 * np.pi)
    first = solutions[0]
    assert (first.amplitude, first.omega) == pytest.approx((cycle.amplitude, cycle.omega), rel=1e-9)
    with pytest.raises(OrbitNotFoundError):
        multi_harmonic_balance(control.tf([1.0], [1.0, 1.0]), Relay(1.5), cycle, (1, 3))
