"""x'' + c x' + k x = constant + F(omega) cos(omega t) with undamped stops, in closed form.

It is independent of the package: one body, the two solutions of a linear oscillator joined at contact. The
number that is varied is omega times a unit.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy.optimize

from tests.trimmer.branches.maps import Given, Single
from trimmer.branches.period_maps.period_map import Phase

SAMPLES = 240
SIDES = {1: Phase.UPPER, -1: Phase.LOWER}


@dataclass(frozen=True)
class Piece:
    """The motion from a moment on while the phase is the same: shape of results (2,) + shape of times."""

    stiffness: float
    damping: float
    constant: float
    force: float
    by_omega: float
    omega: float
    begun: float
    state: np.ndarray

    @property
    def response(self) -> complex:
        return self.force / self.dynamic

    @property
    def dynamic(self) -> complex:
        return self.stiffness - self.omega**2 + 1j * self.damping * self.omega

    def forced(self, time: np.ndarray | float) -> np.ndarray:
        turn = self.response * np.exp(1j * self.omega * time)
        if self.stiffness:
            return np.array([turn.real + self.constant / self.stiffness, (1j * self.omega * turn).real])
        drift = self.constant / self.damping
        return np.array([turn.real + drift * time, (1j * self.omega * turn).real + drift])

    def forced_by_omega(self, time: float) -> np.ndarray:
        by_omega = (self.by_omega - self.response * (-2.0 * self.omega + 1j * self.damping)) / self.dynamic
        turn = (by_omega + 1j * time * self.response) * np.exp(1j * self.omega * time)
        rate = 1j * self.omega * turn + 1j * self.response * np.exp(1j * self.omega * time)
        return np.array([turn.real, rate.real])

    def flow(self, span: np.ndarray | float) -> np.ndarray:
        decay, system = 0.5 * self.damping, np.array([[0.0, 1.0], [-self.stiffness, -self.damping]])
        own = np.sqrt(complex(self.stiffness - decay**2))
        sine = span if own == 0 else (np.sin(own * span) / own).real
        even, odd = np.multiply.outer(np.eye(2), np.cos(own * span).real), system + decay * np.eye(2)
        flow: np.ndarray = np.exp(-decay * span) * (even + np.multiply.outer(odd, sine))
        return flow

    def at(self, time: np.ndarray | float) -> np.ndarray:
        rest = self.state - self.forced(self.begun)
        return self.forced(time) + np.einsum("ij...,j->i...", self.flow(time - self.begun), rest)

    def acceleration(self, time: float, state: np.ndarray) -> float:
        push = self.constant + self.force * np.cos(self.omega * time)
        return float(push - self.stiffness * state[0] - self.damping * state[1])


@dataclass(frozen=True)
class StopOscillator(Single):
    """An oscillator of unit mass.

    ``gaps`` gives the displacement at which the stop on either side, 1 or -1, is touched; that at ``gaps[1]``
    acts on larger displacements.
    """

    stiffness: float
    damping: float
    stop: float
    gaps: dict[int, float]
    force: Callable[[float], tuple[float, float]]
    constant: float = 0.0
    unit_of_length: float = 1.0
    unit_of_value: float = 1.0
    mirrored: bool = False
    size: int = 2

    def passage(self, value: float, state: np.ndarray) -> Given:
        omega = value / self.unit_of_value
        period = (1.0 if self.mirrored else 2.0) * np.pi / omega
        time, now = 0.0, state / self.unit_of_length
        side = next((each for each, gap in self.gaps.items() if each * (now[0] - gap) > 0.0), 0)
        by_state, by_omega = np.eye(2), np.zeros(2)
        made: Counter[tuple[str, Phase]] = Counter()
        largest, events = abs(now), 0
        while True:
            piece = self._piece(side, omega, time, now)
            ended, next_side, peak = self._end(piece, side, period)
            flow = piece.flow(ended - time)
            by_omega = piece.forced_by_omega(ended) + flow @ (by_omega - piece.forced_by_omega(time))
            by_state, now, time = flow @ by_state, piece.at(ended), ended
            largest = np.maximum(largest, peak)
            if next_side == side:
                break
            events += 1
            if next_side:
                made["stop", SIDES[next_side]] += 1
            side = next_side
        by_omega = by_omega - np.array([now[1], piece.acceleration(time, now)]) * period / omega
        sign, unit = -1.0 if self.mirrored else 1.0, self.unit_of_length
        rate = sign * unit * by_omega / self.unit_of_value
        return Given(sign * unit * now, sign * by_state, rate, unit * largest, made, events)

    def samples(self, omega: float, state: np.ndarray, count: int) -> np.ndarray:
        """Return the states at equal times over a period, (2, count)."""
        times = 2.0 * np.pi / omega * np.arange(count) / count
        time, now, states = 0.0, state, np.zeros((2, count))
        side = next((each for each, gap in self.gaps.items() if each * (now[0] - gap) > 0.0), 0)
        while True:
            piece = self._piece(side, omega, time, now)
            ended, next_side, _ = self._end(piece, side, 2.0 * np.pi / omega)
            inside = (time <= times) & (times <= ended)
            states[:, inside] = piece.at(times[inside])
            if next_side == side:
                return states
            time, now, side = ended, piece.at(ended), next_side

    def _piece(self, side: int, omega: float, time: float, state: np.ndarray) -> Piece:
        stop = self.stop if side else 0.0
        constant = self.constant + (self.stop * self.gaps[side] if side else 0.0)
        return Piece(self.stiffness + stop, self.damping, constant, *self.force(omega), omega, time, state)

    def _end(self, piece: Piece, side: int, period: float) -> tuple[float, int, np.ndarray]:
        """Return when the phase ends, the side that follows, and the largest magnitudes on the samples."""
        count = max(2, int(SAMPLES * (period - piece.begun) / period) + 2)
        times = np.linspace(piece.begun, period, count)
        states = piece.at(times)
        turns = [
            scipy.optimize.brentq(lambda at: piece.at(at)[1], times[k], times[k + 1], xtol=1e-16, rtol=1e-15)
            for k in np.flatnonzero(states[1, :-1] * states[1, 1:] < 0.0)
        ]
        moments = np.sort(np.append(times, turns))
        ends = [(period, side)]
        for gap_side, gap in self.gaps.items():
            if side not in (0, gap_side):
                continue
            beyond = gap_side * (piece.at(moments)[0] - gap)
            inside = beyond if side == 0 else -beyond
            later = np.flatnonzero((inside[1:] > 0.0) & (moments[1:] > piece.begun))
            if not len(later):
                continue
            k = int(later[0])
            if inside[k] > 0.0:  # rounding at the very beginning
                continue
            root = moments[k]
            if inside[k] < 0.0:
                root = scipy.optimize.brentq(
                    lambda at, gap=gap: piece.at(at)[0] - gap,
                    moments[k],
                    moments[k + 1],
                    xtol=1e-16,
                    rtol=1e-15,
                )
            ends.append((root, gap_side if side == 0 else 0))
        ended, following = min(ends)
        past = states[:, times <= ended]
        return ended, following, abs(past).max(axis=1)


def of_pyharm(unit_of_length: float = 1.0, unit_of_value: float = 1.0) -> StopOscillator:
    """The published example of pyHarm: k = 40, c = 0.1 sqrt(40), 100 cos, stop of 1000 at 10."""
    return StopOscillator(
        40.0, 0.1 * 40.0**0.5, 1000.0, {1: 10.0}, lambda _: (100.0, 0.0), 0.0, unit_of_length, unit_of_value
    )


def of_dead_zone() -> StopOscillator:
    """x'' + 0.1 x' + g(x) = 0.1 + 0.05 omega² cos(omega t), with g a dead zone of ±1 and slope 1."""
    return StopOscillator(
        0.0, 0.1, 1.0, {1: 1.0, -1: -1.0}, lambda omega: (0.05 * omega**2, 0.1 * omega), 0.1
    )
