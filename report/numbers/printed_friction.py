"""What friction with the sign of equation 3.2 does: the trimmer beside a pin that does not reach it.

In equation 3.2 as printed the friction between motor and cutter acts along their relative motion. With the
largest gap of section 3.3 the pin moves inside of its play, so nothing but friction can act on the trimmer.
"""

from dataclasses import dataclass, replace

import numpy as np

from report.numbers.driven_motion import FORCES, difference_energy, driven_loop
from report.numbers.thesis import LARGEST_GAP
from trimmer import CoulombFriction, TrimmerParameters, simulate
from trimmer.arrays import Reals
from trimmer.loops import BodyFriction
from trimmer.thesis import Displacement, TrimmerBody

CUTTER_RELATIVE_TO_MOTOR = Displacement(TrimmerBody.CUTTER, TrimmerBody.MOTOR)
START = 1e-4  # Displacement of the cutter at the start, m
DURATION = 0.6
LAST = 0.1
_POINTS = 20_001


@dataclass(frozen=True, eq=False)
class FedRun:
    """One run from a displaced cutter."""

    force: float  # F_c, N
    times: Reals  # Instants, s
    energy: Reals  # Kinetic and potential energy at them, J
    amplitude: float  # Half of peak to peak of q2 - q4 at the end, m
    frequency: float  # Largest line of its spectrum at the end, Hz, in bins of 10 Hz


@dataclass(frozen=True, eq=False)
class PrintedFriction:
    """Runs with the sign as printed, by rising force, and one with the opposite sign."""

    as_printed: tuple[FedRun, ...]
    opposite: FedRun


def solve_printed_friction(parameters: TrimmerParameters) -> PrintedFriction:
    """Simulate each force with the printed sign, and the least with the opposite one."""
    return PrintedFriction(
        tuple(_run(parameters, force, -1.0) for force in FORCES), _run(parameters, FORCES[0], 1.0)
    )


def _run(parameters: TrimmerParameters, force: float, factor: float) -> FedRun:
    friction = BodyFriction(CUTTER_RELATIVE_TO_MOTOR, factor * CoulombFriction(force))
    loop = replace(driven_loop(parameters, LARGEST_GAP, 0.0), frictions=(friction,))
    aside = np.zeros(2 * len(TrimmerBody))
    aside[TrimmerBody.CUTTER.index] = START
    motion = simulate(loop, DURATION, initial_state=aside)
    times = np.linspace(0, DURATION, 601)
    end = np.linspace(DURATION - LAST, DURATION, _POINTS)
    output = motion.output(end)
    lines = np.abs(np.fft.rfft(output[:-1]))[1:]
    return FedRun(
        force=force,
        times=times,
        energy=difference_energy(parameters, motion.state(times)),
        amplitude=float(np.ptp(output)) / 2,
        frequency=float(1 + np.argmax(lines)) / LAST,
    )
