"""Maps of a mechanism's period, on mechanisms whose motion is known in closed form."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer import results
from tests.trimmer.branches.test_joining import between_stops
from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer.branches.balanced import balanced_beside
from trimmer.branches.follow import _interval, _orbit_at_start, follow
from trimmer.branches.outputs import body_coefficients, output_measures
from trimmer.branches.period_maps import fitting as fits
from trimmer.branches.period_maps import mechanism_map
from trimmer.branches.period_maps.fitting import _asymmetric, fitting, is_symmetric, shortest_map
from trimmer.branches.period_maps.mechanism_map import MechanismMap
from trimmer.branches.period_maps.period_map import Phase
from trimmer.branches.period_maps.self_excited_map import (
    Section,
    SelfExcitedMap,
    SelfExcitedPassage,
    _halvings,
    section_at,
    with_trivial,
)
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialPoint
from trimmer.contact.flow import ExactFlow
from trimmer.errors import MechanismError, UnsupportedMotionError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force, Friction, Link, Output, Pin, Play

OMEGA = 7.5
RESPONSE = 100.0 / (40.0 - OMEGA**2 + 0.1j * math.sqrt(40.0) * OMEGA)


def settled_state() -> np.ndarray:
    return np.array([RESPONSE.real, (1j * OMEGA * RESPONSE).real])


def test_half_a_period_with_the_mirror_image_of_the_end() -> None:
    mechanism = linear_oscillator()
    whole = MechanismMap(mechanism, "frequency", 1.2)
    half = replace(whole, mirrored=True)
    state, value = np.array([3.0, -20.0]), OMEGA / (2.0 * math.pi)
    one, two = whole.passage(value, state), half.passage(value, state)
    assert two.course.duration == pytest.approx(0.5 * one.course.duration, rel=1e-14)
    assert two.end == pytest.approx(-two.course.end.state, rel=1e-15)
    again = half.passage(value, two.end)
    assert again.end == pytest.approx(one.end, rel=1e-11)
    assert again.jacobian @ two.jacobian == pytest.approx(one.jacobian, rel=1e-10, abs=1e-13)
    assert (one.sign, two.sign) == (1.0, -1.0)
    assert (one.middle, two.middle) == (None, None)
    for map, other in ((whole, whole.doubled()), (half, half.doubled())):
        assert other.doublings == 1
        passage = other.passage(value, state)
        assert passage.middle == pytest.approx(map.passage(value, state).end, rel=1e-11)
    assert whole.doubled().periods == 2
    assert half.doubled().periods == 1
    assert not half.doubled().mirrored
    assert half.doubled().doubled().doublings == 2
    assert whole.size == 2
    assert one.events == 0


def test_the_derivative_by_the_value_and_the_neighbour_it_needs() -> None:
    map = MechanismMap(linear_oscillator(), "bodies.mass.mass", 3.0)
    value, mechanism = map.neighbour(1.0)
    assert value == pytest.approx(1.0 + 3e-7, rel=1e-14)
    assert mechanism.value("bodies.mass.mass") == value
    # Where it cannot be larger, such as a force that static friction bounds, it is smaller.
    twin = between_stops(0.2)
    rubbing = replace(twin, frictions={"floor": Friction(("ground", "body"), force=0.5, static=0.5)})
    below, mechanism = MechanismMap(rubbing, "frictions.floor.force", 2.0).neighbour(0.5)
    assert below == pytest.approx(0.5 - 2e-7, rel=1e-14)
    assert mechanism.value("frictions.floor.force") == below


def test_a_spring_that_appears_with_the_number_has_a_derivative_by_a_difference() -> None:
    # Without friction there is no part for it: the derivative is that of the motion with very little.
    mechanism = replace(linear_oscillator(), frictions={"floor": Friction(("ground", "mass"), force=0.0)})
    map = MechanismMap(mechanism, "frictions.floor.force", 10.0)
    state = settled_state()
    passage = map.passage(0.0, state)
    little = map.passage(1e-5, state)
    assert passage.rate() == pytest.approx((little.end - passage.end) / 1e-5, rel=1e-3)


def test_the_sizes_of_a_passage_are_its_largest_values() -> None:
    map = MechanismMap(linear_oscillator(), "frequency", 1.2)
    sizes = map.passage(OMEGA / (2.0 * math.pi), settled_state()).sizes
    assert sizes == pytest.approx([abs(RESPONSE), OMEGA * abs(RESPONSE)], rel=2e-3)


def test_phases_of_contact_are_counted_and_timed() -> None:
    mechanism = between_stops(0.2)
    flow = ExactFlow(mechanism)
    state = flow.strobe(flow.rest(), 150).states[-1]
    map = MechanismMap(mechanism, "frequency", 0.2)
    whole, half = map.passage(0.2, state), replace(map, mirrored=True).passage(0.2, state)
    upper, lower = ("springs", Phase.UPPER), ("springs", Phase.LOWER)
    assert whole.signature[upper] == whole.signature[lower] > 0
    assert half.signature == {("springs", Phase.EITHER): whole.signature[upper]}
    times = np.linspace(0.0, whole.course.duration, 50_001)
    beyond = whole.course.states(times)[:, 0]
    for phase, touching in ((Phase.UPPER, beyond > 1.0), (Phase.LOWER, beyond < -1.0)):
        edges = np.flatnonzero(np.diff(touching.astype(int)))
        lengths = np.diff(times[edges])
        # Contacts and pauses between them, both within the passage.
        assert whole.shortest("springs", phase) == pytest.approx(lengths.min(), abs=3e-4)
    linear = MechanismMap(linear_oscillator(), "frequency", 1.2).passage(1.2, np.zeros(2))
    assert linear.signature == {}


def test_the_flows_of_the_last_values_are_kept() -> None:
    map = MechanismMap(linear_oscillator(), "frequency", 1.2)
    first = map.flow(1.0)
    for value in (1.1, 1.2, 1.3):
        map.flow(value)
    assert map.flow(1.0) is first
    map.flow(1.4)
    assert map.flow(1.0) is not first
    assert map.flow(1.4).period == pytest.approx(1.0 / 1.4, rel=1e-14)


def test_a_motion_of_too_many_steps_cannot_be_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mechanism_map, "MOST_STEPS", 1)
    map = MechanismMap(impact_oscillator(), "frequency", 1.2)
    for each in (map, replace(map, mirrored=True)):
        with pytest.raises(UnsupportedMotionError, match="the motion ends after"):
            each.passage(1.2, np.array([-25.0, 0.0]))


class Repeating:
    """Says after which parts of its periods a motion repeats."""

    def __init__(self, *known: tuple[int, bool]) -> None:
        self.known = known

    def __call__(self, half: MechanismMap, map: MechanismMap, value: float, state: np.ndarray) -> bool:
        return (half.periods, half.mirrored) in self.known


def shape(map: MechanismMap | None) -> list[tuple[int, bool]]:
    return [] if map is None else [(map.periods, map.mirrored), *shape(map.single)]


@pytest.mark.parametrize(
    ("periods", "symmetric", "known", "expected"),
    [
        (1, False, [], [(1, False)]),
        (1, True, [], [(1, False), (1, True)]),
        (1, True, [(1, True)], [(1, True)]),
        (3, True, [(3, True)], [(3, True)]),
        (2, False, [], [(2, False), (1, False)]),
        (2, False, [(1, False)], [(2, False)]),
        (2, True, [], [(2, False), (1, False), (1, True)]),
        (4, False, [], [(4, False), (2, False), (1, False)]),
        (12, True, [], [(12, False), (6, False), (3, False), (3, True)]),
    ],
)
def test_a_map_is_doubled_so_often_that_the_motion_is_its_orbit(
    monkeypatch: pytest.MonkeyPatch,
    periods: int,
    symmetric: bool,
    known: list[tuple[int, bool]],
    expected: list[tuple[int, bool]],
) -> None:
    mechanism = between_stops(0.2) if symmetric else impact_oscillator()
    monkeypatch.setattr(fits, "_repeats", Repeating(*known))
    found = fitting(MechanismMap(mechanism, "frequency", 1.0, periods), 0.2, np.zeros(2))
    assert shape(found) == expected
    whole = MechanismMap(mechanism, "frequency", 1.0, periods)
    assert is_symmetric(whole, 0.2, np.zeros(2)) == (symmetric and (periods, True) in known)
    assert shape(_asymmetric(whole)) == [each for each in shape(_asymmetric(whole)) if each[0] <= periods]


@pytest.mark.parametrize(
    ("periods", "known", "expected"), [(8, [4, 2], 2), (8, [2], 8), (6, [3, 1], 3), (5, [1], 5), (2, [1], 1)]
)
def test_the_shortest_map_is_halved_as_long_as_the_motion_repeats(
    monkeypatch: pytest.MonkeyPatch, periods: int, known: list[int], expected: int
) -> None:
    monkeypatch.setattr(fits, "_repeats", Repeating(*((each, False) for each in known)))
    map = MechanismMap(impact_oscillator(), "frequency", 1.0, periods)
    assert shortest_map(map, 0.2, np.zeros(2)).periods == expected


def test_a_motion_repeats_if_half_of_it_does_as_far_as_it_is_known() -> None:
    def of(end: list[float]) -> SimpleNamespace:
        passage = SimpleNamespace(end=np.array(end), sizes=np.array([2.0, 0.0]))
        return SimpleNamespace(passage=lambda value, state: passage)

    state = np.array([1.0, 0.0])
    exact = of([1.0, 0.0])
    for end, repeats in (([1.0 + 1.9e-6, 0.0], True), ([1.0 - 2.1e-6, 0.0], False), ([1.0, -1.1e-6], False)):
        assert fits._repeats(of(end), exact, 0.0, state) == repeats  # type: ignore[arg-type]
    # The whole misses by 1e-3 of its size, so that the half may miss by ten times that.
    unsettled = of([1.0 - 2e-3, 0.0])
    for end, repeats in (([1.0 + 1.99e-2, 0.0], True), ([1.0 - 2.02e-2, 0.0], False)):
        assert fits._repeats(of(end), unsettled, 0.0, state) == repeats  # type: ignore[arg-type]


def belt() -> Mechanism:
    """A block on a belt with static friction 1 and kinetic friction 0.5: its motion is known."""
    return Mechanism(
        bodies={"block": Body(1.0)},
        pins={"belt": Pin("ground", velocity=0.2)},
        links={"spring": Link(("ground", "block"), 1.0)},
        frictions={"rubbing": Friction(("belt", "block"), force=0.5, static=1.0)},
        outputs={"block": Output({"block": 1.0})},
    )


SPEED = "pins.belt.velocity"
PERIOD = 2.0 * (math.pi - math.atan(0.5 / 0.2)) + 1.0 / 0.2


def test_the_period_of_a_motion_without_a_drive_is_a_part_of_the_state() -> None:
    map = SelfExcitedMap(belt(), SPEED, 0.2)
    assert map.size == 3
    # Slipping begins at x = 1 with the velocity of the belt; here amid the stick.
    state = np.array([0.7, 0.2, PERIOD])
    passage = map.passage(0.2, state)
    assert passage.end == pytest.approx(state, abs=1e-9)
    assert passage.course.duration == pytest.approx(PERIOD, rel=1e-14)
    assert passage.sizes[-1] == PERIOD
    assert passage.sizes[0] == pytest.approx(0.5 + math.hypot(0.5, 0.2), rel=1e-3)
    section = passage.section
    # The block moves with the belt: the plane is across its displacement, which grows.
    assert section.point == pytest.approx([0.7, 0.2], rel=1e-9)
    assert section.period == pytest.approx(PERIOD, rel=1e-12)
    assert section.normal[0] == pytest.approx(1.0 / passage.sizes[0], rel=1e-9)
    assert section.normal[1] == pytest.approx(0.0, abs=1e-12)
    assert section.height(np.array([[0.8, 9.0], [0.5, 0.0]])) == pytest.approx(
        np.array([0.1, -0.2]) / passage.sizes[0], rel=1e-9
    )
    assert passage.slant == pytest.approx(1.0, rel=1e-12)
    held = replace(map, section=replace(section, point=section.point - [0.1, 0.0]))
    late = held.passage(0.2, state)
    assert late.end[-1] == pytest.approx(PERIOD * (1.0 + 0.1 / passage.sizes[0]), rel=1e-9)
    # Where it sticks neither state has a say in what comes after; the period moves the end along.
    jacobian = late.jacobian
    assert jacobian[:2, 2] == pytest.approx([0.2, 0.0], abs=1e-12)
    assert jacobian[2] == pytest.approx([PERIOD / passage.sizes[0], 0.0, 1.0], abs=1e-9)
    assert abs(late.monodromy).max() < 1e-9
    twice = replace(map, periods=2).passage(0.2, state)
    assert twice.course.duration == pytest.approx(2.0 * PERIOD, rel=1e-14)
    assert twice.jacobian[:2, 2] == pytest.approx([0.4, 0.0], abs=1e-12)
    assert twice.section.period == pytest.approx(PERIOD, rel=1e-12)


def test_a_period_far_from_that_of_the_plane_is_lost() -> None:
    section = Section(np.array([0.7, 0.2]), np.array([1.0, 0.0]), 5.0)
    map = SelfExcitedMap(belt(), SPEED, 0.2, section=section)
    for period in (1.24, 20.1):
        with pytest.raises(UnsupportedMotionError, match="too far"):
            map.passage(0.2, np.array([0.7, 0.2, period]))
    for period in (1.26, 19.9):
        assert map.passage(0.2, np.array([0.7, 0.2, period])).start[-1] == period


def test_an_orbit_is_made_to_begin_amid_its_longest_segment() -> None:
    map = SelfExcitedMap(belt(), SPEED, 0.2)
    # It sticks for longer than it slips: orbits begin amid the stick, at x = 0.5.
    # Here 0.1 s after it has begun to slip, which is too near to that.
    after = 0.1
    displacement = 0.5 + 0.5 * math.cos(after) + 0.2 * math.sin(after)
    slipping = np.array([displacement, 0.2 * math.cos(after) - 0.5 * math.sin(after), PERIOD])
    other, state = map.restarted(0.2, slipping)
    assert other.section is not None
    assert state == pytest.approx([0.5, 0.2, PERIOD], abs=1e-9)
    assert other.section.point == pytest.approx([0.5, 0.2], abs=1e-9)
    same, again = other.restarted(0.2, state)
    assert same is other
    assert again is state
    # It passes the plane upwards once in a period, at that state.
    (phase,) = other.phases(0.2, slipping)
    assert phase == pytest.approx([0.5, 0.2, PERIOD], abs=1e-8)
    assert map.phases(0.2, slipping)[0] is slipping
    doubled = map.doubled()
    assert isinstance(doubled, SelfExcitedMap)
    whole, _ = doubled.restarted(0.2, slipping)
    assert isinstance(whole.single, SelfExcitedMap)
    assert whole.single.section is whole.section
    # A plane along the motion is turned.
    section = replace(other.section, normal=other.section.normal[::-1] * [0.0, 1.0] + [0.0, 1.0])
    turned, _ = replace(map, section=section).restarted(0.2, state)
    assert turned.section is not section


def starting(duration: float, *starts: float) -> float:
    course = SimpleNamespace(log=SimpleNamespace(start=np.array(starts)), duration=duration)
    return SelfExcitedPassage.better_start.fget(SimpleNamespace(course=course))  # type: ignore[attr-defined, no-any-return]


@pytest.mark.parametrize(
    ("duration", "starts", "time"),
    [
        (10.0, (0.0,), 0.0),
        # Its own segment from 7 over the end to 2: two fifths of it lie behind the beginning.
        (10.0, (0.0, 2.0, 7.0), 0.0),
        # The own one is a fifth of the longest, which is from 1 to 9.5.
        (10.0, (0.0, 1.0, 9.5), 5.25),
        (10.0, (0.0, 1.0, 3.0, 9.5), 6.25),
        # Its beginning is too near to the ends of its own: amid that, if it is the longest.
        (10.0, (0.0, 0.5, 4.5), 7.5),
        (10.0, (0.0, 5.5, 9.5), 2.5),
        (10.0, (0.0, 0.2, 6.0), 3.1),
        # It holds the events of one instant once.
        (10.0, (0.0, 2.0, 2.0, 7.0, 7.0), 0.0),
        (10.0, (0.0, 5.0), 0.0),
        (10.0, (0.0, 9.5), 4.5),
        (10.0, (0.0, 1.0), 6.0),
    ],
)
def test_where_an_orbit_had_better_begin(duration: float, starts: tuple[float, ...], time: float) -> None:
    assert starting(duration, *starts) == pytest.approx(time, rel=1e-12)


def test_sequences_that_are_made_of_like_halves() -> None:
    lists = (
        [],
        [1],
        [1, 2],
        [1, 1],
        [1, 2, 1, 2],
        [1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3],
        [1, 1, 1],
        [1, 2, 2, 1],
    )
    assert [_halvings(each) for each in lists] == [0, 0, 0, 1, 1, 2, 0, 0]
    events = [(0.0, 0, 5), (0.1, 1, 4), (0.2, 0, 5), (0.3, 1, 4), (0.4, 1, 4), (0.5, 1, 4)]
    passage = SimpleNamespace(course=SimpleNamespace(events=events))
    assert SelfExcitedPassage.halvings.fget(passage) == 1  # type: ignore[attr-defined]
    passage.course.events = []
    assert SelfExcitedPassage.halvings.fget(passage) == 0  # type: ignore[attr-defined]


def test_the_multiplier_of_a_shift_in_time_takes_the_place_of_two_zeros() -> None:
    found = with_trivial(np.array([-2.0, 0.5j, 1e-17, 0.0]))
    assert found.tolist() == [-2.0, 1.0, 0.5j]


def test_a_plane_across_a_motion_at_a_time() -> None:
    flow = ExactFlow(linear_oscillator())
    course = flow.course(flow.at(settled_state()), 1)
    time = 0.3
    section = section_at(course, time, 1)
    turn = np.exp(1j * OMEGA * time) * RESPONSE
    assert section.point == pytest.approx([turn.real, (1j * OMEGA * turn).real], rel=1e-10)
    rates = np.array([(1j * OMEGA * turn).real / OMEGA, -OMEGA * turn.real / OMEGA]) / abs(RESPONSE)
    assert section.normal * [1.0, OMEGA] * abs(RESPONSE) == pytest.approx(rates, rel=3e-3)
    assert section_at(course, time, 2).period == pytest.approx(0.5 * section.period, rel=1e-14)


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
