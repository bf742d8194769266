"""Harmonic balance of friction-controlled backlash, solved by hand with Newton's method."""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

FIRST_AMPLITUDE = 10.0  # Amplitude over gap of the first guess
FIRST_FREQUENCY = 740.0  # Frequency of the first guess, Hz: a little above the resonance of the cutter
SETTLED = 1e-12
MOST_ITERATIONS = 20


@dataclass(frozen=True)
class Iteration:
    """One state of Newton's method."""

    angle: float  # Angle of contact ℓ, rad
    omega: float  # Angular frequency, rad/s
    gain: complex  # N(ℓ), a number
    inverse: complex  # 1/G(jω), a number

    @property
    def amplitude(self) -> float:
        """Amplitude over gap."""
        return 1 / (1 + math.cos(self.angle))

    @property
    def frequency(self) -> float:
        """Frequency, Hz."""
        return self.omega / (2 * math.pi)

    @property
    def residual(self) -> complex:
        """N + 1/G, which has to vanish."""
        return self.gain + self.inverse


def newton_by_hand(numerator: Sequence[float], denominator: Sequence[float]) -> tuple[Iteration, ...]:
    """Solve N(ℓ) + 1/G(jω) = 0 from the first guess, with the steps that ``derivations.loop`` derives.

    Coefficients of G have the highest power first.

    Returns:
        The first guess and every iteration, the last one with a residual below ``SETTLED``.

    Raises:
        ArithmeticError: if the method does not settle.
    """
    states = tuple(_states(numerator, denominator))
    if abs(states[-1].residual) > SETTLED:
        raise ArithmeticError(f"Newton's method leaves a residual of {abs(states[-1].residual):.1e}")
    return states


def _states(numerator: Sequence[float], denominator: Sequence[float]) -> Iterator[Iteration]:
    angle, omega = math.acos(1 / FIRST_AMPLITUDE - 1), 2 * math.pi * FIRST_FREQUENCY
    for _ in range(MOST_ITERATIONS):
        (below, below_slope), (above, above_slope) = (
            _with_slope(each, 1j * omega) for each in (numerator, denominator)
        )
        inverse = above / below
        gain = (angle - math.sin(angle) * math.cos(angle) - 1j * math.sin(angle) ** 2) / math.pi
        state = Iteration(angle, omega, gain, inverse)
        yield state
        if abs(state.residual) <= SETTLED:
            return
        by_omega = 1j * (above_slope - inverse * below_slope) / below
        by_angle = -2j / math.pi * math.sin(angle) * cmath.exp(1j * angle)
        angle -= _cross(by_omega, state.residual) / _cross(by_omega, by_angle)
        omega -= _cross(by_angle, state.residual) / _cross(by_angle, by_omega)


def _with_slope(coefficients: Sequence[float], place: complex) -> tuple[complex, complex]:
    """Return a polynomial and its derivative, by Horner's rule."""
    value, slope = 0j, 0j
    for coefficient in coefficients:
        slope = slope * place + value
        value = value * place + coefficient
    return value, slope


def _cross(first: complex, second: complex) -> float:
    return (first.conjugate() * second).imag
