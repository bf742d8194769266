"""What is said of strobed states, and how a motion is followed, on numbers made by hand."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.maps.machines import linear_oscillator
from trimmer.contact.advance import Ending
from trimmer.contact.flow import ExactFlow
from trimmer.maps import settle as settling
from trimmer.maps.settle import (
    _beside,
    _compared,
    _Following,
    _is_steady,
    _looks,
    _recurrence,
    orbit_near,
    settle,
    strobed_sizes,
)
from trimmer.response.response import MotionKind
from trimmer.response.settling import MOST_REPEATS


def test_sizes_are_the_largest_moduli_and_not_too_small() -> None:
    states = np.array([[1.0, -3e-5, 0.0], [-200.0, 1e-5, 0.0]])
    assert strobed_sizes(states) == pytest.approx([200.0, 2e-4, 2e-4], rel=1e-12)
    assert strobed_sizes(np.array([[2.0, -3e-6]])) == pytest.approx([2.0, 3e-6], rel=1e-12)
    assert (strobed_sizes(np.zeros((2, 2))) > 0.0).all()


def test_the_looks_are_half_as_long_again_apart() -> None:
    assert _looks(200) == [24, 36, 54, 81, 5]
    assert _looks(24) == [24]
    assert _looks(60) == [24, 36]
    assert _looks(0) == []


def repeating(*back: float) -> np.ndarray:
    """States of which the last one differs from those before it by shares of a size of 50, counted back."""
    last = np.array([50.0, 4e-5])
    return np.array([last * (1.0 - each) for each in reversed(back)] + [last])


@pytest.mark.parametrize(
    ("back", "count", "difference"),
    [
        ((0.1, 0.2, 1e-5, 0.1), 3, 1e-5),
        # The shortest that is no more than ten times as bad as the best.
        ((0.1, 9e-5, 0.1, 1e-5), 2, 9e-5),
        ((0.1, 1.1e-4, 0.1, 1e-5), 4, 1e-5),
        # Below rounding all are as good.
        ((0.1, 9e-10, 0.1, 1e-13), 2, 9e-10),
        ((1e-12, 0.1), 1, 1e-12),
    ],
)
def test_a_motion_returns_after_the_fewest_periods_that_are_good_enough(
    back: tuple[float, ...], count: int, difference: float
) -> None:
    found = _recurrence(repeating(*back))
    assert found[0] == count
    assert found[1] == pytest.approx(difference, rel=1e-3, abs=0.0)


def test_returns_are_looked_for_over_so_many_periods() -> None:
    rising = [0.5] * (MOST_REPEATS - 1)
    assert _recurrence(repeating(*rising, 1e-6, 0.5))[0] == MOST_REPEATS
    assert _recurrence(repeating(*rising, 0.5, 1e-6))[0] == 1
    # What was large long ago does not count.
    long_ago = np.vstack([[[9e9, 9e9]], repeating(*([0.5] * 2 * MOST_REPEATS), 0.5)])
    assert _recurrence(long_ago)[1] == pytest.approx(0.5, rel=1e-12)


def growing(rate: float, count: int = 101, first: float = 1e-9) -> tuple[np.ndarray, np.ndarray]:
    """States, and neighbours whose distance grows by a rate; the second state is the one that parts."""
    at = np.arange(count)
    states = np.column_stack([np.cos(at), 4e-5 * np.sin(at)])
    beside = states + np.outer(first * np.exp(rate * at), [0.0, -4e-5])
    return states, beside


SIZES = np.array([1.0, 4e-5])


def test_distances_that_grow_like_an_exponential_are_chaos() -> None:
    kind, exponent = _compared(*growing(0.3), SIZES)
    assert kind is MotionKind.CHAOTIC
    assert exponent == pytest.approx(0.3, rel=1e-5)
    # Growth by less than a thousand is none.
    assert _compared(*growing(0.068), SIZES)[0] is MotionKind.UNDECIDED
    assert _compared(*growing(0.070), SIZES)[0] is MotionKind.CHAOTIC
    # What has grown at once and not like an exponential is none either.
    states, beside = growing(0.0)
    jumped = beside.copy()
    jumped[-3:, 1] = states[-3:, 1] - 4e-5 * 5e-4
    kind, exponent = _compared(states, jumped, SIZES)
    assert kind is MotionKind.UNDECIDED
    assert exponent is not None and exponent * 100 < math.log(1e3) / 2


def test_distances_that_stay_are_a_torus_if_the_motion_is_steady_and_long_enough() -> None:
    for rate in (0.0, 0.02, -0.02):
        kind, exponent = _compared(*growing(rate), SIZES)
        assert kind is MotionKind.TORUS
        assert exponent == pytest.approx(rate, abs=1e-6)
    for rate in (0.025, -0.025):
        assert _compared(*growing(rate), SIZES)[0] is MotionKind.UNDECIDED
    assert _compared(*growing(0.0, 100), SIZES)[0] is MotionKind.UNDECIDED
    states, beside = growing(0.0)
    swelling = np.linspace(1.0, 2.0, 101)[:, None]
    assert _compared(states * swelling, beside * swelling, SIZES)[0] is MotionKind.UNDECIDED


def test_neighbours_that_part_at_once_say_nothing() -> None:
    assert _compared(*growing(3.0, first=1e-5), SIZES) == (MotionKind.UNDECIDED, None)
    # One period more is enough for an exponent.
    kind, exponent = _compared(*growing(3.0, first=1e-6), SIZES)
    assert kind is MotionKind.CHAOTIC
    assert exponent == pytest.approx(3.0, rel=1e-6)
    states, _ = growing(0.0)
    kind, exponent = _compared(states, states, SIZES)
    assert exponent == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(("factor", "steady"), [(1.0, True), (0.951, True), (0.949, False), (1.06, False)])
def test_a_motion_is_steady_if_both_halves_swing_alike(factor: float, steady: bool) -> None:
    first = np.tile([[1.0, 0.0], [-1.0, 4e-5]], (10, 1))
    second = first * [1.0, factor]
    assert _is_steady(np.vstack([first, second])) is steady
    # The middle of the swing is no part of it.
    assert _is_steady(np.vstack([first, second + 7.0])) is steady


class Strobing:
    """A flow whose strobed states are given, to follow without a mechanism."""

    def __init__(self, states: np.ndarray, ending: Ending = Ending.REACHED_END) -> None:
        self.states, self.ending, self.done = states, ending, 0

    def reduced(self, states: np.ndarray) -> np.ndarray:
        return states

    def strobe(self, instant: object, periods: int) -> SimpleNamespace:
        begin, self.done = self.done, self.done + periods
        rows = self.states[begin : self.done + 1]
        counts = np.ones((periods, 6))
        return SimpleNamespace(states=rows, counts=counts, end=("end", self.done), ending=self.ending)

    def at(self, state: np.ndarray, like: object = None) -> SimpleNamespace:
        return SimpleNamespace(state=state)


def test_a_motion_that_ends_on_the_way_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    flow = Strobing(np.zeros((400, 2)), Ending.CHATTERING)
    found = settle(flow, SimpleNamespace(state=np.zeros(2)), 300)  # type: ignore[arg-type]
    assert (found.kind, found.periods, found.ending) == (MotionKind.UNDECIDED, 24, Ending.CHATTERING)
    assert found.end == ("end", 24)
    # After six periods it ends within the fourth of the next ten.
    later = _Following(Strobing(np.zeros((4, 2)), Ending.CHATTERING), None, np.zeros((7, 2)), [])  # type: ignore[arg-type]
    ended = later.on(10)
    assert ended is not None
    assert (ended.periods, ended.end) == (9, ("end", 10))


def test_orbits_are_solved_for_where_the_motion_returns_more_closely(monkeypatch: pytest.MonkeyPatch) -> None:
    tried, orbit = [], SimpleNamespace(stable=False, neutral=False, instant="there", sizes=7.0, periods=3)
    orbit.course = SimpleNamespace(events=["one"])

    def near(flow: object, instant: object, periods: int) -> object:
        tried.append((instant, periods))
        return orbit

    monkeypatch.setattr(settling, "orbit_near", near)
    monkeypatch.setattr(settling, "settles_to", lambda orbit, states: len(states) > 30)
    distances = iter([1.01e-3, 0.99e-3, 0.21e-3, 0.19e-3])

    def recurrence(states: np.ndarray) -> tuple[int, float]:
        return 3, next(distances)

    monkeypatch.setattr(settling, "_recurrence", recurrence)
    following = _Following(Strobing(np.zeros((100, 2))), None, np.zeros((1, 2)), [])  # type: ignore[arg-type]
    for _ in range(3):
        assert following.on(10) is None
    assert tried == [(("end", 20), 3)]
    assert following.known == []
    orbit.stable = True
    found = following.on(5)
    assert len(tried) == 2
    assert found is not None
    assert (found.kind, found.periods, found.end, found.orbit) == (MotionKind.PERIODIC, 35, "there", orbit)


@pytest.mark.parametrize(
    ("stable", "neutral", "returned", "held"),
    [
        (False, True, True, True),
        (False, True, False, False),
        (False, False, True, False),
        (True, True, True, False),
    ],
)
def test_a_neutral_orbit_is_held_if_the_motion_is_on_it(
    monkeypatch: pytest.MonkeyPatch, stable: bool, neutral: bool, returned: bool, held: bool
) -> None:
    orbit = SimpleNamespace(stable=stable, neutral=neutral, instant="there", sizes=7.0, periods=3)
    orbit.course = SimpleNamespace(events=["one"])
    monkeypatch.setattr(settling, "orbit_near", lambda *_: orbit)
    monkeypatch.setattr(settling, "_recurrence", lambda states: (3, 1e-9))
    monkeypatch.setattr(settling, "settles_to", lambda *_: False)
    asked = []

    def has_returned(states: np.ndarray, sizes: float, periods: int) -> bool:
        asked.append((len(states), sizes, periods))
        return returned

    monkeypatch.setattr(settling, "has_returned", has_returned)
    following = _Following(Strobing(np.zeros((100, 2))), None, np.zeros((1, 2)), [])  # type: ignore[arg-type]
    found = following.on(10)
    assert (found is not None) == held
    if found is not None:
        assert (found.kind, found.periods, found.end, found.orbit) == (
            MotionKind.PERIODIC,
            10,
            "there",
            orbit,
        )
    assert following.known == ([orbit] if stable else [])
    assert asked == ([(11, 7.0, 3)] if neutral and not stable else [])


def test_a_neighbour_begins_a_little_aside_where_the_comparison_begins() -> None:
    begun = []

    class Beside(Strobing):
        def at(self, state: np.ndarray, like: object = None) -> SimpleNamespace:
            begun.append((state, like))
            return SimpleNamespace(state=state)

    states, beside = growing(0.2, 61)
    before = SimpleNamespace(state=states[0])
    flow = Beside(beside)
    earlier = np.vstack([np.full((5, 2), 99.0), states])
    following = _Following(flow, ("end", 65), earlier, [])  # type: ignore[arg-type]
    found = _beside(following, before, 60)  # type: ignore[arg-type]
    assert (found.kind, found.periods, found.end) == (MotionKind.CHAOTIC, 65, ("end", 65))
    assert found.lyapunov == pytest.approx(0.2, rel=1e-5)
    ((state, like),) = begun
    assert like is before
    assert state - states[0] == pytest.approx(1e-9 * strobed_sizes(states), rel=1e-6, abs=0.0)
    lost = _Following(Strobing(beside, Ending.DIVERGED), None, earlier, [])  # type: ignore[arg-type]
    assert _beside(lost, before, 60).kind is MotionKind.UNDECIDED  # type: ignore[arg-type]
    assert _beside(lost, before, 60).lyapunov is None  # type: ignore[arg-type]


def test_an_orbit_is_taken_over_as_few_periods_as_it_needs() -> None:
    flow = ExactFlow(linear_oscillator())
    orbit = orbit_near(flow, flow.rest(), 4)
    assert orbit is not None
    assert orbit.period_count == orbit.periods == 1
    omega = 7.5
    response = 100.0 / (40.0 - omega**2 + 0.1j * math.sqrt(40.0) * omega)
    assert orbit.strobed[0] == pytest.approx([response.real, (1j * omega * response).real], rel=1e-9)


def test_an_orbit_is_solved_for_anew_over_the_periods_it_needs(monkeypatch: pytest.MonkeyPatch) -> None:
    asked, orbits = list[Any](), dict[int, Any]()

    def solve(back: tuple[str, int], instant: tuple[str, str], patience: object) -> tuple[int, str] | None:
        asked.append((back, instant))
        assert patience is settling.PATIENCE
        return (back[1], "shot") if back[1] in orbits else None

    def orbit_of(flow: object, shot: tuple[int, str], periods: int) -> SimpleNamespace:
        assert shot == (periods, "shot")
        return SimpleNamespace(**orbits[periods])

    monkeypatch.setattr(settling, "Return", lambda flow, periods: ("back", periods))
    monkeypatch.setattr(settling, "solve", solve)
    monkeypatch.setattr(settling, "orbit_of", orbit_of)
    flow: Any = SimpleNamespace(at=lambda state, like: (state, like.state))
    begin: Any = SimpleNamespace(state="begin")
    orbits[6] = {"success": True, "period_count": 2, "instant": SimpleNamespace(state="nearer")}
    orbits[2] = {"success": True, "period_count": 2}
    found = orbit_near(flow, begin, 6)
    assert found is not None
    assert found.period_count == 2
    assert asked == [(("back", 6), ("begin", "begin")), (("back", 2), ("nearer", "nearer"))]
    orbits[2]["success"] = False
    assert orbit_near(flow, begin, 6) is None
    assert orbit_near(flow, begin, 3) is None
