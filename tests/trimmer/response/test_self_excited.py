"""How a motion without a drive is searched, with motions, recurrences and a solver that are given."""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.contact.statuses import CONTACT_BROKEN, CONTACT_MADE, NOTHING
from trimmer.response import self_excited as module
from trimmer.response.self_excited import _recurrences, _recurring, at_rest, time_scale


@dataclass(frozen=True)
class Instant:
    state: object = None
    phase: float = 0.0
    statuses: object = "end"
    known_zeros: object = None
    known_action: object = None


def orbit(name: str, stable: bool = False, neutral: bool = False) -> SimpleNamespace:
    return SimpleNamespace(name=name, stable=stable, neutral=neutral, period=3.25)


def recurring(monkeypatch: pytest.MonkeyPatch, pairs: list, shots: list, stable: tuple = ()) -> tuple:
    """What recurrences lead to, and where the solver begins."""
    begun: list = []
    log = SimpleNamespace(start=np.array([0.0, 1.0, 4.0, 6.0, 10.0]), mode=np.array([5, 6, 7, 8, 9]))
    zeros, action = np.array([True, True]), np.array([3, 4])
    course = SimpleNamespace(
        log=log,
        end=Instant(known_zeros=zeros, known_action=action),
        modes={mode: SimpleNamespace(statuses=f"of {mode}") for mode in range(5, 10)},
        states=lambda times: np.array([[time, 2 * time, 99.0] for time in times]),
    )

    def at(state, like):
        assert like.known_zeros.tolist() == [False, False]
        assert like.known_action.tolist() == [-1, -1]
        return (state.tolist(), like.statuses)

    def solve(problem, instant, span):
        assert problem.periods == 0
        begun.append((*instant, span))
        return shots.pop(0)

    monkeypatch.setattr(module, "sizes_of", lambda course: "sizes")
    monkeypatch.setattr(module, "_recurrences", lambda course, sizes: pairs)
    monkeypatch.setattr(module, "solve", solve)
    monkeypatch.setattr(module, "at_rest", lambda course, unit: (course, unit) == ("resting", 2.5))
    monkeypatch.setattr(module, "_once", lambda flow, shot: shot)
    monkeypatch.setattr(
        module, "orbit_of", lambda flow, shot, periods: orbit(shot.name, stable=shot.name in stable)
    )
    found = _recurring(SimpleNamespace(size=2, at=at), course)
    return [each.name for each in found], begun


def shot(name: str, miss: float = 1e-11, course: str = "moving") -> SimpleNamespace:
    return SimpleNamespace(name=name, miss=miss, course=course, duration=2.5)


def test_a_recurrence_is_solved_from_the_middle_of_its_first_segment(monkeypatch: pytest.MonkeyPatch) -> None:
    pairs = [(1, 3), (0, 2), (2, 4)]
    found, begun = recurring(monkeypatch, pairs, [shot("a"), shot("b"), shot("c")])
    assert found == ["a", "b", "c"]
    # Between 1 and 4 s, 0 and 1 s, 4 and 6 s.
    assert begun == [([2.5, 5.0], "of 6", 5.0), ([0.5, 1.0], "of 5", 4.0), ([5.0, 10.0], "of 7", 6.0)]


def test_what_does_not_return_or_rests_is_no_orbit_and_the_first_stable_one_ends_the_search(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pairs = [(1, 3)] * 6
    shots = [
        None,
        shot("a", miss=1e-9),
        shot("b", course="resting"),
        shot("c", miss=1e-10),
        shot("d"),
        shot("e"),
    ]
    assert recurring(monkeypatch, pairs, list(shots))[0] == ["c", "d", "e"]
    found, begun = recurring(monkeypatch, pairs, list(shots), stable=("d",))
    assert (found, len(begun)) == (["c", "d"], 5)
    assert recurring(monkeypatch, [], [])[0] == []


def test_recurrences_are_of_the_same_event_in_the_same_mode_and_lasting() -> None:
    kind = np.array([NOTHING, CONTACT_MADE, CONTACT_MADE, CONTACT_MADE, NOTHING, NOTHING, CONTACT_MADE])
    log = SimpleNamespace(
        kind=kind, start=np.arange(7.0), mode=np.array([1, 1, 2, 1, 1, 1, 1]), part=np.zeros(7, dtype=int),
        state=np.ones((7, 1)),
    )  # fmt: skip
    course = SimpleNamespace(log=log)
    broken = SimpleNamespace(**{**vars(log), "kind": np.where(np.arange(7) == 1, CONTACT_BROKEN, kind)})
    assert _recurrences(SimpleNamespace(log=broken), np.ones(1)) == []
    # Not of the last row, of rows in which nothing happens, or of the other mode.
    assert _recurrences(course, np.ones(1)) == [(1, 3)]
    many = SimpleNamespace(
        kind=np.full(12, CONTACT_MADE), start=np.arange(12.0), mode=np.zeros(12, dtype=int),
        part=np.zeros(12, dtype=int), state=np.arange(12.0)[:, None] * [0.04],
    )  # fmt: skip
    found = _recurrences(SimpleNamespace(log=many), np.ones(1))
    assert found == [(9, 10), (8, 9), (7, 8), (6, 7), (5, 6), (4, 5)]
    assert _recurrences(SimpleNamespace(log=many), np.full(1, 0.3)) == []


def resting(states: list, end: list, flow: list, unit: float) -> bool:
    layout = SimpleNamespace(bodies=("a", "b"), state_count=5, forcing_at=lambda phase: np.array([phase]))
    modes = {7: SimpleNamespace(flow=np.array(flow))}
    course = SimpleNamespace(
        modes=type("Modes", (dict,), {"layout": layout, "number": lambda self, statuses: statuses})(modes),
        log=SimpleNamespace(state=np.array(states)),
        end=SimpleNamespace(state=np.array(end), phase=0.5, statuses=7),
    )
    return at_rest(course, unit)


@pytest.mark.parametrize("reach", [200.0, 2e-4])
def test_rates_at_rest_are_small_beside_what_was_moved(reach: float) -> None:
    """Of two bodies one reached fifty times less; the last column of the flow is the forcing of 1/2."""
    states, end = [[0.02 * reach, -reach, 0.0, 0.0, 1e-3, 9.0]], [0.0] * 5
    fastest = 2 * np.pi * reach / 20.0
    allowed = 1e-9 * np.array([reach, reach, fastest, fastest, 1e-3]) / 20.0
    for place in range(5):
        for share, rests in ((0.99, True), (1.01, False)):
            for sign in (1.0, -1.0):
                flow = np.zeros((6, 6))
                flow[place, 5] = sign * share * allowed[place] / 0.5
                assert resting(states, end, flow, 20.0) is rests


def test_modes_that_hardly_move_have_no_period() -> None:
    def flow(moduli: list) -> SimpleNamespace:
        size = len(moduli)
        matrix = np.zeros((size + 1, size + 1))
        matrix[:size, :size] = np.diag(moduli)
        modes = type("Modes", (dict,), {"number": lambda self, statuses: statuses})
        return SimpleNamespace(modes=modes({3: SimpleNamespace(flow=matrix)}), size=size)

    instant = SimpleNamespace(statuses=3)
    assert time_scale(flow([-2.0, 50.0, 0.5]), instant) == pytest.approx(4 * np.pi)
    assert time_scale(flow([-2.0, 50.0, 1e-9]), instant) == pytest.approx(np.pi)
    assert time_scale(flow([-2e-7, 50.0, 0.0]), instant) == pytest.approx(1e7 * np.pi)
    assert time_scale(flow([-5e-10, -2e-10]), instant) == pytest.approx(1e10 * np.pi)
    assert time_scale(flow([0.0, 0.0]), instant) == 1.0
