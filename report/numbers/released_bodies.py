"""The loop with play and friction after all bodies were displaced alike (section 5.2.5, figure 5.23b).

The thesis starts its closed loop from initial conditions (section 3.3), which it does not give. A
displacement that all four bodies share is the simplest one.
"""

from dataclasses import dataclass

import numpy as np

from report.numbers.driven_motion import friction_between_cutter_and_guard
from report.numbers.equivalent_nonlinearity import FORCE
from report.numbers.record import Record, largest_peaks, line_amplitudes
from report.numbers.thesis import SMALL_GAP, TURN
from trimmer import FrictionBacklash, TrimmerLoop, TrimmerParameters, pin_model, simulate
from trimmer.arrays import Reals
from trimmer.linear import InputChannels
from trimmer.thesis import TrimmerBody

DISPLACEMENTS = (0.01, 0.1, 1.0)  # Displacement that all bodies share at the start, m
RECORD = Record(1.0, 100_001)  # Any number of samples from 98 267 to 105 714 gives the printed digits
PEAKS = 3


@dataclass(frozen=True, eq=False)
class ReleasedBodies:
    """One run."""

    displacement: float  # At the start, m
    left: float  # Half of peak to peak of the last tenth of the record, m
    times: Reals  # s
    output: Reals  # q2 - q4, m
    peaks: tuple[int, ...]  # Bins of the largest peaks of the spectrum, in rising order


@dataclass(frozen=True, eq=False)
class ReleasedBodiesNumbers:
    """The thesis's loop with the gap and the friction of figure 5.23."""

    runs: tuple[ReleasedBodies, ...]  # One for each of ``DISPLACEMENTS``
    # Damped natural frequencies of the loop without play and friction, y fed back as it is, Hz
    modes: tuple[float, ...]


def solve_released_bodies(parameters: TrimmerParameters) -> ReleasedBodiesNumbers:
    """Simulate the runs and find the natural modes."""
    system = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    poles = np.linalg.eigvals(system.A - system.B @ system.C)
    above = sorted(poles[poles.imag > 0], key=lambda pole: pole.imag)
    return ReleasedBodiesNumbers(
        runs=tuple(_run(parameters, displacement) for displacement in DISPLACEMENTS),
        modes=tuple(float(pole.imag) / TURN for pole in above),
    )


def _run(parameters: TrimmerParameters, displacement: float) -> ReleasedBodies:
    loop = TrimmerLoop(
        parameters,
        FrictionBacklash(SMALL_GAP),
        channels=InputChannels.DISPLACEMENT_ONLY,
        frictions=friction_between_cutter_and_guard(FORCE),
    )
    start = np.repeat([displacement, 0.0], len(TrimmerBody))
    motion = simulate(loop, RECORD.duration, initial_state=start)
    times = np.linspace(0, RECORD.duration, RECORD.samples)
    output = motion.output(times)
    return ReleasedBodies(
        displacement=displacement,
        left=float(np.ptp(output[-RECORD.samples // 10 :])) / 2,
        times=times,
        output=output,
        peaks=tuple(sorted(largest_peaks(line_amplitudes(output), PEAKS))),
    )
