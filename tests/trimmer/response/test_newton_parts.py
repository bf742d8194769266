"""Newton's method of a mechanism's return, with a problem that is given, and how long it is followed."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.contact.advance import Ending
from trimmer.response import shooting
from trimmer.response.settling import Settling
from trimmer.response.shooting import Patience, Return, _improved, _shortest, solve


def shot(miss: float, gap: object = None, sizes: object = 1.0, name: str = "") -> SimpleNamespace:
    return SimpleNamespace(miss=miss, gap=np.array([miss]) if gap is None else gap, sizes=sizes, name=name)


class Problem:
    """A problem whose motions are given by the share of the step that they take."""

    periods = 0

    def __init__(self, trials: list, first: object = None, singular: bool = False) -> None:
        self.trials, self.first, self.singular, self.asked = trials, first, singular, []

    def shoot(self, instant, duration):
        self.asked.append((instant, duration))
        return self.first

    def step(self, shot):
        if self.singular:
            raise np.linalg.LinAlgError
        return "correction"

    def corrected(self, shot, share, correction):
        self.asked.append((share, correction))
        return self.trials.pop(0)


@pytest.mark.parametrize(
    ("trials", "taken"),
    [
        ([0.89], 0),
        ([0.91, 0.94], 1),
        ([0.91, 0.96, 0.97], 2),
        ([None, 1.0, 0.97], 2),
        ([0.9, 0.95, 0.975, 0.98], 3),
        ([2.0, 2.0, 2.0, 0.99], None),
    ],
)
def test_a_step_is_halved_until_it_reduces_the_gap_enough(trials: list, taken: int | None) -> None:
    """The gap is 5 long; a tenth of the share has to go."""
    given = [None if each is None else shot(9.0, np.array([3.0, -4.0]) * each) for each in trials]
    problem = Problem(list(given))
    found = _improved(problem, shot(1.0, np.array([3.0, 4.0])), 4)
    assert found is (None if taken is None else given[taken])
    count = 4 if taken is None else taken + 1
    assert problem.asked == [(0.5**k, "correction") for k in range(count)]


def test_where_only_rounding_is_left_a_step_is_not_halved() -> None:
    for miss, count in ((1.1e-12, 5), (1e-12, 1)):
        problem = Problem([None] * 5)
        assert _improved(problem, shot(miss), 5) is None
        assert len(problem.asked) == count
    assert _improved(Problem([], singular=True), shot(1.0), 5) is None


def solved(monkeypatch: pytest.MonkeyPatch, first, improved: list, followed: list, patience: Patience):
    """What is found, how often a step was tried, and how the motion was followed once more."""
    problem, tried = Problem(followed, first), []

    def improve(problem, shot, halvings):
        tried.append((shot, halvings))
        return improved.pop(0)

    monkeypatch.setattr(shooting, "_improved", improve)
    found = solve(problem, "instant", 2.5, patience)
    assert problem.asked[0] == ("instant", 2.5)
    return found, tried, problem.asked[1:]


def test_steps_are_taken_until_nothing_is_left_to_improve(monkeypatch: pytest.MonkeyPatch) -> None:
    a, b, c = shot(1e-2), shot(1e-5), shot(4e-15)
    patience = Patience(iterations=7, halvings=3, followed=2)
    found, tried, _ = solved(monkeypatch, a, [b, c], [], patience)
    assert found is c
    assert tried == [(a, 3), (b, 3)]
    assert solved(monkeypatch, None, [], [], patience)[:2] == (None, [])
    near = shot(9e-11)
    found, tried, asked = solved(monkeypatch, a, [near, None], [], patience)
    assert (found, len(tried), asked) == (near, 2, [])
    found, tried, _ = solved(monkeypatch, a, [b, a, b, a], [], Patience(iterations=3))
    assert (found, len(tried)) == (b, 3)


def test_where_no_step_helps_the_motion_is_followed_once_more(monkeypatch: pytest.MonkeyPatch) -> None:
    a = shot(1e-2, np.array([0.5, -2.0]), np.array([10.0, 3.0]))
    b = shot(1e-3, np.array([0.25, 1.0]), np.array([10.0, 3.0]))
    patience = Patience(iterations=9, halvings=3, followed=2)
    found, tried, asked = solved(monkeypatch, a, [None, None, None], [b, a], patience)
    assert found is a
    assert [each for each, _ in tried] == [a, b, a]
    assert [(share, by.tolist(), longer) for share, (by, longer) in asked] == [
        (1.0, [5.0, -6.0], 0.0),
        (1.0, [2.5, 3.0], 0.0),
    ]
    found, _, asked = solved(monkeypatch, a, [None], [None], patience)
    assert (found, len(asked)) == (a, 1)


def test_singular_equations_have_the_shortest_solution() -> None:
    right = np.array([2.0, 2.0])
    np.testing.assert_allclose(_shortest(np.array([[1.0, 1.0], [1.0, 1.0]]), right), [1.0, 1.0])
    np.testing.assert_allclose(_shortest(np.array([[1.0, 1.0], [1.0, 1.0 + 1e-13]]), right), [1.0, 1.0])
    near = np.array([[1.0, 1.0], [1.0, 1.0 + 1e-9]])
    np.testing.assert_allclose(_shortest(near, right), [2.0, 0.0], atol=1e-5)
    np.testing.assert_allclose(_shortest(np.array([[2.0, 1.0], [0.0, 4.0]]), right), [0.75, 0.5])


def test_a_motion_that_ends_early_or_is_not_finite_is_no_shot() -> None:
    def flow(ending=Ending.REACHED_END, state=(1.0, 2.0)) -> SimpleNamespace:
        course = SimpleNamespace(ending=ending, end=SimpleNamespace(state=np.array(state)))

        def told(*given):
            asked.append(given)
            return course

        return SimpleNamespace(course=told, timed=told)

    asked: list = []
    sizes = np.ones(2)
    assert Return(flow(), 3).shoot("instant", 9.0, sizes).sizes is sizes
    assert Return(flow(), 3, 70).shoot("instant", 9.0, sizes) is not None
    assert Return(flow(), 0, 70).shoot("instant", 9.0, sizes) is not None
    assert asked == [("instant", 3, 600_000), ("instant", 3, 210), ("instant", 9.0, 70)]
    assert Return(flow(Ending.DIVERGED), 3).shoot("instant", 0.0, sizes) is None
    assert Return(flow(state=(1.0, np.nan)), 3).shoot("instant", 0.0, sizes) is None
    assert Return(flow(state=(np.inf, 1.0)), 3).shoot("instant", 0.0, sizes) is None


class Waiting(Settling):
    """A motion of which it is told how it is followed, and when an orbit is looked for."""

    def __init__(self, found: dict, near: bool = False, ends: int = 10**6) -> None:
        super().__init__(SimpleNamespace(reduced=lambda states: states), SimpleNamespace(state=np.zeros(1)))
        self.found, self.near, self.ends = found, near, ends
        self.blocks: list = []
        self.looks: list = []
        self._quiet = False

    def follow(self, periods: int) -> bool:
        self.blocks.append(periods)
        self.periods += periods
        return self.periods < self.ends

    def _accepted(self, orbits):
        return self.found.get(-self.periods)

    def _looked_for(self):
        self.looks.append(self.periods)
        return self.found.get(self.periods)

    def _is_near(self) -> bool:
        return self.near


def test_a_motion_is_looked_at_ever_more_rarely() -> None:
    motion = Waiting({})
    assert motion.until_settled(600) is None
    assert motion.looks == [8, 16, 32, 64, 128, 256, 384, 512]
    assert motion.blocks == [8, 8, 16, 32, 64, 128, 128, 128, 88]
    short = Waiting({})
    assert short.until_settled(5) is None
    assert (short.blocks, short.looks) == ([5], [])
    assert short.until_settled(5) is None
    assert short.blocks == [5]
    near = Waiting({}, near=True)
    near.until_settled(70)
    assert near.blocks == [8] * 8 + [6]
    assert near.looks == [8, 16, 32, 64]


def test_a_motion_is_followed_until_an_orbit_is_accepted_or_found_or_it_ends() -> None:
    found = Waiting({32: "orbit"})
    assert found.until_settled(600) == "orbit"
    assert found.periods == 32
    accepted = Waiting({-32: "known", 32: "orbit"})
    assert accepted.until_settled(600) == "known"
    assert accepted.looks == [8, 16]
    ended = Waiting({32: "orbit"}, ends=32)
    assert ended.until_settled(600) is None
    assert ended.looks == [8, 16]
