"""Signals that are sums of exponentials and a ramp, in 30 digits, and linear oscillators driven by them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import mpmath
import numpy as np
from mpmath import mpf

DIGITS = 30
ZERO, ONE = mpf(0), mpf(1)


@dataclass(frozen=True)
class Signal:
    """The real part of the sum of c exp(mu t), plus offset + slope t; ``terms`` has c for each mu."""

    terms: dict[mpmath.mpc, mpmath.mpc] = field(default_factory=dict)
    offset: mpf = ZERO
    slope: mpf = ZERO

    def __add__(self, other: Signal) -> Signal:
        terms = dict(self.terms)
        for mu, c in other.terms.items():
            terms[mu] = terms.get(mu, ZERO) + c
        return Signal(terms, self.offset + other.offset, self.slope + other.slope)

    def __sub__(self, other: Signal) -> Signal:
        return self + -1 * other

    def __rmul__(self, factor: mpf) -> Signal:
        terms = {mu: factor * c for mu, c in self.terms.items()}
        return Signal(terms, factor * self.offset, factor * self.slope)

    def derivative(self) -> Signal:
        return Signal({mu: mu * c for mu, c in self.terms.items()}, self.slope)

    def at(self, time: mpf) -> mpf:
        exponentials = mpmath.fsum(c * mpmath.exp(mu * time) for mu, c in self.terms.items())
        return mpmath.re(exponentials) + self.offset + self.slope * time

    @property
    def size(self) -> float:
        """The sum of the moduli at t = 0, which separates zero from rounding."""
        return float(mpmath.fsum(abs(c) for c in self.terms.values()) + abs(self.offset))

    def sampled(self, times: np.ndarray) -> np.ndarray:
        """Evaluate in double precision, which is enough to see a sign away from a zero."""
        total = float(self.offset) + float(self.slope) * times
        for mu, c in self.terms.items():
            total = total + (complex(c) * np.exp(complex(mu) * times)).real
        return total

    def falls_through_zero(self, low: mpf, high: mpf) -> mpf:
        """Find the zero between two times of different sign: Newton's method, kept inside by bisection."""
        rate, point = self.derivative(), (low + high) / 2
        for _ in range(200):
            value = self.at(point)
            low, high = (point, high) if value > 0 else (low, point)
            following = point - value / rate.at(point)
            if not low < following < high:
                following = (low + high) / 2
            if abs(following - point) < mpf(10) ** (4 - DIGITS) * high:
                return following
            point = following
        raise AssertionError("no convergence")


def combination(factors: Iterable[mpf], signals: list[Signal]) -> Signal:
    """Add signals with factors."""
    total = Signal()
    for factor, signal in zip(factors, signals, strict=True):
        if factor != 0:
            total = total + factor * signal
    return total


class Oscillator:
    """M z'' + C z' + K z = force, by its eigenvalues; K must not be singular."""

    def __init__(self, M: mpmath.matrix, C: mpmath.matrix, K: mpmath.matrix) -> None:
        self.M, self.C, self.K = M, C, K
        self.size = M.rows
        inverse = M**-1
        first_order = mpmath.zeros(2 * self.size)
        for i in range(self.size):
            first_order[i, self.size + i] = 1
        first_order[self.size :, : self.size] = -inverse * K
        first_order[self.size :, self.size :] = -inverse * C
        self.eigenvalues, self.vectors = mpmath.eig(first_order)
        self.coordinates = self.vectors**-1

    def motion(self, force: list[Signal], position: mpmath.matrix, rate: mpmath.matrix) -> list[Signal]:
        """Return z for a force and the values at t = 0."""
        n = self.size
        steady = self._steady(force)
        start = mpmath.matrix([*position, *rate])
        for i, signal in enumerate(steady):
            start[i] -= signal.at(ZERO)
            start[n + i] -= signal.derivative().at(ZERO)
        weights = self.coordinates * start
        return [
            steady[i] + Signal({self.eigenvalues[k]: self.vectors[i, k] * weights[k] for k in range(2 * n)})
            for i in range(n)
        ]

    def _steady(self, force: list[Signal]) -> list[Signal]:
        """Return the particular solution without eigenmodes."""
        slope = mpmath.lu_solve(self.K, mpmath.matrix([each.slope for each in force]))
        offset = mpmath.lu_solve(self.K, mpmath.matrix([each.offset for each in force]) - self.C * slope)
        solution = [Signal({}, offset[i], slope[i]) for i in range(self.size)]
        for mu in {mu for each in force for mu in each.terms}:
            amplitudes = mpmath.matrix([each.terms.get(mu, ZERO) for each in force])
            response = mpmath.lu_solve(self.M * mu**2 + self.C * mu + self.K, amplitudes)
            solution = [solution[i] + Signal({mu: response[i]}) for i in range(self.size)]
        return solution
