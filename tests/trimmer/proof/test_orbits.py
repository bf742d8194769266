"""Exact orbits by ball arithmetic: the right one is proven, and nothing that is not one."""

import re
from collections.abc import Callable
from pathlib import Path

import control
import numpy as np
import pytest
import scipy.linalg

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.cases import block_on_belt
from tests.mechanisms.differences import once_around
from tests.mechanisms.dynamics import System
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from trimmer import ClosedLoop, Drive, OpenLoop, Relay, Saturation, forced_orbit, periodic_orbits, respond
from trimmer.elements import FrictionBacklash
from trimmer.errors import TrimmerError
from trimmer.mechanism import Body, Force, Friction, Link, Mechanism, Output, Pid
from trimmer.proof import Proof, prove_orbit
from trimmer.response.periodic.orbit import Orbit
from trimmer.thesis import TrimmerParameters, pin_model

pytest.importorskip("flint")

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


def sampled(limit: float | None, friction: float) -> Mechanism:
    """A mass of 0.2 g m^2 under a moment of 50 Hz, held by a controller that samples once a millisecond."""
    control = Pid(
        measure="angle",
        acts=("ground", "motor"),
        kp=1.5,
        kd=0.02,
        filter_time=2e-3,
        sample=1e-3,
        delay=5e-4,
        limit=limit,
    )
    return Mechanism(
        bodies={"motor": Body(inertia=2e-4)},
        frequency=50.0,
        links={"bearing": Link(("ground", "motor"), damping=1e-3)},
        forces={"load": Force("motor", amplitude=0.05)},
        frictions={"rub": Friction(("ground", "motor"), friction)} if friction else {},
        controllers={"axis": control},
        outputs={"angle": Output({"motor": 1.0})},
    )


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
    "ball on a wall": lambda: forced_orbit(machine("bouncing-ball.toml")),
    "ball without rebound": lambda: forced_orbit(
        machine("bouncing-ball.toml", walls__plate__restitution=0.0, pins__table__amplitude=9e-4)
    ),
    "ball at rest on a wall": lambda: forced_orbit(
        machine("bouncing-ball.toml", walls__plate__restitution=0.1)
    ),
    "an advance that is found": lambda: forced_orbit(machine("conveyor.toml")),
    "an advance that is known": lambda: forced_orbit(machine("gear-rattle.toml")),
    "sampled, at its limit": lambda: forced_orbit(sampled(0.012, 0.01)),
}


@pytest.mark.parametrize("name", quick(ORBITS, 0, 1, 2, 3, 4, 7, 10, 11, 13, 15))
def test_an_orbit_is_proven_with_its_largest_multiplier(name: str) -> None:
    orbit = ORBITS[name]()
    proof = prove_orbit(orbit.subject, orbit)
    assert (proof.verdict, proof.reason) == ("proven", "")
    assert ("It is stable" if orbit.stable else "It is unstable") in proof.theorem
    told = re.search(r"is between (\S+) and (\S+)\.$", proof.theorem)
    largest = float(abs(orbit.nontrivial_multipliers).max())
    assert float(told[1]) <= largest + 1e-9
    assert largest <= float(told[2]) + 1e-9
    assert float(told[2]) - float(told[1]) < 1e-9


def test_an_orbit_of_another_machine_is_none() -> None:
    orbit = forced_orbit(twin(1.0))
    for other in (twin(1.0 + 1e-6), machine("oscillator-stop.toml")):
        refused = prove_orbit(other, orbit)
        assert refused.verdict in ("refuted", "undecided")
        assert refused.theorem == ""


def test_a_sampled_motion_has_the_multipliers_of_its_difference_equation() -> None:
    """Without friction and limit it is linear, in angle, speed, filter and two demands, over 20 samples."""
    orbit = forced_orbit(sampled(None, 0.0))
    flow = scipy.linalg.expm(0.5e-3 * np.array([[0.0, 1.0, 0.0], [0.0, -5.0, 5e3], [0.0, 0.0, 0.0]]))[:2]
    share = 1e-3 / (2e-3 + 1e-3)
    # e = -y, z = z + share (e - z), u = kp e + kd (e - z)/filter_time: the old u acts for half a sample.
    filtered = np.array([-share, 0.0, 1.0 - share])
    demand = 1.5 * np.array([-1.0, 0.0, 0.0]) + 10.0 * (np.array([-1.0, 0.0, 0.0]) - filtered)
    sample = np.zeros((4, 4))
    halfway = np.hstack([flow[:, :2], np.zeros((2, 1)), flow[:, 2:]])
    sample[:2] = flow[:, :2] @ halfway
    sample[:2, :3] += np.outer(flow[:, 2], demand)
    sample[2, :3], sample[3, :3] = filtered, demand
    largest = abs(np.linalg.eigvals(np.linalg.matrix_power(sample, 20))).max()
    proof = prove_orbit(orbit.subject, orbit)
    told = re.search(r"40 of them at instants of a clock.* is between (\S+) and (\S+)\.$", proof.theorem)
    assert float(told[1]) <= largest <= float(told[2])


def test_a_ball_on_a_wall_loses_area_by_the_square_of_its_restitution() -> None:
    orbit = ORBITS["ball on a wall"]()
    proof = prove_orbit(orbit.subject, orbit)
    told = re.search(r"is between (\S+) and (\S+)\.$", proof.theorem)
    # The multipliers are complex, with the product 0.6^2: both have the modulus 0.6.
    assert float(told[1]) <= 0.6 <= float(told[2])


def test_what_is_not_covered_is_undecided() -> None:
    ball = machine("bouncing-ball.toml", walls__plate__restitution=0.1, pins__table__amplitude=9e-4)
    proof = prove_orbit(ball, forced_orbit(ball))
    assert proof.verdict == "undecided"
    assert "a chatter's end" in proof.reason


def require_return_and_events(proof: Proof, orbit: Orbit, mechanism: Mechanism, seed: int) -> None:
    """Hold a proven orbit against brute force: it returns too, and each event that it sees is one there.

    A spring that a contact has left, and that comes to rest, is an event of the proof alone.
    """
    system = System(mechanism)
    size = system.rows.state_size
    state = orbit.instant.state[:size]
    around = once_around(BruteForce(), system, state, orbit.periods)
    growth = max(1.0, float(abs(orbit.nontrivial_multipliers).max(initial=0.0)))
    assert np.max(np.abs(around.final - state) / system.usual[:size]) < 1e-6 * growth, seed
    times = np.cumsum([each["duration"] for each in proof.data["motion"]["segments"]][:-1])
    for event in around.events:
        assert np.min(np.abs(times - event.time)) < 1e-6 * growth / mechanism.frequency, (seed, event)


def proven_and_held_against_brute_force(seeds: range) -> int:
    """Prove orbits of random machines; return how many are proven, each of which brute force confirms."""
    count = 0
    for seed in seeds:
        mechanism = random_mechanism(seed)
        try:
            orbit = forced_orbit(mechanism)
        except TrimmerError:
            continue
        proof = prove_orbit(mechanism, orbit)
        if proof:
            require_return_and_events(proof, orbit, mechanism, seed)
            count += 1
    return count


@pytest.mark.parametrize("seeds", quick([range(7, 8), *(range(k, k + 15) for k in range(0, 200, 50))], 0))
def test_of_random_machines_none_is_proven_wrongly(seeds: range) -> None:
    """Of 0 to 199 it was 136; 45 were not proven, and 19 have no motion that repeats."""
    assert proven_and_held_against_brute_force(seeds), "nothing was held against brute force"


@pytest.mark.parametrize("seed", quick([1014, 1012, 1129]))
def test_an_orbit_over_which_balls_grow_far_is_proven_with_more_bits(seed: int) -> None:
    """Of 1000 to 1129 it was 97, ten of them so; 23 were not proven, and 10 have no motion that repeats."""
    mechanism = random_mechanism(seed)
    orbit = forced_orbit(mechanism)
    proof = prove_orbit(mechanism, orbit)
    assert (proof.verdict, proof.reason) == ("proven", "")
    assert proof.theorem
    require_return_and_events(proof, orbit, mechanism, seed)


def test_one_of_a_family_is_undecided_and_says_so() -> None:
    mechanism = random_mechanism(1029)
    proof = prove_orbit(mechanism, forced_orbit(mechanism))
    assert (proof.verdict, proof.theorem) == ("undecided", "")
    assert "it may be one of a family" in proof.reason
