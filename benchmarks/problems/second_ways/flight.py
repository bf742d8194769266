"""A motion of the second way: its pieces, and what is read of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from scipy.optimize import brentq


@dataclass(frozen=True)
class Flight:
    """Pieces as (solution, begin, end, modes), events as (time, element, mode, rate before)."""

    pieces: list = field(default_factory=list)
    events: list = field(default_factory=list)
    time: float = 0.0
    state: np.ndarray | None = None
    modes: tuple[int, ...] = ()

    def extremes(self, of: Callable[[float, np.ndarray], float]) -> tuple[float, float]:
        """Return smallest and largest value of a function of time and state."""
        found = []
        for solution, begin, end, _ in self.pieces:
            found += [of(begin, solution(begin)), of(end, solution(end))]
            times = np.linspace(begin, end, 400)
            values = np.array([of(t, solution(t)) for t in times])
            for sign in (1.0, -1.0):
                place = int(np.argmax(sign * values))
                if 0 < place < len(times) - 1:
                    found.append(
                        _peak(lambda t, s=solution: of(t, s(t)), times[place - 1], times[place + 1], sign)
                    )
        return min(found), max(found)

    @property
    def length(self) -> float:
        """Return how long the pieces take together."""
        return sum(end - begin for _, begin, end, _ in self.pieces)

    def between(self, begin: float, end: float) -> Flight:
        """Return the pieces between two times."""
        within = [piece for piece in self.pieces if piece[2] > begin and piece[1] < end]
        return Flight([(s, max(a, begin), min(b, end), modes) for s, a, b, modes in within])

    def passes(self, of: Callable[[np.ndarray], float], level: float) -> list[float]:
        """Return the times at which a function of the state passes a level."""
        found = []
        for solution, begin, end, _ in self.pieces:
            times = np.linspace(begin, end, 60)
            values = np.array([of(solution(t)) - level for t in times])
            for i in np.flatnonzero(np.sign(values[:-1]) * np.sign(values[1:]) < 0):
                a, b = times[i], times[i + 1]
                found.append(brentq(lambda t, s=solution: of(s(t)) - level, a, b, xtol=1e-15))
        return found

    def peak_to_peak(self, of: Callable[[float, np.ndarray], float]) -> float:
        """Return largest less smallest value."""
        low, high = self.extremes(of)
        return high - low

    def mean(self, of: Callable[[float, np.ndarray], float]) -> float:
        """Return the mean over the flight, by Gauss-Legendre between the solver's steps."""
        nodes, weights = np.polynomial.legendre.leggauss(6)
        total = 0.0
        for solution, begin, end, _ in self.pieces:
            steps = np.unique(np.clip(solution.ts, begin, end))
            for a, b in pairwise(steps):
                times = 0.5 * (a + b) + 0.5 * (b - a) * nodes
                total += (
                    0.5 * (b - a) * sum(w * of(t, solution(t)) for w, t in zip(weights, times, strict=True))
                )
        return total / self.length


def _peak(of: Callable[[float], float], a: float, b: float, sign: float) -> float:
    """Return the extreme value between two times: three parabolas, each on a tenth of the one before."""
    middle, half = 0.5 * (a + b), 0.5 * (b - a)
    for _ in range(4):
        low, mid, high = (of(middle + shift) for shift in (-half, 0.0, half))
        bend = low - 2.0 * mid + high
        if bend == 0.0:
            break
        middle += half * float(np.clip(0.5 * (low - high) / bend, -1.0, 1.0))
        half *= 0.1
    return sign * max(sign * of(middle), sign * of(middle - half), sign * of(middle + half))
