"""What a followed branch tells of its orbits: outputs, balance, tables, and where it may begin."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer import results
from tests.trimmer.branches.test_self_excited_map import belt
from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer.branches.balanced import balanced_beside
from trimmer.branches.follow import _interval, _orbit_at_start, follow
from trimmer.branches.outputs import body_coefficients, output_measures
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialPoint
from trimmer.contact.flow import ExactFlow
from trimmer.errors import MechanismError
from trimmer.mechanism.parts import Force, Play

OMEGA = 7.5
RESPONSE = 100.0 / (40.0 - OMEGA**2 + 0.1j * math.sqrt(40.0) * OMEGA)


def settled_state() -> np.ndarray:
    return np.array([RESPONSE.real, (1j * OMEGA * RESPONSE).real])


def test_outputs_of_a_linear_motion() -> None:
    flow = ExactFlow(linear_oscillator())
    for periods in (1, 3):
        course = flow.course(flow.at(settled_state()), periods)
        measure = output_measures(linear_oscillator(), course)["x"]
        assert measure.peak_to_peak == pytest.approx(2.0 * abs(RESPONSE), rel=1e-10)
        assert measure.harmonics[0] == pytest.approx(abs(RESPONSE), rel=1e-10)
        assert abs(measure.harmonics[1:]).max() < 1e-10 * abs(RESPONSE)
        assert len(measure.harmonics) == 15
        assert "m peak to peak, 15 harmonics" in str(measure)
        found = body_coefficients(course, periods, 4)
        wanted = np.zeros(5, dtype=complex)
        wanted[periods] = RESPONSE
        assert found == pytest.approx(wanted[None], abs=1e-10 * abs(RESPONSE))
        balanced = balanced_beside(course, linear_oscillator(), periods, 2)
        assert balanced.converged
        assert balanced.distance < 1e-7
    pushed = replace(linear_oscillator(), forces={"push": Force("mass", constant=80.0, amplitude=100.0)})
    flow = ExactFlow(pushed)
    course = flow.course(flow.strobe(flow.rest(), 200).end, 1)
    assert body_coefficients(course, 1, 1)[0, 0] == pytest.approx(2.0, rel=1e-9)


def test_what_lies_beyond_the_last_harmonic_is_a_part_of_the_distance() -> None:
    course, mechanism = results.forced().course, impact_oscillator()
    coefficients = body_coefficients(course, 1, 40)
    power = 0.5 * abs(coefficients[0, 1:]) ** 2
    found = balanced_beside(course, mechanism, 1, 1)
    rest = math.sqrt(power[1:].sum() / power.sum())
    assert found.distance >= rest * (1.0 - 1e-3)
    finer = balanced_beside(course, mechanism, 1, 20)
    assert finer.distance < 0.1 * found.distance


def test_a_followed_branch_tells_its_orbits() -> None:
    branch = results.branch()
    rows = list(branch._table().rows())
    assert len(rows) == sum(len(each.points) for each in branch.all())
    orbit = branch.points[3]
    assert rows[3] == (
        0,
        orbit.value,
        orbit.stable,
        pytest.approx(1.0 / orbit.value),
        1,
        pytest.approx(orbit.largest_multiplier),
        orbit.events_per_period,
        orbit.outputs["x"].peak_to_peak,
    )
    assert orbit.largest_multiplier == max(abs(orbit.multipliers))
    units = branch._table().units
    assert (units["value"], units["period"], units["outputs.x.peak_to_peak"]) == ("Hz", "s", "m")
    assert branch.unit == "Hz"
    assert str(orbit).find(f"frequency = {orbit.value:.9g}, stable, 1 drive period") >= 0
    unstable = next(each for each in branch.points if not each.stable)
    assert "not stable" in str(unstable)
    told = str(branch)
    assert f"over frequency, {len(branch.points)} orbits, {len(branch.special)} special point" in told
    assert "more branch" not in told
    inner = replace(branch, branches=())
    one, two = (
        replace(branch, branches=(inner,)),
        replace(branch, branches=(replace(branch, branches=(inner,)), inner)),
    )
    assert "one more branch" in str(one)
    assert "3 more branches" in str(two)
    assert list(two.all())[1:] == [two.branches[0], inner, inner]
    numbers = [row[0] for row in two._table().rows()]
    assert sorted({*numbers}) == [0, 1, 2, 3]
    assert f"neighbours of {len(branch.points)} orbits" in branch.searched
    fold = branch.special[0]
    assert isinstance(fold, SpecialPoint)
    outside = branch.outputs_at(fold)["x"].peak_to_peak
    near = min(
        branch.points, key=lambda each: abs(each.value - fold.value) + abs(each.state - fold.state).max()
    )
    assert outside == pytest.approx(near.outputs["x"].peak_to_peak, rel=2e-2)


def test_an_orbit_of_given_periods_begins_a_branch_stable_or_not() -> None:
    found = _orbit_at_start(linear_oscillator(), 3, 1)
    assert found is not None
    assert found.success
    assert _orbit_at_start(linear_oscillator(), 3, None) is None
    waited = _orbit_at_start(linear_oscillator(), 400, None)
    assert waited is not None
    assert waited.instant.state == pytest.approx(found.instant.state, rel=1e-9)
    branch = follow(
        linear_oscillator(), "frequency", 1.1, 1.2, periods=1, settings=FollowSettings(2, quiet=True)
    )
    omega = 2.0 * math.pi * 1.1
    wanted = 2.0 * 100.0 / abs(40.0 - omega**2 + 0.1j * math.sqrt(40.0) * omega)
    assert branch.points[0].outputs["x"].peak_to_peak == pytest.approx(wanted, rel=1e-9)


def test_the_interval_is_checked_at_both_ends() -> None:
    assert _interval(linear_oscillator(), "frequency", "1.1 Hz", 1.2) == (1.1, 1.2)
    with pytest.raises(MechanismError, match="no length"):
        _interval(linear_oscillator(), "frequency", 1.1, "1.1 Hz")
    with pytest.raises(MechanismError, match="frequency"):
        _interval(belt(), "frequency", 1.1, 1.2)
    with pytest.raises(MechanismError):
        follow(linear_oscillator(), "bodies.mass.mass", 1.0, -1.0)
    free = Play(("ground", "block"), 10.0, gap=2.0)
    assert _interval(replace(belt(), plays={"gap": free}), "plays.gap.gap", 1.0, 3.0) == (1.0, 3.0)
