"""Trigonometric polynomials of odd harmonics, e(θ) = Im Σ c_n exp(j n θ) over n = 1, 3, 5 ..."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy.optimize

from trimmer.arrays import Complexes, Integers, Reals

POINTS = 721  # Points of an interval of phases between which a function changes its sign at most once


@dataclass(frozen=True, eq=False)
class OddPolynomial:
    """A trigonometric polynomial with coefficients c_1, c_3, c_5 ..., (n,), in the unit of the signal."""

    coefficients: Complexes

    @property
    def numbers(self) -> Integers:
        """Numbers of the harmonics, 1, 3, 5 ..., in the shape of the coefficients."""
        return 2 * np.arange(len(self.coefficients)) + 1

    def __call__(self, phase: Reals | float, derivative: int = 0) -> Reals:
        """Evaluate the polynomial, or a derivative by the phase, at phases, rad, in their shape."""
        factors = self.coefficients * (1j * self.numbers) ** derivative
        # Horner's rule takes one exponential for each phase, where a matrix takes one for each harmonic too.
        turned = np.exp(1j * np.asarray(phase))
        square, total = turned * turned, np.zeros_like(turned)
        for factor in factors[::-1]:
            total = total * square + factor
        values: Reals = (total * turned).imag
        return values

    def largest(self) -> float:
        """Return the largest value over a period, which is half of peak to peak, in its unit."""
        phases = np.linspace(0.0, 2.0 * np.pi, 2 * POINTS)
        best = float(phases[int(np.argmax(self(phases)))])
        width = float(phases[1])
        found = scipy.optimize.brentq(lambda phase: float(self(phase, 1)), best - width, best + width)
        return float(self(found))


def falls_through_zero(function: Callable[[Reals], Reals], begin: float, end: float) -> float | None:
    """Return where a function first falls through zero between two phases, rad; None if it does not."""
    phases = np.linspace(begin, end, POINTS)
    values = function(phases)
    falls = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
    if not falls.size:
        return None
    low, high = phases[falls[0]], phases[falls[0] + 1]
    return float(scipy.optimize.brentq(lambda phase: float(function(np.array(phase))), low, high, xtol=1e-15))


def sign_changes(given: OddPolynomial, derivative: int) -> list[float]:
    """Return the phases from 0 to below pi at which a polynomial, or a derivative of it, changes its sign."""
    phases = np.linspace(0.0, np.pi, POINTS)
    values = given(phases, derivative)
    if values[0] == 0:  # Just before phase 0 it has the sign that it has not just before pi.
        values[0] = -values[-2]
    values[-1] = -values[0]
    return _zeros(lambda phase: float(given(phase, derivative)), phases, values)


def passes(given: OddPolynomial, limit: float, begin: float = 0.0, span: float = np.pi) -> list[float]:
    """Return the phases from ``begin`` on, rad, at which a polynomial passes a limit, in its unit."""
    phases = np.linspace(begin, begin + span, POINTS)
    return _zeros(lambda phase: float(given(phase)) - limit, phases, given(phases) - limit)


def _zeros(at: Callable[[float], float], phases: Reals, values: Reals) -> list[float]:
    """Return where a function passes zero, from its values at phases."""

    def root(first: float, last: float) -> float:
        # A zero at one end may have another sign there when it is evaluated alone.
        if at(first) * at(last) >= 0:
            return first if abs(at(first)) < abs(at(last)) else last
        return float(scipy.optimize.brentq(at, first, last, xtol=1e-15))

    places = np.flatnonzero((values[:-1] > 0) != (values[1:] > 0))
    return [root(float(phases[k]), float(phases[k + 1])) for k in places]
