"""Inertia-controlled backlash behind a drive, and Listing A.8's block in a loop (section 5.2.2, figure 5.14).

The block is the load of inertia-controlled backlash for one amplitude, frequency and phase of its input,
written as pieces in time: in flight its output does not depend on the input at all. In a loop it makes a
linear system whose coefficients change with the drive's period, so its free motion has Floquet multipliers.
"""

from dataclasses import dataclass

import control
import numpy as np
from scipy.linalg import expm

from report.numbers.record import Record, change, harmonics, largest_peaks, line_amplitudes
from report.numbers.thesis import (
    DRIVE_AMPLITUDE,
    DRIVE_FREQUENCY,
    DRIVE_OMEGA,
    LISTED_CONTACT,
    LISTED_OFFSET,
    TIMED_GAP,
)
from trimmer import Drive, InertiaBacklash, OpenLoop, simulate
from trimmer.arrays import Complexes, Reals

RECORD = Record(0.1, 2_001)  # A record from rest with the length of section 5.2.1, ten periods
SETTLING = 0.6  # Time after which the open loop repeats, s
MOST = 40  # Peaks among which the largest is sought that is no multiple of the drive's frequency
SLACK = 1e-12  # Rounding of an instant, s
_PHASES = 2048


@dataclass(frozen=True)
class _Piece:
    """A segment of the period: its end (s), and output = gain * input + slope * t + constant."""

    end: float
    gain: float
    slope: float
    constant: float


@dataclass(frozen=True, eq=False)
class TimedBlockNumbers:
    """A reference or drive of 100 Hz and 1.5 mm, from rest."""

    times: Reals  # s, over ``RECORD`` with both ends
    block_in_loop: Reals  # y of the loop with Listing A.8's block, e = r - y, m
    multipliers: Complexes  # Its Floquet multipliers over a period
    open_loop: Reals  # y of the open loop with inertia-controlled backlash, m
    harmonics: Reals  # Amplitude of the latter at 0, 1, 2 ... times the drive's frequency once it repeats, m.
    repeat: float  # Largest |y(t + T) - y(t)| of it then, over the largest |y|

    @property
    def largest_other_line(self) -> tuple[float, float]:
        """Frequency (Hz) and amplitude (m) of the largest line of the loop with the block.

        Multiples of the drive's frequency do not count.
        """
        amplitudes = line_amplitudes(self.block_in_loop)
        bins_of_drive = round(DRIVE_FREQUENCY * RECORD.duration)
        other = next(number for number in largest_peaks(amplitudes, MOST) if number % bins_of_drive)
        return RECORD.frequency(other), float(amplitudes[other])

    @property
    def exponents(self) -> Complexes:
        """Floquet exponents, rad/s, their imaginary part up to multiples of the drive's frequency."""
        return np.asarray(np.log(self.multipliers) * DRIVE_FREQUENCY)


def solve_timed_block(system: control.StateSpace) -> TimedBlockNumbers:
    """Follow both; ``system`` is the thesis's G."""
    times = np.linspace(0, RECORD.duration, RECORD.samples)
    output, multipliers = _with_block(system, times)
    loop = OpenLoop(system, InertiaBacklash(TIMED_GAP), Drive(DRIVE_AMPLITUDE, DRIVE_OMEGA))
    motion = simulate(loop, SETTLING)
    before, after = (
        motion.output(SETTLING + (np.arange(_PHASES) / _PHASES - back) / DRIVE_FREQUENCY) for back in (2, 1)
    )
    return TimedBlockNumbers(
        times=times,
        block_in_loop=output,
        multipliers=multipliers,
        open_loop=motion.output(times),
        harmonics=harmonics(after),
        repeat=change(before, after),
    )


def _with_block(system: control.StateSpace, times: Reals) -> tuple[Reals, Complexes]:
    """Return y of the loop with the block, by the matrix exponential piece by piece, and its multipliers."""
    pieces = _pieces()
    matrices = [_matrix(system, piece) for piece in pieces]
    output, flow = np.zeros(times.size), np.eye(system.nstates)
    state = np.zeros(matrices[0].shape[0])
    state[-3:-1] = 1.0  # cosine of the reference, and one
    for number in range(round(RECORD.duration * DRIVE_FREQUENCY)):
        begin = number / DRIVE_FREQUENCY
        state[-1] = 0.0  # time since the period began
        for piece, matrix in zip(pieces, matrices, strict=True):
            end = number / DRIVE_FREQUENCY + piece.end
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
    contact, offset = float(LISTED_CONTACT), float(LISTED_OFFSET)
    half, speed = 1 / (2 * DRIVE_FREQUENCY), DRIVE_OMEGA * DRIVE_AMPLITUDE
    return (
        _Piece(contact, 0.0, speed, -TIMED_GAP / 2),
        _Piece(half, 1.0, 0.0, TIMED_GAP / 2),
        _Piece(half + contact, 0.0, -speed, offset),
        _Piece(2 * half, 1.0, 0.0, -TIMED_GAP / 2),
    )


def _matrix(system: control.StateSpace, piece: _Piece) -> Reals:
    """Return the flow of plant, sine and cosine of the reference, one, and time since the period began."""
    size = system.nstates
    matrix = np.zeros((size + 4, size + 4))
    column = system.B[:, 0]
    matrix[:size, :size] = system.A - piece.gain * np.outer(column, system.C[0])
    matrix[:size, size] = piece.gain * DRIVE_AMPLITUDE * column
    matrix[:size, size + 2] = piece.constant * column
    matrix[:size, size + 3] = piece.slope * column
    matrix[size, size + 1], matrix[size + 1, size] = DRIVE_OMEGA, -DRIVE_OMEGA
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
