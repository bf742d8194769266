"""Where along omega many responses are looked at: close together where a pole turns the phase."""

import numpy as np

from trimmer.arrays import Complexes, Reals

ANGLES = np.tan(np.radians(np.linspace(-84.0, 84.0, 22)))
"""Distances from a pole in units of its damping: its own phase turns by 8 degrees between two of them."""
BETWEEN = 56  # Frequencies, evenly spaced on a logarithmic scale, beside those near poles
BEYOND = 20.0  # By which factor these go beyond the slowest and the fastest pole


def frequencies_near(poles: Complexes) -> Reals:
    """Return rising angular frequencies, (n, points), near poles in pairs, (n, count), in their unit."""
    sizes = np.abs(poles)
    lowest, highest = np.log(sizes.min(axis=1) / BEYOND), np.log(sizes.max(axis=1) * BEYOND)
    between = np.exp(lowest[:, None] + np.linspace(0.0, 1.0, BETWEEN) * (highest - lowest)[:, None])
    upper = np.take_along_axis(poles, np.argsort(-poles.imag, axis=1), axis=1)[:, : poles.shape[1] // 2]
    near = np.abs(upper.imag)[:, :, None] + np.abs(upper.real)[:, :, None] * ANGLES
    # Of a heavily damped pole some would be negative.
    near = np.maximum(near.reshape(len(poles), -1), between[:, :1])
    return np.sort(np.concatenate([between, near], axis=1), axis=1)
