"""The trimmer with play and friction between its events, in 30 digits, with nothing of trimmer.loops.

From Newton's law: between events every coordinate is a sum of exponentials.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field, replace
from functools import cache

import mpmath
import numpy as np
from mpmath import mpf

from tests.trimmer.loops.reference.exact_signals import ZERO, Oscillator, Signal, combination
from trimmer.parameters import TrimmerParameters

BODIES = 4


@dataclass(frozen=True)
class Friction:
    """Coulomb friction against the displacement of one body, relative to another or to the ground (None)."""

    of: int
    relative_to: int | None
    force: float

    @property
    def row(self) -> list[int]:
        return [(i == self.of) - (i == self.relative_to) for i in range(BODIES)]


@dataclass(frozen=True)
class Trimmer:
    """What is simulated; without drive the pin follows q4 - q2."""

    parameters: TrimmerParameters
    gap: float
    time_constant: float
    velocity_too: bool
    drive: tuple[float, float] | None = None
    frictions: tuple[Friction, ...] = ()


@dataclass(frozen=True)
class Moment:
    """State at an instant: bodies, load, the side in contact (0, 1, -1), and signs of sliding (0 sticks)."""

    time: mpf
    q: mpmath.matrix
    rate: mpmath.matrix
    load: mpf = ZERO
    load_rate: mpf = ZERO
    side: int = 0
    sliding: tuple[int, ...] = ()


@dataclass(frozen=True)
class Flight:
    """The motion from a moment until the next event, as signals of the time since then."""

    q: list[Signal]
    pin: Signal
    load: Signal
    holding: list[Signal] = field(default_factory=list)


def network(pairs: dict[tuple[int, int | None], float]) -> mpmath.matrix:
    """Return the matrix of springs or dampers between bodies, or between a body and the ground."""
    total = mpmath.zeros(BODIES)
    for (first, second), value in pairs.items():
        row = mpmath.matrix([[(i == first) - (i == second) for i in range(BODIES)]])
        total += mpf(value) * (row.T * row)
    return total


@cache
def oscillator(trimmer: Trimmer, closed: bool, stuck: tuple[int, ...]) -> tuple[Oscillator, mpmath.matrix]:
    """Return the bodies with the closed loop as a spring, and the directions that stick leaves free."""
    p = trimmer.parameters
    M = mpmath.diag([mpf(m) for m in (p.m1, p.m2, p.m3, p.m4)])
    K = network({(0, None): p.k1, (0, 1): p.k2, (2, None): p.k3, (2, 3): p.k4, (1, 2): p.k5})
    C = network({(0, None): p.c1, (0, 1): p.c2, (2, None): p.c3, (2, 3): p.c4})
    if closed:  # The load is at q4 - q2 -+ gap/2, and k2 times it pushes the cutter forwards.
        through = mpmath.matrix([[-1], [1], [0], [0]]) * mpmath.matrix([[0, 1, 0, -1]])
        K += mpf(p.k2) * through
        C += mpf(p.c2) * through if trimmer.velocity_too else mpmath.zeros(BODIES)
    free = mpmath.eye(BODIES)
    if stuck:
        rows = np.array([trimmer.frictions[k].row for k in stuck])
        directions = [v for v in itertools.product((-1, 0, 1), repeat=BODIES) if not (rows @ v).any()]
        chosen: list[tuple[int, ...]] = []
        for direction in directions:
            if np.linalg.matrix_rank(np.array([*chosen, direction])) > len(chosen):
                chosen.append(direction)
        free = mpmath.matrix(chosen).T
    return Oscillator(free.T * M * free, free.T * C * free, free.T * K * free), free


def flight(trimmer: Trimmer, now: Moment) -> Flight:
    """Return the motion that follows, with the force that each stuck friction needs."""
    stuck = tuple(k for k, sign in enumerate(now.sliding) if sign == 0)
    closed = bool(now.side) and trimmer.drive is None
    bodies, free = oscillator(trimmer, closed, stuck)
    whole, _ = oscillator(trimmer, closed, ())
    load = _load(trimmer, now)
    push = mpf(trimmer.parameters.k2) * load
    if trimmer.velocity_too:
        push = push + mpf(trimmer.parameters.c2) * load.derivative()
    force = [-1 * push, push, Signal(), Signal()]
    for friction, sign in zip(trimmer.frictions, now.sliding, strict=True):
        force = [
            f - Signal({}, mpf(sign * friction.force * e)) for f, e in zip(force, friction.row, strict=True)
        ]
    held = whole.K * now.q
    reduced = [
        combination(free[:, j], [f - Signal({}, h) for f, h in zip(force, held, strict=True)])
        for j in range(free.cols)
    ]
    rates = mpmath.lu_solve(free.T * free, free.T * now.rate)
    z = bodies.motion(reduced, mpmath.zeros(free.cols, 1), rates)
    q = [Signal({}, now.q[i]) + combination(free[i, :], z) for i in range(BODIES)]
    pin = _drive(trimmer, now.time) if trimmer.drive else q[3] - q[1]
    if now.side:
        load = pin - Signal({}, now.side * mpf(trimmer.gap) / 2)
    return Flight(q, pin, load, _holding(trimmer, whole, q, force, stuck))


def _drive(trimmer: Trimmer, time: mpf) -> Signal:
    amplitude, omega = map(mpf, trimmer.drive)
    return Signal({mpmath.mpc(0, omega): -1j * amplitude * mpmath.expj(omega * time)})


def _load(trimmer: Trimmer, now: Moment) -> Signal:
    """Return the load's motion as far as it is known beforehand; the rest is in K and C."""
    tau = trimmer.time_constant
    if now.side:
        known = _drive(trimmer, now.time) if trimmer.drive else Signal()
        return known - Signal({}, now.side * mpf(trimmer.gap) / 2)
    if tau == 0:
        return Signal({}, now.load)
    if tau == float("inf"):
        return Signal({}, now.load, now.load_rate)
    distance = mpf(tau) * now.load_rate
    return Signal({mpmath.mpc(-1 / mpf(tau)): -distance}, now.load + distance)


def _holding(
    trimmer: Trimmer, bodies: Oscillator, q: list[Signal], force: list[Signal], stuck: tuple[int, ...]
) -> list[Signal]:
    """Return the forces against the stuck displacements that the balance of forces leaves."""
    if not stuck:
        return []
    rates = [each.derivative() for each in q]
    accelerations = [each.derivative() for each in rates]
    missing = [
        force[i]
        - combination(bodies.M[i, :], accelerations)
        - combination(bodies.C[i, :], rates)
        - combination(bodies.K[i, :], q)
        for i in range(BODIES)
    ]
    rows = mpmath.matrix([trimmer.frictions[k].row for k in stuck])
    solve = (rows * rows.T) ** -1 * rows
    return [combination(solve[k, :], missing) for k in range(len(stuck))]


def contact_force(trimmer: Trimmer, now: Moment, motion: Flight) -> Signal:
    """Return the force of the pin on the load, over M or D."""
    rate = motion.pin.derivative()
    if trimmer.time_constant == float("inf"):
        return now.side * rate.derivative()
    return now.side * (mpf(trimmer.time_constant) * rate.derivative() + rate)


def event_functions(trimmer: Trimmer, now: Moment, motion: Flight) -> dict[tuple[str, int], Signal]:
    """Return signals that are positive until an event, by what happens then."""
    found = {}
    if now.side:
        found["separation", 0] = contact_force(trimmer, now, motion)
    else:
        half_gap, play = Signal({}, mpf(trimmer.gap) / 2), motion.pin - motion.load
        found["impact", 1], found["impact", -1] = half_gap - play, half_gap + play
    holding = iter(motion.holding)
    for k, (friction, sign) in enumerate(zip(trimmer.frictions, now.sliding, strict=True)):
        if sign:
            found["stop", k] = sign * sliding_rate(friction, motion)
        else:
            limit, force = Signal({}, mpf(friction.force)), next(holding)
            found["slip forwards", k], found["slip backwards", k] = limit - force, limit + force
    return found


def sliding_rate(friction: Friction, motion: Flight) -> Signal:
    return combination(friction.row, [each.derivative() for each in motion.q])


def moved(now: Moment, motion: Flight, elapsed: mpf) -> Moment:
    rates = [each.derivative() for each in motion.q]
    return replace(
        now,
        time=now.time + elapsed,
        q=mpmath.matrix([each.at(elapsed) for each in motion.q]),
        rate=mpmath.matrix([each.at(elapsed) for each in rates]),
        load=motion.load.at(elapsed),
        load_rate=motion.load.derivative().at(elapsed),
    )
