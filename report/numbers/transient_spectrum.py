"""The spectrum of what dies out after the start of a driven run."""

from __future__ import annotations

import numpy as np
from scipy.signal import find_peaks

from report.numbers.driven_motion import SAMPLE_RATE, DrivenRun
from trimmer.arrays import Reals

PADDED = 2**17
"""Samples of the record with zeros added: a finer grid of frequencies, not a finer resolution."""
LOWEST, HIGHEST = 150.0, 1000.0
"""Range of the peaks, Hz: beyond the drive itself."""
SMALLEST = 0.05
"""Smallest peak, over the largest."""


def transient_spectrum(run: DrivenRun) -> tuple[Reals, Reals]:
    """Return frequencies (Hz) and the modulus of the spectrum of the transient (m s)."""
    return (
        np.asarray(np.fft.rfftfreq(PADDED, 1 / SAMPLE_RATE), dtype=np.float64),
        np.abs(np.fft.rfft(run.transient, PADDED)) / SAMPLE_RATE,
    )


def transient_peaks(run: DrivenRun) -> tuple[float, ...]:
    """Return the frequencies of the peaks of the transient, rising, Hz."""
    frequency, modulus = transient_spectrum(run)
    inside = (frequency > LOWEST) & (frequency < HIGHEST)
    places, _ = find_peaks(np.where(inside, modulus, 0.0), height=SMALLEST * modulus[inside].max())
    return tuple(float(each) for each in frequency[places])
