"""What an answer says was searched, and that an orbit is in it once."""

import re
from dataclasses import FrozenInstanceError

import control
import numpy as np
import pytest
import scipy.signal

from trimmer import OrbitSearch, TrimmerParameters, periodic_orbits, pin_model
from trimmer.choices import ChoiceError
from trimmer.elements import FrictionBacklash, InertiaBacklash, Relay, Saturation
from trimmer.errors import OrbitNotFoundWarning, WrongTypeError
from trimmer.orbits import (
    BalanceSearch,
    OrbitSearched,
    OrbitSearchInterrupted,
    RelaySearch,
    Simulations,
    SimulationSearch,
)

QUIET = control.ss(control.tf([1], [1, 1, 1]))
BOUNCING = control.ss(*scipy.signal.tf2ss([20, 8.5], [1, 4.7, 0])), InertiaBacklash(0.64)
ALWAYS = OrbitSearch(Simulations.ALWAYS)


def test_an_empty_answer_says_what_was_searched() -> None:
    orbits = periodic_orbits(QUIET, FrictionBacklash(1.0))
    assert len(orbits) == 0
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
    assert asked.search.simulations.settled > 0
    assert [each.amplitude for each in asked] == pytest.approx([each.amplitude for each in orbits], rel=1e-9)


def test_guesses_alone_are_followed_alone_and_are_cycles_or_pairs() -> None:
    with pytest.warns(OrbitNotFoundWarning):
        orbits = periodic_orbits(*BOUNCING, [(2.0, 9.0)])
    assert orbits == []
    assert (orbits.search.relay, orbits.search.simulations) == (None, None)
    assert orbits.search.sentence.startswith("searched: near 1 guess (1 led to none). Not searched: other")
    for wrong in ("ab", (1.0,), (1.0, 2.0, 3.0), 2.0):
        with pytest.raises(WrongTypeError, match=r"guesses\[1\] must be a limit cycle or a pair"):
            periodic_orbits(*BOUNCING, [(1.0, 2.0), wrong])


def test_the_answer_is_a_sequence() -> None:
    orbits = periodic_orbits(*BOUNCING, search=OrbitSearch(starts=8))
    (orbit,) = orbits
    assert orbits[0] is orbit
    assert orbits[-1:] == (orbit,)
    assert orbits == [orbit]
    assert orbits != []
    with pytest.raises(FrozenInstanceError):
        orbits.search.failed = 1  # type: ignore[misc]


def test_the_same_seed_gives_the_same_answer() -> None:
    first, second = (periodic_orbits(*BOUNCING, search=OrbitSearch(starts=8, seed=7)) for _ in range(2))
    assert [each.amplitude for each in first] == [each.amplitude for each in second]
    assert first.search == second.search
    other = periodic_orbits(*BOUNCING, search=OrbitSearch(starts=8, seed=8))
    assert other.search != first.search
    assert [each.amplitude for each in other] == pytest.approx([first[0].amplitude], rel=1e-9)


@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ({"starts": 0}, "starts must be a whole number from 1 on, not 0"),
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


def test_orbits_say_whether_the_search_went_to_its_end_and_each_how_well_it_returns() -> None:
    orbits = periodic_orbits(pin_model(TrimmerParameters.thesis()), FrictionBacklash(4e-5))
    assert orbits.success
    assert orbits.message == f"2 periodic orbits found; {orbits.search.sentence}"
    stable, unstable = orbits
    assert stable.success and unstable.success and max(stable.residual, unstable.residual) <= 1e-10
    assert re.fullmatch(r"a stable motion that repeats after 0\.00137326\d+ s", stable.message)
    assert unstable.message.startswith("an unstable motion that repeats after ")
    with pytest.warns(OrbitNotFoundWarning):
        nothing = periodic_orbits(*BOUNCING, [(2.0, 9.0)])
    assert not nothing.success
    assert nothing.message.startswith("0 periodic orbits found; 1 guess led to no orbit; searched: near 1")


@pytest.mark.parametrize("word", ["never", "where-predictions-fail", "always"])
def test_when_to_simulate_is_chosen_by_its_word(word: str) -> None:
    assert OrbitSearch(word).simulations.word == word
    with pytest.raises(ChoiceError, match="simulations is 'nonsense': choose never, where-predictions-fail"):
        OrbitSearch("nonsense")


RELAY = RelaySearch((0.25, 4.0), 3, ((1.0, 1.5), (2.0, 2.25)), 0)
SIMULATED = SimulationSearch(10, 5, 4, 3, 2, 1, 0, 10)
CUT = SimulationSearch(2, 0, 0, 0, 0, 0, 2, 32)
LEFT_OUT = "other orbits, which simulations look for if they are asked for (--simulate)."
ALL_RETURN = "return with their signs changed after one switch, with half periods from 0.25 to 4 s"
SENTENCES = [
    (OrbitSearched(0, False, 0, None, None), ["searched: near no guess. Not searched: " + LEFT_OUT]),
    (OrbitSearched(1, True, 0, None, None), ["near 1 prediction of harmonic balance (all led to an orbit)"]),
    (OrbitSearched(3, True, 1, None, None), ["near 3 predictions of harmonic balance (1 led to none)"]),
    (
        OrbitSearched(0, True, 0, None, None, BalanceSearch(15, 40, 2)),
        ["harmonic balance (order 15 from 40 starts on a grid, 2 more left out; no certificate), which pred"],
    ),
    (
        OrbitSearched(2, False, 0, RELAY, SIMULATED),
        [
            "searched: near 2 guesses (all led to an orbit); all orbits of the relay",
            ALL_RETURN
            + " except in 2 intervals of 0.75 s together; stable orbits by simulation from 10 init",
            "(seed 5: 4 settled on an orbit, 3 came to rest, 2 grew without bound, 1 ended as ",
            "Not searched: other unstable orbits, stable orbits that none of these initial states leads to.",
        ],
    ),
    (
        OrbitSearched(0, False, 0, RelaySearch((0.25, 4.0), 3, (), 48), CUT),
        [
            ALL_RETURN + "; orbits with two switches at unequal distances from a grid of 48 durations; ",
            "from 2 of 32 initial states (seed 0: 2 did not settle in time)",
        ],
    ),
]


@pytest.mark.parametrize(("searched", "parts"), SENTENCES)
def test_a_sentence_tells_what_was_searched_and_what_was_not(searched: OrbitSearched, parts: list) -> None:
    for part in parts:
        assert part in searched.sentence


def test_doubts_are_what_was_left_open() -> None:
    done = RelaySearch((0.25, 4.0), 3, (), 0)
    assert OrbitSearched(3, True, 0, done, SIMULATED).doubts == ()
    assert OrbitSearched(3, True, 2, RELAY, CUT).doubts == (
        "2 predictions of harmonic balance led to no orbit",
        "part of the interval of half periods is undecided",
        "some simulations did not settle in time",
        "the search was interrupted",
    )


ENDS = {
    "settled": (control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0), {}),
    "at_rest": (control.tf([1.0], [1.0, 2.0]), Relay(1.0), {}),
    "diverged": (control.tf([1.0], [1.0, -0.5, 1.0]), Saturation(1.0, 1.0), {}),
    "accumulated": (control.tf([60.0], [1, 3, 3, 1]), FrictionBacklash(1.0) + Relay(1.0), {}),
    "left": (control.tf([1.0], [1.0, 3.0, 2.0, 0.0]), Relay(1.0), {"steps": 3}),
}


@pytest.mark.parametrize("end", ENDS)
@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_ends_of_simulated_motions_are_counted(end: str) -> None:
    plant, element, settings = ENDS[end]
    found = periodic_orbits(plant, element, [], OrbitSearch("always", starts=4, seed=2, **settings))
    told = found.search.simulations
    assert {name: getattr(told, name) for name in ENDS} == {name: 4 * (name == end) for name in ENDS}
    assert (told.starts, told.planned, told.seed, told.interrupted) == (4, 4, 2, False)


class Interrupting:
    """A generator of random numbers at whose third state Ctrl-C is pressed."""

    def __init__(self, given: np.random.Generator) -> None:
        self.given, self.count = given, 0

    def __getattr__(self, name: str) -> object:
        self.count += name == "integers"
        if self.count == 3:
            raise KeyboardInterrupt
        return getattr(self.given, name)


def test_an_interrupted_search_keeps_what_it_has(monkeypatch: pytest.MonkeyPatch) -> None:
    given = np.random.default_rng
    monkeypatch.setattr(np.random, "default_rng", lambda seed: Interrupting(given(seed)))
    with pytest.raises(OrbitSearchInterrupted) as raised:
        periodic_orbits(*BOUNCING, [], ALWAYS)
    orbits = raised.value.orbits
    assert (len(orbits), orbits.search.simulations.settled, orbits.search.simulations.starts) == (1, 2, 2)
    assert orbits.search.doubts == ("the search was interrupted",)
    assert str(raised.value) == orbits.message


@pytest.mark.parametrize(
    ("loop", "of_size"),
    [
        (pin_model(TrimmerParameters.thesis(), channels="displacement"), FrictionBacklash),
        (control.tf([10.0], [1, 3, 3, 1]), lambda size: Relay(size, 0.2 * size, size)),
    ],
)
def test_motions_begin_at_all_sizes_of_the_element(loop, of_size) -> None:
    """An unstable orbit parts motions that grow from those that come to rest, whatever its size."""
    some = OrbitSearch("always", starts=12)
    told = [periodic_orbits(loop, of_size(size), [], some).search.simulations for size in (1e-9, 1.0, 1e9)]
    assert told[0] == told[1] == told[2]
    assert min(told[0].settled, told[0].at_rest) > 1
