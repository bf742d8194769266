"""All zeros of a smooth signal on an interval, from a bound of its second derivative."""

import numpy as np

from trimmer.arrays import Reals
from trimmer.harmonics.waveform import PeriodicWaveform

FIRST_PIECES = 32
MOST_HALVINGS = 40
MOST_ITERATIONS = 60


def crossings(signal: PeriodicWaveform, begin: float, end: float) -> Reals:
    """Return the times, s, at which a signal changes its sign between begin and end, in their order.

    The interval is halved until the bound of the curvature shows that the signal keeps its sign or is
    monotone on each piece; only zeros where it touches and turns to rounding are left out.
    """
    edges = np.linspace(begin, end, FIRST_PIECES + 1)
    low, high = edges[:-1], edges[1:]
    found: list[Reals] = []
    for _ in range(MOST_HALVINGS):
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        values, slopes = signal.at(middle), abs(signal.slope(middle))
        without = abs(values) > slopes * half + 0.5 * signal.sharpness * half**2
        monotone = slopes > signal.sharpness * half
        found.append(_in_monotone(signal, low[~without & monotone], high[~without & monotone]))
        # What has no curvature and is neither is zero all the time: it never changes its sign.
        left = ~without & ~monotone & (signal.sharpness > 0.0)
        if not left.any():
            break
        low = np.concatenate([low[left], middle[left]])
        high = np.concatenate([middle[left], high[left]])
    return np.sort(np.concatenate(found))


def _in_monotone(signal: PeriodicWaveform, low: Reals, high: Reals) -> Reals:
    """Return the zeros on pieces on which the signal is monotone, by Newton's method kept in brackets."""
    first, last = signal.at(low), signal.at(high)
    crosses = (first < 0.0) != (last < 0.0)
    low, high, rising = low[crosses], high[crosses], last[crosses] > first[crosses]
    times = 0.5 * (low + high)
    for _ in range(MOST_ITERATIONS if len(times) else 0):
        values = signal.at(times)
        above = (values > 0.0) == rising
        low, high = np.where(above, low, times), np.where(above, times, high)
        newton = times - values / signal.slope(times)
        inside = (low <= newton) & (newton <= high)
        following = np.where(inside, newton, 0.5 * (low + high))
        if (abs(following - times) <= 4e-16 * abs(times) + 1e-18 * abs(high)).all():
            return following
        times = following
    return times
