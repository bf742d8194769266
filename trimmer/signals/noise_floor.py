"""The noise below the lines of a record, as power over frequency."""

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals

_RATIO = 1.3  # The median is taken from f / 1.3 to 1.3 f, so that a floor that rises towards 0 Hz is followed
_FEWEST = 12  # Bins on either side from which it is taken at least
_PLACES = 160
_HANN_BANDWIDTH = 1.5


@dataclass(frozen=True, eq=False)
class Powers:
    """Variance of a record in each bin of its spectrum with a Hann window."""

    frequency: Reals  # Frequencies, Hz, shape (m,), from that on which is told from the mean
    total: Reals  # Variance in each bin, in the square of the signal's unit, shape (m,)
    floor: Reals  # The part of it that is noise, or anything without lines


def powers(values: Reals, rate: float) -> Powers:
    """Return the variance of a record, (n,), n >= 16, over frequency, and its floor; the rate is in Hz.

    Noise has exponentially distributed powers, with the median ln 2 times the mean; a few lines among the
    bins hardly move the median.
    """
    from scipy.signal import detrend
    from scipy.signal.windows import hann

    weights = hann(values.size, sym=False)
    lines = np.fft.rfft(detrend(values) * weights)
    total = 2.0 * np.abs(lines) ** 2 / float(weights.sum()) ** 2 / _HANN_BANDWIDTH
    total[-1] *= 0.5 if values.size % 2 == 0 else 1.0
    frequency = np.asarray(np.arange(total.size) * (rate / values.size))
    return Powers(frequency[2:], total[2:], _floor(total)[2:])


def _floor(total: Reals) -> Reals:
    bins = np.arange(total.size)
    places = np.unique(np.geomspace(2, max(2, total.size - 1), _PLACES).astype(int))
    floor = np.empty(places.size)
    for row, place in enumerate(places.tolist()):
        low = max(2, min(int(place / _RATIO), place - _FEWEST))
        high = max(math.ceil(place * _RATIO), place + _FEWEST)
        floor[row] = np.median(total[low : high + 1]) / math.log(2.0)
    tiny = np.finfo(float).tiny
    logs = np.interp(np.log(np.maximum(bins, 1)), np.log(places), np.log(np.maximum(floor, tiny)))
    return np.asarray(np.exp(logs))
