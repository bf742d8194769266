"""Numbers of a motion by brute force: rms, smallest and largest value."""

import numpy as np
from scipy.optimize import brentq

from tests.mechanisms.brute_force import BruteMotion

NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
TURNS = 9


def root_mean_square(motion: BruteMotion, row_of) -> float:
    """Rms of the row that ``row_of`` gives for each mode, by Gauss's rule on each step."""
    total = 0.0
    for piece in motion.pieces:
        half = (piece.end - piece.begin) / 2
        times = piece.begin + half * (1 + NODES)
        total += half * (row_of(piece.mode) @ piece.interpolated(times)) ** 2 @ WEIGHTS
    return float(np.sqrt(total / (motion.pieces[-1].end - motion.pieces[0].begin)))


def extremes(motion: BruteMotion, row_of) -> tuple[float, float]:
    """Smallest and largest value of the row that ``row_of`` gives for each mode, on both sides of events."""
    low, high = np.inf, -np.inf
    for piece in motion.pieces:
        row = row_of(piece.mode)
        rate = row @ motion.system.dynamics(piece.mode).rates
        times = np.linspace(piece.begin, piece.end, TURNS)
        values, rates = row @ piece.interpolated(times), rate @ piece.interpolated(times)
        found = list(values)
        for place in np.flatnonzero(rates[:-1] * rates[1:] < 0):

            def speed(time, piece=piece, rate=rate):
                return float(rate @ piece.interpolated(np.array([time]))[:, 0])

            ends = times[place], times[place + 1]
            if speed(ends[0]) * speed(ends[1]) >= 0:  # A rate that is rounding at an end, which is looked at.
                continue
            time = brentq(speed, *ends, xtol=1e-300, rtol=1e-14)
            found.append(float(row @ piece.interpolated(np.array([time]))[:, 0]))
        low, high = min(low, *found), max(high, *found)
    return low, high
