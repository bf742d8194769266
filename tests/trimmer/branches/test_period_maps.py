"""Maps of a mechanism's period, on mechanisms whose motion is known in closed form."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.test_joining import between_stops
from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer.branches.period_maps import fitting as fits
from trimmer.branches.period_maps import mechanism_map
from trimmer.branches.period_maps.fitting import _asymmetric, fitting, is_symmetric, shortest_map
from trimmer.branches.period_maps.mechanism_map import MechanismMap
from trimmer.branches.period_maps.period_map import Phase
from trimmer.contact.advance import Instant
from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import (
    BACKWARD,
    FORWARD,
    FREE,
    MINUS,
    PLUS,
    RELEASED_MINUS,
    RELEASED_PLUS,
    STICK,
)
from trimmer.errors import UnsupportedMotionError
from trimmer.mechanism.parts import Friction

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


def test_a_passage_begins_with_the_statuses_of_its_end_where_it_ends_with_them_again() -> None:
    flow = SimpleNamespace(
        at=lambda state, phase: SimpleNamespace(statuses=(0,)), reduced=lambda state: state
    )
    followed = mechanism_map.MechanismMap.followed
    for statuses, repeated, expected in (
        ((0,), "again", "course"),
        ((1,), "again", "again"),
        ((1,), None, "course"),
    ):
        asked = []

        def course(
            flow: object, begin: object, duration: float, asked: list[object] = asked
        ) -> SimpleNamespace:
            asked.append(duration)
            return SimpleNamespace(end="end", name="course")

        map = SimpleNamespace(
            course=course,
            _phase=lambda flow: 0.0,
            returned=lambda flow, end, statuses=statuses: SimpleNamespace(statuses=statuses),
            _repeated=lambda *given, repeated=repeated: (
                repeated and ("begin", SimpleNamespace(name=repeated))
            ),
        )
        assert followed(map, flow, np.zeros(2), 0.7)[1].name == expected  # type: ignore[arg-type, attr-defined]
        assert asked == [0.7]


def test_the_end_of_a_mirrored_passage_begins_the_next_with_sides_exchanged() -> None:
    flow = SimpleNamespace(modes=SimpleNamespace(machine=SimpleNamespace(stiffness=np.zeros(5))))
    statuses = (PLUS, MINUS, RELEASED_PLUS, RELEASED_MINUS, FREE, FORWARD, BACKWARD, STICK)
    nothing = np.zeros(8)
    end = Instant(np.array([1.0, -2.0]), statuses, 7, 0.25, nothing, nothing, np.zeros(5))
    map = MechanismMap(linear_oscillator(), "frequency", 1.2)
    assert map.returned(flow, end) is end  # type: ignore[arg-type]
    found = replace(map, mirrored=True).returned(flow, end)  # type: ignore[arg-type]
    assert found.state.tolist() == [-1.0, 2.0]
    assert (found.periods, found.phase) == (7, 0.25)
    assert found.statuses == (MINUS, PLUS, RELEASED_MINUS, RELEASED_PLUS, FREE, BACKWARD, FORWARD, STICK)


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
        assert (value, state.tolist()) == (0.2, [0.0, 0.0])
        assert (map.periods, map.mirrored) in ((half.periods, False), (2 * half.periods, False))
        return (half.periods, half.mirrored) in self.known


def shape(map: MechanismMap | None) -> list[tuple[int, bool]]:
    if map is None:
        return []
    assert isinstance(map.periods, int)
    return [(map.periods, map.mirrored), *shape(map.single)]


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


def test_a_motion_of_an_even_number_of_periods_or_without_a_mirror_is_not_symmetric(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(fits, "_repeats", lambda *_: True)
    for mechanism, periods, symmetric in (
        (between_stops(0.2), 1, True),
        (between_stops(0.2), 2, False),
        (between_stops(0.2), 3, True),
        (impact_oscillator(), 1, False),
    ):
        assert is_symmetric(MechanismMap(mechanism, "frequency", 1.0, periods), 0.2, np.zeros(2)) is symmetric


@pytest.mark.parametrize(
    ("periods", "known", "expected"), [(8, [4, 2], 2), (8, [2], 8), (6, [3, 1], 3), (5, [1], 5), (2, [1], 1)]
)
def test_the_shortest_map_is_halved_as_long_as_the_motion_repeats(
    monkeypatch: pytest.MonkeyPatch, periods: int, known: list[int], expected: int
) -> None:
    monkeypatch.setattr(fits, "_repeats", Repeating(*((each, False) for each in known)))
    map = MechanismMap(impact_oscillator(), "frequency", 1.0, periods)
    found = shortest_map(map, 0.2, np.zeros(2)).periods
    assert (found, isinstance(found, int)) == (expected, True)


def test_a_motion_repeats_if_half_of_it_does_as_far_as_it_is_known() -> None:
    def of(end: list[float], small: float = 0.0) -> SimpleNamespace:
        passage = SimpleNamespace(end=np.array([*end, small]), sizes=np.array([2.0, 0.0, 4e-5]))
        return SimpleNamespace(passage=lambda value, state: passage)

    state = np.array([1.0, 0.0, 0.0])
    exact = of([1.0, 0.0])
    for small, repeats in ((3.9e-11, True), (4.1e-11, False)):
        assert fits._repeats(of([1.0, 0.0], small), exact, 0.0, state) == repeats  # type: ignore[arg-type]
    for end, repeats in (([1.0 + 1.9e-6, 0.0], True), ([1.0 - 2.1e-6, 0.0], False), ([1.0, -1.1e-6], False)):
        assert fits._repeats(of(end), exact, 0.0, state) == repeats  # type: ignore[arg-type]
    # The whole misses by 1e-3 of its size, so that the half may miss by ten times that.
    unsettled = of([1.0 - 2e-3, 0.0])
    for end, repeats in (([1.0 + 1.99e-2, 0.0], True), ([1.0 - 2.02e-2, 0.0], False)):
        assert fits._repeats(of(end), unsettled, 0.0, state) == repeats  # type: ignore[arg-type]
