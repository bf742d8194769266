"""Exact orbits by ball arithmetic: the right one is proven, and nothing that is not one."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import control
import numpy as np
import pytest

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.cases import block_on_belt
from tests.mechanisms.differences import once_around
from tests.mechanisms.dynamics import System
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from trimmer import (
    ClosedLoop,
    Drive,
    FrictionBacklash,
    Mechanism,
    OpenLoop,
    Relay,
    Saturation,
    forced_orbit,
    periodic_orbits,
    respond,
)
from trimmer.command_line.main import main
from trimmer.errors import TrimmerError
from trimmer.response.orbit import Orbit
from trimmer.thesis import TrimmerParameters, pin_model

pytest.importorskip("flint")
from trimmer.proof import Proof, check_proof, prove_orbit

EXAMPLES = Path(__file__).parents[3] / "examples"
THIRD = control.tf([8.0], [1.0, 3.0, 3.0, 1.0])
TRIMMER = pin_model(TrimmerParameters.thesis())


def machine(name: str, **numbers: float) -> Mechanism:
    found = Mechanism.from_toml(EXAMPLES / name)
    for place, value in numbers.items():
        found = found.with_value(place.replace("__", "."), value)
    return found


def twin(force: float) -> Mechanism:
    return machine("thesis-play.toml", frictions__blade__force=force)


ORBITS: dict[str, Callable[[], Orbit]] = {
    "relay": lambda: periodic_orbits(ClosedLoop(THIRD, Relay(1.0))).orbits[0],
    "stick-slip": lambda: respond(block_on_belt((0.0, 0.0))).motion.orbit,
    "without events": lambda: forced_orbit(machine("oscillator-stop.toml")),
    "stable loop": lambda: periodic_orbits(ClosedLoop(TRIMMER, FrictionBacklash(4e-5))).orbits[0],
    "unstable loop": lambda: periodic_orbits(ClosedLoop(TRIMMER, FrictionBacklash(4e-5))).orbits[1],
    "saturation": lambda: periodic_orbits(ClosedLoop(2.5 * THIRD, Saturation(1.0, 1.0))).orbits[0],
    "driven loop": lambda: forced_orbit(OpenLoop(TRIMMER, FrictionBacklash(4e-5), Drive(1e-3, 110.0))),
    "the thesis's trimmer": lambda: forced_orbit(twin(1.0)),
    "two plays": lambda: forced_orbit(machine("second-play.toml")),
    "toothbrush": lambda: forced_orbit(machine("toothbrush.toml")),
}


@pytest.mark.parametrize("name", quick(ORBITS, 0, 1, 2, 3, 4, 7))
def test_an_orbit_is_proven_with_its_largest_multiplier(name: str) -> None:
    orbit = ORBITS[name]()
    proof = prove_orbit(orbit.subject, orbit)
    assert (proof.verdict, proof.reason) == ("proven", "")
    assert ("It is stable" if orbit.stable else "It is unstable") in proof.theorem
    told = re.search(r"is between (\S+) and (\S+)\.$", proof.theorem)
    assert told is not None
    largest = float(abs(orbit.nontrivial_multipliers).max())
    assert float(told[1]) <= largest + 1e-9
    assert largest <= float(told[2]) + 1e-9


def test_an_orbit_of_another_machine_is_none() -> None:
    orbit = forced_orbit(twin(1.0))
    for other in (twin(1.0 + 1e-6), machine("oscillator-stop.toml")):
        refused = prove_orbit(other, orbit)
        assert refused.verdict in ("refuted", "undecided")
        assert refused.theorem == ""


@pytest.fixture(scope="module")
def proof() -> Proof:
    orbit = ORBITS["stable loop"]()
    return prove_orbit(orbit.subject, orbit)


def less_an_event(data: dict[str, Any]) -> None:
    data["segments"][1]["duration"] += data["segments"].pop(2)["duration"]


def moved(data: dict[str, Any]) -> None:
    data["state"][0] *= 1 + 1e-6


def stiffer(data: dict[str, Any]) -> None:
    row = max(data["modes"][0]["flow"], key=lambda each: max(map(abs, each)))
    place = int(np.argmax(np.abs(row)))
    row[place] *= 1 + 1e-6


def unstable(data: dict[str, Any]) -> None:
    data["stable"] = False


def of_no_loss(data: dict[str, Any]) -> None:
    data["segments"][0]["reset"][0][0] += 1e-3


def longer(data: dict[str, Any]) -> None:
    data["segments"][-1]["duration"] *= 1 + 1e-6


def another_event(data: dict[str, Any]) -> None:
    functions = data["modes"][0]["functions"]
    functions.append([-each for each in functions[0]])


def no_event(data: dict[str, Any]) -> None:
    data["segments"][1]["zeros"].append([1, 1])


def two_at_once(data: dict[str, Any]) -> None:
    data["segments"][1]["together"] = [0]


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (less_an_event, "an event is too far from where it was computed"),
        (moved, "the motion begins elsewhere: state 0"),
        (stiffer, "the motion begins elsewhere: state 0"),
        (unstable, "it is said to be unstable, and is stable"),
        (of_no_loss, "does not map the ball of starts into itself"),
        (longer, "its period is longer by -2.65"),
        (another_event, "event function 1 of segment 0 is negative within it"),
        (no_event, "event function 1 of segment 1 is not zero where it is said to be"),
        (two_at_once, "two event functions come to zero at one instant"),
    ],
)
def test_a_file_that_was_made_false_is_refused(
    proof: Proof,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    change: Callable[[dict[str, Any]], None],
    told: str,
) -> None:
    path = tmp_path / "orbit.json"
    proof.write(path)
    content = json.loads(path.read_text())
    change(content["data"])
    path.write_text(json.dumps(content))
    assert main(["check", str(path)]) == 2
    assert told in capsys.readouterr().err


def test_a_file_as_it_was_written_is_proven_again(proof: Proof, tmp_path: Path) -> None:
    proof.write(tmp_path / "orbit.json")
    assert check_proof(tmp_path / "orbit.json") == proof


def test_what_is_not_covered_is_undecided() -> None:
    ball = forced_orbit(machine("bouncing-ball.toml"))
    gears = forced_orbit(machine("gear-rattle.toml"))
    reasons = [prove_orbit(each.subject, each) for each in (ball, gears)]
    assert [each.verdict for each in reasons] == ["undecided", "undecided"]
    assert "a shift along which no force changes" in reasons[1].reason


def held_against_brute_force(seeds: range) -> Counter[str]:
    """Prove orbits of random machines: brute force returns too, after as many events."""
    counts: Counter[str] = Counter()
    for seed in seeds:
        mechanism = random_mechanism(seed)
        try:
            orbit = forced_orbit(mechanism)
        except TrimmerError:
            continue
        found = prove_orbit(mechanism, orbit)
        counts[found.verdict] += 1
        if found and orbit.stable:
            system = System(mechanism)
            size = system.rows.state_size
            state = orbit.instant.state[:size]
            around = once_around(BruteForce(), system, state, orbit.periods).final
            assert np.max(np.abs(around - state) / system.usual[:size]) < 1e-6, seed
    return counts


def test_random_machines() -> None:
    assert held_against_brute_force(range(7, 8))["proven"] == 1


@pytest.mark.slow
def test_two_hundred_random_machines() -> None:
    counts = held_against_brute_force(range(200))
    assert counts["proven"] >= 100
    assert not counts["refuted"]
