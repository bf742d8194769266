"""Points along -1/G of many trimmers, and how far N is from it at the same phase lag."""

from typing import NamedTuple

import numpy as np

from trimmer.arrays import Complexes, Flags, Reals
from trimmer.ensembles.gain_by_phase import gain_by_lag
from trimmer.ensembles.responses import Responses

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
    near = upper.imag[:, :, None] + np.abs(upper.real)[:, :, None] * ANGLES
    # Of a heavily damped pole some would be negative.
    near = np.maximum(near.reshape(len(poles), -1), between[:, :1])
    return np.sort(np.concatenate([between, near], axis=1), axis=1)


LOUD = 0.5  # Ln |1/G| up to which a point counts: |N| is at most 1, so above 0 there is no limit cycle


class FrequencyGrid(NamedTuple):
    """Points along omega, each field of shape (n, points)."""

    omega: Reals  # In units of the references, rising
    loud: Flags  # Whether |1/G| is small enough for a limit cycle to be near; the next two count only there
    lag: Reals  # Phase lag that N needs, rad, from -π to π
    # ln |N| - ln |1/G|, with N of that lag; 0 at a limit cycle. Beyond the lags that N can have, with N of
    # the nearest lag.
    h: Reals

    @property
    def inside(self) -> Flags:
        """Where N can have the lag."""
        return np.asarray(self.loud & (self.lag > 0) & (self.lag < 0.5 * np.pi))


def grid_at(responses: Responses, omega: Reals) -> FrequencyGrid:
    """Return the points at some frequencies, in units of the references, shape (n, points)."""
    inverse: Complexes = responses.inverse(omega)
    with np.errstate(all="ignore"):
        size = inverse.real**2
        size += inverse.imag**2
    loud = size < np.exp(2.0 * LOUD)
    lag, h = np.zeros(omega.shape), np.full(omega.shape, -LOUD)
    here = inverse[loud]
    lags = np.arctan2(-here.imag, here.real)
    lag[loud] = lags
    with np.errstate(divide="ignore"):
        h[loud] = gain_by_lag().log_gain_at(lags) - 0.5 * np.log(size[loud])
    return FrequencyGrid(omega, loud, lag, h)


def merged(first: FrequencyGrid, second: FrequencyGrid) -> FrequencyGrid:
    """Return the points of two grids in rising order."""
    both = [np.concatenate(pair, axis=1) for pair in zip(first, second, strict=True)]
    order = np.argsort(both[0], axis=1)
    return FrequencyGrid(*(np.take_along_axis(each, order, axis=1) for each in both))
