"""What an answer says was searched, and that an orbit is in it once."""

from __future__ import annotations

import re
from dataclasses import FrozenInstanceError

import control
import numpy as np
import pytest
import scipy.signal

from trimmer import (
    ChoiceError,
    FrictionBacklash,
    InertiaBacklash,
    OrbitNotFoundWarning,
    OrbitSearch,
    PeriodicOrbit,
    Relay,
    Simulations,
    TrimmerParameters,
    periodic_orbits,
    pin_model,
)
from trimmer.orbits.describe import orbit_of
from trimmer.orbits.distinct import same, shortest
from trimmer.orbits.return_map import arcs, flow, follow
from trimmer.orbits.shooting import Return, solve

QUIET = control.ss(control.tf([1], [1, 1, 1]))
BOUNCING = control.ss(*scipy.signal.tf2ss([20, 8.5], [1, 4.7, 0])), InertiaBacklash(0.64)
ALWAYS = OrbitSearch(Simulations.ALWAYS)


def test_an_empty_answer_says_what_was_searched() -> None:
    orbits = periodic_orbits(QUIET, FrictionBacklash(1.0))
    assert len(orbits) == 0
    assert orbits.search.simulations is not None
    assert orbits.search.simulations.at_rest == 32
    assert orbits.search.sentence == (
        "searched: harmonic balance, which predicts no limit cycle; stable orbits by simulation from 32 "
        "initial states (seed 0: 32 came to rest). Not searched: other unstable orbits, stable orbits that "
        "none of these initial states leads to."
    )


def test_where_the_predictions_lead_to_orbits_nothing_is_simulated_unless_asked_for() -> None:
    system, element = pin_model(TrimmerParameters.thesis()), FrictionBacklash(4e-5)
    orbits = periodic_orbits(system, element)
    assert orbits.search.simulations is None
    assert "near 2 predictions of harmonic balance (all led to an orbit)" in orbits.search.sentence
    assert "Not searched: other orbits" in orbits.search.sentence
    asked = periodic_orbits(system, element, search=ALWAYS)
    assert asked.search.simulations is not None
    assert asked.search.simulations.settled > 0
    assert [each.amplitude for each in asked] == pytest.approx([each.amplitude for each in orbits], rel=1e-9)


def test_guesses_alone_are_followed_alone() -> None:
    with pytest.warns(OrbitNotFoundWarning):
        orbits = periodic_orbits(*BOUNCING, [(2.0, 9.0)])
    assert orbits == []
    assert (orbits.search.relay, orbits.search.simulations) == (None, None)
    assert orbits.search.sentence.startswith(
        "searched: near 1 guess (1 led to none). Not searched: other orb"
    )


def test_the_answer_is_a_sequence() -> None:
    orbits = periodic_orbits(*BOUNCING)
    (orbit,) = orbits
    assert orbits[0] is orbit
    assert orbits[-1:] == (orbit,)
    assert orbits == [orbit]
    assert orbits != []
    with pytest.raises(FrozenInstanceError):
        orbits.search.failed = 1  # type: ignore[misc]


def test_the_same_seed_gives_the_same_answer() -> None:
    first, second = (periodic_orbits(*BOUNCING, search=OrbitSearch(seed=7)) for _ in range(2))
    assert [each.amplitude for each in first] == [each.amplitude for each in second]
    assert first.search == second.search
    other = periodic_orbits(*BOUNCING, search=OrbitSearch(seed=8))
    assert other.search != first.search
    assert [each.amplitude for each in other] == pytest.approx([first[0].amplitude], rel=1e-9)


@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ({"starts": 0}, "starts must be a whole number of at least 1, not 0"),
        ({"starts": 1.5}, "starts must be"),
        ({"seed": -1}, "seed must be"),
        ({"steps": 0}, "steps must be"),
        ({"half_periods": (2.0, 1.0)}, "half_periods must be"),
        ({"half_periods": (0.0, 1.0)}, "half_periods must be"),
        ({"half_periods": (1.0, np.inf)}, "half_periods must be"),
    ],
)
def test_settings_out_of_range_are_refused(setting: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        OrbitSearch(**setting)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def bouncing() -> PeriodicOrbit:
    return periodic_orbits(*BOUNCING)[0]


def shot_again(orbit: PeriodicOrbit, share: float, sign: float, periods: int) -> PeriodicOrbit:
    """Find an orbit again from another phase of it or of its mirror image, over several periods."""
    loop = orbit.motion.loop
    time = share * orbit.period
    segment = int(np.searchsorted(orbit.motion.log.start, time, side="right")) - 1
    mode = int(orbit.motion.log.mode[segment])
    state = (
        flow(loop.modes, mode, time - float(orbit.motion.log.start[segment]))
        @ orbit.motion.log.state[segment]
    )
    sizes = abs(orbit.motion.log.state).max(axis=0)
    sizes[sizes == 0.0] = 1.0
    problem = Return(loop.modes, mirrored=False, driven=False, sizes=sizes)
    if sign < 0:
        mirrored = Return(loop.modes, mirrored=True, driven=False, sizes=sizes)
        mode, state = mirrored.final(mode), mirrored.signs * state
        state[-1] = 1.0
    shot = solve(problem, mode, state, periods * orbit.period)
    assert shot is not None
    return orbit_of(loop, *shortest(problem, shot), None)


@pytest.mark.parametrize("share", [0.1, 0.37, 0.8])
@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("periods", [1, 2, 3])
def test_an_orbit_is_known_again_from_any_phase_and_as_its_image(
    bouncing: PeriodicOrbit, share: float, sign: float, periods: int
) -> None:
    orbit = bouncing
    again = shot_again(orbit, share, sign, periods)
    assert same(orbit, again)
    assert again.period == pytest.approx(orbit.period, rel=1e-9)
    assert np.sort(abs(again.multipliers)) == pytest.approx(np.sort(abs(orbit.multipliers)), abs=1e-6)


def test_two_orbits_are_told_apart() -> None:
    outer, inner = periodic_orbits(pin_model(TrimmerParameters.thesis()), FrictionBacklash(4e-5))
    assert not same(outer, inner)


def test_a_contact_of_no_length_gives_all_multipliers() -> None:
    # The load is met and left at one instant; the motion starts in flight, where its states are free.
    (orbit,) = periodic_orbits(*BOUNCING)
    events = orbit.motion.events
    assert [events[k].time for k in (0, 2)] == [events[k].time for k in (1, 3)]
    loop, start, mode = orbit.motion.loop, orbit.motion.log.state[0], int(orbit.motion.log.mode[0])
    sizes = abs(orbit.motion.log.state).max(axis=0)[:4]
    columns = []
    for each in range(4):
        ends = []
        for sign in (-1.0, 1.0):
            disturbed = start.copy()
            disturbed[each] += sign * 1e-6 * sizes[each]
            log = follow(loop.modes, mode, disturbed, orbit.period)
            assert log is not None
            last = arcs(loop.modes, log, orbit.period)[-1]
            ends.append((flow(loop.modes, last.mode, last.duration) @ last.state)[:4] / sizes)
        columns.append((ends[1] - ends[0]) / 2e-6)
    differences = np.sort(abs(np.linalg.eigvals(np.array(columns).T)))
    assert len(orbit.multipliers) == 4  # Two of the plant, position and velocity of the load.
    assert np.sort(abs(orbit.multipliers)) == pytest.approx(differences, rel=1e-5, abs=1e-5)
    assert abs(orbit.multipliers[2:]).max() < 0.03


def test_a_relay_that_comes_to_rest_is_told() -> None:
    orbits = periodic_orbits(control.tf([1], [1, 2]), Relay(1.0))
    assert len(orbits) == 0
    assert orbits.search.simulations is not None
    assert orbits.search.simulations.at_rest == 32
    assert (
        "all orbits of the relay that return with their signs changed after one switch"
        in orbits.search.sentence
    )


def test_orbits_say_whether_the_search_went_to_its_end() -> None:
    orbits = periodic_orbits(pin_model(TrimmerParameters.thesis()), FrictionBacklash(4e-5))
    assert orbits.success
    assert orbits.message == f"2 periodic orbits found; {orbits.search.sentence}"
    with pytest.warns(OrbitNotFoundWarning):
        nothing = periodic_orbits(*BOUNCING, [(2.0, 9.0)])
    assert not nothing.success
    assert nothing.message.startswith(
        "0 periodic orbits found; 1 guess led to no orbit; searched: near 1 guess"
    )


def test_an_orbit_says_how_well_it_returns() -> None:
    stable, unstable = periodic_orbits(pin_model(TrimmerParameters.thesis()), FrictionBacklash(4e-5))
    assert stable.success
    assert unstable.success
    assert re.fullmatch(
        r"the state returns after 0\.00137327 s, with a miss of \d\.\de-\d\d of its size; stable",
        stable.message,
    )
    assert unstable.message.endswith("; not stable")


@pytest.mark.parametrize("word", ["never", "where-predictions-fail", "always"])
def test_when_to_simulate_is_chosen_by_its_word(word: str) -> None:
    assert OrbitSearch(word).simulations.word == word
    with pytest.raises(
        ChoiceError, match="simulations is 'nonsense': choose never, where-predictions-fail or al"
    ):
        OrbitSearch("nonsense")
