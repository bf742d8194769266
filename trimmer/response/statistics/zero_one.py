"""The 0-1 test for chaos, which gives 0 for order and 1 for chaos.

A series drives a point in the plane, which stays in bounds if the series is quasi-periodic and wanders off
like a random walk if it is chaotic (Gottwald and Melbourne, SIAM J. Appl. Dyn. Syst. 8, 2009).
"""

import numpy as np

from trimmer.arrays import Reals

SEED = 0  # Of the angles, which are the same for each series
ANGLES = 101  # Number of angles by which the plane turns at each step, of which the median counts


def growth_of_walk(series: Reals) -> float:
    """Return how closely the mean square of the walk follows the time: near 0 or near 1; 0 at rest."""
    count = len(series)
    longest = count // 10
    apart = series - series.mean()
    if not apart.any():
        return 0.0
    angles = np.random.default_rng(SEED).uniform(np.pi / 5, 4 * np.pi / 5, ANGLES)
    steps = np.arange(1, count + 1)
    walks = np.cumsum(np.exp(1j * angles[:, None] * steps) * apart, axis=1)
    lags = np.arange(1, longest + 1)
    squares = np.array(
        [
            (abs(walks[:, lag : count - longest + lag] - walks[:, : count - longest]) ** 2).mean(1)
            for lag in lags
        ]
    )
    return float(np.median([np.corrcoef(lags, column)[0, 1] for column in squares.T]))
