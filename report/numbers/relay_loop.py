"""The thesis's loop with an ideal relay, and with friction (section 5.2.4).

Relay or friction force, and impulse, times one factor give the motion times that factor: all depends on
impulse over force. The model has a relay of one.
"""

from dataclasses import dataclass

import control
import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

from report.numbers.time_stepping import last_turn_in_steps, linear_step
from trimmer import ClosedLoop, CoulombFriction, Relay, ViscousFriction, simulate
from trimmer.arrays import Reals
from trimmer.loops import LoopMotion

IMPULSES = (1e-6, 1e-3, 1.0)  # Impulses over the force of the relay or of friction, s
EVENTS = 3_000  # Switchings after which a run with a relay is ended
DURATION = 0.5  # Length of the runs with friction, s
VISCOUS = 0.1  # Viscous part of figure 5.20, which does not scale with the force
HALF_PERIODS = np.geomspace(1e-8, 1.0, 20_001)
"""Half periods at which the exact condition for a periodic motion is evaluated, s."""
STEP = 1e-5  # Step of a simulation that looks at the relay's input once a step, s
RECORD = 0.06  # Length of that simulation, s
_SHARES = np.linspace(0, 1, 33)


@dataclass(frozen=True, eq=False)
class RelayRun:
    """The loop with a relay of one after an impulse."""

    impulse: float  # Over the level, s
    times: Reals  # Instants of switching, s
    swings: Reals  # Largest |y| between one switching and the next, over the level
    growth: float  # Rate at which the frequency grows over the last third of the run, 1/s

    @property
    def frequencies(self) -> Reals:
        """Frequency that belongs to each half swing, Hz."""
        return np.asarray(0.5 / np.diff(self.times))


@dataclass(frozen=True, eq=False)
class PeriodicCandidates:
    """Where a square wave of the relay would return with y zero at its jumps (exact, with all harmonics)."""

    frequencies: tuple[float, ...]  # Hz
    # For each, whether y then has the sign of the relay's output and so would not keep it up
    in_phase: tuple[bool, ...]


@dataclass(frozen=True, eq=False)
class FrictionRun:
    """The loop with friction and viscous friction on y' after an impulse."""

    impulse: float  # Over the force, s
    last_turn: float  # When y' was zero for the last time before it stuck for good, or crept on one way, s


@dataclass(frozen=True, eq=False)
class RelayNumbers:
    """What the loop does with a relay on y, and with friction on y'."""

    runs: tuple[RelayRun, ...]  # With a relay, one for each of ``IMPULSES``
    alone: PeriodicCandidates  # With a relay alone
    with_viscous: PeriodicCandidates  # With a relay and a gain of ``VISCOUS``, the block of figure 5.20 on y
    friction: tuple[FrictionRun, ...]  # The block of figure 5.20 on y', one run for each of ``IMPULSES``
    last_turn_in_steps: tuple[float, ...]  # What ``last_turn`` of these is in a second way, s
    damping: float  # How fast y' decays by itself at high frequency, -C A^2 B / (C A B), 1/s
    # Frequency (Hz) and amplitude over the level that a relay looked at once a step keeps up
    sampled: tuple[float, float]


def solve_relay(system: control.StateSpace) -> RelayNumbers:
    """Simulate the runs and evaluate the exact condition; ``system`` is the thesis's G."""
    A, B, C = system.A, system.B, system.C
    acceleration = float((C @ A @ B).item())
    return RelayNumbers(
        runs=tuple(_run(system, impulse) for impulse in IMPULSES),
        alone=_candidates(A, B[:, 0], C[0]),
        with_viscous=_candidates(A - VISCOUS * B @ C, B[:, 0], C[0]),
        friction=tuple(_with_friction(system, impulse) for impulse in IMPULSES),
        last_turn_in_steps=tuple(last_turn_in_steps(system, impulse, VISCOUS) for impulse in IMPULSES),
        damping=-float((C @ A @ A @ B).item()) / acceleration,
        sampled=_sampled(system),
    )


def _run(system: control.StateSpace, impulse: float) -> RelayRun:
    motion = simulate(ClosedLoop(system, Relay(1.0)), DURATION, impulse=impulse, event_limit=EVENTS)
    times = motion.log.start[1:]
    swings = np.abs(motion.output(times[:-1, None] + np.diff(times)[:, None] * _SHARES)).max(axis=1)
    last = slice(2 * times.size // 3, None)
    middles, lengths = (times[:-1] + times[1:]) / 2, np.diff(times)
    decay = np.polyfit(middles[last], np.log(lengths[last]), 1)[0]
    return RelayRun(impulse, times, np.asarray(swings), -float(decay))


def friction_motion(system: control.StateSpace, impulse: float) -> LoopMotion:
    """Return the loop with the block of figure 5.20 on y' after an impulse over force, s."""
    law = CoulombFriction(1.0) + ViscousFriction(VISCOUS)
    return simulate(ClosedLoop(system, law), DURATION, impulse=impulse)


def _with_friction(system: control.StateSpace, impulse: float) -> FrictionRun:
    """Return when the loop turns for the last time: each zero of y' is an event, where it turns or sticks."""
    return FrictionRun(impulse, float(friction_motion(system, impulse).log.start[-1]))


def output_at_jump(A: Reals, B: Reals, C: Reals, half_periods: Reals) -> Reals:
    """Return the output -C tanh(A T/4) A^-1 B at the jump up of a square wave of one (Tsypkin 1984)."""
    poles, vectors = np.linalg.eig(A)
    residues = (C @ vectors) * np.linalg.solve(vectors, B.astype(complex))
    terms = residues / poles * np.tanh(np.multiply.outer(half_periods, poles) / 2)
    return np.asarray(-terms.sum(axis=1).real)


def _candidates(A: Reals, B: Reals, C: Reals) -> PeriodicCandidates:
    def at_one(half_period: float) -> float:
        return float(output_at_jump(A, B, C, np.array([half_period]))[0])

    at_jump = output_at_jump(A, B, C, HALF_PERIODS)
    found = [
        float(brentq(at_one, HALF_PERIODS[k], HALF_PERIODS[k + 1]))
        for k in np.flatnonzero(at_jump[:-1] * at_jump[1:] < 0)
    ]
    return PeriodicCandidates(
        frequencies=tuple(0.5 / half_period for half_period in found),
        in_phase=tuple(_in_the_middle(A, B, C, half_period) > 0 for half_period in found),
    )


def _in_the_middle(A: Reals, B: Reals, C: Reals, half_period: float) -> float:
    """Return y in the middle of the half period in which the relay's output is one."""
    identity, steady = np.eye(B.size), -np.linalg.solve(A, B)
    whole, half = expm(A * half_period), expm(A * half_period / 2)
    start = -np.linalg.solve(identity + whole, (identity - whole) @ steady)
    return float(C @ (half @ start + (identity - half) @ steady))


def _sampled(system: control.StateSpace) -> tuple[float, float]:
    """Follow the loop whose relay is set once a step from y at its begin."""
    (through, column, _), row = linear_step(system.A, system.B[:, 0], STEP), system.C[0]
    state, output = IMPULSES[0] * system.B[:, 0], np.empty(round(RECORD / STEP))
    for each in range(output.size):
        output[each] = row @ state
        state = through @ state - column * np.sign(output[each])
    last = output[output.size // 2 :]
    turns = np.flatnonzero(last[:-1] * last[1:] < 0)
    return float((turns.size - 1) / (2 * (turns[-1] - turns[0]) * STEP)), float(np.ptp(last)) / 2
