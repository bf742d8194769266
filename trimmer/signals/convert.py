"""Displacement, velocity and acceleration made of one another, in the band where that can be trusted."""

import math
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arguments import real_number, require_instance
from trimmer.arrays import Reals
from trimmer.showing.shown import Shown
from trimmer.signals.band import Band
from trimmer.signals.faults import faults
from trimmer.signals.noise_floor import Powers, powers
from trimmer.signals.omega_kernel import REACH, OmegaKernel
from trimmer.signals.quantity import MotionQuantity
from trimmer.signals.signal import Signal, SignalError

ANTI_ALIAS = 2.56  # Sample rate over the highest frequency that anti-alias filters of analysers usually pass
NOISE_SHARE = 0.01  # Largest share of the variance in the trusted band that may be noise: 10 % of the rms
SENSOR_RATIO = 3.0
"""From how many times its corner on a sensor's high-pass of first order takes at most about 5 % off."""

_MOSTLY_NOISE = 0.5
_FEWEST = 64


@dataclass(frozen=True, eq=False, repr=False)
class Conversion(Shown):
    """A signal converted to another quantity.

    Attributes:
        signal: The result, in SI; its ``trusted`` is the band that it holds, and its ``notes`` say all that
            follows in sentences.
        source: The signal that it was made of.
        cut: Time that is cut off at either end, s.
        end_error: About what the unknown signal before and after the record changes, in the unit of the
            result: the largest change where a little more of the record is taken to be unknown.
        end_bound: Bound of that, if the signal is nowhere larger than in the record.
        noise: Root mean square of the noise in the result, from the noise floor of the source.
        outside: Share of the variance of the source that lies outside the band, and is not in the result.
    """

    signal: Signal
    source: Signal
    cut: float
    end_error: float
    end_bound: float
    noise: float
    outside: float

    def _told(self) -> str:
        return f"{self.source.heading} to {self.signal.heading}, {self.cut:.6g} s cut off at either end"


def convert(
    signal: Signal,
    quantity: MotionQuantity | str,
    *,
    lowest: float | None = None,
    highest: float | None = None,
    sensor_corner: float | None = None,
) -> Conversion:
    """Integrate or differentiate a signal by dividing or multiplying its spectrum by j omega.

    Only a band is converted: from ``lowest`` on, since drift and noise grow as 1/omega or 1/omega^2 towards
    0 Hz, up to ``highest``. Within it the response is (j omega)^n to rounding; its flanks, from half of the
    lowest frequency on and up to a quarter above the highest, are integrals of Kaiser windows, so that the
    kernel is short. What it reaches beyond the ends of the record is not known: so much is cut off there.

    Not given, the lowest frequency is the largest of three: that which leaves half of the record, that from
    which on the sensor passes all but 5 %, and that from which on noise is at most 1 % of the variance of the
    result. The highest is 1/2.56 of the sample rate, or when differentiating less, where noise asks for it.

    Args:
        signal: Displacement, velocity or acceleration.
        quantity: What is wanted, a member or its word, such as ``displacement``.
        lowest: Lower end of the band, Hz.
        highest: Upper end, Hz.
        sensor_corner: Frequency at which the sensor's high-pass, of first order, has 3 dB, Hz.

    Raises:
        SignalError: if the signal's unit is none of a motion, a frequency is out of its range, or the record
            is too short.
        ChoiceError: if there is no such quantity.
        WrongTypeError: if an argument is of another type.
    """
    require_instance("signal", signal, Signal, "a trimmer.Signal")
    quantity = MotionQuantity.chosen(quantity, "quantity")
    _check(signal, quantity)
    source = signal.in_si()
    times = quantity.derivatives - source.quantity.derivatives
    if times == 0:
        return Conversion(source, signal, 0.0, 0.0, 0.0, math.nan, 0.0)
    if source.values.size < _FEWEST:
        raise SignalError(
            f"{source.values.size} samples are too few to convert; {_FEWEST} or more are needed"
        )
    scale = float(np.abs(source.values).max()) or 1.0  # keeps squares finite
    source = replace(source, values=source.values / scale)
    spectrum = powers(source.values, source.sample_rate)
    limits = _Limits(source, times, spectrum)
    band = limits.band(lowest, highest, sensor_corner)
    # What was cut off below a band before needs not be cut off again, which would cost both ends.
    passed = replace(band, lowest=0.0) if times > 0 and lowest is None else band
    kernel = OmegaKernel.of(source, times, passed)
    values, end_error, end_bound = kernel.applied(source.values)
    inside = (spectrum.frequency >= band.lowest) & (spectrum.frequency <= band.highest)
    total = float(spectrum.total.sum()) or 1.0
    result = Conversion(
        signal=replace(
            source,
            values=scale * values,
            name=f"{source.name} as {quantity.word}",
            unit=quantity.unit,
            start=source.start + kernel.reach / source.sample_rate,
            trusted=band,
            full_scale=math.inf,
            converted=source.converted + times,
        ),
        source=signal,
        cut=kernel.reach / source.sample_rate,
        end_error=scale * end_error,
        end_bound=scale * end_bound,
        noise=scale * math.sqrt(float(np.abs(kernel.response(spectrum.frequency)) ** 2 @ spectrum.floor)),
        outside=float(spectrum.total[~inside].sum()) / total,
    )
    told = (*signal.notes, *(fault.sentence for fault in faults(signal)), *_notes(result, band))
    return replace(result, signal=replace(result.signal, notes=told))


def _check(signal: Signal, quantity: MotionQuantity) -> None:
    if quantity is MotionQuantity.OTHER:
        raise SignalError(
            "a signal can be converted to displacement, velocity or acceleration, not to 'other'"
        )
    if signal.quantity is MotionQuantity.OTHER:
        raise SignalError(
            f"{signal.name}: the unit {signal.unit!r} does not tell whether it is a displacement, a "
            "velocity or an acceleration; say what it is (--unit m/s2, with --scale to multiply it)"
        )


@dataclass(frozen=True, eq=False)
class _Limits:
    """What bounds the band of a conversion: a signal, SI, differentiated so many times, and its powers."""

    source: Signal
    times: int
    spectrum: Powers

    @property
    def integrated(self) -> bool:
        """Whether the signal is integrated."""
        return self.times < 0

    @property
    def gain(self) -> Reals:
        """Square of what the conversion multiplies lines with."""
        return np.asarray((2 * np.pi * self.spectrum.frequency) ** (2 * self.times))

    def band(self, lowest: float | None, highest: float | None, corner: float | None) -> Band:
        """Choose the ends of the band that are not given, and check those that are."""
        half = 0.5 * self.source.sample_rate
        high, why_high = self.source.sample_rate / ANTI_ALIAS, f"sample rate over {ANTI_ALIAS:g}"
        if highest is not None:
            high, why_high = _frequency("highest", highest, 0.0, half), "as given"
        low, why_low = 0.0, ""
        if lowest is not None:
            low, why_low = _frequency("lowest", lowest, 0.0, high), "as given"
        elif self.integrated:
            low, why_low = 8 * REACH / self.source.duration, "length of the record"
        band = Band(low, high, why_low, why_high)
        if corner is not None and lowest is None:
            band = band.within(
                Band(
                    lowest=SENSOR_RATIO * _frequency("sensor_corner", corner, 0.0, half),
                    lowest_reason=f"the sensor's high-pass at {corner:g} Hz takes 5 % off there",
                )
            )
        band = band.within(self.source.trusted)
        return self._above_noise(band, lowest is None, highest is None)

    def _above_noise(self, band: Band, low_free: bool, high_free: bool) -> Band:
        """Narrow the band until noise is a small share of the result, at the end where it grows."""
        integrated = self.integrated
        if not (low_free if integrated else high_free):
            return band
        frequency = self.spectrum.frequency
        places = np.flatnonzero((frequency >= band.lowest) & (frequency <= band.highest))
        order = places[::-1] if integrated else places
        total = np.cumsum((self.gain * self.spectrum.total)[order])
        noise = np.cumsum((self.gain * self.spectrum.floor)[order])
        # The flank passes noise too, about as much as half of it would without weight.
        reached = np.interp(
            frequency[order] * (0.75 if integrated else 1.125), *_rising(frequency[order], noise)
        )
        enough = np.flatnonzero(reached <= NOISE_SHARE * total)
        if enough.size == 0 or enough[-1] == order.size - 1:
            return band
        end = float(frequency[order[enough[-1]]])
        told = f"noise beyond it would be more than {100 * NOISE_SHARE:g} % of the variance"
        bound = Band(end, lowest_reason=told) if integrated else Band(highest=end, highest_reason=told)
        return band.within(bound)


def _rising(places: Reals, values: Reals) -> tuple[Reals, Reals]:
    order = np.argsort(places)
    return places[order], values[order]


def _frequency(name: str, value: float, above: float, below: float) -> float:
    if not above < real_number(name, value, "Hz") < below:
        raise SignalError(f"{name} is {value!r}: it must be above {above:g} Hz and below {below:.6g} Hz")
    return float(value)


def _notes(result: Conversion, band: Band) -> tuple[str, ...]:
    signal, unit = result.signal, result.signal.unit
    rms = signal.rms
    what = f"{result.source.quantity.word} converted to {signal.quantity.word} in the frequency domain"
    rest = "mean, drift and slow motion are lost" if band.lowest else "the mean is lost"
    outside = f"{100 * result.outside:.2g} % of the variance about mean and trend lies outside"
    notes = [
        f"{what}, {band.sentence}; {outside}: {rest}",
        f"{result.cut:.4g} s are cut off at either end; what was before and after the record changes the "
        f"rest by about {result.end_error:.2g} {unit}, at most {result.end_bound:.2g} {unit} if it was no "
        "larger there",
        f"noise in the result: about {result.noise:.2g} {unit} rms, of {rms:.3g} {unit} rms altogether",
    ]
    if result.noise > _MOSTLY_NOISE * rms:
        notes.append(
            "much of the result has no lines: it is noise, or a motion that does not repeat; the spectrum "
            "does not tell which"
        )
    return tuple(notes)
