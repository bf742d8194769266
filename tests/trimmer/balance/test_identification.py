from __future__ import annotations

import math

import control
import pytest

from tests.trimmer.balance.loops import GAP, THESIS_LOOP
from trimmer.balance.identification import identify_time_constant
from trimmer.balance.solve import limit_cycles
from trimmer.elements.viscous_backlash import ViscousBacklash
from trimmer.linear.frequency_response import UnsupportedSystemError


@pytest.mark.parametrize("time_constant", [0.0, 3e-5, 1e-3, 0.1, math.inf])
def test_the_time_constant_of_a_predicted_limit_cycle_is_found_again(time_constant: float) -> None:
    for cycle in limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, time_constant)):
        found = identify_time_constant(THESIS_LOOP, GAP, cycle.frequency)
        nearest = min(found, key=lambda each: abs(each.amplitude / cycle.amplitude - 1))
        assert nearest.time_constant == pytest.approx(time_constant, rel=1e-8)
        assert nearest.amplitude == pytest.approx(cycle.amplitude, rel=1e-8)
        assert nearest.stable == cycle.stable


def test_no_time_constant_gives_a_frequency_outside_the_range() -> None:
    lowest, highest = (
        limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, time_constant))[-1].frequency
        for time_constant in (0.0, math.inf)
    )
    assert identify_time_constant(THESIS_LOOP, GAP, 1.01 * highest) == ()
    assert identify_time_constant(THESIS_LOOP, GAP, 0.99 * lowest) == ()
    assert len(identify_time_constant(THESIS_LOOP, GAP, 0.5 * (lowest + highest))) == 1


@pytest.mark.parametrize("frequency", [0.0, -1.0, math.nan, math.inf])
def test_a_frequency_that_cannot_be_used(frequency: float) -> None:
    with pytest.raises(ValueError, match="frequency must be positive"):
        identify_time_constant(THESIS_LOOP, GAP, frequency)


def test_a_gap_and_a_system_that_cannot_be_used() -> None:
    with pytest.raises(ValueError, match="gap must be positive"):
        identify_time_constant(THESIS_LOOP, 0.0, 700.0)
    with pytest.raises(UnsupportedSystemError, match="more zeros than poles"):
        identify_time_constant(control.tf([1, 0], [1]), GAP, 700.0)
