"""Samples at unequal distances brought to equal ones by a cubic spline, and how far that can be trusted."""

import math

import numpy as np

from trimmer.arrays import Reals
from trimmer.signals.band import Band

SPLINE_ERROR = 0.01
"""Largest error of a line, relative to its amplitude, up to the frequency that counts as trusted."""

_BOUND = 5.0 / 384.0
"""Error of a cubic spline with exact end slopes over h^4 max|f''''|, on any mesh of largest step h (Hall and
Meyer, Journal of Approximation Theory 16, 1976). The ends here have no slopes, so it holds inside."""


def resampled(times: Reals, values: Reals, rate: float) -> Reals:
    """Evaluate the cubic spline through samples, (n,), n >= 4, at a rate, Hz, from the first time, s, on."""
    from scipy.interpolate import CubicSpline

    count = math.floor((times[-1] - times[0]) * rate * (1 + 1e-12)) + 1
    return np.asarray(CubicSpline(times, values)(times[0] + np.arange(count) / rate))


def trusted_band(times: Reals) -> Band:
    """Return the band in which the spline changes no line by more than ``SPLINE_ERROR``.

    A line at f has a fourth derivative of (2 pi f)^4 times its amplitude; the largest step decides.
    """
    longest = float(np.diff(times).max())
    highest = (SPLINE_ERROR / _BOUND) ** 0.25 / (2 * math.pi * longest)
    return Band(
        highest=highest,
        highest_reason=f"cubic spline over steps of up to {longest:.4g} s, lines exact to "
        f"{100 * SPLINE_ERROR:g} %",
    )
