"""Inertia-controlled backlash behind a drive, and Listing A.8's block in a loop (section 5.2.2, figure 5.14).

The block is the load of inertia-controlled backlash for one amplitude, frequency and phase of its input,
written as pieces in time: in flight its output does not depend on the input at all. In a loop it makes a
linear system whose coefficients change with the drive's period, so its free motion has Floquet multipliers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import control
import numpy as np
from scipy.linalg import expm

from report.numbers.record import Record
from trimmer.arrays import Complexes, Reals
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.motion.loops import Drive, OpenLoop
from trimmer.motion.simulation import simulate

GAP, AMPLITUDE, OFFSET = 0.0004, 0.0015, 0.0049
"""Lines 2, 3 and 12 of Listing A.8, m."""
FREQUENCY, CONTACT = 100.0, 0.00190662
"""Lines 5 and 8: Hz, s."""
RECORD = Record(0.1, 2_001)
"""A record from rest with the length of section 5.2.1, ten periods."""
SETTLING = 0.6
"""Time after which the open loop repeats, s."""
SLACK = 1e-12
"""Rounding of an instant, s."""
_PHASES = 2048


@dataclass(frozen=True)
class _Piece:
    """A stretch of the period: its end (s), and output = gain * input + slope * t + constant."""

    end: float
    gain: float
    slope: float
    constant: float


@dataclass(frozen=True, eq=False)
class TimedBlockNumbers:
    """A reference or drive of 100 Hz and 1.5 mm, from rest.

    Attributes:
        times: s, over ``RECORD`` with both ends.
        block_in_loop: y of the loop with Listing A.8's block, e = r - y, m.
        multipliers: Its Floquet multipliers over a period.
        open_loop: y of the open loop with inertia-controlled backlash, m.
        harmonics: Amplitude of the latter at 0, 1, 2 ... times the drive's frequency once it repeats, m.
        repeat: Largest |y(t + T) - y(t)| of it then, over the largest |y|.
    """

    times: Reals
    block_in_loop: Reals
    multipliers: Complexes
    open_loop: Reals
    harmonics: Reals
    repeat: float

    @property
    def exponents(self) -> Complexes:
        """Floquet exponents, rad/s, their imaginary part up to multiples of the drive's frequency."""
        return np.asarray(np.log(self.multipliers) * FREQUENCY)


def solve_timed_block(system: control.StateSpace) -> TimedBlockNumbers:
    """Follow both; ``system`` is the thesis's G."""
    times = np.linspace(0, RECORD.duration, RECORD.samples)
    output, multipliers = _with_block(system, times)
    loop = OpenLoop(system, InertiaBacklash(GAP), Drive(AMPLITUDE, 2 * math.pi * FREQUENCY))
    motion = simulate(loop, SETTLING)
    before, after = (
        motion.output(SETTLING + (np.arange(_PHASES) / _PHASES - back) / FREQUENCY) for back in (2, 1)
    )
    harmonics = np.abs(np.fft.rfft(after)) * 2 / _PHASES
    harmonics[0] /= 2
    return TimedBlockNumbers(
        times=times,
        block_in_loop=output,
        multipliers=multipliers,
        open_loop=motion.output(times),
        harmonics=harmonics,
        repeat=float(np.abs(after - before).max() / np.abs(after).max()),
    )


def _with_block(system: control.StateSpace, times: Reals) -> tuple[Reals, Complexes]:
    """Return y of the loop with the block, by the matrix exponential piece by piece, and its multipliers."""
    pieces = _pieces()
    matrices = [_matrix(system, piece) for piece in pieces]
    output, flow = np.zeros(times.size), np.eye(system.nstates)
    state = np.zeros(matrices[0].shape[0])
    state[-3:-1] = 1.0  # cosine of the reference, and one
    for number in range(round(RECORD.duration * FREQUENCY)):
        begin = number / FREQUENCY
        state[-1] = 0.0  # time since the period began
        for piece, matrix in zip(pieces, matrices, strict=True):
            end = number / FREQUENCY + piece.end
            chosen = np.flatnonzero((times >= begin - SLACK) & (times < end - SLACK))
            output[chosen] = _along(matrix, state, times[chosen] - begin, system.C[0])
            step = expm(matrix * (end - begin))
            state = step @ state
            if number == 0:
                flow = step[: system.nstates, : system.nstates] @ flow
            begin = end
    output[-1] = system.C[0] @ state[: system.nstates]
    return output, np.linalg.eigvals(flow).astype(complex)


def _pieces() -> tuple[_Piece, ...]:
    """Return lines 10 to 13 of the listing."""
    half, speed = 1 / (2 * FREQUENCY), 2 * math.pi * FREQUENCY * AMPLITUDE
    return (
        _Piece(CONTACT, 0.0, speed, -GAP / 2),
        _Piece(half, 1.0, 0.0, GAP / 2),
        _Piece(half + CONTACT, 0.0, -speed, OFFSET),
        _Piece(2 * half, 1.0, 0.0, -GAP / 2),
    )


def _matrix(system: control.StateSpace, piece: _Piece) -> Reals:
    """Return the flow of plant, sine and cosine of the reference, one, and time since the period began."""
    size = system.nstates
    matrix = np.zeros((size + 4, size + 4))
    column = system.B[:, 0]
    matrix[:size, :size] = system.A - piece.gain * np.outer(column, system.C[0])
    matrix[:size, size] = piece.gain * AMPLITUDE * column
    matrix[:size, size + 2] = piece.constant * column
    matrix[:size, size + 3] = piece.slope * column
    omega = 2 * math.pi * FREQUENCY
    matrix[size, size + 1], matrix[size + 1, size] = omega, -omega
    matrix[size + 3, size + 2] = 1.0
    return matrix


def _along(matrix: Reals, state: Reals, elapsed: Reals, row: Reals) -> Reals:
    """Return row x at equally spaced times after a state."""
    step = expm(matrix * RECORD.duration / (RECORD.samples - 1))
    current = expm(matrix * elapsed[0]) @ state
    values = np.empty(elapsed.size)
    for each in range(elapsed.size):
        values[each] = row @ current[: row.size]
        current = step @ current
    return values
