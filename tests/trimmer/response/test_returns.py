"""Newton's method for a state that returns, in its parts, and what an orbit says of itself."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import CONTACT_MADE, NOTHING, REVERSED
from trimmer.mechanism import Body, Force, Link, Mechanism
from trimmer.response import self_excited
from trimmer.response.orbit import MechanismOrbit, _divides, _smallest, orbit_of
from trimmer.response.self_excited import _recurrences, at_rest, time_scale
from trimmer.response.settling import Settling
from trimmer.response.shooting import Patience, Return, _improved, sizes_of, solve

OMEGA = 7.5
DRIVEN = Mechanism(
    {"one": Body(1.0), "two": Body(0.5)},
    frequency=OMEGA / (2 * math.pi),
    links={"spring": Link(("ground", "one"), 40.0, 0.6), "strut": Link(("one", "two"), 90.0, 0.2)},
    forces={"push": Force("two", constant=5.0, amplitude=100.0)},
)


def test_one_step_of_newton_solves_a_linear_return() -> None:
    flow = ExactFlow(DRIVEN)
    problem = Return(flow, 2)
    shot = problem.shoot(flow.at(np.array([1.0, -2.0, 30.0, 4.0])))
    assert shot.miss > 1e-2
    by, longer = problem.step(shot)
    assert longer == 0.0
    solved = problem.corrected(shot, 1.0, (by, longer))
    assert solved.miss < 1e-12
    assert solved.sizes is shot.sizes
    # The steady response, from the balance of forces.
    dynamic = np.array(
        [
            [130 - OMEGA**2 + 0.8j * OMEGA, -90 - 0.2j * OMEGA],
            [-90 - 0.2j * OMEGA, 90 - 0.5 * OMEGA**2 + 0.2j * OMEGA],
        ]
    )
    moved = np.linalg.solve(dynamic, [0, 100])
    constant = np.linalg.solve([[130, -90], [-90, 90]], [0, 5])
    expected = np.concatenate([moved.imag + constant, (1j * OMEGA * moved).imag])
    np.testing.assert_allclose(shot.course.begin.state + by, expected, rtol=1e-9)
    half = problem.corrected(shot, 0.5, (by, longer))
    np.testing.assert_allclose(half.course.begin.state, shot.course.begin.state + 0.5 * by, rtol=1e-12)
    assert half.miss == pytest.approx(0.5 * shot.miss, rel=1e-9)
    assert _improved(problem, shot, 1).miss < 1e-12
    assert _improved(problem, shot, 0) is None
    assert solve(problem, shot.course.begin, patience=Patience(iterations=1)).miss < 1e-12
    assert solve(problem, shot.course.begin, patience=Patience(iterations=0)).miss == shot.miss


def test_a_gap_is_end_less_start_in_sizes() -> None:
    flow = ExactFlow(DRIVEN)
    shot = Return(flow, 1).shoot(flow.at(np.array([1.0, -2.0, 30.0, 4.0])), sizes=np.array([2.0, 3, 4, 5]))
    course = shot.course
    apart = (course.end.state - course.begin.state) / [2.0, 3, 4, 5]
    np.testing.assert_allclose(shot.gap, apart, rtol=1e-9)
    assert shot.miss == pytest.approx(abs(apart).max(), rel=1e-9)
    assert shot.duration == pytest.approx(2 * math.pi / OMEGA)
    before, after = shot.rates
    step = 1e-6
    for rate, time in ((before, 0.0), (after, shot.duration - 2 * step)):
        states = course.states(np.array([time, time + step, time + 2 * step]))[:, :4]
        slopes = (states[2] - states[0]) / (2 * step)
        np.testing.assert_allclose(rate, slopes, rtol=1e-3, atol=1e-3)


def test_without_a_drive_the_correction_is_at_right_angles_to_the_motion() -> None:
    flow = ExactFlow(Mechanism({"body": Body(2.0)}, links={"spring": Link(("ground", "body"), 50.0)}))
    problem = Return(flow, 0)
    shot = problem.shoot(flow.at(np.array([0.3, 0.4])), 1.3)
    by, longer = problem.step(shot)
    assert shot.duration + longer == pytest.approx(2 * math.pi / 5, abs=0.05)
    tangent = np.array([0.4, -25 * 0.3])
    assert abs((tangent / shot.sizes) @ (by / shot.sizes)) < 1e-9 * abs(tangent / shot.sizes).max()
    again = solve(problem, flow.at(np.array([0.3, 0.4])), 1.3)
    assert again.duration == pytest.approx(2 * math.pi / 5, rel=1e-9)
    assert problem.corrected(shot, 1.0, (by, -1.3)) is None
    assert problem.corrected(shot, 1.0, (by, 3 * 1.3 + 1e-9)) is None
    assert problem.corrected(shot, 1.0, (by, 3 * 1.3 - 1e-9)) is not None


def course_of(states: list, end: list, bodies: int, duration: float):
    """A motion of which sizes are asked."""
    frame = SimpleNamespace(reduced=lambda states: states)
    layout = SimpleNamespace(bodies=("b",) * bodies, state_count=len(end), frame=frame, period=0.0)
    log = SimpleNamespace(state=np.column_stack([states, np.full(len(states), 99.0)]))
    last = SimpleNamespace(state=np.array(end))
    return SimpleNamespace(modes=SimpleNamespace(layout=layout), log=log, end=last, duration=duration)


def test_sizes_are_the_largest_moduli() -> None:
    states = [[1.0, -2.0, 3.0, 10.0, 0.5], [-1.5, 0.0, -2.0, 4.0, -0.7]]
    course = course_of(states, [0.1, 0.2, 5.0, 1.0, 0.6], 2, 1.0)
    assert sizes_of(course).tolist() == [1.5, 2.0, 5.0, 10.0, 0.7]


def test_what_hardly_moves_is_measured_by_the_others_of_its_kind() -> None:
    # The longest is 4, at 2 pi / s; the fastest 100.
    course = course_of([[4.0, 1e-9, 100.0, 1e-9, 1e-9]], [0.0] * 5, 2, 1.0)
    assert sizes_of(course) == pytest.approx([4.0, 4e-4, 100.0, 1e-2, 4e-4])
    # Displacements are at least a tenth of what the velocities make of them, and the other way round.
    course = course_of([[0.0, 100.0]], [0.0, 0.0], 1, 3.0)
    assert sizes_of(course) == pytest.approx([1e-4 * 10.0 / (2 * math.pi / 3), 100.0])
    course = course_of([[7.0, 0.0]], [0.0, 0.0], 1, 3.0)
    assert sizes_of(course) == pytest.approx([7.0, 1e-4 * 0.7 * (2 * math.pi / 3)])
    assert sizes_of(course_of([[0.0, 0.0]], [0.0, 0.0], 1, 3.0)).tolist() == [1.0, 1.0]


def test_the_time_scale_is_the_period_of_the_slowest_mode() -> None:
    links = {"a": Link(("ground", "one"), 50.0), "b": Link(("ground", "two"), 8.0)}
    flow = ExactFlow(Mechanism({"one": Body(2.0), "two": Body(2.0)}, links=links))
    assert time_scale(flow, flow.rest()) == pytest.approx(math.pi)
    free = ExactFlow(Mechanism({"one": Body(2.0)}, forces={"push": Force("one", constant=1.0)}))
    assert time_scale(free, free.rest()) == 1.0


def test_a_motion_is_at_rest_where_nothing_changes_any_more() -> None:
    mechanism = Mechanism({"body": Body(1.0)}, links={"spring": Link(("ground", "body"), 25.0, 5.0)})
    flow = ExactFlow(mechanism)
    begun = flow.rest({"body": (1.0, 0.0)})
    # It decays with 2.5 / s.
    assert not at_rest(flow.timed(begun, 5.0), 2 * math.pi / 5)
    assert not at_rest(flow.timed(begun, 8.0), 2 * math.pi / 5)
    assert at_rest(flow.timed(begun, 11.0), 2 * math.pi / 5)
    assert at_rest(flow.timed(flow.rest(), 1.0), 2 * math.pi / 5)


def logged(rows: list, times: list):
    """A log: mode, part, kind and two states of each row."""
    mode, part, kind, *states = np.array(rows, dtype=float).T
    log = SimpleNamespace(
        start=np.array(times),
        mode=mode.astype(int),
        part=part.astype(int),
        kind=kind.astype(int),
        state=np.array([*states, np.ones(len(mode))]).T,
    )
    return SimpleNamespace(log=log)


def test_recurrences_are_the_same_event_in_nearly_the_same_state() -> None:
    made, turned = CONTACT_MADE, REVERSED
    rows = [
        [0, 0, NOTHING, 1.0, 1.0],
        [1, 0, made, 1.0, 5.0],
        [0, 1, turned, 2.0, 5.0],
        [1, 0, made, 1.05, 5.4],
        [1, 1, made, 1.05, 5.4],
        [1, 0, made, 1.0, 7.0],
        [1, 0, made, 1.05, 5.1],
        [0, 1, turned, 2.05, 5.1],
        [0, 1, turned, 9.0, 5.1],
    ]
    course = logged(rows, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0])
    assert _recurrences(course, np.array([1.0, 5.0])) == [(2, 7), (3, 6), (1, 3)]
    # A row that lasts no time, and the last one, do not count.
    course = logged(rows, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 6.0, 8.0])
    assert _recurrences(course, np.array([1.0, 5.0])) == [(2, 7), (1, 3)]
    assert _recurrences(course, np.array([0.1, 0.1])) == []


def test_a_motion_is_told_over_its_smallest_period(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []

    def once(apart: dict[int, list], *, events: int = 6, miss: float = 0.0, resting: bool = False):
        def states(times: np.ndarray) -> np.ndarray:
            (count,) = np.round(12.0 / times).astype(int)
            one, two = apart.get(count, [0.0, 0.0])
            return np.array([[1.0 + one, 2.0 + two, 99.0]])

        def solved(problem: Return, begin: SimpleNamespace, span: float) -> SimpleNamespace:
            assert problem.periods == 0
            asked.append(span)
            return SimpleNamespace(miss=miss, course="shorter", duration=span)

        begin = SimpleNamespace(state=np.array([1.0, 2.0]))
        course = SimpleNamespace(events=[0] * events, duration=12.0, states=states, begin=begin)
        monkeypatch.setattr(self_excited, "solve", solved)
        monkeypatch.setattr(
            self_excited, "at_rest", lambda course, unit: resting or (course, unit) != ("shorter", asked[-1])
        )
        given = SimpleNamespace(course=course, sizes=np.array([10.0, 0.1]))
        found = self_excited._once(SimpleNamespace(size=2), given)
        return None if found is given else found.duration

    assert once({}) == 2.0
    # In units of the sizes: the first entry is 10, the second 0.1.
    assert once({6: [9e-6, 9e-8]}) == 2.0
    assert once({6: [-1.1e-5, 0.0]}) == 4.0
    assert once({6: [0.0, 1.1e-7], 3: [0.0, -1.1e-7]}) == 6.0
    assert once({6: [1.0, 0.0], 3: [0.0, 1.0], 2: [1.0, 0.0]}) is None
    assert once({}, events=5) == 12.0 / 5
    asked.clear()
    assert once({}, events=1) is None
    assert asked == []
    assert once({}, miss=1.0) is None
    assert asked == [2.0, 4.0, 6.0]
    assert once({}, resting=True) is None


def orbit(multipliers: list, periods: int = 1, success: bool = True, sizes: tuple = (1.0, 1.0), **parts):
    course = SimpleNamespace(
        duration=3.0, events=[0] * 12, begin="begin", monodromy=parts.pop("monodromy", None)
    )
    flow = SimpleNamespace(mechanism=SimpleNamespace(title="it"), period=1.5, size=2, shifts=0)
    flow.reduced, flow.travelling = (lambda states: states), (lambda course: (flow, course))
    values = np.array(multipliers, dtype=complex)
    return MechanismOrbit(flow, periods, 1, course, np.array(sizes), values, 1e-12, success, "told")


def test_an_orbit_is_stable_neutral_or_neither() -> None:
    for multipliers, margins, stable, neutral in (
        ([0.9, -0.99], [0.0, 0.0], True, False),
        ([1.0 - 1e-7, 0.5], [1e-8, 1e-8], True, False),
        ([1.0 - 1e-9, 0.5], [1e-8, 1e-8], False, True),
        ([1.0, 0.5], [0.0, 0.0], False, True),
        ([0.5, -1.0 - 5e-9], [0.0, 1e-8], False, True),
        ([0.5, -1.0 - 5e-7], [0.0, 1e-8], False, False),
        ([0.5, 1.1j], [0.0, 0.0], False, False),
        ([], [], True, False),
    ):
        found = replace(orbit(multipliers), margins=np.array(margins))
        assert (found.stable, found.neutral) == (stable, neutral)
        missed = replace(found, success=False)
        assert not missed.stable
        assert not missed.neutral
    free = orbit([-1.2, 1.0 + 1e-9, 0.3], periods=0)
    assert free.nontrivial_multipliers.tolist() == [-1.2, 0.3]
    assert orbit([0.7, 1.0 + 1e-9], periods=0).stable
    assert (orbit([], 4).events_per_period, orbit([], 0).events_per_period) == (3.0, 12.0)
    assert (free.period, free.instant) == (3.0, "begin")


def test_small_distances_may_grow_before_they_die_out() -> None:
    matrix = np.array([[0.5, 30.0], [0.0, 0.4]])
    found = orbit([0.5, 0.4], sizes=(2.0, 3.0), monodromy=matrix)
    shares = [[0.5, 45.0], [0.0, 0.4]]
    np.testing.assert_allclose(found.monodromy, shares)
    powers = [np.linalg.matrix_power(shares, k) for k in range(1, 12)]
    assert found.growth == pytest.approx(max(abs(each).sum(axis=1).max() for each in powers))
    assert orbit([0.1], sizes=(1.0, 1.0), monodromy=0.05 * np.eye(2)).growth == 1.0
    slow = np.array([[0.5, 4.0], [0.0, 0.9]])
    powers = [np.linalg.matrix_power(slow, k) for k in range(1, 40)]
    largest = max(abs(each).sum(axis=1).max() for each in powers)
    assert orbit([0.9], monodromy=slow).growth == pytest.approx(largest)


def test_the_smallest_number_of_periods_divides_the_number() -> None:
    apart = np.array([0.0, 1.0, 1e-9, 1e-9, 1.0, 1.0])
    assert [_divides(count, 6, apart) for count in (1, 2, 3, 4)] == [False, True, True, False]
    flow = SimpleNamespace(period=0.5, size=2)
    sizes = np.array([1.0, 10.0])

    def smallest(states: list) -> int:
        def at(times: np.ndarray) -> np.ndarray:
            np.testing.assert_allclose(times, 0.5 * np.arange(len(states)))
            return np.column_stack([states, np.ones(len(states))])

        return _smallest(flow, SimpleNamespace(course=SimpleNamespace(states=at), sizes=sizes), len(states))

    assert smallest([[0.0, 1.0]] * 4) == 1
    assert smallest([[0.0, 1.0], [0.3, 1.0]] * 3) == 2
    assert smallest([[0.0, 1.0], [0.0, 1.0 + 2e-7], [0.0, 1.0 - 2e-7]] * 2) == 3
    assert smallest([[0.0, 1.0], [0.3, 1.0], [0.4, 1.0], [0.0, 1.0], [0.0, 1.2]]) == 5
    assert smallest([[0.0, 1.0]]) == 1


TOLD = [
    ([0.5], 1, "a stable motion that repeats after one drive period"),
    ([1.0], 3, "a neutral motion that repeats after one drive period already, not 3"),
    ([2.0], 1, "an unstable motion that repeats after one drive period"),
]


@pytest.mark.parametrize(("multipliers", "periods", "told"), TOLD)
def test_an_orbit_says_what_it_is(multipliers: list, periods: int, told: str) -> None:
    def states(times: np.ndarray) -> np.ndarray:
        return np.ones((len(times), 2))

    course = SimpleNamespace(states=states, duration=0.5, events=[])
    flow = SimpleNamespace(period=0.5, size=1, shifts=0, reduced=lambda states: states)
    flow.advances = lambda sizes: False
    flow.travelling = lambda course: (flow, course)
    shot = SimpleNamespace(
        monodromy=np.diag(multipliers), miss=1e-12, course=course, sizes=np.ones(1), gap=None, calm=None
    )
    assert orbit_of(flow, shot, periods).message == told
    assert orbit_of(flow, shot, periods, "more").message == f"{told}; more"
    missed = SimpleNamespace(**{**vars(shot), "miss": 1e-3})
    found = orbit_of(flow, missed, periods, "more")
    assert not found.success
    assert found.residual == 1e-3
    assert found.period_count == periods
    count = f"{periods} drive periods"
    assert found.message.startswith(f"no motion that returns after {count} was found; the closest misses")
    free = orbit_of(flow, missed, 0)
    assert free.message.startswith("no motion that returns after 0.5 s was found")
    assert free.period_count == 1


def test_multipliers_come_by_falling_modulus() -> None:
    course = SimpleNamespace(duration=0.5, begin=None, events=[])
    shot = SimpleNamespace(
        monodromy=np.diag([0.1, -3.0, 1.0]), miss=0.0, course=course, sizes=np.ones(3), calm=None
    )
    flow = SimpleNamespace(period=0.0, size=3, shifts=0, travelling=lambda course: (flow, course))
    flow.advances = lambda sizes: False
    found = orbit_of(flow, shot, 0)
    assert found.multipliers.tolist() == [-3.0, 1.0, 0.1]
    assert found.message == "an unstable motion that repeats after 0.5 s"


def test_a_motion_is_followed_in_periods_and_the_last_ones_are_kept() -> None:
    flow = ExactFlow(DRIVEN)
    settling = Settling(flow, flow.rest())
    assert settling.follow(200)
    assert (settling.periods, settling.states.shape) == (200, (201, 4))
    assert settling.follow(100)
    assert (settling.periods, settling.states.shape) == (300, (256, 4))
    np.testing.assert_array_equal(settling.states[-1], settling.instant.state)
    expected = flow.strobe(flow.rest(), 60).states[-1]
    np.testing.assert_allclose(settling.states[60 - 300 - 1], expected, rtol=1e-9)
    near = SimpleNamespace(strobed=settling.states[-1:] + 0.4, sizes=np.ones(4))
    far = SimpleNamespace(strobed=settling.states[-1:] + np.array([0.0, 0.0, 0.6, 0.0]), sizes=np.ones(4))
    settling.known[:] = [far]
    assert not settling._is_near()
    settling.known.append(near)
    assert settling._is_near()
