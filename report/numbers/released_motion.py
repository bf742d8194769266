"""The closed loop with play and friction, released without drive: exact motions for chapter 3 and appendix E.

The parameters are those of Listing A.1. With friction (section 3.3) the pin acts by its displacement and its
velocity, as in equation 3.2; without it (appendix E) by its displacement alone, as in section 5.2.
"""

from dataclasses import dataclass

import numpy as np

from report.numbers.driven_motion import friction_between_cutter_and_guard
from report.numbers.record import padded_spectrum
from report.numbers.thesis import EXPERIMENT_GAP, LARGEST_GAP, SAMPLE_RATE
from trimmer import FrictionBacklash, TrimmerLoop, TrimmerParameters, simulate
from trimmer.arrays import Reals
from trimmer.linear import InputChannels
from trimmer.loops import LoopMotion
from trimmer.thesis import TrimmerBody

DURATION = 0.3  # Length of a run, s
LAST = 0.02  # Length at the end of a run over which amplitude and frequency are taken, s: 14 periods
FORCES_OF_FIGURE = (0.0025, 0.02, 0.25)  # Friction of figure 3.9, N
RISING_FORCES = (0.0, 0.25, 0.5, 0.75, 1.0, 1.2, 1.3)  # Friction with the gap of the experiment, N
INSIDE, OUTSIDE = 0.4, 4.0
"""Displacements of the cutter at the start, in gaps: less than half a gap, and near the limit cycle."""
SCALE = 10  # Factor on gap, friction and start between two motions that are to be alike
APPENDIX_GAPS = (3e-4, 4e-4, 5e-4, 6e-4)  # Gaps of figure E.1, m
NEAR_SECOND_MODE = (320.0, 420.0)  # Range in which the peak near 350 Hz is sought, Hz
_POINTS = 8_001


@dataclass(frozen=True, eq=False)
class ReleasedRun:
    """One run from a displaced cutter."""

    gap: float  # Total clearance, m
    force: float  # Friction between cutter and guard, N
    start: float  # Displacement of the cutter at the start, in gaps
    times: Reals  # Instants at ``SAMPLE_RATE``, s
    output: Reals  # q2 - q4, m
    amplitude: float  # Half of peak to peak at the end, m
    frequency: float  # Rising zero crossings per second at the end, Hz; 0 where there are fewer than two

    @property
    def goes_on(self) -> bool:
        """Whether it still crosses the gap at the end."""
        return self.amplitude > self.gap / 2


@dataclass(frozen=True, eq=False)
class ReleasedNumbers:
    """All runs of the closed loop."""

    figure: tuple[ReleasedRun, ...]  # Two gaps, three frictions, started inside of the gap and outside
    # The gap of the experiment, with friction from zero up, started outside
    by_force: tuple[ReleasedRun, ...]
    scaled: ReleasedRun  # The second of ``by_force`` with gap, friction and start times ``SCALE``
    appendix: tuple[ReleasedRun, ...]  # The four gaps of figure E.1, without friction

    def released(self, gap: float, force: float, start: float) -> ReleasedRun:
        """Return the run of the figure with a gap (m), a friction (N) and a start (gaps).

        Raises:
            StopIteration: if there is none.
        """
        return next(run for run in self.figure if (run.gap, run.force, run.start) == (gap, force, start))


def released_spectrum(run: ReleasedRun) -> tuple[Reals, Reals]:
    """Return frequencies (Hz) and amplitudes (m) of a run's spectrum, padded to a finer grid."""
    frequency, modulus = padded_spectrum(run.output)
    return frequency, 2 * modulus / run.output.size


def released_peak(run: ReleasedRun) -> float:
    """Return the frequency of the largest line near the second natural mode, Hz."""
    frequency, amplitude = _near_second_mode(run)
    return float(frequency[np.argmax(amplitude)])


def line_near_second_mode(run: ReleasedRun) -> float:
    """Return the amplitude of the largest line near the second natural mode, m."""
    return float(_near_second_mode(run)[1].max())


def _near_second_mode(run: ReleasedRun) -> tuple[Reals, Reals]:
    frequency, amplitude = released_spectrum(run)
    near = (frequency > NEAR_SECOND_MODE[0]) & (frequency < NEAR_SECOND_MODE[1])
    return frequency[near], amplitude[near]


def solve_released(parameters: TrimmerParameters) -> ReleasedNumbers:
    """Simulate the runs of figures 3.9 and E.1 and of section 3.3."""
    both, displacement_only = InputChannels.DISPLACEMENT_AND_VELOCITY, InputChannels.DISPLACEMENT_ONLY
    return ReleasedNumbers(
        figure=tuple(
            _run(parameters, both, gap, force, start)
            for gap in (EXPERIMENT_GAP, LARGEST_GAP)
            for force in FORCES_OF_FIGURE
            for start in (INSIDE, OUTSIDE)
        ),
        by_force=tuple(_run(parameters, both, EXPERIMENT_GAP, force, OUTSIDE) for force in RISING_FORCES),
        scaled=_run(parameters, both, SCALE * EXPERIMENT_GAP, SCALE * RISING_FORCES[1], OUTSIDE),
        appendix=tuple(_run(parameters, displacement_only, gap, 0.0, 2 * OUTSIDE) for gap in APPENDIX_GAPS),
    )


def _run(
    parameters: TrimmerParameters, channels: InputChannels, gap: float, force: float, start: float
) -> ReleasedRun:
    loop = TrimmerLoop(
        parameters,
        FrictionBacklash(gap),
        channels=channels,
        frictions=friction_between_cutter_and_guard(force),
    )
    aside = np.zeros(2 * len(TrimmerBody))
    aside[TrimmerBody.CUTTER.index] = start * gap
    motion = simulate(loop, DURATION, initial_state=aside)
    times = np.arange(int(DURATION * SAMPLE_RATE) + 1) / SAMPLE_RATE
    return ReleasedRun(gap, force, start, times, motion.output(np.minimum(times, DURATION)), *_end(motion))


def _end(motion: LoopMotion) -> tuple[float, float]:
    """Return half of peak to peak and the frequency at the end of a motion."""
    times = np.linspace(motion.duration - LAST, motion.duration, _POINTS)
    output = motion.output(times)
    rising = np.flatnonzero((output[:-1] <= 0) & (output[1:] > 0))
    amplitude = float(np.ptp(output)) / 2
    if rising.size < 2:
        return amplitude, 0.0
    before, after = output[rising], output[rising + 1]
    crossings = times[rising] - before / (after - before) * (times[1] - times[0])
    return amplitude, float((rising.size - 1) / (crossings[-1] - crossings[0]))
