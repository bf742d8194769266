"""A filter that integrates or differentiates in a band, with a short kernel."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.signals.band import Band
from trimmer.signals.signal import Signal, SignalError

REACH = 3.0  # Half length of the kernel times the width of the narrowest flank, in s and Hz

_SHAPE = 10.0  # Kaiser's beta of the flanks: what the kernel has beyond ``REACH`` is then about 1e-4 of it
_FEWEST_LEFT = 16


@dataclass(frozen=True)
class OmegaKernel:
    """(j omega)^n in a band, as a filter whose kernel is short."""

    times: int  # n
    band: Band  # The band
    rate: float  # Sample rate, Hz
    reach: int  # Half length of the kernel, in samples

    @classmethod
    def of(cls, source: Signal, times: int, band: Band) -> OmegaKernel:
        """Make the filter for a record."""
        rate = source.sample_rate
        flank = min(0.5 * band.lowest or math.inf, _highest_end(band, rate) - band.highest)
        reach = math.ceil(REACH / flank * rate)
        if source.values.size - 2 * reach < _FEWEST_LEFT:
            raise SignalError(
                f"the record lasts {source.duration:.4g} s, too short to convert from {band.lowest:.4g} to "
                f"{band.highest:.4g} Hz: {reach / rate:.4g} s are lost at either end; give a lowest "
                f"frequency well above {4 * REACH / source.duration:.3g} Hz (--lowest), or a longer record"
            )
        return cls(times, band, rate, reach)

    def response(self, frequency: Reals) -> Complexes:
        """Evaluate the response at frequencies, Hz: nothing at 0 Hz and at half the sample rate."""
        weight = 1.0 - _flank(frequency, self.band.highest, _highest_end(self.band, self.rate))
        if self.band.lowest:
            weight = weight * _flank(frequency, 0.5 * self.band.lowest, self.band.lowest)
        response = np.zeros(frequency.size, np.complex128)
        moving = frequency > 0
        response[moving] = weight[moving] * (2j * np.pi * frequency[moving]) ** self.times
        return response

    def applied(self, values: Reals) -> tuple[Reals, float, float]:
        """Return the result inside the record, and what its ends change: about, and at most.

        Mean and straight line, which the kernel takes to 0 when integrating, are taken off before, so that
        less is unknown beyond the ends; when differentiating, the slope is put back.
        """
        from scipy.fft import next_fast_len

        count, reach = values.size, self.reach
        length = next_fast_len(count + 2 * reach, real=True)
        response = self.response(np.asarray(np.arange(length // 2 + 1) * (self.rate / length)))
        ramp = np.arange(count) - 0.5 * (count - 1)
        slope = float(ramp @ values) / float(ramp @ ramp)
        apart = values - values.mean() - slope * ramp
        result = np.fft.irfft(np.fft.rfft(apart, length) * response, length)
        more = min(reach, (count - 2 * reach) // 3)
        known = apart.copy()
        known[:more] = known[count - more :] = 0.0
        other = np.fft.irfft(np.fft.rfft(known, length) * response, length)
        inner = slice(reach + more, count - reach - more)
        kernel = np.abs(np.fft.irfft(response, length))
        bound = float(kernel[reach + 1 : length - reach].sum()) * float(np.abs(apart).max())
        kept = result[reach : count - reach]
        if self.times == 1 and not self.band.lowest:
            kept = kept + slope * self.rate
        return np.asarray(kept), float(np.abs(result - other)[inner].max()), bound


def _highest_end(band: Band, rate: float) -> float:
    return min(0.5 * rate, 1.25 * band.highest)


def _flank(frequency: Reals, begin: float, end: float) -> Reals:
    """Rise from 0 to 1 as the integral of a Kaiser window does."""
    places = np.linspace(-1.0, 1.0, 8193)
    window = np.i0(_SHAPE * np.sqrt(1.0 - places**2))
    risen = np.concatenate([[0.0], np.cumsum(window[1:] + window[:-1])])
    share = (2.0 * frequency - begin - end) / (end - begin)
    return np.asarray(np.interp(share, places, risen / risen[-1]))
