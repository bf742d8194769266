"""How a search puts its answer together: from guesses, a relay's equation and simulations that are given."""

from __future__ import annotations

import math
from types import SimpleNamespace

import control
import numpy as np
import pytest

from trimmer import (
    ClosedLoop,
    FrictionBacklash,
    OrbitNotFoundWarning,
    OrbitSearch,
    OrbitSearchInterrupted,
    Relay,
    WrongTypeError,
    limit_cycles,
    periodic_orbits,
)
from trimmer.balance.limit_cycle import HarmonicBalance
from trimmer.orbits import periodic_orbits as module
from trimmer.orbits.guess import starting_point
from trimmer.orbits.periodic_orbits import _add, _guesses, _near, _shot, _wider
from trimmer.orbits.search import OrbitSearched, RelaySearch, SimulationSearch

LOOP = ClosedLoop(control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0))
RELAY = RelaySearch((0.25, 4.0), 3, (), 48)
DONE = SimulationSearch(32, 0, 32, 0, 0, 0, 0, 32)


def found(name: str, amplitude: float) -> SimpleNamespace:
    return SimpleNamespace(name=name, amplitude=amplitude, has_neighbours=False)


@pytest.fixture
def given(monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
    """What the parts of a search answer, and what they are asked."""
    parts = SimpleNamespace(near={}, relay=([], RELAY), settled=([], DONE), asked=[])

    def near(loop, amplitude, omega, prediction):
        parts.asked.append(("near", amplitude, omega, prediction))
        return parts.near.get((amplitude, omega))

    def relay(loop, half_periods):
        parts.asked.append(("relay", half_periods))
        return parts.relay

    def settled(loop, search, known):
        parts.asked.append(("settled", search, [each.name for each in known]))
        return parts.settled

    monkeypatch.setattr(module, "_near", near)
    monkeypatch.setattr(module, "relay_orbits", relay)
    monkeypatch.setattr(module, "settled_orbits", settled)
    monkeypatch.setattr(module, "same", lambda one, other: one.name == other.name)
    return parts


GUESSES = [(2.0, 3.0), (4.0, 5.0), (6.0, 7.0)]


def test_orbits_come_once_by_falling_amplitude(given: SimpleNamespace) -> None:
    given.near = {(2.0, 3.0): found("a", 1.0), (4.0, 5.0): found("b", 3.0), (6.0, 7.0): found("a", 1.0)}
    orbits = periodic_orbits(LOOP, GUESSES)
    assert [each.name for each in orbits] == ["b", "a"]
    assert orbits.search == OrbitSearched(3, False, 0, None, None)
    assert given.asked == [("near", *guess, None) for guess in GUESSES]


def test_a_guess_that_leads_nowhere_is_counted_and_told(given: SimpleNamespace) -> None:
    given.near = {(4.0, 5.0): found("b", 3.0)}
    told = r"from the amplitude 2 and omega 3 rad/s"
    with (
        pytest.warns(OrbitNotFoundWarning, match=told),
        pytest.warns(OrbitNotFoundWarning, match="6 and omega 7"),
    ):
        orbits = periodic_orbits(LOOP, GUESSES)
    assert [each.name for each in orbits] == ["b"]
    assert orbits.search == OrbitSearched(3, False, 2, None, None)


def test_all_predictions_lead_to_the_wider_search(given: SimpleNamespace) -> None:
    predictions = limit_cycles(LOOP)
    (cycle,) = predictions
    at = cycle.amplitude, cycle.omega
    given.near = {at: found("a", 1.0)}
    given.relay = [found("c", 5.0), found("a", 1.0)], RELAY
    orbits = periodic_orbits(LOOP)
    assert [each.name for each in orbits] == ["c", "a"]
    assert orbits.search == OrbitSearched(1, True, 0, RELAY, None)
    assert given.asked == [("near", *at, cycle), ("relay", None)]
    # One that was led to nothing lets motions be simulated.
    given.asked.clear()
    given.near, given.settled = {}, ([found("d", 2.0)], DONE)
    with pytest.warns(OrbitNotFoundWarning):
        orbits = periodic_orbits(LOOP)
    assert [each.name for each in orbits] == ["c", "d", "a"]
    assert orbits.search == OrbitSearched(1, True, 1, RELAY, DONE)
    assert given.asked[-1] == ("settled", OrbitSearch(), ["c", "a"])


def test_an_interrupted_search_raises_what_it_has(given: SimpleNamespace) -> None:
    cut = SimulationSearch(2, 0, 2, 0, 0, 0, 0, 32)
    given.settled = [found("d", 2.0)], cut
    with pytest.raises(OrbitSearchInterrupted) as raised:
        periodic_orbits(LOOP, [], OrbitSearch("always"))
    assert [each.name for each in raised.value.orbits] == ["d"]
    assert raised.value.orbits.search == OrbitSearched(0, False, 0, RELAY, cut)


def test_a_search_beside_guesses_is_as_wide_as_it_is_asked_for(given: SimpleNamespace) -> None:
    known: list = []
    assert _wider(LOOP, None, known, True) == (None, None)
    assert given.asked == []
    given.relay, given.settled = None, ([found("d", 2.0)], DONE)
    for word, needed, simulated in (
        ("never", True, False),
        ("where-predictions-fail", False, False),
        ("where-predictions-fail", True, True),
        ("always", False, True),
    ):
        known, search = [], OrbitSearch(word, half_periods=(0.5, 2.0))
        given.asked.clear()
        assert _wider(LOOP, search, known, needed) == (None, DONE if simulated else None)
        assert given.asked == [("relay", (0.5, 2.0)), ("settled", search, [])][: 1 + simulated]
        assert [each.name for each in known] == ["d"][: int(simulated)]


def test_only_what_is_new_is_added(given: SimpleNamespace) -> None:
    orbits = [found("a", 1.0)]
    _add(orbits, [found("b", 1.0), found("a", 2.0), found("b", 3.0)])
    assert [(each.name, each.amplitude) for each in orbits] == [("a", 1.0), ("b", 1.0)]


def test_guesses_are_cycles_or_pairs() -> None:
    (cycle,) = predictions = limit_cycles(LOOP)
    assert _guesses(LOOP, [cycle, (2, 3.0), [4.0, 5]]) == [cycle, (2.0, 3.0), (4.0, 5.0)]
    assert _guesses(LOOP, None) == predictions
    balance = HarmonicBalance.__new__(HarmonicBalance)
    object.__setattr__(balance, "limit_cycles", predictions)
    assert _guesses(LOOP, balance) is predictions
    for wrong in ("ab", (1.0,), (1.0, 2.0, 3.0), 2.0):
        with pytest.raises(WrongTypeError, match=r"guesses\[1\] must be a limit cycle or a pair"):
            _guesses(LOOP, [cycle, wrong])
    for wrong, name in (((0.0, 1.0), "amplitude"), ((1.0, -1.0), "omega"), ((1.0, math.inf), "omega")):
        with pytest.raises(ValueError, match=f"{name} of a guess"):
            _guesses(LOOP, [wrong])


def test_newtons_method_begins_at_the_first_harmonic_and_then_at_balanced_ones(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    trials: list = []
    starts = [SimpleNamespace(name="second"), SimpleNamespace(name="third")]
    monkeypatch.setattr(
        module, "balanced_starts", lambda *given: trials.append(given) or zip(starts, (8, 9), strict=True)
    )
    monkeypatch.setattr(module, "starting_point", lambda *given: SimpleNamespace(name=given[1:]))
    monkeypatch.setattr(module, "orbit_of", lambda *given: given)

    def shot(loop, start, omega):
        trials.append((start.name, omega))
        return ("problem", "shot") if start.name == "second" else None

    monkeypatch.setattr(module, "_shot", shot)
    assert _near(LOOP, 2.0, 3.0, "cycle") == (LOOP, "problem", "shot", "cycle")
    assert trials == [(LOOP, 2.0, 3.0), ((2.0, 3.0), 3.0), ("second", 8)]
    starts[:] = [SimpleNamespace(name="third")] * 2
    assert _near(LOOP, 2.0, 3.0, None) is None
    assert trials[-2:] == [("third", 8), ("third", 9)]


def test_where_the_element_is_not_reached_there_is_nothing_to_follow(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "starting_point", None)
    loop = ClosedLoop(control.tf([1.0], [1.0, 1.0, 1.0]), FrictionBacklash(1.0))
    assert np.isnan(loop.element.describing_function(0.4, 1.0))
    assert _near(loop, 0.4, 1.0, None) is None


def test_a_shot_takes_half_a_period() -> None:
    (cycle,) = limit_cycles(LOOP)
    start = starting_point(LOOP, cycle.amplitude, cycle.omega)
    problem, shot = _shot(LOOP, start, cycle.omega)
    assert (problem.mirrored, problem.driven) == (True, False)
    assert problem.sizes is start.sizes
    # Half the period of 1/(s (s+1) (s+2)) with a relay solves Tsypkin's equation.
    half = shot.span
    assert half / 4 - math.tanh(half / 2) + math.tanh(half) / 4 == pytest.approx(0.0, abs=1e-9)
    assert _shot(LOOP, start, 40 * cycle.omega) is None
