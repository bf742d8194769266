"""When the search gives a box up, along which side it cuts, and what it makes of solutions, by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.balance.loops import THIRD_ORDER, s
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve, GainDisks, GainTable
from trimmer.balance.exclusion import EnclosedCells
from trimmer.balance.inverse_response import Enclosure, InverseResponse
from trimmer.balance.loop import LoopEquation, loop_equation
from trimmer.balance.search import Problem, _along_u, _hopeless, _settled, _Solutions, find_all
from trimmer.balance.stability import _drifting_poles, limit_cycles_at, other_unstable_poles, sine_of_crossing
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.elements.relay import Relay
from trimmer.elements.viscous_friction import ViscousFriction
from trimmer.linear.zero_pole_gain import ZeroPoleGain

CURVE = ElementCurve(FrictionBacklash(1.0))
RESPONSE = InverseResponse.of(ZeroPoleGain.of(4 / (s * (s + 1))))
PROBLEM = Problem(RESPONSE, CURVE, GainTable.of(CURVE, np.array([-1.0, 0.0, 1.0])), 0.0)


def boxes(
    u: tuple[float, float],
    x: tuple[float, float],
    *,
    radii: tuple[float, float] = (1.0, 1.0),
    centres: tuple[complex, complex] = (1.0, 1.0),
    u_share: float = 1.0,
) -> EnclosedCells:
    one = np.ones(1)
    return EnclosedCells(
        Cells(u[0] * one, u[1] * one, x[0] * one, x[1] * one),
        GainDisks(centres[0] * one, radii[0] * one, u_share * one, np.array([True])),
        Enclosure(centres[1] * one, one, radii[1] * one, one, one, one),
    )


def test_a_box_is_cut_along_the_side_that_adds_more() -> None:
    def along(radius: float, share: float, inverse: float) -> bool:
        return bool(_along_u(boxes((0.5, 1.0), (0.0, 0.1), radii=(radius, inverse), u_share=share))[0])

    # The width in u adds the share, that in x the rest of the radius and that of 1/G.
    assert along(3.0, 2.0, 1.0)
    assert not along(3.0, 2.0, 1.1)
    assert not along(3.1, 2.0, 1.0)


def hopeless(u: tuple[float, float] = (0.5, 1.0), x: tuple[float, float] = (0.0, 0.1), **rest) -> bool:
    return bool(_hopeless(PROBLEM, boxes(u, x, **rest))[0])


def test_a_box_is_given_up_when_its_disks_are_small_beside_what_they_hold() -> None:
    assert not hopeless()
    assert hopeless(radii=(4e-7, 5e-7), u_share=1e-7)
    assert not hopeless(radii=(6e-7, 5e-7), u_share=1e-7)
    assert hopeless(radii=(3e-6, 3e-6), centres=(1.0, 3 + 6j), u_share=1e-7)
    assert hopeless(radii=(3e-6, 3e-6), centres=(3 + 6j, 1.0), u_share=1e-7)
    # Where the edge runs through the region it is not: there only at 1e-13.
    carried = ElementCurve(ViscousBacklash(1.0, 1.0))
    edge = float(carried.edge(np.zeros(1))[0])
    problem = Problem(RESPONSE, carried, GainTable.of(carried, PROBLEM.table.x_breaks), 0.0)
    for u, size, given_up in ((0.5 * edge, 4e-7, True), (edge, 4e-7, False), (edge, 4e-14, True)):
        box = boxes((u - 0.01, u), (-0.5, 0.5), radii=(size, size), u_share=0.25 * size)
        assert _hopeless(problem, box).tolist() == [given_up]


def test_a_box_is_given_up_when_it_is_too_narrow_or_no_number() -> None:
    assert hopeless(x=(0.0, 1.9e-12), radii=(1.0, 1.0), u_share=0.5)
    assert not hopeless(x=(0.0, 2.1e-12), radii=(1.0, 1.0), u_share=0.5)
    # Cut along u it may go on.
    assert not hopeless(x=(0.0, 1.9e-12), radii=(1.0, 0.0), u_share=1.0)
    assert hopeless((1.0, 1.0 + 1e-15))
    assert not hopeless((1.0, 1.0 + 1e-14))
    assert hopeless(centres=(np.nan, 1.0))


def test_too_many_boxes_are_given_up_all_together() -> None:
    one = boxes((0.5, 1.0), (0.0, 0.1))
    for count in (10_000, 10_001):
        many = np.zeros(count, dtype=int)
        taken = EnclosedCells(one.cells.take(many), one.disks.take(many), one.enclosure.take(many))
        assert _hopeless(PROBLEM, taken).all() == (count > 10_000)


def test_a_solution_is_found_once_and_settles_its_neighbours() -> None:
    result = find_all(PROBLEM)
    u, x = result.u, result.x
    assert u.size == 2
    residual = CURVE.value(u, x) + RESPONSE.value(x)
    assert np.abs(residual) == pytest.approx(np.zeros(2), abs=1e-11)
    assert result.examined > 64
    assert len(result.undecided) == 0
    d = 1e-3
    beside = Cells(
        np.array([u[0] - 0.1 * d, u[0] - d]),
        np.array([u[0] + d, u[0] + 0.1 * d]),
        np.array([x[0] - d, x[0] - d]),
        np.array([x[0] + d, x[0] + d]),
    )
    nothing = _Solutions(np.empty(0), np.empty(0), Cells.none())
    found, settled = _settled(PROBLEM, beside, nothing)
    assert settled.all()
    assert found.u == pytest.approx([u[0]], rel=1e-12)
    # The region of the first is kept, twice as wide as its box.
    assert found.regions.u_lower == pytest.approx([u[0] - 0.65 * d], abs=1e-9)
    assert found.regions.u_upper == pytest.approx([u[0] + 1.55 * d], abs=1e-9)
    again, settled = _settled(PROBLEM, beside, found)
    assert settled.all()
    assert again.u.size == 1
    both, _ = _settled(PROBLEM, Cells(u[1:] - d, u[1:] + d, x[1:] - d, x[1:] + d), found)
    assert both.u == pytest.approx(u, rel=1e-12)
    assert len(both.regions) == 2
    wide = Cells(u - 2.0 * d, u + 2.0 * d, x - 2.0 * d, x + 2.0 * d)
    both, settled = _settled(PROBLEM, wide, found)
    assert both.u == pytest.approx(u, rel=1e-12)
    assert settled.all()
    # Of a box that may hold several nothing is settled.
    all_of_it = Cells(*(side[None] for side in (u.min() - d, u.max() + d, x.min() - d, x.max() + d)))
    none, settled = _settled(PROBLEM, all_of_it, nothing)
    assert (none.u.size, settled.tolist()) == (0, [False])


def test_the_sine_of_a_crossing_is_that_of_the_angle() -> None:
    assert sine_of_crossing(3 + 0j, 2j) == 1.0
    assert sine_of_crossing(2j, 3 + 0j) == -1.0
    assert sine_of_crossing(1 + 2j, 3 + 1j) == pytest.approx((1.0 - 6.0) / math.sqrt(50.0))
    assert sine_of_crossing(1 + 1j, 2 + 2j) == 0.0
    assert math.isnan(sine_of_crossing(0j, 1j))


def test_limit_cycles_come_by_frequency_then_by_amplitude_with_all_their_fields() -> None:
    loop = LoopEquation(RESPONSE, CURVE)
    given_u, given_x = np.array([0.5, 0.3, 0.7]), np.array([0.4, 0.2, 0.2])
    cycles = limit_cycles_at(loop, given_u, given_x)
    assert [each.amplitude for each in cycles] == pytest.approx([1 / 0.7, 1 / 0.3, 2.0])
    assert [each.omega for each in cycles] == pytest.approx([math.exp(0.2), math.exp(0.2), math.exp(0.4)])
    for cycle in cycles:
        omega = np.array([cycle.omega])
        G = 1.0 / RESPONSE.value(np.log(omega))[0]
        gain = complex(CURVE.element.describing_function(cycle.amplitude))
        assert cycle.residual == pytest.approx(abs(1.0 + gain * G))
        step = 1e-6
        by_a = complex(CURVE.element.describing_function(cycle.amplitude + step)) - gain
        _, slope = RESPONSE.value_and_slope(np.log(omega))
        angle = np.angle(complex(slope[0]) / by_a)
        assert cycle.crossing_angle == pytest.approx(math.asin(abs(math.sin(angle))), abs=1e-5)
        assert cycle.index == (1 if math.sin(angle) > 0 else -1)
        assert cycle.stable == (cycle.index == 1 and cycle.other_unstable_poles == 0)
    assert limit_cycles_at(loop, np.empty(0), np.empty(0)) == ()


def test_the_residual_is_that_of_the_loop_as_it_was_given() -> None:
    loop = loop_equation(THIRD_ORDER, Relay(1.0) + ViscousFriction(0.4))
    (cycle,) = limit_cycles_at(loop, np.array([0.8]), np.array([0.3]))
    omega = math.exp(0.3)
    s0 = 1j * omega
    gain = complex(Relay(1.0).describing_function(cycle.amplitude)) + 0.4j * omega
    assert cycle.residual == pytest.approx(abs(1.0 + gain / (s0 * (s0 + 1.0) * (s0 + 2.0))))


def test_other_unstable_poles_are_those_above_the_axis_and_real_ones_of_the_mean() -> None:
    # 1/((s + 1)(s² - 0.2 s + 9)): one pair that swings.
    swinging = loop_equation(1 / ((s + 1) * (s**2 - 0.2 * s + 9)), Relay(1.0))
    gains, amplitudes = np.array([0.01 + 0j, 0.01]), np.ones(2)
    found = other_unstable_poles(swinging, gains, amplitudes, np.array([3.0, 0.1]))
    # Near 3 rad/s the pair is that of the limit cycle itself.
    assert found.tolist() == [0, 1]
    # Of two pairs, at 3 and at 30 rad/s, the slow one grows.
    pairs = loop_equation(1 / ((s**2 - 0.2 * s + 9) * (s**2 + 2 * s + 900)), Relay(1.0))
    found = other_unstable_poles(pairs, gains, amplitudes, np.array([3.0, 30.0]))
    assert found.tolist() == [0, 1]
    # A growth of a billionth is rounding, beside the size of the pole itself.
    for growth, count in ((0.9e-9, 0), (1.1e-9, 1)):
        for size in (1e3, 1e-3):
            poles = np.array([-1.0, size * (growth + 1j), size * (growth - 1j)])
            loop = LoopEquation(
                InverseResponse(1.0, poles, np.empty(0, complex), 1.0), ElementCurve(Relay(1.0))
            )
            found = other_unstable_poles(loop, np.zeros(1, complex), np.ones(1), np.array([-1e9]))
            assert found.tolist() == [count]
    drifting = InverseResponse.of(ZeroPoleGain.of(1 / ((s - 1) * (s + 3))))
    # (s - 1)(s + 3) + N: a positive real root up to N = 3.
    assert np.asarray(_drifting_poles(drifting, np.array([0.0, 2.9, 3.1, np.nan]))).tolist() == [1, 1, 0, 0]
    resting = InverseResponse.of(ZeroPoleGain.of(1 / ((s + 1) * (s + 3))))
    assert np.asarray(_drifting_poles(resting, np.array([-2.9, -3.1]))).tolist() == [0, 1]
    assert np.asarray(_drifting_poles(resting, np.array([5.0, -3.1]))).tolist() == [0, 1]
    assert np.asarray(_drifting_poles(resting, np.array([0.0, 5.0]))).tolist() == 0


@pytest.mark.parametrize("size", [1e4, 1e-4])
def test_a_double_real_pole_that_rounding_parts_counts_twice(size: float) -> None:
    poles = size * np.array([1.0 + 0.5e-7j, 1.0 - 0.5e-7j, -2.0, 0.0])
    given = InverseResponse(1.0, poles, np.empty(0, complex), 1.0)
    assert np.asarray(_drifting_poles(given, np.array([0.0, np.nan]))).tolist() == [2, 0]
    apart = InverseResponse(1.0, size * np.array([1.0 + 2e-7j, 1.0 - 2e-7j]), np.empty(0, complex), 1.0)
    assert np.asarray(_drifting_poles(apart, np.zeros(1))).tolist() == 0


def test_poles_of_the_mean_are_added_to_those_that_swing() -> None:
    # (s - 1)(s + 3) + N has a root right of the axis up to N = 3; of the relay N is 1/A here.
    loop = loop_equation(1 / ((s - 1) * (s + 3)), Relay(0.5 * math.pi))
    found = other_unstable_poles(loop, np.array([4.0 + 0j, 4.0]), np.array([1.0, 0.2]), np.array([1.0, 1.0]))
    assert found.tolist() == [1, 0]


def test_an_index_is_one_where_loebs_criterion_holds_and_else_minus_one() -> None:
    result = find_all(PROBLEM)
    cycles = limit_cycles_at(LoopEquation(RESPONSE, CURVE), result.u, result.x)
    assert sorted(cycle.index for cycle in cycles) == [-1, 1]
    assert all(cycle.stable == (cycle.index == 1) for cycle in cycles)


def test_the_crossing_angle_counts_how_n_changes_with_frequency() -> None:
    carried = ViscousBacklash(1.0, 0.8)
    loop = LoopEquation(RESPONSE, ElementCurve(carried))
    (cycle,) = limit_cycles_at(loop, np.array([0.6]), np.array([0.3]))
    step = 1e-6

    def rest(amplitude: float, x: float) -> complex:
        gain = complex(carried.describing_function(amplitude, math.exp(x)))
        return gain + complex(RESPONSE.value(np.array([x]))[0])

    A, x = cycle.amplitude, 0.3
    by_a, by_x = rest(A + step, x) - rest(A - step, x), rest(A, x + step) - rest(A, x - step)
    assert math.sin(cycle.crossing_angle) == pytest.approx(abs(math.sin(np.angle(by_x / by_a))), rel=1e-6)
