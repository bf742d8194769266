"""Special points by ball arithmetic: folds, period doublings, symmetry breakings, and what is not covered."""

import math
import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import control
import numpy as np
import pytest
import scipy.linalg
import scipy.optimize

from tests.quick import quick
from tests.trimmer.branches.bouncing_ball import ball, fold, thrown
from tests.trimmer.branches.published import dead_zone, two_blocks
from trimmer import Body, ClosedLoop, FollowSettings, Force, Link, Mechanism, Play, Relay, SpecialKind, follow
from trimmer.branches import FollowedBranch, SpecialPoint
from trimmer.mechanism import Pid
from trimmer.proof import Proof, check_proof, prove_special_point

pytest.importorskip("flint")

TURN = 2.0 * math.pi
EXAMPLES = Path(__file__).parents[3] / "examples"
MACHINE = Mechanism.from_toml(EXAMPLES / "oscillator-stop.toml")
DOUBLING = 5.5567187941  # rad/s, of the example of pyHarm in tests/trimmer/branches/published.py
ALONE = FollowSettings(switches=0, quiet=True, largest_step=0.05)
PLANT = control.tf([8.0], [1.0, 3.0, 3.0, 1.0])


def relay_that_rests() -> float:
    """Return the largest half width of the dead zone of a relay of 1 at which its loop with PLANT vibrates.

    Half a period T, in which the relay is on for a time: from where the output reaches the edge at t = 0.
    """
    space = control.ss(PLANT)

    def at_edges(half: float, share: float) -> tuple[float, float]:
        pushed = scipy.linalg.expm(np.block([[space.A, -space.B], [np.zeros((1, 4))]]) * share * half)
        rest = scipy.linalg.expm(space.A * (1.0 - share) * half)
        start = np.linalg.solve(-np.eye(3) - rest @ pushed[:3, :3], rest @ pushed[:3, 3])
        after = pushed[:3, :3] @ start + pushed[:3, 3]
        return float((space.C @ start)[0]), float((space.C @ after)[0])

    def edge(share: float) -> float:
        half = scipy.optimize.brentq(lambda half: np.subtract(*at_edges(half, share)), 1.5, 2.5, xtol=1e-14)
        return at_edges(float(half), share)[0]

    best = scipy.optimize.minimize_scalar(lambda share: -edge(share), bounds=(0.2, 0.7), method="bounded")
    return -float(best.fun)


def between_stops() -> Mechanism:
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=0.2,
        links={"spring": Link(("ground", "body"), stiffness=1.0, damping=0.1)},
        plays={"springs": Play(("ground", "body"), 10.0, gap=2.0)},
        forces={"drive": Force("body", amplitude=3.0)},
        outputs={},
    )


def wall(amplitude: float) -> Mechanism:
    machine = Mechanism.from_toml(EXAMPLES / "bouncing-ball.toml")
    return machine.with_value(AMPLITUDE, amplitude)


def sampled() -> Mechanism:
    ends, numbers = ("ground", "mass"), {"kp": 0.5, "kd": 0.02, "filter_time": 0.05, "limit": 3.0}
    place = Pid(measure="mass", acts=ends, sample=1 / 8.8, **numbers)
    return replace(MACHINE, frequency=1.1, controllers={"place": place})


GRAVITY, OMEGA, REBOUND = 9.81, 20.0 * TURN, 0.6
THROWN = GRAVITY * math.pi * (1 - REBOUND) / (1 + REBOUND) / OMEGA**2
"""Amplitude, m, from which a table throws a ball once a period, by Newton's law. At impact A cos(phase) is
this, so that the fold has it at t = 0; of multipliers with the product e^2 one is -1 where A sin(phase) is
``TURNED``.
"""
TURNED = 2.0 * GRAVITY * (1 + REBOUND**2) / (1 + REBOUND) ** 2 / OMEGA**2
TWICE = math.hypot(THROWN, TURNED)
SPEEDS = 5.553 / TURN, 5.56 / TURN
TOUCH = math.sqrt(0.5 * (79.6 - math.sqrt(79.6**2 - 6000.0))) / TURN
"""Without contact (40 - w^2)^2 + 0.4 w^2 = (100/10)^2."""
AMPLITUDE = "pins.table.amplitude"
SPEED = "pins.belt.velocity"
BRANCHES: dict[str, tuple[Callable[[], Any], str, tuple[float, float], str, Callable[[], float]]] = {
    "doubling": (lambda: MACHINE, "frequency", SPEEDS, "period-doubling", lambda: DOUBLING / TURN),
    "touch": (lambda: MACHINE, "frequency", (5.53 / TURN, 5.54 / TURN), "grazing", lambda: TOUCH),
    "ball": (lambda: ball(1e4, 0.3, 0.45), AMPLITUDE, (0.45, 0.3), "fold", lambda: fold(1e4)),
    "wall": (lambda: wall(5e-4), AMPLITUDE, (5e-4, 4e-4), "fold", lambda: THROWN),
    "wall, twice": (lambda: wall(8e-4), AMPLITUDE, (8e-4, 8.3e-4), "period-doubling", lambda: TWICE),
    # Closed loop, of its own period.
    "relay": (
        lambda: ClosedLoop(PLANT, Relay(1.0, 0.0, 0.6)),
        "element.dead_zone",
        (0.6, 0.9),
        "fold",
        relay_that_rests,
    ),
    # Two computations: tests/trimmer/branches/test_joining.py.
    "stops": (between_stops, "frequency", (0.193, 0.19), "symmetry-breaking", lambda: 0.191360833785),
    # By brute force: tests/trimmer/branches/test_follow_self_excited.py.
    "blocks": (lambda: two_blocks(0.7), SPEED, (0.7, 0.69), "period-doubling", lambda: 0.697486236508),
    # By DOP853 between samples: the least amplitude over all starts near it that return.
    "sampled": (sampled, "forces.drive.amplitude", (55.0, 46.5), "fold", lambda: 46.83340038247),
}
STATES = {"ball": thrown(0.3, 0.45), "blocks": [0.549, 0.543, -0.954, -0.952, 6.44]}
STATES["sampled"] = [-1.85, 71.66, 9.0155, 3.0]
"""Where a branch begins, if not where its first motion settles."""


@cache
def found(name: str) -> tuple[FollowedBranch, SpecialPoint]:
    make, place, ends, kind, _ = BRANCHES[name]
    branch = follow(make(), place, *ends, state=STATES.get(name), settings=ALONE)
    return branch, next(each for each in branch.special if each.kind.word == kind)


@cache
def proven(name: str) -> Proof:
    return prove_special_point(BRANCHES[name][0](), *found(name))


@pytest.mark.parametrize("name", quick(BRANCHES, 0, 2, 3, 4, 5, 7))
def test_a_special_point_is_proven_where_it_is_otherwise_found(name: str, tmp_path: Path) -> None:
    proof = proven(name)
    assert (proof.verdict, proof.reason) == ("proven", "")
    told = re.search(rf"a {BRANCHES[name][3]} within 1e-09, relative, of \S+ = (\S+)\.$", proof.theorem)
    assert float(told[1]) == pytest.approx(BRANCHES[name][4](), rel=2e-9)
    proof.write(tmp_path / "special.json")
    assert check_proof(tmp_path / "special.json") == proof


@pytest.mark.slow
def test_all_folds_and_doublings_of_a_dead_zone_are_proven() -> None:
    machine = dead_zone(0.5)
    branch = follow(machine, "frequency", 0.5 / TURN, 1.6 / TURN, settings=ALONE)
    kinds = SpecialKind.FOLD, SpecialKind.PERIOD_DOUBLING
    proofs = [prove_special_point(machine, branch, each) for each in branch.special if each.kind in kinds]
    assert len(proofs) > 1
    assert all(proofs)


@pytest.mark.slow
def test_what_a_clock_asks_of_a_number_is_not_covered() -> None:
    _, fold_over_force = found("sampled")
    machine = sampled().with_value("forces.drive.amplitude", fold_over_force.value)
    branch = follow(machine, "controllers.place.limit", 3.0, 3.001, settings=ALONE)
    proof = prove_special_point(machine, branch, replace(fold_over_force, value=3.0))
    assert "demands or their limits depend" in proof.reason


@pytest.mark.parametrize("factor", quick([1 + 3e-6, 1 - 3e-6], 0))
def test_one_that_was_moved_is_refuted(factor: float) -> None:
    branch, doubling = found("doubling")
    moved = replace(doubling, value=doubling.value * factor)
    proof = prove_special_point(MACHINE, branch, moved)
    assert (proof.verdict, proof.theorem) == ("refuted", "")
    assert proof.reason.startswith("the period-doubling nearest to it is at 0.88437926")


@pytest.mark.parametrize(
    ("kind", "told"),
    [
        (SpecialKind.TORUS, "no pair of multipliers is alone near the unit circle"),
        (SpecialKind.GRAZING, "the motion begins elsewhere"),
        (SpecialKind.SYMMETRY_BREAKING, "not covered"),
        (SpecialKind.STICK, "not covered"),
    ],
)
def test_what_is_none_or_not_covered_is_not_proven(kind: SpecialKind, told: str) -> None:
    branch, doubling = found("doubling")
    proof = prove_special_point(MACHINE, branch, replace(doubling, kind=kind))
    assert proof.verdict != "proven"
    assert told in proof.reason


@pytest.mark.parametrize("factor", [1 + 2e-9, 1 - 2e-9])
def test_a_grazing_that_was_moved_is_undecided(factor: float) -> None:
    branch, touch = found("touch")
    proof = prove_special_point(MACHINE, branch, replace(touch, value=touch.value * factor))
    assert (proof.verdict, proof.theorem) == ("undecided", "")
    assert "does not change its sign" in proof.reason
