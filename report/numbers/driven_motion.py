"""The trimmer driven by its pin, with play and friction: exact motions for the claims of chapter 3.

The parameters are those of Listing A.1; the experiment's are not published. The pin acts by its displacement
and its velocity, as in equation 3.2; friction is between cutter and guard unless stated otherwise.
"""

from dataclasses import dataclass

import numpy as np
from scipy.signal import find_peaks

from report.numbers.record import change, harmonics, padded_spectrum
from report.numbers.thesis import (
    DRIVE_AMPLITUDE,
    EXPERIMENT_GAP,
    LARGER_GAP,
    LARGEST_GAP,
    MEASURED_DRIVE_FREQUENCY,
    MEASURED_DRIVE_OMEGA,
    SAMPLE_RATE,
)
from trimmer import CoulombFriction, Drive, FrictionBacklash, TrimmerParameters, simulate
from trimmer.arrays import Reals
from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD, TrimmerBody
from trimmer.loops import LoopMotion
from trimmer.loops.trimmer_loop import BodyFriction, TrimmerLoop

DURATION = 0.6  # Length of a run from rest, s: fifteen time constants of the slowest mode
FORCES = (0.25, 0.5, 0.75)  # Friction of figures 3.6 to 3.8, N
PERIOD = 1 / MEASURED_DRIVE_FREQUENCY
PERIODS_LATER = int(DURATION / 2 / PERIOD)
HARMONICS = 20
STARTED_ASIDE = 1e-3
"""Displacement of the cutter at the start of the second of two motions with the same pin, m."""
LOWEST, HIGHEST = 150.0, 1000.0
"""Range of the peaks of what dies out after the start, Hz: beyond the drive itself."""
SMALLEST = 0.05  # Smallest of these peaks, over the largest
_PHASES = 4096


@dataclass(frozen=True, eq=False)
class DrivenRun:
    """One run from rest."""

    gap: float  # Total clearance, m; 0 without play
    force: float  # Friction, N
    times: Reals  # Instants at ``SAMPLE_RATE``, s
    pin: Reals  # Displacement of the pin relative to the motor, m
    cutter: Reals  # q2, m
    guard: Reals  # q4, m
    transient: Reals  # q2 - q4 in the first half of the run less its value a whole number of periods later, m
    harmonics: Reals  # Amplitude of q2 - q4 at 0, 1, 2 ... times the drive's frequency in the last period, m.
    repeat: float  # Largest |y(t + T) - y(t)| over the largest |y|, between the last two periods
    mirror: float  # Largest |y(t + T/2) + y(t)| over the largest |y|, in the last period

    @property
    def output(self) -> Reals:
        """Displacement of the cutter relative to the guard, q2 - q4, m."""
        return self.cutter - self.guard

    def last(self, samples: int) -> slice:
        """Return the place of the last samples of the run."""
        return slice(self.times.size - samples, self.times.size)


@dataclass(frozen=True, eq=False)
class DrivenNumbers:
    """All runs with a drive of ``MEASURED_DRIVE_FREQUENCY`` and 1.5 mm."""

    runs: tuple[DrivenRun, ...]  # Without play, and with the three gaps of section 3.3
    times: Reals  # Instants, s, of the two following rows
    # Energy of the difference of two motions with the same pin, over its value at the start: the gap of the
    # experiment, the largest friction of ``FORCES``
    apart: Reals

    def run(self, gap: float, force: float) -> DrivenRun:
        """Return the run with a gap (m) and a friction (N).

        Raises:
            StopIteration: if there is none.
        """
        return next(each for each in self.runs if (each.gap, each.force) == (gap, force))


def solve_driven(parameters: TrimmerParameters) -> DrivenNumbers:
    """Simulate the runs without play and with each gap, and two motions with the same pin."""
    settings = [
        *((0.0, force) for force in FORCES),
        *((gap, force) for gap in (EXPERIMENT_GAP, LARGER_GAP) for force in (0.0, *FORCES)),
        *((LARGEST_GAP, force) for force in FORCES),
    ]
    times, apart = _two_motions(parameters)
    return DrivenNumbers(tuple(_run(parameters, gap, force) for gap, force in settings), times, apart)


def driven_loop(parameters: TrimmerParameters, gap: float, force: float) -> TrimmerLoop:
    """Return the driven trimmer with play, or without if the gap is 0, and with friction, or without."""
    return TrimmerLoop(
        parameters,
        FrictionBacklash(gap) if gap else None,
        Drive(DRIVE_AMPLITUDE, MEASURED_DRIVE_OMEGA),
        frictions=friction_between_cutter_and_guard(force),
    )


def friction_between_cutter_and_guard(force: float) -> tuple[BodyFriction, ...]:
    """Return Coulomb friction between these two; none if the force (N) is 0."""
    return (BodyFriction(CUTTER_RELATIVE_TO_GUARD, CoulombFriction(force)),) if force else ()


def _run(parameters: TrimmerParameters, gap: float, force: float) -> DrivenRun:
    loop = driven_loop(parameters, gap, force)
    motion = simulate(loop, DURATION)
    times = np.arange(int(DURATION * SAMPLE_RATE) + 1) / SAMPLE_RATE
    state = motion.state(np.minimum(times, DURATION))
    amplitudes, repeat, mirror = _settled(motion)
    early = times[times < DURATION / 2]
    return DrivenRun(
        gap=gap,
        force=force,
        times=times,
        pin=DRIVE_AMPLITUDE * np.sin(MEASURED_DRIVE_OMEGA * times),
        cutter=state[TrimmerBody.CUTTER.index],
        guard=state[TrimmerBody.GUARD.index],
        transient=motion.output(early) - motion.output(early + PERIODS_LATER * PERIOD),
        harmonics=amplitudes,
        repeat=repeat,
        mirror=mirror,
    )


def _settled(motion: LoopMotion) -> tuple[Reals, float, float]:
    """Return harmonics of the last period, and its distance from the one before and its mirror image."""
    start = motion.duration - 2 * PERIOD
    first, second = motion.output(start + np.arange(2 * _PHASES) * PERIOD / _PHASES).reshape(2, _PHASES)
    mirrored = -np.roll(second, _PHASES // 2)
    return harmonics(second)[:HARMONICS], change(first, second), change(mirrored, second)


def _two_motions(parameters: TrimmerParameters) -> tuple[Reals, Reals]:
    """Return instants and the energy of the difference of a motion from rest and one from aside."""
    loop = driven_loop(parameters, EXPERIMENT_GAP, FORCES[-1])
    aside = np.zeros(2 * len(TrimmerBody))
    aside[TrimmerBody.CUTTER.index] = STARTED_ASIDE
    times = np.linspace(0, DURATION, 2001)
    rest, other = (simulate(loop, DURATION, initial_state=start).state(times) for start in (None, aside))
    energy = difference_energy(parameters, other - rest)
    return times, energy / energy[0]


def difference_energy(parameters: TrimmerParameters, state: Reals) -> Reals:
    """Return kinetic and potential energy of states (8, n) with the pin held still, J, shape (n,).

    The transformed velocities of ``pin_model`` differ from the velocities by a multiple of the pin's
    displacement, which two motions with the same pin share.
    """
    q1, q2, q3, q4 = state[: len(TrimmerBody)]
    values = parameters
    masses = np.array([values.m1, values.m2, values.m3, values.m4])
    kinetic = masses @ state[len(TrimmerBody) :] ** 2
    potential = values.k1 * q1**2 + values.k2 * (q2 - q1) ** 2 + values.k3 * q3**2
    potential = potential + values.k4 * (q4 - q3) ** 2 + values.k5 * (q2 - q3) ** 2
    return np.asarray((kinetic + potential) / 2)


def transient_spectrum(run: DrivenRun) -> tuple[Reals, Reals]:
    """Return frequencies (Hz) and the modulus of the spectrum of what dies out after the start (m s)."""
    frequency, modulus = padded_spectrum(run.transient)
    return frequency, modulus / SAMPLE_RATE


def transient_peaks(run: DrivenRun) -> tuple[float, ...]:
    """Return the frequencies of the peaks of that spectrum, rising, Hz."""
    frequency, modulus = transient_spectrum(run)
    inside = (frequency > LOWEST) & (frequency < HIGHEST)
    places, _ = find_peaks(np.where(inside, modulus, 0.0), height=SMALLEST * modulus[inside].max())
    return tuple(float(each) for each in frequency[places])
