"""The words and counts of searches, made by hand."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.orbits.search import (
    OrbitSearch,
    OrbitSearched,
    OrbitSearchInterrupted,
    PeriodicOrbits,
    RelaySearch,
    SimulationSearch,
)

RELAY = RelaySearch((0.25, 4.0), 3, ((1.0, 1.5), (2.0, 2.25)), 0)
SIMULATED = SimulationSearch(10, 5, 4, 3, 2, 1, 0, 10)
ALL_RETURN = (
    "all orbits of the relay that return with their signs changed after one switch, with half periods "
    "from 0.25 to 4 s"
)


def test_a_relay_search_tells_interval_gaps_and_grid() -> None:
    assert RELAY.sentence == f"{ALL_RETURN} except in 2 intervals of 0.75 s together"
    assert RelaySearch((0.25, 4.0), 3, ((1.0, 1.5),), 0).sentence.endswith("1 interval of 0.5 s together")
    assert RelaySearch((0.25, 4.0), 3, (), 0).sentence == ALL_RETURN
    grid = "; orbits with two switches at unequal distances from a grid of 48 durations"
    assert RelaySearch((0.25, 4.0), 3, (), 48).sentence == ALL_RETURN + grid


def test_a_search_by_simulation_tells_the_ends_that_there_were() -> None:
    assert SIMULATED.sentence == (
        "stable orbits by simulation from 10 initial states (seed 5: 4 settled on an orbit, 3 came to rest, "
        "2 grew without bound, 1 ended as their events accumulate)"
    )
    assert not SIMULATED.interrupted
    cut = SimulationSearch(2, 0, 0, 0, 0, 0, 2, 32)
    assert cut.interrupted
    assert cut.sentence == (
        "stable orbits by simulation from 2 of 32 initial states (seed 0: 2 did not settle in time)"
    )


def test_doubts_are_what_was_left_open() -> None:
    assert OrbitSearched(3, True, 0, None, None).doubts == ()
    done = RelaySearch((0.25, 4.0), 3, (), 0)
    assert OrbitSearched(3, True, 0, done, SIMULATED).doubts == ()
    cut = SimulationSearch(2, 0, 0, 0, 0, 0, 2, 32)
    assert OrbitSearched(3, True, 2, RELAY, cut).doubts == (
        "2 predictions of harmonic balance led to no orbit",
        "part of the interval of half periods is undecided",
        "some simulations did not settle in time",
        "the search was interrupted",
    )
    assert OrbitSearched(3, False, 1, None, None).doubts == ("1 guess led to no orbit",)
    left = SimulationSearch(2, 0, 0, 0, 0, 0, 2, 2)
    assert OrbitSearched(0, True, 0, None, left).doubts == ("some simulations did not settle in time",)


NEAR = {
    (0, True, 0): "harmonic balance, which predicts no limit cycle",
    (0, False, 0): "near no guess",
    (1, True, 0): "near 1 prediction of harmonic balance (all led to an orbit)",
    (2, False, 0): "near 2 guesses (all led to an orbit)",
    (3, True, 1): "near 3 predictions of harmonic balance (1 led to none)",
}


@pytest.mark.parametrize("counts", NEAR)
def test_the_sentence_tells_what_was_searched_and_what_was_not(counts: tuple[int, bool, int]) -> None:
    guesses, predicted, failed = counts
    others = "other orbits, which simulations look for if they are asked for (--simulate)"
    alone = OrbitSearched(guesses, predicted, failed, None, None)
    assert alone.sentence == f"searched: {NEAR[counts]}. Not searched: {others}."
    both = OrbitSearched(guesses, predicted, failed, RELAY, SIMULATED)
    assert both.sentence == (
        f"searched: {NEAR[counts]}; {RELAY.sentence}; {SIMULATED.sentence}. Not searched: other unstable "
        "orbits, stable orbits that none of these initial states leads to."
    )


def test_orbits_are_a_sequence_with_a_search() -> None:
    one, two = object(), object()
    searched = OrbitSearched(2, False, 0, None, None)
    orbits = PeriodicOrbits((one, two), searched)
    assert orbits == [one, two]
    assert orbits != [two, one]
    assert orbits != {one, two}
    assert hash(orbits) == hash(PeriodicOrbits((one, two), OrbitSearched(3, True, 1, None, None)))
    assert (len(orbits), list(orbits), orbits[1], orbits[:1]) == (2, [one, two], two, (one,))
    assert orbits.success
    assert orbits.message == f"2 periodic orbits found; {searched.sentence}"
    single = PeriodicOrbits((one,), OrbitSearched(2, False, 1, None, None))
    assert not single.success
    assert single.message.startswith("1 periodic orbit found; 1 guess led to no orbit; searched: ")
    assert orbits._told() == "2 periodic orbits; the search went to its end"
    assert single._told() == "1 periodic orbit; 1 guess led to no orbit"
    interrupt = OrbitSearchInterrupted(single)
    assert interrupt.orbits is single
    assert str(interrupt) == single.message


@pytest.mark.parametrize(("name", "least"), [("starts", 1), ("seed", 0), ("steps", 1)])
def test_the_least_setting_is_allowed(name: str, least: int) -> None:
    assert getattr(OrbitSearch(**{name: least}), name) == least
    with pytest.raises(ValueError, match=f"{name} must be a whole number of at least {least}"):
        OrbitSearch(**{name: least - 1})


def test_half_periods_rise() -> None:
    assert OrbitSearch(half_periods=(0.5, 0.6)).half_periods == (0.5, 0.6)
    for wrong in ((0.5, 0.5), (0.5,), (0.5, 0.6, 0.7), (0.0, 1.0), (-1.0, 1.0)):
        with pytest.raises(ValueError, match="0 < shortest < longest"):
            OrbitSearch(half_periods=wrong)


def orbit(multipliers: list, driven: bool = False, residual: float = 1e-12, prediction=None) -> PeriodicOrbit:
    return PeriodicOrbit(0.25, 3.0, np.array(multipliers, complex), driven, residual, None, prediction)


def test_the_multiplier_nearest_to_one_is_trivial_without_a_drive() -> None:
    free = orbit([-0.99, 1.0 + 1e-9, 0.5, 1e-3])
    assert free.nontrivial_multipliers.tolist() == [-0.99, 0.5, 1e-3]
    assert free.largest_multiplier == 0.99
    assert free.stable
    assert orbit([1.8, 1.0 - 1e-9, 0.5]).nontrivial_multipliers.tolist() == [1.8, 0.5]
    driven = orbit([1.0 + 1e-9, -0.99], driven=True)
    assert driven.nontrivial_multipliers.tolist() == [1.0 + 1e-9, -0.99]
    assert not driven.stable
    assert driven.largest_multiplier == 1.0 + 1e-9
    assert not orbit([1.0, 1.0 - 1e-7]).stable
    assert orbit([1.0, 1.0 - 1e-5]).stable
    assert not orbit([1.0, 0.9j + 0.9]).stable
    assert orbit([1.0]).largest_multiplier == 0.0


def test_an_orbit_has_frequency_errors_and_words() -> None:
    cycle = SimpleNamespace(amplitude=3.3, frequency=5.0)
    found = orbit([1.0, 0.5], prediction=cycle)
    assert (found.frequency, found.omega) == (4.0, pytest.approx(8 * np.pi))
    assert found.amplitude_error == pytest.approx(0.1)
    assert found.frequency_error == pytest.approx(0.25)
    assert np.isnan([orbit([1.0]).amplitude_error, orbit([1.0]).frequency_error]).all()
    assert found.success
    assert found.message == "the state returns after 0.25 s, with a miss of 1.0e-12 of its size; stable"
    missed = orbit([1.0, 2.0], residual=1e-3)
    assert not missed.success
    assert missed.message == "the state does not return, with a miss of 1.0e-03 of its size; not stable"
