"""Writing of a vibration as sound: mono WAV files at a rate that sound devices play."""

import io
import math
import wave
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from trimmer.arguments import file_path, real_number, truth_value
from trimmer.arrays import Reals
from trimmer.choices import Choice
from trimmer.files import write_atomically
from trimmer.showing.shown import ShownFields
from trimmer.signals.signal import SignalError, checked_rate, checked_samples

SUITED_RATES = (8000, 11025, 12000, 16000, 22050, 24000, 32000, 44100, 48000, 88200, 96000, 176400, 192000)
"""Sample rates that sound devices play, Hz; a signal at one of them is not resampled."""

HIGHEST_TARGET = 48000
"""Highest sample rate to which a signal is resampled, Hz; what it leaves out cannot be heard."""

LOWEST_AUDIBLE = 20.0  # Lowest frequency that is heard as a sound, Hz

SHORTEST = 0.01  # Shortest vibration that is written, s

_LARGEST_FACTOR = 50_000
_LARGEST_DATA = 2**32 - 64
"""Bytes of samples that fit into a WAV file, whose sizes have 32 bits, with its head."""


class BitDepth(Choice):
    """Bits of a sample in a WAV file."""

    SIXTEEN = 16
    TWENTY_FOUR = 24

    @property
    def word(self) -> str:
        """Number of bits."""
        return str(self.value)

    @property
    def full_scale(self) -> int:
        """Largest sample; the most negative one, which has no positive counterpart, is not used."""
        bits: int = self.value
        return (1 << (bits - 1)) - 1


@dataclass(frozen=True)
class WavFile(ShownFields):
    """Description of a WAV file that was written, with its normalisation.

    Attributes:
        sample_rate: Sample rate of the file, Hz.
        samples: Number of samples.
        bit_depth: Bits of a sample.
        mean: Mean that was subtracted from the signal, in its unit.
        full_scale: Deviation from the mean that a full-scale sample stands for, in the signal's unit; 0 for a
            constant signal, which is silence.
        pitch_error: How much faster the file plays than the signal was, relative: 0 unless the ratio of the
            sample rates had to be rounded.
    """

    sample_rate: int
    samples: int
    bit_depth: BitDepth
    mean: float
    full_scale: float
    pitch_error: float


def write_wav(
    path: Path | str,
    signal: ArrayLike,
    sample_rate: float,
    bit_depth: BitDepth | int = BitDepth.SIXTEEN,
    peak: float = 0.9,
    *,
    overwrite: bool = False,
) -> WavFile:
    """Write a vibration as a mono PCM WAV file, whole or not at all.

    The mean is subtracted, since a loudspeaker cannot play it. A sample rate that is not one of
    ``SUITED_RATES`` is changed to the next of them, or to ``HIGHEST_TARGET`` if it is above that, by
    ``scipy.signal.resample_poly``, whose low-pass filter keeps what lies above half the new rate from being
    heard as something else. Then the largest sample is brought to ``peak`` of full scale: none is clipped.

    Args:
        path: The file.
        signal: Samples, shape (n,), in any unit.
        sample_rate: Samples per second, Hz.
        bit_depth: Bits of a sample: a member, or 16 or 24.
        peak: Largest sample as a share of full scale, 0 < peak <= 1.
        overwrite: Replace a file of any kind; see ``write_atomically``.

    Returns:
        Description of the file, with the normalisation.

    Raises:
        ChoiceError: if ``bit_depth`` is neither 16 nor 24.
        SignalError: if samples, sample rate or peak cannot be used, if the file would be larger than 4 GiB,
            or nothing of it could be heard (shorter than ``SHORTEST``, or slower than ``LOWEST_AUDIBLE``).
        FileWriteError: if the file cannot be written.
    """
    values = checked_samples(signal)
    rate = checked_rate(sample_rate)
    bit_depth = BitDepth.chosen(bit_depth, "bit_depth")
    overwrite = truth_value("overwrite", overwrite)
    if not 0 < real_number("peak", peak) <= 1:
        raise SignalError(f"peak is {peak!r}: it must be above 0 and at most 1, which is full scale")
    wav_rate = _suited(rate)
    ratio = Fraction(wav_rate) / Fraction(rate)
    used = _simple(ratio)
    _check_audible(values.size, rate)
    if values.size * float(ratio) * bit_depth.value / 8 > _LARGEST_DATA:
        raise SignalError(
            f"{values.size} samples at {rate:g} Hz make a WAV file of more than 4 GiB; cut them"
        )
    scale, mean, vibration = _without_mean(values)
    sound = _resampled(vibration, used)
    loudest = float(np.abs(sound).max())
    samples = np.rint(sound * (peak * bit_depth.full_scale / loudest if loudest else 0.0)).astype("<i4")
    content = _content(samples, wav_rate, bit_depth)
    write_atomically(file_path("path", path), content, overwrite=overwrite)
    return WavFile(
        sample_rate=wav_rate,
        samples=samples.size,
        bit_depth=bit_depth,
        mean=mean,
        full_scale=scale * (loudest / peak),
        pitch_error=float(ratio / used - 1),
    )


def _without_mean(values: Reals) -> tuple[float, float, Reals]:
    """Return scale, mean, and the vibration over the scale, so that no sum is too large for a number."""
    scale = float(np.abs(values).max()) or 1.0
    relative = values / scale
    mean = float(relative.mean())
    return scale, scale * mean, relative - mean


def _check_audible(samples: int, rate: float) -> None:
    if samples < SHORTEST * rate:
        raise SignalError(
            f"{samples} samples at {rate:g} Hz last {samples / rate:.3g} s; a sound needs {SHORTEST:g} s"
        )
    if rate < 2 * LOWEST_AUDIBLE:
        raise SignalError(
            f"{rate:g} samples per second hold no frequency above {rate / 2:g} Hz; "
            f"below {LOWEST_AUDIBLE:g} Hz nothing can be heard"
        )


def _suited(rate: float) -> int:
    if rate in SUITED_RATES:
        return int(rate)
    return next((suited for suited in SUITED_RATES if rate < suited <= HIGHEST_TARGET), HIGHEST_TARGET)


def _simple(ratio: Fraction) -> Fraction:
    """Round a ratio of sample rates to whole numbers that are not large, since they set the cost."""
    if ratio > 1:
        return 1 / _simple(1 / ratio)
    return ratio.limit_denominator(max(_LARGEST_FACTOR, math.ceil(1 / ratio)))


def _resampled(vibration: Reals, ratio: Fraction) -> Reals:
    if ratio == 1:
        return vibration
    from scipy.signal import resample_poly

    return np.asarray(resample_poly(vibration, ratio.numerator, ratio.denominator))


def _content(samples: NDArray[np.int32], rate: int, bit_depth: BitDepth) -> bytes:
    width = bit_depth.value // 8
    frames = np.ascontiguousarray(samples).view(np.uint8).reshape(-1, 4)[:, :width]
    content = io.BytesIO()
    with wave.open(content, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(width)
        file.setframerate(rate)
        file.writeframes(frames.tobytes())
    return content.getvalue()
