"""Two loops followed in small fixed steps: a second way to motions that are elsewhere followed exactly.

Nothing of the event-driven simulation is used: between steps the linear part is advanced by SciPy's matrix
exponential, and the element acts at the steps alone.
"""

import math
from collections.abc import Sequence

import control
import numpy as np
from scipy.linalg import expm

from report.numbers.thesis import TURN
from trimmer import PeriodicOrbit
from trimmer.arrays import Reals

STEP = 2e-5  # Step of the loop with backlash, s
DURATION, RECORD = 0.2, 0.1  # Length of its motion, and of the end of it that is looked at, s
FINE_STEP, SHORT = 2e-8, 1e-4  # Step and length of the loop with friction, s


def last_turn_in_steps(system: control.StateSpace, impulse: float, viscous: float) -> float:
    """Return when y' turns or comes to rest for the last time after an impulse, s, under a friction of one.

    Steps are those of Moreau: the force of friction is found from the velocity at the end of a step, so that
    sticking needs no tolerance (Acary and Brogliato, 2008). The output of G has a velocity C A x; the impulse
    is over the force, s, and ``viscous`` the gain of the viscous part.
    """
    A, B, rate = system.A, system.B[:, 0], (system.C @ system.A)[0]
    through = np.linalg.inv(np.eye(system.nstates) - FINE_STEP * A)
    column = FINE_STEP * through @ B
    gain = float(rate @ column)
    state, before, last = impulse * B, float(rate @ B) * impulse, 0.0
    for number in range(1, round(SHORT / FINE_STEP) + 1):
        free = through @ state
        without = float(rate @ free)
        velocity = math.copysign(max(abs(without) - gain, 0.0), without) / (1 + viscous * gain)
        state = free - column * (without - velocity) / gain
        if before != 0 and velocity * before <= 0:
            last = number * FINE_STEP
        before = velocity
    return last


def lines_in_steps(
    orbit: PeriodicOrbit, gap: float, references: Sequence[Reals], frequencies: Sequence[float]
) -> Reals:
    """Return the amplitude of a line of y in the loop with friction-controlled backlash and a reference, m.

    The motions start on the limit cycle, without reference for a gap of one metre. Between steps the
    element's output is taken as straight. Of each motion r is given at each step, and the line, Hz.
    """
    system, rows = orbit.motion.loop.model, np.array(references)
    through, hold, ramp = linear_step(system.A, system.B[:, 0], STEP)
    state = np.repeat(gap * orbit.motion.state(0.0)[:, None], len(references), axis=1)
    output = np.full(len(references), gap * float(orbit.motion.element_output(0.0)))
    before, row = output, system.C[0]
    record = np.empty_like(rows)
    for number in range(rows.shape[1]):
        free = through @ state + np.outer(hold, output)
        ahead = _follow(output, rows[:, number] - row @ (free + np.outer(ramp, output - before)), gap)
        state = free + np.outer(ramp, ahead - output)
        record[:, number] = row @ state
        before, output = output, _follow(output, rows[:, number] - record[:, number], gap)
    return _lines(record[:, -round(RECORD / STEP) :], frequencies)


def steps(amplitude: float, frequency: float) -> Reals:
    """Return a sine at the end of each step."""
    times = STEP * np.arange(1, round(DURATION / STEP) + 1)
    return np.asarray(amplitude * np.sin(TURN * frequency * times))


def _follow(output: Reals, signal: Reals, gap: float) -> Reals:
    return np.minimum(np.maximum(output, signal - gap / 2), signal + gap / 2)


def linear_step(A: Reals, B: Reals, step: float) -> tuple[Reals, Reals, Reals]:
    """Return what a step makes of the state of x' = A x + B u, of a held u, and of one that rises to one.

    Exact, by the matrix exponential; shapes (n, n), (n,) and (n,) for n states and one input.
    """
    size = B.size
    whole = np.zeros((size + 2, size + 2))
    whole[:size, :size], whole[:size, size] = A * step, B * step
    whole[size, size + 1] = 1.0
    flow = expm(whole)
    return flow[:size, :size], flow[:size, size], flow[:size, size + 1]


def _lines(record: Reals, frequencies: Sequence[float]) -> Reals:
    times = STEP * np.arange(record.shape[1])
    window = np.hanning(record.shape[1])
    turning = np.exp(-1j * TURN * np.outer(frequencies, times))
    return np.asarray(2 * np.abs((record * window * turning).sum(axis=1)) / window.sum())
