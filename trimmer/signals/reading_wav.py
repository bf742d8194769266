"""Reading of a WAV file: one channel of it, as shares of full scale."""

import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from trimmer.arguments import file_path, real_number, whole_number
from trimmer.arrays import Reals
from trimmer.files import STANDARD_INPUT
from trimmer.signals.signal import LARGEST_VALUE, Signal
from trimmer.signals.text_file import SignalFileError, unreadable

_RIFF = (b"RIFF", b"RIFX", b"RF64")


def is_wav(path: Path) -> bool:
    """Return whether a file begins as a WAV file does; standard input is taken for text."""
    if path == STANDARD_INPUT:
        return False
    try:
        with path.open("rb") as file:
            head = file.read(12)
    except OSError:
        return False
    return head[:4] in _RIFF and head[8:] == b"WAVE"


def read_wav(
    path: Path | str, *, channel: int | None = None, begin: float = 0.0, end: float = math.inf
) -> Signal:
    """Read a channel of a WAV file: PCM of 8 to 32 bits, or floating point.

    Whole numbers become shares of full scale, which is 2**(bits - 1): a WAV file does not say what full scale
    stands for. ``Signal.scaled`` gives them a unit. Of a file of 8, 16 or 32 bits only what is asked for is
    taken into memory.

    Args:
        path: The file.
        channel: Number of the channel, from 1; not needed if there is one.
        begin: Time from which on to read, s from the start of the file.
        end: Time up to which to read, s.

    Raises:
        SignalFileError: if the file cannot be read as WAV, the channel does not exist or has to be chosen, or
            nothing lies between the times.
        ValueError: if the channel is no number from 1 on.
    """
    path = file_path("path", path)
    if channel is not None:
        whole_number("channel", channel, 1)
    begin, end = real_number("begin", begin, "s"), real_number("end", end, "s")
    rate, data, problems = _content(path)
    frames = data[:, None] if data.ndim == 1 else data
    chosen = _channel(path, frames.shape[1], channel)
    first = math.ceil(begin * rate - 1e-6) if begin > 0 else 0
    last = frames.shape[0] if end == math.inf else math.floor(end * rate + 1e-6) + 1
    taken = frames[first : max(last, 0), chosen]
    if taken.size == 0:
        raise SignalFileError(
            f"{path}: lasts {frames.shape[0] / rate:.6g} s, and holds no sample from {begin:g} s to {end:g} s"
        )
    values, told = _shares(taken)
    wrong = np.flatnonzero(~(np.abs(values) <= LARGEST_VALUE))
    if wrong.size:
        raise SignalFileError(
            f"{path}: sample {first + int(wrong[0]) + 1} is not finite, or above {LARGEST_VALUE:g}; "
            "was it overloaded?"
        )
    several = f", channel {chosen + 1} of {frames.shape[1]}" if frames.shape[1] > 1 else ""
    notes = (f"WAV file{several}: {told}", *problems)
    full_scale = math.inf if frames.dtype.kind == "f" else 1.0
    name = f"channel {chosen + 1}"
    return Signal(values, float(rate), name, "", first / rate, notes=notes, full_scale=full_scale)


def _content(path: Path) -> tuple[int, NDArray[Any], list[str]]:
    """Return rate, frames and what was odd about the file; memory-mapped where that is possible."""
    from scipy.io import wavfile

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", wavfile.WavFileWarning)
        try:
            try:
                rate, data = wavfile.read(path, mmap=True)
            except ValueError:  # samples of 24 bits cannot be mapped
                rate, data = wavfile.read(path)
        except OSError as error:
            raise unreadable(path, error) from error
        except Exception as error:  # SciPy raises several kinds for files that are no WAV
            raise SignalFileError(
                f"{path}: cannot be read as a WAV file ({error}); export it as PCM or floating point"
            ) from error
    if rate <= 0 or data.size == 0:
        raise SignalFileError(f"{path}: holds no samples, or no sample rate")
    told = {str(each.message) for each in caught if "chunk" not in str(each.message).lower()}
    return int(rate), data, sorted(f"odd WAV file: {text.rstrip('.')}" for text in told)


def _channel(path: Path, count: int, channel: int | None) -> int:
    if channel is None and count > 1:
        raise SignalFileError(f"{path}: has {count} channels; choose one (--channel 1 to {count})")
    if channel is not None and channel > count:
        raise SignalFileError(f"{path}: there is no channel {channel}; it has {count}")
    return 0 if channel is None else channel - 1


def _shares(taken: NDArray[Any]) -> tuple[Reals, str]:
    """Return samples as floats, and what they are; SciPy puts 24 bits into the upper ones of 32."""
    kind = taken.dtype.kind
    if kind == "f":
        return taken.astype(np.float64), "floating-point samples as they are"
    bits = 8 * taken.dtype.itemsize
    middle = 2.0 ** (bits - 1)
    values = (taken.astype(np.float64) - (middle if kind == "u" else 0.0)) / middle
    return np.asarray(values), f"samples of {bits} bits as shares of full scale"
