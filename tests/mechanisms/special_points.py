"""Folds and period doublings by brute force: Newton's method on the orbit and a multiplier at once."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import root

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.differences import monodromy, once_around
from tests.mechanisms.dynamics import System
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force, Link, Play, Stop


@dataclass(frozen=True)
class SpecialPoint:
    """Where an orbit has a given multiplier, and the state of the orbit at t = 0."""

    omega: float
    state: np.ndarray


def orbit(mechanism: Mechanism, guess: np.ndarray, force: BruteForce | None = None) -> np.ndarray:
    """Return the state at t = 0 of a periodic motion near a guess, by Newton's method."""
    force, system, state = force or BruteForce(), System(mechanism), np.array(guess)
    usual = system.usual[: len(state)]
    for _ in range(12):
        off = (once_around(force, system, state).final - state) / usual
        if np.max(np.abs(off)) < 1e-12:
            break
        jacobian = monodromy(force, system, state)
        state = state - usual * np.linalg.solve(jacobian - np.eye(len(state)), off)
    return state


def special_point(
    at: Callable[[float], Mechanism], guess: SpecialPoint, multiplier: float, step: float = 1e-4
) -> SpecialPoint:
    """Return where the period map's Jacobian has a multiplier.

    Raises:
        RuntimeError: if the iteration does not settle.
    """
    force = BruteForce()

    def missing(unknown: np.ndarray) -> np.ndarray:
        system = System(at(unknown[-1]))
        usual = system.usual[: len(guess.state)]
        off = (once_around(force, system, unknown[:-1]).final - unknown[:-1]) / usual
        jacobian = monodromy(force, system, unknown[:-1], step=step)
        return np.r_[off, np.linalg.det(jacobian - multiplier * np.eye(len(off)))]

    found = root(missing, np.r_[guess.state, guess.omega], tol=1e-12, options={"eps": 1e-9})
    if np.max(np.abs(found.fun)) > 1e-7:
        raise RuntimeError(f"{found.message}: {found.fun}")
    return SpecialPoint(float(found.x[-1]), found.x[:-1])


def body_with_stop(omega: float) -> Mechanism:
    """The published example of pyHarm."""
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=omega / (2 * math.pi),
        links={"spring": Link(("ground", "body"), 40.0, 0.1 * math.sqrt(40))},
        stops={"wall": Stop(("ground", "body"), 1000.0, 0.0, 10.0)},
        forces={"drive": Force("body", amplitude=100.0, phase=math.pi / 2)},
    )


def two_bodies_with_stop(omega: float) -> Mechanism:
    """The published example of NLvib."""
    return Mechanism(
        bodies={"first": Body(1.0), "second": Body(1.0)},
        frequency=omega / (2 * math.pi),
        links={
            "between": Link(("first", "second"), 1.0, 0.03),
            "held": Link(("ground", "second"), 1.0, 0.03),
        },
        stops={"wall": Stop(("ground", "first"), 100.0, 0.0, 1.0)},
        forces={"drive": Force("second", amplitude=0.1, phase=math.pi / 2)},
    )


def dead_zone(omega: float) -> Mechanism:
    """A body in a slot of +-1, with damping to the ground outside the slot."""
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=omega / (2 * math.pi),
        links={"damper": Link(("ground", "body"), 0.0, 0.1)},
        plays={"slot": Play(("ground", "body"), 1.0, 0.0, 2.0)},
        forces={"drive": Force("body", constant=0.1, phase=math.pi / 2, unbalance=0.05)},
    )
