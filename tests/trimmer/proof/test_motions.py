"""Motions from a state by ball arithmetic: against brute force and closed forms; made false, refused."""

import math
import re
from pathlib import Path

import control
import numpy as np
import pytest

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.dynamics import System
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from tests.trimmer.proof.test_orbits import machine, sampled
from trimmer import ClosedLoop, Relay, simulate
from trimmer.mechanism import Body, Mechanism, Output, Wall

pytest.importorskip("flint")
from trimmer.proof import Proof, check_proof, prove_motion

BETWEEN = r"between (\S+) and ([^\s,;]+\d)"
PERIODS = 2.3


def told(proof: Proof, pattern: str) -> list[tuple[float, float]]:
    found = re.findall(f"{pattern} {BETWEEN}", proof.theorem)
    return [(float(lower), float(upper)) for lower, upper in found]


def proven_and_confirmed(seed: int) -> bool:
    """Prove a motion of a random machine from rest; where proven, brute force has its events and its end.

    Where several frictions decide at one instant, brute force may decide otherwise: so in one of 70.
    """
    mechanism = random_mechanism(seed)
    duration = PERIODS / mechanism.frequency
    names = [f"{axis}.{body}" for axis in ("displacements", "velocities") for body in mechanism.bodies]
    proof = prove_motion(mechanism, simulate(mechanism, duration), readings=names)
    if not proof:
        return False
    system, motion = System(mechanism), BruteForce().from_rest(mechanism, duration)
    times = np.array(told(proof, r"event \d+")).mean(axis=-1)
    own = np.array([event.time for event in motion.events if event.time > 0])
    found = [np.min(abs(times - each)) < 1e-6 / mechanism.frequency for each in own]
    if not all(found):
        last = own[found.index(False) - 1]
        assert np.sum(own == last) > 1, (seed, last)
        return True
    ends, usual = told(proof, r"unchecked, is: [^:]*?at the end"), system.usual[: len(motion.final)]
    for (lower, upper), value, size in zip(ends, motion.final, usual, strict=False):
        assert abs(0.5 * (lower + upper) - value) < 1e-6 * size + (upper - lower), (seed, proof.theorem)
    return True


@pytest.mark.parametrize("seeds", quick([range(11, 12), *(range(k, k + 12) for k in range(0, 150, 50))], 0))
def test_of_motions_of_random_machines_none_is_proven_wrongly(seeds: range) -> None:
    assert sum(map(proven_and_confirmed, seeds)) > 0.7 * len(seeds)


def falling() -> Proof:
    ball = Mechanism(
        bodies={"ball": Body(mass=1.0)},
        walls={"floor": Wall(("ball", "ground"), restitution=0.5)},
        forces={},
        outputs={"height": Output({"ball": 1.0})},
    )
    motion = simulate(ball, 3.0, state={"ball": (1.0, -1.0)})
    return prove_motion(ball, motion, readings=["outputs.height", "outputs.height = 0.25"])


def test_a_body_without_forces_is_where_a_line_is() -> None:
    """It falls 1 m at 1 m/s, and comes back at half that."""
    proof = falling()
    for pattern, value in {
        "event 1": 1.0,
        "at the end": 1.0,
        "integral": 0.5 + 1.0,
        "zero at": 0.75,
        "zero at between [^ ]+ and [^ ]+ s and": 1.5,
    }.items():
        ((lower, upper),) = told(proof, pattern)
        assert lower <= value <= upper < lower + 1e-13, pattern


def test_a_relay_in_a_loop_switches_when_its_output_says() -> None:
    """An integrator of a lag behind a relay, from y = 1 at rest: 1 - (t - 1 + exp(-t)) = 0."""
    plant = control.ss([[0.0, 1.0], [0.0, -1.0]], [[0.0], [1.0]], [[1.0, 0.0]], [[0.0]])
    loop = ClosedLoop(plant, Relay(1.0))
    motion = simulate(loop, 2.5, initial_state=[1.0, 0.0])
    proof = prove_motion(loop, motion)
    assert proof.verdict == "proven"
    ((lower, upper),) = told(proof, "event 1")
    for end, sign in ((lower, 1), (upper, -1)):
        assert sign * (2.0 - end - math.exp(-end)) >= 0


def test_a_sampled_motion_at_its_limit_is_proven_and_verified_again(tmp_path: Path) -> None:
    axis = sampled(0.012, 0.01)
    proof = prove_motion(axis, simulate(axis, 0.05))
    assert proof.verdict == "proven"
    assert "At 100 times the states become what it says, where its 74 inequalities hold" in proof.theorem
    proof.write(tmp_path / "motion.json")
    assert check_proof(tmp_path / "motion.json") == proof


def test_a_chatter_that_ends_is_not_covered() -> None:
    ball = machine("bouncing-ball.toml", walls__plate__restitution=0.1, pins__table__amplitude=9e-4)
    proof = prove_motion(ball, simulate(ball, 0.3))
    assert (proof.verdict, proof.theorem) == ("undecided", "")
    assert "a chatter's end" in proof.reason
