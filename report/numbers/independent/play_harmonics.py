"""The open loop with a very small load: its output's harmonics from those of backlash and the response."""

from __future__ import annotations

import control
import numpy as np

from report.thesis import TURN
from trimmer import response_at
from trimmer.elements.friction_backlash import FrictionBacklash

HARMONICS = np.arange(3, 80, 2)
"""Orders that make up the ripple."""
PHASES = 2**13


def play_harmonic(
    system: control.StateSpace, gap: float, amplitude: float, omega: float, order: int
) -> complex:
    """Return a harmonic of the output, m, for a pin of this amplitude (m) and angular frequency (rad/s)."""
    element = FrictionBacklash(gap).describing_function(amplitude, harmonic=order)
    return complex(element) * complex(response_at(system, omega * order)) * amplitude


def play_ripple(system: control.StateSpace, gap: float, amplitude: float, omega: float) -> float:
    """Return half of peak to peak of the output's ``HARMONICS``, m."""
    waveform = FrictionBacklash(gap).waveform(TURN * np.arange(PHASES) / PHASES, amplitude)
    lines = np.fft.rfft(waveform)
    passed = np.zeros_like(lines)
    passed[HARMONICS] = lines[HARMONICS] * response_at(system, omega * HARMONICS)
    return float(np.ptp(np.fft.irfft(passed))) / 2
