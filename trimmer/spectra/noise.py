"""Threshold of a spectrum above which a bin is more than noise."""

import math

import numpy as np
from scipy.ndimage import median_filter

from trimmer.arrays import Reals

NEIGHBOURHOOD = 401  # Number of bins over which noise is taken as white


def noise_threshold(amplitude: Reals, false_alarm: float) -> Reals:
    """Find the amplitude, (m,), that noise alone exceeds with a given probability, in any of m bins.

    The amplitude of Gaussian noise in a bin has a Rayleigh distribution with median s sqrt(2 ln 2), and
    exceeds a with probability exp(-(a/s)**2/2). The median is taken over the ``NEIGHBOURHOOD`` of each
    bin, so that noise may change along the spectrum; a few lines among the bins hardly move it. It is
    uncertain itself, which makes false alarms somewhat more frequent: 1.5 % where 1 % is asked for, in
    1000 bins.
    """
    median = median_filter(amplitude, min(NEIGHBOURHOOD, amplitude.size), mode="reflect")
    return np.asarray(median * math.sqrt(math.log(amplitude.size / false_alarm) / math.log(2.0)))
