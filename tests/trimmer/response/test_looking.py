"""Which orbits a motion is held against on its way, with recurrences and a solver that are given."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.contact.advance import Ending
from trimmer.response import settling as module
from trimmer.response.settling import PATIENCE, Settling, _listed


def orbit(
    name: str, stable: bool = True, neutral: bool = False, returned: bool = False, settles: bool = False
):
    return SimpleNamespace(name=name, stable=stable, neutral=neutral, returned=returned, settles=settles)


def looked_for(
    monkeypatch: pytest.MonkeyPatch, found: dict, known: list = (), ending=Ending.REACHED_END
) -> tuple[str | None, list]:
    """What is found of orbits that are given for numbers of periods, and what is known then."""
    states = np.zeros((1, 2))
    asked: list = []

    def orbit_of(self, periods, state):
        if state is not settling.instant.state:
            return None  # What is tried from the middle of the motion, if nothing is known.
        asked.append(periods)
        return found[periods]

    def candidates(given, sizes, most):
        assert (given.shape, sizes, most) == ((1, 2), "sizes", 24)
        return list(found)

    def has_returned(given, sizes, periods):
        assert sizes == "sizes"
        return found[periods].returned

    monkeypatch.setattr(module, "sizes_of", lambda course: "sizes")
    monkeypatch.setattr(module, "candidates", candidates)
    monkeypatch.setattr(module, "has_returned", has_returned)
    monkeypatch.setattr(module, "settles_to", lambda orbit, given: orbit.settles)
    monkeypatch.setattr(module, "_listed", lambda orbit, known: orbit.name in [each.name for each in known])
    monkeypatch.setattr(Settling, "_orbit", orbit_of)
    flow = SimpleNamespace(
        course=lambda instant, periods: SimpleNamespace(ending=ending, periods=periods),
        reduced=lambda states: states,
    )
    settling = Settling(flow, SimpleNamespace(state=states[0]), list(known))
    result = settling._looked_for()
    return None if result is None else result.name, [each.name for each in settling.known], asked


def test_the_first_orbit_to_which_the_motion_has_returned_or_settles_counts(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def look(*orbits, **options):
        return looked_for(monkeypatch, dict(enumerate(orbits, 1)), **options)

    stable, settles = orbit("stable"), orbit("settles", settles=True)
    assert look(None, stable, settles, orbit("later")) == ("settles", ["stable", "settles"], [1, 2, 3])
    assert look(stable) == (None, ["stable"], [1])
    assert look(orbit("back", returned=True)) == ("back", [], [1])
    neutral = orbit("neutral", stable=False, neutral=True, returned=True)
    assert look(neutral) == ("neutral", [], [1])
    assert look(orbit("neutral", stable=False, neutral=True, settles=True)) == (None, [], [1])
    unstable = orbit("unstable", stable=False, returned=True, settles=True)
    assert look(unstable, stable) == (None, ["stable"], [1, 2])
    # What is known was held against the motion before.
    assert look(settles, known=[settles]) == (None, ["settles"], [1])
    assert look(settles, ending=Ending.DIVERGED) == (None, [], [])
    assert look() == (None, [], [])


class Solved:
    """A solver that tells for which numbers of periods it was asked, and where it began."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, counts: dict) -> None:
        self.counts, self.asked = counts, []
        monkeypatch.setattr(module, "solve", self._solve)
        monkeypatch.setattr(module, "orbit_of", self._orbit)

    def reduced(self, states):
        return states

    def at(self, state, like):
        assert state in ("here", "of 6", "of 3")
        return "begin"

    def _solve(self, problem, start, patience):
        assert (problem.flow, patience) == (self, PATIENCE)
        self.asked.append((problem.periods, start))
        return self.counts[problem.periods]

    def _orbit(self, flow, shot, count):
        success, smallest = shot
        return SimpleNamespace(success=success, period_count=smallest, count=count, instant=f"of {count}")

    def orbit(self, periods: int):
        found = Settling(self, SimpleNamespace(state=np.zeros(2)))._orbit(periods, "here")
        return None if found is None else found.count


def test_an_orbit_is_solved_over_its_smallest_number_of_periods(monkeypatch: pytest.MonkeyPatch) -> None:
    solved = Solved(monkeypatch, {6: (True, 2), 3: (True, 1), 2: (True, 2), 1: (True, 1)})
    assert solved.orbit(6) == 2
    assert solved.asked == [(6, "begin"), (3, "of 6"), (2, "of 3")]
    assert Solved(monkeypatch, {6: (True, 6)}).orbit(6) == 6
    assert Solved(monkeypatch, {1: (True, 1)}).orbit(1) == 1


def test_what_is_not_solved_is_no_orbit(monkeypatch: pytest.MonkeyPatch) -> None:
    assert Solved(monkeypatch, {6: None}).orbit(6) is None
    assert Solved(monkeypatch, {6: (False, 6)}).orbit(6) is None
    solved = Solved(monkeypatch, {6: (True, 2), 3: (False, 3)})
    assert solved.orbit(6) is None
    assert [count for count, _ in solved.asked] == [6, 3]
    assert Solved(monkeypatch, {2: (True, 1), 1: (True, 7)}).orbit(2) is None


def test_an_orbit_is_listed_if_it_is_one_of_those_that_are_known(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("trimmer.response.same.same_orbit", lambda orbit, other: (orbit, other) == ("a", "b"))
    assert _listed("a", ["c", "b"])
    assert not _listed("b", ["c", "a"])
    assert not _listed("a", [])


def test_the_first_known_orbit_that_the_motion_settles_to_is_accepted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(module, "settles_to", lambda orbit, states: orbit.settles)
    settling = Settling(SimpleNamespace(reduced=lambda states: states), SimpleNamespace(state=np.zeros(2)))
    one, two, three = orbit("a"), orbit("b", settles=True), orbit("c", settles=True)
    assert settling._accepted([one, two, three]) is two
    assert settling._accepted([one]) is None
