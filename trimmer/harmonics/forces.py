"""Coefficients of a force that is linear in a signal on some pieces of the period and zero elsewhere."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.harmonics.waveform import PeriodicWaveform


@dataclass(frozen=True, eq=False)
class Harmonics:
    """Coefficients of a force, N, (H + 1,), and their derivatives by those of the signal.

    They are those by the coefficients, and by their conjugates, (H + 1) x (H + 1).
    """

    coefficients: Complexes
    direct: Complexes
    conjugate: Complexes

    def __add__(self, other: Harmonics) -> Harmonics:
        return Harmonics(
            self.coefficients + other.coefficients,
            self.direct + other.direct,
            self.conjugate + other.conjugate,
        )


@dataclass(frozen=True, eq=False)
class Pieces:
    """Times, s, at which pieces begin and end, and which of two linear functions acts, 1 or -1: (pieces,)."""

    begin: Reals
    end: Reals
    sign: Reals


def piecewise(signal: PeriodicWaveform, factors: Complexes, constant: float, pieces: Pieces) -> Harmonics:
    """Integrate Re Σ factors_m c_m exp(i m omega t) - sign constant over pieces; factors are (H + 1,)."""
    count = len(factors)
    over = _exponentials(signal, pieces, np.ones(len(pieces.sign)))
    signed = _exponentials(signal, pieces, pieces.sign)
    rows, columns = np.ogrid[:count, :count]
    # The middle of the table is exponent 0.
    direct = over[2 * count + columns - rows] / signal.period
    conjugate = over[2 * count - columns - rows] / signal.period
    direct[0] *= 0.5
    conjugate[0] *= 0.5
    linear = factors * signal.coefficients
    offsets = 2.0 * signed[2 * count - np.arange(count)] / signal.period
    offsets[0] *= 0.5
    coefficients = direct @ linear + conjugate @ linear.conj() - constant * offsets
    coefficients[0] = coefficients[0].real
    return Harmonics(coefficients, direct * factors, conjugate * factors.conj())


def _exponentials(signal: PeriodicWaveform, pieces: Pieces, weights: Reals) -> Complexes:
    """Integrate exp(i p omega t) over weighted pieces for p = -2 (H + 1) ... 2 (H + 1)."""
    count = 2 * len(signal.coefficients)
    exponents = np.delete(np.arange(-count, count + 1), count)
    rates = 1j * signal.omega * exponents
    ends = np.exp(np.multiply.outer(rates, pieces.end)) - np.exp(np.multiply.outer(rates, pieces.begin))
    integrals = np.insert((ends @ weights) / rates, count, weights @ (pieces.end - pieces.begin))
    return np.asarray(integrals, dtype=np.complex128)


def with_moving_ends(
    harmonics: Harmonics, signal: PeriodicWaveform, times: Reals, amounts: Reals, weights: Complexes
) -> Harmonics:
    """Add what changes because the ends of pieces move, where the force jumps, at times, s, (jumps,).

    A rise of the weighted signal by 1 adds amounts, (jumps,), to the impulse; weights, (H + 1,), set the
    moments.
    """
    turns = np.exp(np.multiply.outer(times, signal.turning))
    added = (2.0 / signal.period) * (turns.conj().T * amounts) @ (0.5 * turns * weights)
    conjugate = (2.0 / signal.period) * (turns.conj().T * amounts) @ (0.5 * (turns * weights).conj())
    added[0] *= 0.5
    conjugate[0] *= 0.5
    return Harmonics(harmonics.coefficients, harmonics.direct + added, harmonics.conjugate + conjugate)
