"""Exact measures of a linear motion on a torus: waves of the drive, and vibrations that never decay."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.mechanism.drives import apart
from trimmer.motion.measures import HARMONICS
from trimmer.motion.signals import Signal

if TYPE_CHECKING:
    from collections.abc import Mapping

    from trimmer.arrays import Complexes, Reals
    from trimmer.response.without_events.linear_motion import LinearMotion

ANGLES = 4096  # Instants in a drive period at which the largest value of several waves is looked for


@dataclass(frozen=True, eq=False)
class LinearLines:
    """The lines of a linear motion without what decays."""

    motion: LinearMotion  # The motion

    @cached_property
    def _of_outputs(self) -> Mapping[str, tuple[Complexes, Reals]]:
        return {name: self._lines(each.signal) for name, each in self.motion.flow.outputs.items()}

    @cached_property
    def _mode(self) -> int:
        return self.motion.flow.modes.number(self.motion.instant.statuses)

    def _lines(self, signal: Signal) -> tuple[Complexes, Reals]:
        """Return the waves of a signal, complex, and the amplitudes of its free vibrations."""
        _, waves, free = self.motion.seen_by(signal(self._mode))
        alive = self.motion.alive & (self.motion.rates.imag > 0)
        near = [abs(self.motion.rates.imag - each) <= 1e-12 * each for each in self.motion.frequencies]
        return waves, np.array([2 * abs(free[alive & each].sum()) for each in near])

    @property
    def mean(self) -> Mapping[str, float]:
        """Mean of each output, m."""
        outputs = self.motion.flow.outputs
        return {name: self.motion.seen_by(each.signal(self._mode))[0] for name, each in outputs.items()}

    @property
    def advance(self) -> Mapping[str, float]:
        """Shift of each output over a drive period, or a second without a drive, m."""
        flow = self.motion.flow
        return {name: each.speed * (flow.period or 1.0) for name, each in flow.outputs.items()}

    @property
    def rms(self) -> Mapping[str, float]:
        """Root of the mean square of each output about its mean, m."""
        return {name: _rms(*lines) for name, lines in self._of_outputs.items()}

    @property
    def peak_to_peak(self) -> Mapping[str, float]:
        """Largest less smallest value of each output, m, which it comes near again and again."""
        return {name: self._swing(*lines) for name, lines in self._of_outputs.items()}

    def _swing(self, waves: Complexes, free: Reals) -> float:
        if len(waves) <= 1:
            return float(2 * abs(waves).sum() + 2 * free.sum())
        layout, orders = self.motion.flow.modes.system.layout, self.motion.orders
        turns = layout.recurrence
        if turns:
            angles = 2 * np.pi * np.arange(turns * ANGLES) / ANGLES
            return float(np.ptp((np.exp(1j * np.outer(angles, orders)) @ waves).real) + 2 * free.sum())
        # Drives that do not return together meet in all phases.
        swing, ratios = 2 * float(free.sum()), tuple(layout.drives.ratios.values())
        turn = 2 * np.pi * np.arange(ANGLES) / ANGLES
        for ratio, places in apart(tuple(orders), ratios):
            driven = np.exp(1j * np.outer(turn, np.rint(orders[places] / ratio))) @ waves[places]
            swing += float(np.ptp(driven.real))
        return swing

    @property
    def harmonics(self) -> Mapping[str, Reals]:
        """Amplitudes of each output at the harmonics of the drive, m."""
        found = {}
        for name, (waves, _) in self._of_outputs.items():
            found[name] = np.zeros(HARMONICS)
            for order, wave in zip(self.motion.orders.tolist(), waves, strict=True):
                if order <= HARMONICS and order == int(order):
                    found[name][int(order) - 1] = abs(wave)
        return found

    @property
    def rms_acceleration(self) -> Mapping[str, float]:
        """Root of the mean square of the acceleration of each body, m/s²."""
        accelerations = self.motion.flow.accelerations
        return {name: _rms(*self._lines(signal)) for name, signal in accelerations.items()}


def _rms(waves: Complexes, free: Reals) -> float:
    return float(np.sqrt(0.5 * (abs(waves) ** 2).sum() + 0.5 * (free**2).sum()))
