"""What a followed branch tells of its orbits: outputs, balance, tables, and where it may begin."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer import results
from tests.trimmer.branches.test_self_excited_map import PERIOD, belt
from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer.branches import balanced as module
from trimmer.branches import followed as followed_module
from trimmer.branches.balanced import balanced_beside
from trimmer.branches.follow import _interval, _orbit_at_start, follow
from trimmer.branches.followed import FollowedOrbit
from trimmer.branches.outputs import body_coefficients, output_measures
from trimmer.branches.period_maps.mechanism_map import MechanismMap
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


def test_the_distance_is_that_of_the_body_where_it_is_largest_relative_to_its_motion(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # Displacements 5 + 4 cos + 2 sin 2 of one body, 0.3 cos of another, and one that rests; 16 even instants.
    angles = 2.0 * math.pi * np.arange(16) / 16.0
    moved = [5.0 + 4.0 * np.cos(angles) + 2.0 * np.sin(2.0 * angles), 0.3 * np.cos(angles), 0.0 * angles]
    states = np.column_stack([*moved, np.ones(16)])
    nodes = SimpleNamespace(states=states, weights=np.full(16, 3.0 / 16.0))
    course: Any = SimpleNamespace(nodes=nodes, duration=3.0)
    exact = np.array([[5.0, 4.0], [0.0, 0.3], [0.0, 0.0]], dtype=complex)
    asked = []

    def coefficients(course: Any, periods: int, count: int) -> np.ndarray:
        asked.append((periods, count))
        return exact

    off = np.array([[7.0, 1.0j], [0.0, 0.15], [9.0, 0.0]])

    def balanced(mechanism: str, begin: np.ndarray, periods: int) -> Any:
        asked.append((mechanism, begin is exact, periods))
        return SimpleNamespace(coefficients=exact + off, converged="so it is")

    monkeypatch.setattr(module, "body_coefficients", coefficients)
    monkeypatch.setattr(module, "harmonic_balance_of", balanced)

    def distance() -> float:
        return balanced_beside(course, "it", 2, 3).distance  # type: ignore[arg-type]

    # Mean squares: 0.5 of the difference and 2 beyond against 10, and a quarter of its own.
    assert distance() == pytest.approx(math.sqrt(2.5 / 10.0), rel=1e-12)
    assert asked == [(2, 6), ("it", True, 2)]
    off[1, 1] = 0.24
    assert distance() == pytest.approx(0.8, rel=1e-12)
    # What rests has no size of its own.
    off[2, 1] = 1.2
    assert distance() == pytest.approx(math.sqrt(0.72), rel=1e-12)
    # More in the harmonics than in the motion is a matter of rounding, and counts as nothing.
    off[1:, 1] = 0.03, 0.0
    exact[0, 1] = 5.0
    assert distance() == pytest.approx(math.sqrt(0.5 / 10.0), rel=1e-12)
    assert balanced_beside(course, "it", 2, 3).converged == "so it is"  # type: ignore[arg-type, comparison-overlap]


def test_an_orbit_is_balanced_over_its_own_periods(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(followed_module, "balanced_beside", lambda *given: given)
    point: Any = SimpleNamespace()
    orbit = FollowedOrbit(point, MechanismMap(linear_oscillator(), "frequency", 1.0, 3))
    course, mechanism = object(), object()
    vars(orbit)["passage"] = SimpleNamespace(course=course, flow=SimpleNamespace(mechanism=mechanism))
    assert orbit.balanced(7) == (course, mechanism, 3, 7)  # type: ignore[comparison-overlap]


def test_outputs_of_a_motion_without_a_drive_have_its_own_harmonics() -> None:
    flow = ExactFlow(belt())
    course = flow.timed(flow.at(np.array([0.7, 0.2])), PERIOD)
    measure = output_measures(belt(), course)["block"]
    times = PERIOD * np.arange(60_000) / 60_000
    block = course.states(times)[:, 0]
    wanted = 2.0 * abs(np.fft.fft(block)[1:16]) / len(times)
    assert measure.harmonics == pytest.approx(wanted, rel=1e-6, abs=1e-9)
    assert measure.peak_to_peak == pytest.approx(np.ptp(block), rel=1e-7)


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
    assert "2 more branches" in str(replace(branch, branches=(inner, inner)))
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
