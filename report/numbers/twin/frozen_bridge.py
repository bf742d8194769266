"""The thesis's play in the driven trimmer, and what its bridge that stays where it was left would need.

The thesis puts play before a linear trimmer: the bridge follows the pin, or stays. What its spring then
carries is computed here, though the thesis asks nobody for it.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from report.numbers.driven_motion import friction_between_cutter_and_guard
from report.numbers.record import change, harmonics
from report.numbers.thesis import DRIVE_AMPLITUDE
from report.numbers.twin.mechanism import FREQUENCY
from trimmer import Drive, FrictionBacklash, TrimmerLoop, TrimmerParameters, simulate
from trimmer.arrays import Reals
from trimmer.thesis import TrimmerBody

PHASES: Final = 8192  # Samples of a drive period
PERIODS: Final = 66  # Drive periods of a run from rest: 0.6 s, fifteen time constants of the slowest mode
MOVING: Final = 1e-9
"""Share of the pin's largest change from sample to sample below which the bridge stands still."""


@dataclass(frozen=True, eq=False)
class FrozenBridge:
    """One settled period of the thesis's model, ``PHASES`` samples from where the pin passes 0 upwards."""

    gap: float  # Total clearance, m
    force: float  # Friction between cutter and guard, N
    stroke: Reals  # Displacement of the cutter relative to the guard, m
    bridge: Reals  # Displacement of the bridge relative to the motor, m
    tension: Reals  # Force of the bridge's spring on the cutter, N, its reaction on the motor
    standing: np.ndarray[tuple[int], np.dtype[np.bool_]]  # Where the bridge stands still
    # Where it follows the pin, and the pin would have to pull it
    pulled: np.ndarray[tuple[int], np.dtype[np.bool_]]
    motor_acceleration: float  # Root of the mean square, m/s²
    repeat: float  # Largest change of the stroke from the period before, over the largest stroke

    @property
    def peak_to_peak(self) -> float:
        """Of the stroke, m."""
        return float(np.ptp(self.stroke))

    @property
    def harmonics(self) -> Reals:
        """Amplitudes of the stroke at 0, 1, 2 ... times the drive, m."""
        return harmonics(self.stroke)

    @property
    def share_standing(self) -> float:
        """Share of the period in which the bridge stands still."""
        return float(self.standing.mean())

    @property
    def share_on_the_way(self) -> float:
        """Share of the period that the pin needs to cross the gap twice, from where it turns round."""
        return float(np.arccos(1 - self.gap / DRIVE_AMPLITUDE) / np.pi)

    @property
    def share_pulled(self) -> float:
        """Share of the period in which the pin would have to pull the bridge."""
        return float(self.pulled.mean())

    @property
    def holding(self) -> float:
        """Largest force on the bridge while it stands still, N: what would have to hold it."""
        return float(abs(self.tension[self.standing]).max(initial=0.0))

    @property
    def largest_pull(self) -> float:
        """Largest force with which the pin would have to pull, N."""
        return float(abs(self.tension[self.pulled]).max(initial=0.0))


def frozen_bridge(gap: float, force: float) -> FrozenBridge:
    """Follow the thesis's driven model with a gap > 0, m, and a friction, N, until it has settled."""
    parameters = TrimmerParameters.thesis()
    drive = Drive(DRIVE_AMPLITUDE, frequency=FREQUENCY)
    loop = TrimmerLoop(
        parameters, FrictionBacklash(gap), drive, frictions=friction_between_cutter_and_guard(force)
    )
    motion = simulate(loop, (PERIODS + 0.01) * drive.period)
    times = drive.period * (PERIODS - 2 + np.arange(2 * PHASES) / PHASES)
    q1, q2, _, q4 = (motion.state(times)[body.index] for body in TrimmerBody)
    before, stroke = (q2 - q4).reshape(2, PHASES)
    q1, q2, bridge = (each[PHASES:] for each in (q1, q2, motion.element_output(times)))
    follows = _rate(q1 - q2, drive.omega) + _bridge_rate(bridge, drive, times[PHASES:])
    tension = parameters.k2 * (bridge + q1 - q2) + parameters.c2 * follows
    standing = _bridge_rate(bridge, drive, times[PHASES:]) == 0
    pushes = np.sign(np.cos(drive.omega * times[PHASES:])) * tension >= 0
    acceleration = -(parameters.k1 * q1 + parameters.c1 * _rate(q1, drive.omega) + tension) / parameters.m1
    return FrozenBridge(
        gap=gap,
        force=force,
        stroke=stroke,
        bridge=bridge,
        tension=tension,
        standing=standing,
        pulled=~standing & ~pushes,
        motor_acceleration=float(np.sqrt((acceleration**2).mean())),
        repeat=change(before, stroke),
    )


def _bridge_rate(bridge: Reals, drive: Drive, times: Reals) -> Reals:
    """Return the velocity of the bridge relative to the motor: the pin's where it moves with it, or 0."""
    moved = abs(np.roll(bridge, -1) - bridge)
    still = moved <= MOVING * moved.max()
    return np.where(still, 0.0, drive.amplitude * drive.omega * np.cos(drive.omega * times))


def _rate(period: Reals, omega: float) -> Reals:
    """Return the derivative of an evenly sampled period, by its Fourier series."""
    orders = np.arange(len(period) // 2 + 1)
    return np.asarray(np.fft.irfft(1j * omega * orders * np.fft.rfft(period), len(period)))
