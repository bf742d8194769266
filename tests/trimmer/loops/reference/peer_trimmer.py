"""Motions of the trimmer by SciPy's `solve_ivp` with terminal events, written from Newton's law alone."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from scipy.integrate import solve_ivp

from trimmer import TrimmerParameters
from trimmer.arrays import Reals

EventFunction = Callable[[float, Reals], float]

TOLERANCES = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-16, "max_step": 2e-4}
PUSH = np.array([-1.0, 1.0, 0.0, 0.0])
"""How the force of the bridge acts on motor, cutter, housing and event function."""


@dataclass(frozen=True)
class Friction:
    """Coulomb and viscous friction against row . q; they may be zero."""

    row: tuple[float, float, float, float]
    force: float
    damping: float = 0.0


@dataclass(frozen=True)
class PeerTrimmer:
    """What moves; without a drive the pin follows q4 - q2; without a gap the pin is rigid."""

    parameters: TrimmerParameters
    velocity_too: bool
    drive: tuple[float, float] | None = None
    gap: float | None = None
    tau: float = 0.0
    frictions: tuple[Friction, ...] = ()

    def matrices(self) -> tuple[Reals, Reals, Reals]:
        """Return the masses, C and K; the friction's viscous part is in C."""
        p = self.parameters
        springs = [((1, 0, 0, 0), p.k1), ((1, -1, 0, 0), p.k2), ((0, 0, 1, 0), p.k3), ((0, 0, 1, -1), p.k4)]
        dampers = [((1, 0, 0, 0), p.c1), ((1, -1, 0, 0), p.c2), ((0, 0, 1, 0), p.c3), ((0, 0, 1, -1), p.c4)]
        springs.append(((0, 1, -1, 0), p.k5))
        dampers += [(each.row, each.damping) for each in self.frictions]
        K, C = (sum(value * np.outer(row, row) for row, value in pairs) for pairs in (springs, dampers))
        return np.array([p.m1, p.m2, p.m3, p.m4]), C, K


@dataclass
class Course:
    """A motion under way: time, q with q' and the load with its rate, side of contact, signs of sliding."""

    trimmer: PeerTrimmer
    z: Reals
    time: float = 0.0
    side: int = 0
    signs: list[int] = field(default_factory=list)
    events: list[float] = field(default_factory=list)
    pieces: list[tuple[float, float, Callable[[float], Reals]]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.matrices = self.trimmer.matrices()
        self.rows = np.array([each.row for each in self.trimmer.frictions]).reshape(-1, 4)
        self.side = 1 if self.trimmer.gap is None else 0
        frictions = self.trimmer.frictions
        rates = self.rows @ self.z[4:8]
        self.signs = [int(np.sign(r)) if each.force else 1 for r, each in zip(rates, frictions, strict=True)]
        self.settle([k for k, sign in enumerate(self.signs) if sign == 0])

    def pin(self, t: float, z: Reals) -> tuple[float, float]:
        """Return displacement and velocity of the pin."""
        if self.trimmer.drive is None:
            return z[3] - z[1], z[7] - z[5]
        amplitude, omega = self.trimmer.drive
        return amplitude * math.sin(omega * t), amplitude * omega * math.cos(omega * t)

    def bridge(self, t: float, z: Reals) -> tuple[float, float]:
        """Return displacement and velocity of the bridge."""
        pin, rate = self.pin(t, z)
        return (pin - self.side * (self.trimmer.gap or 0.0) / 2, rate) if self.side else (z[8], z[9])

    def forces(self, t: float, z: Reals) -> tuple[Reals, Reals]:
        """Return the accelerations of the bodies, and the forces that stuck frictions need (0 if sliding)."""
        masses, C, K = self.matrices
        p, (u, rate) = self.trimmer.parameters, self.bridge(t, z)
        force = (p.k2 * u + (p.c2 * rate if self.trimmer.velocity_too else 0.0)) * PUSH
        force = force - K @ z[:4] - C @ z[4:8]
        for sign, friction in zip(self.signs, self.trimmer.frictions, strict=True):
            force = force - sign * friction.force * np.array(friction.row)
        holding, stuck = np.zeros(len(self.signs)), np.array(self.signs, dtype=int) == 0
        if stuck.any():
            rows = self.rows[stuck]
            holding[stuck] = np.linalg.solve((rows / masses) @ rows.T, rows @ (force / masses))
        return (force - holding @ self.rows) / masses, holding

    def contact_force(self, t: float, z: Reals) -> float:
        """Return the force of the pin on the load, over M or D, on the side in contact."""
        rate = self.pin(t, z)[1]
        if self.trimmer.drive is None:
            accelerations = self.forces(t, z)[0]
            curvature = accelerations[3] - accelerations[1]
        else:
            curvature = -(self.trimmer.drive[1] ** 2) * self.pin(t, z)[0]
        tau = self.trimmer.tau
        return self.side * (curvature if math.isinf(tau) else tau * curvature + rate)

    def event_functions(self) -> list[tuple[str, int, EventFunction]]:
        """Return what can happen next: what, to which friction or on which side, and what falls to zero."""
        found: list[tuple[str, int, EventFunction]] = []
        gap = self.trimmer.gap
        if gap is not None and self.side:
            found.append(("separation", 0, self.contact_force))
        for side in (1, -1) if gap is not None and not self.side else ():
            found.append(
                ("impact", side, lambda t, z, side=side: gap / 2 - side * (self.pin(t, z)[0] - z[8]))
            )
        for k, (sign, friction) in enumerate(zip(self.signs, self.trimmer.frictions, strict=True)):
            if sign and friction.force:
                found.append(("stop", k, lambda t, z, k=k, sign=sign: sign * (self.rows[k] @ z[4:8])))
            for side in () if sign else (1, -1):
                limit = friction.force
                found.append(
                    (
                        *("slip", (k + 1) * side),
                        lambda t, z, k=k, side=side, limit=limit: limit - side * self.forces(t, z)[1][k],
                    )
                )
        return found

    def settle(self, open_choices: list[int]) -> None:
        """Choose the signs of these frictions, whose velocities are zero, so that all laws hold."""
        for trial in itertools.product((0, 1, -1), repeat=len(open_choices)):
            for k, sign in zip(open_choices, trial, strict=True):
                self.signs[k] = sign
            accelerations, holding = self.forces(self.time, self.z)
            if all(
                abs(holding[k]) <= self.trimmer.frictions[k].force
                if self.signs[k] == 0
                else self.signs[k] * (self.rows[k] @ accelerations) > 0
                for k in open_choices
            ):
                return
        raise AssertionError("no consistent state")

    def follow(self, end: float) -> Course:
        """Go on until a time."""
        tau = self.trimmer.tau

        def rates(t: float, z: Reals) -> Reals:
            load = (0.0, 0.0) if self.side else (z[9], -z[9] / tau if 0 < tau < math.inf else 0.0)
            return np.concatenate([z[4:8], self.forces(t, z)[0], load])

        while True:
            possible = self.event_functions()
            terminal = [_terminal(event_function) for _, _, event_function in possible]
            part = solve_ivp(
                rates, (self.time, end), self.z, events=terminal, dense_output=True, **TOLERANCES
            )
            self.pieces.append((self.time, part.t[-1], part.sol))
            self.time, self.z = float(part.t[-1]), part.y[:, -1]
            if part.status != 1:
                return self
            self.events.append(self.time)
            kind, where, _ = possible[next(k for k, times in enumerate(part.t_events) if times.size)]
            self.happen(kind, where)

    def happen(self, kind: str, where: int) -> None:
        """Change the modes at an event."""
        at_rest = [k for k, sign in enumerate(self.signs) if sign == 0]
        if kind == "impact":
            self.side = where
            self.settle(at_rest)
        if kind == "separation" or (kind == "impact" and self.contact_force(self.time, self.z) < 0):
            self.z[8], rate = self.bridge(self.time, self.z)
            self.z[9] = rate if self.trimmer.tau > 0 else 0.0
            self.side = 0
            self.settle(at_rest)
        elif kind == "stop":
            self.settle([*at_rest, where])
        elif kind == "slip":
            slipping = abs(where) - 1
            self.signs[slipping] = 1 if where > 0 else -1
            self.settle([k for k in at_rest if k != slipping])

    def displacements(self, time: float) -> Reals:
        """Return q at a time."""
        dense = next(dense for begin, end, dense in reversed(self.pieces) if begin <= time <= end)
        return np.asarray(dense(time))[:4]


def _terminal(event_function: EventFunction) -> EventFunction:
    def event(time: float, z: Reals) -> float:
        return event_function(time, z)

    event.terminal, event.direction = True, -1.0  # type: ignore[attr-defined]
    return event
