"""A unit mass on the spring y = x³, with amplitude one: its describing function and its exact frequency."""

from __future__ import annotations

import mpmath
import numpy as np

SAMPLES = 4096


def sampled_gain() -> float:
    """Return the describing function, sampled."""
    phases = 2 * np.pi * np.arange(SAMPLES) / SAMPLES
    return float(2 * np.mean(np.sin(phases) ** 4))


def exact_frequency() -> float:
    """Return the frequency of free vibration, rad/s: a quarter period is an integral over the position."""
    return float(mpmath.pi / (2 * mpmath.quad(lambda x: 1 / mpmath.sqrt((1 - x**4) / 2), [0, 1])))
