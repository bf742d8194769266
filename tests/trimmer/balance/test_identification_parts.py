"""The parts of identification with hand-made bands: turning points, the nearest end, and intervals."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.balance.loops import GAP, THESIS_LOOP
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.feasible_frequencies import BandEnd, FeasibleBand
from trimmer.balance.identification import (
    IdentifiedTimeConstant,
    _at_limit,
    _intervals,
    _nearest,
    _time_constants,
    _turning_points,
    identify_time_constant,
)
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.elements.backlashes.inertia_backlash import InertiaBacklash
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.linear.frequency_response import response_at

CYCLE = LimitCycle(0.5, 40.0 * math.pi, True, 0.0, 1.0, 1, 0)


def band(lower: float, upper: float, first: float = math.nan, last: float = math.nan) -> FeasibleBand:
    return FeasibleBand(BandEnd(lower, first), BandEnd(upper, last))


def test_a_band_holds_its_ends() -> None:
    given = band(20.0, 30.0, 0.1, 0.2)
    assert [given.holds(each) for each in (19.9, 20.0, 25.0, 30.0, 30.1)] == [False, True, True, True, False]
    assert given.frequencies == (20.0, 30.0)
    assert "from 20 Hz, M/D 0.1 s, to 30 Hz, M/D 0.2 s" in repr(given)
    assert "no end" in repr(band(0.0, math.inf))


def test_turning_points_are_minima_and_maxima_between_samples() -> None:
    frequencies = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]

    def value(frequency: float) -> float:
        return math.sin(0.5 * math.pi * (frequency - 0.3))

    found = list(_turning_points(value, frequencies, [value(each) for each in frequencies]))
    assert found == pytest.approx([1.3, 3.3], abs=1e-4)
    few = frequencies[:-1]
    later = [value(each - 1.4) for each in few]  # the last three hold a turning point too
    assert list(_turning_points(lambda each: value(each - 1.4), few, later)) == pytest.approx(
        [0.7, 2.7], abs=1e-4
    )
    assert list(_turning_points(value, frequencies, frequencies)) == []
    assert list(_turning_points(value, frequencies, [1.0] * 6)) == []
    assert len(list(_turning_points(value, [0.0, 1.0, 2.0], [5.0, 5.0, 1.0]))) == 0


def identified(time_constant: float) -> IdentifiedTimeConstant:
    return IdentifiedTimeConstant(time_constant, CYCLE)


def test_an_interval_is_that_part_of_a_band_that_was_measured() -> None:
    bands = [band(10.0, 20.0, 0.5, 0.9), band(30.0, 40.0, 7.0, 8.0), band(50.0, 60.0, 0.0, 1.0)]

    def at(frequency: float) -> tuple[IdentifiedTimeConstant, ...]:
        return (identified(1.0 + (frequency - 17.0) ** 2), identified(99.0))

    first, second = _intervals(at, bands, 15.0, 35.0)
    assert first.frequencies == (15.0, 20.0)
    assert first.lowest == 0.9  # at the end of the band
    assert first.highest == pytest.approx(10.0)
    assert second.frequencies == (30.0, 35.0)
    assert (second.lowest, second.highest) == (7.0, pytest.approx(1.0 + 18.0**2))
    (inner,) = _intervals(at, bands, 15.0, 19.5)
    assert inner.lowest == pytest.approx(1.0, abs=1e-8)  # between samples
    assert (inner.highest, inner.frequencies) == (pytest.approx(1.0 + 2.5**2), (15.0, 19.5))
    (point,) = _intervals(at, bands, 20.0, 20.0)
    assert (point.lowest, point.highest) == (0.9, 10.0)
    assert list(_intervals(at, bands, 21.0, 29.0)) == []
    assert list(_intervals(lambda frequency: (), bands, 15.0, 19.0)) == []


def test_the_nearest_end_is_that_of_the_nearest_band() -> None:
    asked: list[float] = []

    def at(frequency: float) -> tuple[IdentifiedTimeConstant, ...]:
        asked.append(frequency)
        return (identified(3.0), identified(4.0))

    bands = [band(10.0, 20.0), band(30.0, 40.0)]
    for frequency, inside in (
        (9.0, 10.0 + 1e-5),
        (24.0, 20.0 - 2e-5),
        (26.0, 30.0 + 3e-5),
        (99.0, 40.0 - 4e-5),
    ):
        found = _nearest(at, bands, frequency)
        assert found is not None
        assert found.time_constant == 3.0
        assert asked.pop() == pytest.approx(inside, rel=1e-12)
    _nearest(at, [band(10.0, 10.0 + 2e-6)], 9.0)
    assert asked.pop() == pytest.approx(10.0 + 1e-6, rel=1e-12)
    known = FeasibleBand(BandEnd(10.0, 0.0, CYCLE), BandEnd(20.0, math.inf))
    assert _nearest(at, [known], 9.0) == IdentifiedTimeConstant(0.0, CYCLE)
    assert asked == []
    assert _nearest(at, [], 9.0) is None
    assert _nearest(lambda frequency: (), bands, 9.0) is None


@pytest.mark.parametrize("time_constant", [0.0, math.inf])
def test_a_load_without_a_time_constant_is_told_from_n_itself(time_constant: float) -> None:
    element = ViscousBacklash(GAP, time_constant)
    exact = {0.0: FrictionBacklash(GAP), math.inf: InertiaBacklash(GAP)}[time_constant]
    edge = ElementCurve(exact).edge(np.zeros(1)).item()
    for u in (0.01 * edge, 0.3, 0.9, 0.99 * edge):
        inverse = -complex(exact.describing_function(GAP / u))
        assert _at_limit(element, inverse, 691.0) == pytest.approx([u], rel=1e-10)
        if 0.1 < u < 1.0:
            assert _at_limit(element, inverse * (1.0 + 1e-5j), 691.0).size == 0
        assert _at_limit(element, -inverse, 691.0).size == 0


def test_what_was_identified_tells_itself() -> None:
    one = identified(2.5e-3)
    assert (one.amplitude, one.stable) == (0.5, True)
    assert "M/D 0.0025 s, amplitude 0.5, 20 Hz, stable" in repr(one)
    unstable = IdentifiedTimeConstant(0.0, replace(CYCLE, stable=False))
    assert not unstable.stable
    assert "unstable" in repr(unstable)


def test_an_identification_holds_what_was_given() -> None:
    (*_, given) = limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, 2e-4))
    result = identify_time_constant(THESIS_LOOP, GAP, given.frequency, frequency_uncertainty=0.5)
    assert (result.frequency, result.frequency_uncertainty, result.gap) == (given.frequency, 0.5, GAP)
    for found in result.time_constants:
        cycle = found.limit_cycle
        assert cycle.frequency == pytest.approx(given.frequency)
        element = ViscousBacklash(GAP, found.time_constant)
        gain = complex(element.describing_function(cycle.amplitude, cycle.omega))
        assert 1.0 + gain * complex(response_at(THESIS_LOOP, cycle.omega)) == pytest.approx(0.0, abs=1e-9)
        again = result.limit_cycles_with(found.time_constant)
        assert any(each.amplitude == pytest.approx(cycle.amplitude) for each in again)
    constants = [found.time_constant for found in result.time_constants]
    assert constants == sorted(constants)
    assert any(each == pytest.approx(2e-4, rel=1e-8) for each in constants)
    assert result.nearest is None
    assert result.success
    (interval,) = result.intervals
    assert interval.lowest < 2e-4 < interval.highest
    assert interval.frequencies == pytest.approx((given.frequency - 0.5, given.frequency + 0.5))


def test_a_table_tells_each_time_constant_with_its_limit_cycle() -> None:
    (cycle,) = limit_cycles(THESIS_LOOP, FrictionBacklash(GAP))[-1:]
    told = identify_time_constant(THESIS_LOOP, GAP, cycle.frequency)
    assert told.frequency_uncertainty == 0.0
    (found,) = told.time_constants
    rows = [list(row) for row in told._table().rows()]
    expected = found.limit_cycle
    assert rows == [
        [
            *(0.0, expected.amplitude, expected.omega, expected.frequency),
            *(expected.stable, expected.crossing_angle),
        ]
    ]
    assert repr(told).count("M/D within the uncertainty: 0 to 0 s") == 1


def test_limit_cycles_with_another_load_are_those_of_the_solver() -> None:
    told = identify_time_constant(THESIS_LOOP, GAP, 740.0)
    found = told.limit_cycles_with(3e-4)
    assert [each.frequency for each in found] == pytest.approx(
        [each.frequency for each in limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, 3e-4))], rel=1e-10
    )


def test_the_time_constant_is_that_of_the_load_at_its_frequency() -> None:
    """-1/G at 691 rad/s is made to be N of gap 1 and omega M/D = 0.7 at u = 0.6."""
    gamma = 0.7
    element = ViscousBacklash(1.0, gamma)
    omega = 691.0
    u = 0.6
    gain = complex(element.describing_function(float(element.amplitude_scale) / u, 1.0))
    response = InverseResponse(-gain / (1j * omega + 9.0), np.array([-9.0]), np.empty(0), 1.0)
    (found,) = _time_constants(response, 1.0, omega / (2.0 * math.pi))
    assert found.time_constant == pytest.approx(gamma / omega, rel=1e-9)
    assert found.limit_cycle.omega == pytest.approx(omega, rel=1e-12)
    assert found.amplitude == pytest.approx(float(element.amplitude_scale) / u, rel=1e-9)
